"""Depths of solids in views: where they lie, what is one region, and how sure it is."""

from collections.abc import Callable

import numpy as np
import pytest

from gaussiancad_core.hull.depth_maps import CastSolid, confidence, depth_map_of, trusted
from gaussiancad_core.hull.visual_hull import DepthMap
from gaussiancad_core.lines.line_agreement import match_lines
from gaussiancad_core.lines.line_points import lines_of_strokes
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import View, ViewSet
from sample_parts.modelling import box, cut, cylinder

Viewed = Callable[..., ViewSet]
SIZE = (40.0, 30.0, 20.0)
BLOCK = box((0, 0, 0), SIZE)
POCKETED = cut(BLOCK, box((10, 8, 12), (30, 22, 21)), cylinder(Axis.Z, (20, 15), 4, -1, 5))


def _at(depth_map: DepthMap, view: View, right: float, up: float) -> tuple[int, float]:
    """Region and depth at a point of a view."""
    x, y = view.to_pixels(np.array([[right, up]]))[0]
    return int(depth_map.regions[int(y), int(x)]), float(depth_map.depths[int(y), int(x)])


def test_depths_count_from_the_side_that_is_nearest(viewed: Viewed) -> None:
    top = viewed(POCKETED)[Role.TOP]
    solid = CastSolid(POCKETED, SIZE)
    above, below = (depth_map_of([solid], top, behind) for behind in (False, True))
    assert (above.behind, below.behind) == (False, True)
    assert _at(above, top, 12, 10)[1] == pytest.approx(8.0, abs=1e-4)
    assert _at(above, top, 3, 3)[1] == pytest.approx(0.0, abs=1e-4)
    assert _at(below, top, 20, 15)[1] == pytest.approx(5.0, abs=1e-4)
    assert _at(below, top, 3, 3)[1] == pytest.approx(0.0, abs=1e-4)


@pytest.mark.parametrize("role", list(Role))
def test_every_role_sees_its_own_side(viewed: Viewed, role: Role) -> None:
    step = cut(BLOCK, box((-1, -1, 14), (6, 31, 21)), box((-1, -1, -1), (41, 3, 21)))
    moved = viewed(step, (role,))
    view = moved[role]
    axis, sign = role.frame.look_axis
    depths = depth_map_of([CastSolid(step, SIZE)], view, False).depths[view.mask]
    # The front is cut off by 3; the upper left edge lies 6 in from the left and 6 down from above.
    deepest = {
        (Axis.Y, 1): 3.0,
        (Axis.Y, -1): 0.0,
        (Axis.X, 1): 6.0,
        (Axis.X, -1): 0.0,
        (Axis.Z, 1): 0.0,
        (Axis.Z, -1): 6.0,
    }
    assert float(depths.max()) == pytest.approx(deepest[axis, sign], abs=1e-4)


def test_regions_are_the_patches_that_a_view_sees(viewed: Viewed) -> None:
    top = viewed(POCKETED)[Role.TOP]
    solid = CastSolid(POCKETED, SIZE)
    above, below = (depth_map_of([solid], top, behind) for behind in (False, True))
    assert set(np.unique(above.regions)) == {0, 1, 2}
    assert _at(above, top, 12, 10)[0] != _at(above, top, 3, 3)[0]
    floor = above.regions == _at(above, top, 20, 15)[0]
    assert floor.sum() * 0.01 == pytest.approx(20 * 14, rel=0.01)
    bore = below.regions == _at(below, top, 20, 15)[0]
    assert bore.sum() * 0.01 == pytest.approx(np.pi * 16, rel=0.02)


def test_what_one_of_two_solids_fills_is_not_void(viewed: Viewed) -> None:
    top = viewed(POCKETED)[Role.TOP]
    shallow = cut(BLOCK, box((10, 8, 12), (30, 22, 21)), box((2, 2, 15), (6, 6, 21)))
    deep = cut(BLOCK, box((10, 8, 5), (30, 22, 21)))
    both = depth_map_of([CastSolid(solid, SIZE) for solid in (deep, shallow)], top, False)
    assert _at(both, top, 20, 15)[1] == pytest.approx(8.0, abs=1e-4)
    assert _at(both, top, 4, 4)[1] == pytest.approx(0.0, abs=1e-4)


def test_regions_without_lines_on_the_sheet_are_not_trusted(viewed: Viewed) -> None:
    two = cut(BLOCK, box((4, 8, 12), (14, 22, 21)), box((24, 8, 12), (34, 22, 21)))
    one = cut(BLOCK, box((4, 8, 12), (14, 22, 21)))
    view = viewed(two)[Role.TOP]
    sheet = viewed(one)[Role.TOP].strokes
    matched = match_lines(sheet, lines_of_strokes(view.strokes, 0.05), 0.2)
    depth_map = depth_map_of([CastSolid(two, SIZE)], view, False)
    drawn, invented = _at(depth_map, view, 9, 15)[0], _at(depth_map, view, 29, 15)[0]
    sure = confidence(depth_map, view, matched)
    assert sure.shares[drawn] == pytest.approx(1.0)
    assert sure.shares[invented] == pytest.approx(0.0)
    kept = trusted(depth_map, sure, 0.8)
    assert _at(kept, view, 9, 15)[0] == drawn
    assert _at(kept, view, 29, 15)[0] == 0
