"""Walls of through holes: lines of the views beside, found together as one by one."""

import numpy as np
import pytest

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.sheet.registration.through_holes import ViewEvidence, is_through

_BOX = (100.0, 50.0, 200.0, 110.0)


def _front(*walls: tuple[float, Linetype]) -> ViewEvidence:
    strokes = [
        Segment((_BOX[0] + at, _BOX[1]), (_BOX[0] + at, _BOX[3]), linetype)
        for at, linetype in walls
    ]
    rounding = Arc((150.0, 80.0), 10.0, 0.0, 1.0, Linetype.HIDDEN)
    mask = np.ones((60, 100), bool)
    return ViewEvidence(Role.FRONT, (*strokes, rounding), _BOX, mask, 1.0, _BOX[:2])


@pytest.mark.parametrize(
    ("walls", "expected"),
    [
        (((30.0, Linetype.HIDDEN), (50.0, Linetype.HIDDEN)), True),
        (((31.5, Linetype.HIDDEN), (48.5, Linetype.VISIBLE)), True),
        (((30.0, Linetype.VISIBLE), (50.0, Linetype.VISIBLE)), False),
        (((30.0, Linetype.HIDDEN),), False),
        (((30.0, Linetype.HIDDEN), (53.0, Linetype.HIDDEN)), False),
        ((), False),
    ],
)
def test_both_walls_show_over_the_whole_depth(
    walls: tuple[tuple[float, Linetype], ...], expected: bool
) -> None:
    extent = {Axis.X: (0.3, 0.5), Axis.Y: (0.2, 0.4)}
    assert is_through(Role.TOP, extent, [], [_front(*walls)], 2.0) is expected
