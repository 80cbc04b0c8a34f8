"""Which curves of a file are the part's."""

import numpy as np
import pytest

from gaussiancad_core.files.vectors import StrokeKind, StrokeRole, VectorStroke
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.vector_views.part_curves import InkMasks, part_curves, share_inked

LEVEL = Turn(0.0, (50.0, 50.0))


def masks(part: bool = True) -> InkMasks:
    """A sheet full of ink, all of it the part's or none."""
    whole = np.ones((100, 100), np.uint8)
    return InkMasks(whole, whole if part else np.zeros_like(whole))


def stroke(*ends: float, width: float = 3.0, **more: object) -> VectorStroke:
    """A line from x0, y0 to x1, y1."""
    return VectorStroke(LineSegment(ends[:2], ends[2:]), width, **more)


def kept(*strokes: VectorStroke, part: bool = True) -> list[VectorStroke]:
    """Those that are the part's."""
    return list(part_curves(strokes, LEVEL, masks(part))[0])


def test_what_the_file_calls_something_else_is_not_the_part_s() -> None:
    edges = [
        stroke(10, 10, 60, 10),
        stroke(10, 10, 10, 60, role=StrokeRole.VISIBLE),
        stroke(10, 30, 60, 30, dashes=(5.0, 3.0), role=StrokeRole.HIDDEN),
    ]
    strange = [
        stroke(30, 0, 30, 90, dashes=(9.0, 2.0, 2.0, 2.0), role=StrokeRole.CENTRE),
        stroke(5, 5, 5, 80, role=StrokeRole.OTHER),
        stroke(5, 5, 8, 80, kind=StrokeKind.DIMENSION),
        stroke(20, 20, 40, 40, kind=StrokeKind.HATCH),
        stroke(40, 40, 40.01, 40),
    ]
    assert kept(*edges, *strange) == edges
    found, others = part_curves((*edges, *strange), LEVEL, masks())
    assert [item.curve for item in strange[:4]] == list(others)
    assert len(found) == 3


def test_what_was_taken_off_the_picture_is_an_annotation_unless_the_file_calls_it_hidden() -> None:
    solid = stroke(10, 10, 60, 10)
    dashed = stroke(10, 30, 60, 30, dashes=(5.0, 3.0), role=StrokeRole.HIDDEN)
    assert kept(solid, dashed, part=False) == [dashed]


def test_strokes_off_the_ink_are_not_believed() -> None:
    assert kept(stroke(200, 10, 260, 10)) == []


def test_thin_dashes_that_go_on_in_an_annotation_are_left_of_centre_lines() -> None:
    edges = [stroke(10, 10, 90, 10), stroke(10, 10, 10, 90), stroke(90, 10, 90, 90)]
    dash = stroke(40, 50, 46, 50, width=1.5)
    hidden = [stroke(20 + at, 30, 26 + at, 30, width=1.5) for at in (0, 9, 18, 27)]
    tangent = stroke(10, 70, 90, 70, width=1.5)
    long = stroke(50, 50, 80, 50, width=1.5, role=StrokeRole.CENTRE)
    assert kept(*edges, dash, *hidden, tangent, long) == [*edges, *hidden, tangent]
    assert kept(*edges, dash, *hidden, tangent) == [*edges, dash, *hidden, tangent]


@pytest.mark.parametrize(
    "curve",
    [
        LineSegment((20.0, 30.0), (60.0, 40.0)),
        CircularArc((50.0, 40.0), 20.0, 0.4, 2.0),
        EllipticArc((50.0, 40.0), 20.6, 10.3, 0.25, 0.4, 2.0),
        Chain(((20.0, 30.0), (40.0, 35.0), (60.0, 30.0))),
    ],
    ids=lambda curve: type(curve).__name__,
)
def test_curves_are_turned_with_the_sheet(curve: object) -> None:
    turn = Turn(0.1, (50.0, 50.0))
    found, _ = part_curves((VectorStroke(curve, 3.0),), turn, masks())
    assert type(found[0].curve) is type(curve)
    expected = turn.to_upright(curve.sample(1.0))
    assert found[0].curve.sample(1.0) == pytest.approx(expected, abs=1e-9)


def test_the_inked_share_counts_places() -> None:
    mask = np.zeros((100, 100), np.uint8)
    mask[:, :50] = 1
    assert share_inked(LineSegment((0.5, 10.5), (99.5, 10.5)), mask) == pytest.approx(0.5, abs=0.01)
    assert share_inked(LineSegment((-50.0, 10.5), (49.5, 10.5)), mask) == pytest.approx(
        0.5, abs=0.01
    )
