"""Stretches on which an outline leaves its line by a pixel or two."""

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.outline_bows import with_bows
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

_TOP, _BOTTOM = 40.0, 130.0


def _bow(first: float, last: float, level: float, height: float) -> list[tuple[float, float]]:
    """Points of an arc that leaves a level line downwards."""
    at = np.linspace(-1.0, 1.0, 41)
    middle, half = (first + last) / 2.0, (last - first) / 2.0
    radius = (half**2 + height**2) / (2.0 * height)
    ys = level + height - radius + np.sqrt(radius**2 - (half * at) ** 2)
    return [(middle + half * float(x), float(y)) for x, y in zip(at, ys, strict=True)]


@pytest.mark.parametrize("height", [1.4, 2.0, 2.4])
@pytest.mark.parametrize("wide", [36.0, 46.0])
def test_the_mouth_of_a_cross_bore_bows_the_outline(sketch, height: float, wide: float) -> None:  # noqa: ANN001
    first, last = 70.0, 70.0 + wide
    drawn = sketch().lines((30.0, _TOP), (first, _TOP), width=2.7)
    drawn.lines(*_bow(first, last, _TOP, height), width=2.7)
    drawn.lines(
        (last, _TOP), (170.0, _TOP), (170.0, _BOTTOM), (30.0, _BOTTOM), (30.0, _TOP), width=2.7
    )
    sheet = clean_sheet(drawn.grey)
    shapes = find_shapes(sheet, (28.0, 38.0, 172.0, 132.0))
    strokes = classify_strokes(shapes, view_rhythm([shapes], sheet.stroke_width))
    assert len(strokes) == 6
    (arc,) = [stroke for stroke in strokes if isinstance(stroke, Arc)]
    assert arc.linetype is Linetype.VISIBLE
    points = arc.sample(arc.length / 20.0) - 0.5
    assert points[:, 1].max() == pytest.approx(_TOP + height, abs=0.25)
    assert sorted(points[[0, -1], 0]) == pytest.approx([first, last], abs=3.0)
    ends = [
        np.array([stroke.start, stroke.end]) for stroke in strokes if isinstance(stroke, Segment)
    ]
    level = [end for end in ends if np.abs(end[:, 1] - 0.5 - _TOP).max() < 0.5]
    assert len(level) == 2


def _line(start: tuple[float, float], end: tuple[float, float]) -> tuple[Line, Piece]:
    way = np.subtract(end, start)
    length = float(np.hypot(*way))
    line = Line(start, (float(way[0]) / length, float(way[1]) / length))
    return line, Piece(0.0, length, Linetype.VISIBLE, 1.0)


def test_a_bow_ends_at_the_strokes_beside_it(sketch) -> None:  # noqa: ANN001
    drawn = sketch().line((30.0, _TOP), (70.0, _TOP)).lines(*_bow(70.0, 106.0, _TOP, 2.2))
    drawn.line((106.0, _TOP), (170.0, _TOP)).line((70.0, _TOP), (70.0, 90.0))
    sheet = clean_sheet(drawn.grey)
    pieces = [_line((30.0, _TOP), (170.0, _TOP)), _line((70.0, _TOP), (70.0, 90.0))]
    found = with_bows(pieces, sheet)
    ((circle, arc),) = [item for item in found if isinstance(item[0], Circle)]
    ends = circle.points_at(np.array([arc.start, arc.end]))
    assert sorted(ends[:, 0]) == pytest.approx([70.0, 106.0], abs=1.0)
    assert min(abs(ends[:, 0] - 70.0)) < 1e-6
    spans = sorted((piece.start, piece.end) for item, piece in found if item == pieces[0][0])
    assert [spans[0][0], spans[0][1], spans[1][1]] == pytest.approx([0.0, 40.0, 140.0])


@pytest.mark.parametrize("height", [0.0, 0.5])
def test_a_straight_line_has_no_bow(sketch, height: float) -> None:  # noqa: ANN001
    drawn = sketch().line((30.0, _TOP), (170.0, _TOP))
    if height:
        drawn = sketch().line((30.0, _TOP), (70.0, _TOP)).line((106.0, _TOP), (170.0, _TOP))
        drawn.lines(*_bow(70.0, 106.0, _TOP, height))
    pieces = [_line((30.0, _TOP), (170.0, _TOP))]
    assert with_bows(pieces, clean_sheet(drawn.grey)) == pieces


def test_a_step_is_no_bow(sketch) -> None:  # noqa: ANN001
    drawn = sketch().line((30.0, _TOP), (90.0, _TOP)).line((90.0, _TOP + 2.0), (170.0, _TOP + 2.0))
    pieces = [_line((30.0, _TOP), (170.0, _TOP))]
    assert with_bows(pieces, clean_sheet(drawn.grey)) == pieces


def test_a_line_along_the_middle_of_a_bow_is_none(sketch) -> None:  # noqa: ANN001
    drawn = sketch().line((30.0, _TOP), (70.0, _TOP)).lines(*_bow(70.0, 136.0, _TOP, 3.0))
    drawn.line((136.0, _TOP), (170.0, _TOP)).line((80.0, _TOP + 14.0), (120.0, _TOP + 14.0))
    pieces = [
        _line((30.0, _TOP), (70.0, _TOP)),
        _line((136.0, _TOP), (170.0, _TOP)),
        _line((74.0, _TOP + 2.4), (132.0, _TOP + 2.7)),
        _line((80.0, _TOP + 14.0), (120.0, _TOP + 14.0)),
    ]
    whole = pieces[0][0]
    pieces[1] = whole, Piece(106.0, 140.0, Linetype.VISIBLE, 1.0)
    found = with_bows(pieces, clean_sheet(drawn.grey))
    assert sum(isinstance(item[0], Circle) for item in found) == 1
    assert pieces[2] not in found
    assert pieces[3] in found
    slanted = _line((52.0, _TOP), (118.0, _TOP + 2.4))
    assert slanted not in with_bows([*pieces, slanted], clean_sheet(drawn.grey))
    assert len(found) == 4


@pytest.mark.parametrize(("height", "length"), [(1.8, 17.0), (2.1, 14.0), (2.5, 24.0)])
def test_an_end_that_flattens_into_its_line_is_no_bow_beyond(
    sketch,  # noqa: ANN001
    height: float,
    length: float,
) -> None:
    """What is left of a bow before the corner at which another cut ends it."""
    share = np.linspace(0.0, 1.0, 9)
    rest = np.stack([30.0 + length * share, _TOP - height * (1.0 - share) ** 1.3], axis=1)
    drawn = sketch(240).lines(*map(tuple, rest.tolist()), (200.0, _TOP))
    pieces = [_line((30.0, _TOP), (200.0, _TOP))]
    assert with_bows(pieces, clean_sheet(drawn.grey)) == pieces
