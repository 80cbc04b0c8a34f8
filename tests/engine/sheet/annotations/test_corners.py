"""Where a line ends in another line's end, it is no centre line."""

import pytest

from gaussiancad_core.sheet.annotations.corners import Corners
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

RUNS = (InkedRun(Run(0.0, 40.0), 2.0), InkedRun(Run(46.0, 90.0), 2.0))
LEVEL = InkedShape(Line((10.0, 20.0), (1.0, 0.0)), RUNS)


def _upright(x: float, start: float, end: float) -> InkedShape:
    return InkedShape(Line((x, 0.0), (0.0, 1.0)), (InkedRun(Run(start, end), 2.0),))


@pytest.mark.parametrize(
    ("other", "corner"),
    [
        (_upright(10.0, 20.0, 60.0), True),
        (_upright(100.5, -30.0, 21.0), True),
        # It passes by, or ends in the gap, or elsewhere.
        (_upright(10.0, -20.0, 60.0), False),
        (_upright(53.0, 20.0, 60.0), False),
        (_upright(10.0, 24.0, 60.0), False),
        # In line, it goes on.
        (InkedShape(Line((101.0, 20.0), (1.0, 0.0)), (InkedRun(Run(0.0, 30.0), 2.0),)), False),
        (InkedShape(Circle((10.0, 40.0), 20.0), (InkedRun(Run(0.0, 30.0), 2.0),)), False),
    ],
)
def test_ends_that_meet(other: InkedShape, corner: bool) -> None:
    corners = Corners.of([LEVEL, other], 2.0)
    assert corners.has_end(LEVEL.geometry, RUNS) is corner
    assert not corners.has_end(Circle((0.0, 0.0), 5.0), RUNS)


def test_without_lines_there_are_no_corners() -> None:
    assert not Corners.of([], 2.0).has_end(LEVEL.geometry, RUNS)
