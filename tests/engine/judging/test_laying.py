"""A solid in any position is found on its sheet; a mirrored or stretched one is not the same."""

from collections.abc import Callable

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.faceted_solids import faceted_shape
from gaussiancad_core.judging.laying import lay
from gaussiancad_core.judging.misfits import Judge
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cut, cylinder, fuse

# No turn of its mirror image is the part itself.
_PART = cut(
    box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0)),
    box((30.0, -1.0, 20.0), (61.0, 41.0, 31.0)),
    cylinder(Axis.Z, (15.0, 10.0), 5.0, -1.0, 31.0),
)

_ORIGIN = np.zeros(3)


@pytest.fixture(scope="module")
def judge(drawn: Callable[[TopoDS_Shape], DrawnViews]) -> Judge:
    return Judge(drawn_sheet(drawn(_PART)))


@pytest.mark.parametrize("turn", [[1, 2, 0], [2, 0, 1], [0, 1, 2]])
def test_a_turned_and_moved_solid_is_laid_where_it_was_drawn(judge: Judge, turn: list[int]) -> None:
    matrix = np.eye(3)[turn]
    moved = faceted_shape(_PART).mapped(matrix, np.array([7.0, -300.0, 12.5]))
    laid = lay(moved, judge)
    assert laid is not None
    assert laid.misfit.cost == pytest.approx(0.0)
    assert laid.pose.scale == 1.0
    assert laid.pose.matrix @ matrix == pytest.approx(np.eye(3))
    assert laid.solid.box == pytest.approx(np.array([[0.0, 0.0, 0.0], [60.0, 40.0, 30.0]]))


def test_a_solid_of_another_size_is_laid_at_its_scale(judge: Judge) -> None:
    laid = lay(faceted_shape(_PART).mapped(25.4 * np.eye(3), _ORIGIN), judge)
    assert laid is not None
    assert laid.pose.scale == pytest.approx(25.4)
    assert laid.misfit.cost == pytest.approx(0.0)


def test_a_mirrored_solid_fits_in_no_pose(judge: Judge) -> None:
    laid = lay(faceted_shape(_PART).mapped(np.diag([-1.0, 1.0, 1.0]), _ORIGIN), judge)
    assert laid is not None
    assert laid.misfit.share > 0.05


def test_a_stretched_solid_is_told_by_how_much(judge: Judge) -> None:
    laid = lay(faceted_shape(_PART).mapped(np.diag([1.0, 1.03, 1.0]), _ORIGIN), judge)
    assert laid is not None
    assert laid.pose.deviation == pytest.approx([0.0, 0.03, 0.0])


def test_another_part_is_laid_nowhere(judge: Judge) -> None:
    assert lay(faceted_shape(box((0.0, 0.0, 0.0), (60.0, 60.0, 10.0))), judge) is None


def test_a_part_with_something_put_on_is_laid_by_what_fits(judge: Judge) -> None:
    # It stands out of two sides.
    higher = fuse(_PART, box((10.0, 25.0, 29.0), (20.0, 42.0, 34.0)))
    laid = lay(faceted_shape(higher), judge)
    assert laid is not None
    assert laid.pose.deviation == pytest.approx([0.0, 0.05, 4.0 / 30.0])
    assert laid.misfit.share < 0.25
