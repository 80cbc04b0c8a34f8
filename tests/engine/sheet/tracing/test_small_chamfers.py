"""Small chamfers are read exactly, sharp corners and steps are none."""

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype, Segment, Stroke
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.small_chamfers import with_chamfers

_LEFT, _TOP, _RIGHT, _BOTTOM = 40.0, 30.0, 340.0, 250.0


def _ends(stroke: Segment) -> list[tuple[float, float]]:
    """In px whose centres are at integers, the left one first."""
    return sorted((x - 0.5, y - 0.5) for x, y in (stroke.start, stroke.end))


def _slanted(strokes: tuple[Stroke, ...]) -> list[Segment]:
    return [
        stroke
        for stroke in strokes
        if isinstance(stroke, Segment)
        and min(np.abs(np.subtract(stroke.end, stroke.start)) / stroke.length) > 0.15
    ]


@pytest.mark.parametrize("width", [2.0, 3.0])
@pytest.mark.parametrize("legs", [(5.0, 5.0), (6.0, 6.0), (8.0, 8.0), (6.0, 10.0), (12.0, 7.0)])
def test_an_outline_with_one_chamfer(sketch, width: float, legs: tuple[float, float]) -> None:  # noqa: ANN001
    across, down = legs
    corners = [
        (_RIGHT - across, _TOP),
        (_LEFT, _TOP),
        (_LEFT, _BOTTOM),
        (_RIGHT, _BOTTOM),
        (_RIGHT, _TOP + down),
    ]
    found = sketch(380, 290).lines(*corners, corners[0], width=width).strokes()
    assert len(found) == 5
    (chamfer,) = _slanted(found)
    assert np.array(_ends(chamfer)) == pytest.approx(np.array([corners[0], corners[4]]), abs=0.6)


def test_a_chamfer_beside_the_edge_that_it_makes(sketch) -> None:  # noqa: ANN001
    """A chamfered rod from the side: the line of the chamfer's edge is seven px from its end."""
    drawing = sketch(380, 290).lines(
        (_RIGHT, _TOP), (_LEFT + 7, _TOP), (_LEFT, _TOP + 7), (_LEFT, _BOTTOM - 7),
        (_LEFT + 7, _BOTTOM), (_RIGHT, _BOTTOM), (_RIGHT, _TOP), width=3.0,
    )  # fmt: skip
    drawing.line((_LEFT + 7, _TOP), (_LEFT + 7, _BOTTOM), 3.0)
    slanted = sorted(
        (_ends(stroke) for stroke in _slanted(drawing.strokes())), key=lambda e: e[0][1]
    )
    assert np.array(slanted) == pytest.approx(
        np.array(
            [
                [(_LEFT, _TOP + 7), (_LEFT + 7, _TOP)],
                [(_LEFT, _BOTTOM - 7), (_LEFT + 7, _BOTTOM)],
            ]
        ),
        abs=0.6,
    )


def test_sharp_corners_and_steps_are_no_chamfers(sketch) -> None:  # noqa: ANN001
    corners = [
        (_LEFT, _TOP), (200.0, _TOP), (200.0, _TOP + 8), (_RIGHT, _TOP + 8),
        (_RIGHT, _BOTTOM), (_LEFT, _BOTTOM), (_LEFT, _TOP),
    ]  # fmt: skip
    found = sketch(380, 290).lines(*corners, width=3.0).strokes()
    assert len(found) == 6
    assert _slanted(found) == []
    assert all(stroke.linetype is Linetype.VISIBLE for stroke in found)


def test_a_chamfer_beside_its_edge_is_no_arc_as_well(sketch) -> None:  # noqa: ANN001
    """The ink of the chamfer and of what it joins is bent like that of an arc."""
    end, edge, size = 60.34, 69.1, 8.76
    drawing = sketch(380, 290).lines(
        (_RIGHT, _TOP), (edge, _TOP), (end, _TOP + size), (end, _BOTTOM - size),
        (edge, _BOTTOM), (_RIGHT, _BOTTOM), (_RIGHT, _TOP), width=2.6,
    )  # fmt: skip
    drawing.line((edge, _TOP), (edge, _BOTTOM), 2.6)
    found = drawing.strokes()
    assert all(isinstance(stroke, Segment) for stroke in found)
    assert len(found) == 7


def test_no_piece_ends_before_it_starts(sketch) -> None:  # noqa: ANN001
    """A dash's rest beside a chamfer is shorter than what the chamfer would take off it."""
    low = _TOP + 9.0
    drawing = sketch(380, 290).lines((_LEFT, _TOP), (_RIGHT - 6, _TOP), (_RIGHT, low), width=3.0)
    drawing.line((_RIGHT, low), (_RIGHT, _BOTTOM), 3.0)
    top = Line((_LEFT, _TOP), (1.0, 0.0)), Piece(0.0, _RIGHT - 6 - _LEFT, Linetype.VISIBLE, 1.0)
    side = Line((_RIGHT, low), (0.0, -1.0))
    rest = side, Piece(2.4, 3.4, Linetype.VISIBLE, 1.0)
    found = with_chamfers(drawing.weight, [top, rest], 3.0)
    assert all(piece.start <= piece.end for _, piece in found)
