"""Chamfers as small as the pen is wide are read beside their edge, square ends have none."""

import numpy as np
import pytest

from gaussiancad_core.model.views import Segment, Stroke

_LEFT, _TOP, _RIGHT, _BOTTOM = 40.3, 30.6, 340.2, 250.9


def _ends(stroke: Segment) -> list[tuple[float, float]]:
    """In px whose centres are at integers, the left one first."""
    return sorted((x - 0.5, y - 0.5) for x, y in (stroke.start, stroke.end))


def _slanted(strokes: tuple[Stroke, ...]) -> list[list[tuple[float, float]]]:
    found = [
        _ends(stroke)
        for stroke in strokes
        if isinstance(stroke, Segment)
        and min(np.abs(np.subtract(stroke.end, stroke.start)) / stroke.length) > 0.15
    ]
    return sorted(found, key=lambda ends: ends[0][1])


def _rod(sketch, across: float, down: float, width: float):  # noqa: ANN001, ANN202
    """A chamfered rod from the side, with the edges of its left end's chamfer."""
    drawing = sketch(380, 290).lines(
        (_RIGHT, _TOP), (_LEFT + across, _TOP), (_LEFT, _TOP + down), (_LEFT, _BOTTOM - down),
        (_LEFT + across, _BOTTOM), (_RIGHT, _BOTTOM), (_RIGHT, _TOP), width=width,
    )  # fmt: skip
    return drawing.line((_LEFT + across, _TOP), (_LEFT + across, _BOTTOM), width)


@pytest.mark.parametrize(
    ("width", "leg"), [(2.0, 3.6), (2.5, 3.6), (3.0, 3.6), (3.0, 4.4), (4.0, 4.8), (4.0, 6.0)]
)
def test_an_even_chamfer(sketch, width: float, leg: float) -> None:  # noqa: ANN001
    slanted = _slanted(_rod(sketch, leg, leg, width).strokes())
    true = [
        [(_LEFT, _TOP + leg), (_LEFT + leg, _TOP)],
        [(_LEFT, _BOTTOM - leg), (_LEFT + leg, _BOTTOM)],
    ]
    assert np.array(slanted) == pytest.approx(np.array(true), abs=0.4)


def test_a_steep_chamfer(sketch) -> None:  # noqa: ANN001
    slanted = _slanted(_rod(sketch, 5.0, 9.0, 3.0).strokes())
    true = [
        [(_LEFT, _TOP + 9.0), (_LEFT + 5.0, _TOP)],
        [(_LEFT, _BOTTOM - 9.0), (_LEFT + 5.0, _BOTTOM)],
    ]
    assert np.array(slanted) == pytest.approx(np.array(true), abs=0.6)


@pytest.mark.parametrize(("width", "away"), [(2.0, 3.6), (3.0, 4.2), (4.0, 5.4)])
def test_a_line_beside_a_square_end_is_no_edge_of_a_chamfer(
    sketch,  # noqa: ANN001
    width: float,
    away: float,
) -> None:
    corners = [(_LEFT, _TOP), (_RIGHT, _TOP), (_RIGHT, _BOTTOM), (_LEFT, _BOTTOM), (_LEFT, _TOP)]
    drawing = sketch(380, 290).lines(*corners, width=width)
    drawing.line((_LEFT + away, _TOP), (_LEFT + away, _BOTTOM), width)
    found = drawing.strokes()
    assert _slanted(found) == []
    assert len(found) == 5
