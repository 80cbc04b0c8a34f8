"""Edges drawn a few pixels too short or too long end where they are meant to."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.registration.view_masks import find_outline
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.dangling import with_met_ends
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

VISIBLE, HIDDEN = Linetype.VISIBLE, Linetype.HIDDEN
CORNERS = [(60.0, 50.0), (340.0, 50.0), (340.0, 240.0), (60.0, 240.0)]
BLANK = np.zeros((300, 400), dtype=bool)
WIDTH = 3.0


def _placed(
    start: tuple[float, float], end: tuple[float, float], linetype: Linetype = VISIBLE
) -> Placed:
    length = float(np.hypot(*np.subtract(end, start)))
    way = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    return Line(start, way), Piece(0.0, length, linetype, 1.0)


def _ends(placed: Placed) -> list[tuple[float, float]]:
    geometry, piece = placed
    return [geometry.at(piece.start), geometry.at(piece.end)]


@given(st.lists(st.floats(-5.0, 5.0), min_size=8, max_size=8))
def test_the_sides_of_a_box_meet_at_its_corners(off: list[float]) -> None:
    pieces = []
    for k, (start, end) in enumerate(zip(CORNERS, [*CORNERS[1:], CORNERS[0]], strict=True)):
        line, piece = _placed(start, end)
        pieces.append(
            (line, Piece(piece.start - off[2 * k], piece.end + off[2 * k + 1], VISIBLE, 1.0))
        )
    for k, placed in enumerate(with_met_ends(pieces, BLANK, WIDTH)):
        expected = CORNERS[k], CORNERS[(k + 1) % 4]
        # What ends within the strokes' ink is settled with the other ends.
        for found, corner in zip(_ends(placed), expected, strict=True):
            assert found == pytest.approx(corner, abs=WIDTH / 2 + 1.0 + 1e-6)


def test_what_is_met_or_may_go_on_stays() -> None:
    edge = _placed((200.0, 20.0), (200.0, 280.0))
    short = _placed((60.0, 150.0), (195.0, 150.0))
    assert _ends(with_met_ends([edge, short], BLANK, WIDTH)[1])[1] == pytest.approx((200.0, 150.0))
    # Hidden lines end in gaps; a hidden one is nothing that a visible edge ends at.
    dashed = _placed((200.0, 20.0), (200.0, 280.0), HIDDEN)
    assert with_met_ends([dashed, short], BLANK, WIDTH)[1] == short
    hidden = _placed((60.0, 150.0), (195.0, 150.0), HIDDEN)
    assert with_met_ends([edge, hidden], BLANK, WIDTH)[1] == hidden
    # Something meets it where it ends, as a narrow chamfer does.
    chamfer = _placed((195.0, 150.0), (200.0, 145.0))
    assert with_met_ends([edge, short, chamfer], BLANK, WIDTH)[1] == short
    curved = BLANK.copy()
    curved[148:151, 197:199] = True
    assert with_met_ends([edge, short], curved, WIDTH)[1] == short
    line, piece = short
    goes_on = line, Piece(piece.end, 200.0, HIDDEN, 1.0)
    assert with_met_ends([edge, short, goes_on], BLANK, WIDTH)[1] == short
    far = _placed((60.0, 150.0), (192.0, 150.0))
    assert with_met_ends([edge, far], BLANK, WIDTH)[1] == far


@settings(max_examples=12, deadline=None)
@given(st.lists(st.sampled_from([-4.0, -3.0, 0.0, 3.0, 4.0]), min_size=8, max_size=8))
def test_a_box_with_loose_corners_is_read_and_filled(sketch: Sketch, off: list[float]) -> None:
    drawn = sketch(400, 300)
    for k, (start, end) in enumerate(zip(CORNERS, [*CORNERS[1:], CORNERS[0]], strict=True)):
        way = np.sign(np.subtract(end, start))
        drawn.line(
            tuple(np.subtract(start, off[2 * k] * way)),
            tuple(np.add(end, off[2 * k + 1] * way)),
            WIDTH,
        )
    sheet, box = clean_sheet(drawn.grey), (54.0, 44.0, 346.0, 246.0)
    view = find_shapes(sheet, box)
    found = classify_strokes(view, view_rhythm([view], sheet.stroke_width))
    assert len(found) == 4
    for stroke in found:
        assert isinstance(stroke, Segment)
        for end in (stroke.start, stroke.end):
            away = np.hypot(*(np.array(CORNERS) + 0.5 - np.array(end)).T)
            assert away.min() < WIDTH / 2 + 1.5
    outline = find_outline(sheet, box, 2)
    assert outline is not None
    assert outline.mask.sum() / 4.0 == pytest.approx(280.0 * 190.0, rel=0.02)
