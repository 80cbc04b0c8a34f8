from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
import trimesh

from gaussiancad_core.lines.line_agreement import Agreement, match_lines
from gaussiancad_core.lines.mesh_lines import redraw_mesh
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke

_PITCH = 0.1


def _rectangle(x0: float, y0: float, x1: float, y1: float) -> list[Stroke]:
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]
    return [Segment(start, end, Linetype.VISIBLE) for start, end in pairwise(corners)]


def _hidden(*points: tuple[float, float]) -> list[Stroke]:
    return [Segment(start, end, Linetype.HIDDEN) for start, end in pairwise(points)]


_BLIND_HOLE = {
    Role.FRONT: _rectangle(0, 0, 40, 20) + _hidden((19, 20), (19, 7), (31, 7), (31, 20)),
    Role.REAR: _rectangle(-40, 0, 0, 20) + _hidden((-19, 20), (-19, 7), (-31, 7), (-31, 20)),
    Role.RIGHT: _rectangle(0, 0, 30, 20) + _hidden((6, 20), (6, 7), (18, 7), (18, 20)),
    Role.LEFT: _rectangle(-30, 0, 0, 20) + _hidden((-6, 20), (-6, 7), (-18, 7), (-18, 20)),
    Role.TOP: [*_rectangle(0, 0, 40, 30), Arc((25, 12), 6, 0, 2 * np.pi, Linetype.VISIBLE)],
    Role.BOTTOM: [*_rectangle(0, -30, 40, 0), Arc((25, -12), 6, 0, 2 * np.pi, Linetype.HIDDEN)],
}


@pytest.mark.parametrize("role", list(Role))
def test_a_block_with_a_blind_hole_is_drawn_exactly(blind_hole: TriangleMesh, role: Role) -> None:
    lines = redraw_mesh(blind_hole, role, _PITCH)
    # Lines run between pixels: half a pixel's diagonal is the most that they can be off.
    found = match_lines(_BLIND_HOLE[role], lines, 1.5 * _PITCH).agreement
    assert found == Agreement(1.0, 1.0, pytest.approx(1.0, abs=0.01), 1.0)
    assert bool(len(lines.hidden.points)) == (role is not Role.TOP)


@pytest.mark.parametrize("role", list(Role))
def test_a_rounded_surface_is_drawn_within_its_rounding(
    rounded_block: TriangleMesh, role: Role
) -> None:
    lines = redraw_mesh(rounded_block, role, _PITCH)
    found = match_lines(_BLIND_HOLE[role], lines, 0.5).agreement
    assert found.worst > 0.97


def test_lines_are_one_wide(blind_hole: TriangleMesh) -> None:
    lines = redraw_mesh(blind_hole, Role.FRONT, _PITCH)
    assert lines.visible.lengths.sum() == pytest.approx(120.0, rel=0.01)
    assert lines.hidden.lengths.sum() == pytest.approx(38.0, rel=0.03)


def test_a_pocket_behind_an_equal_one_is_not_drawn(box: Callable[..., TriangleMesh]) -> None:
    """Its hidden lines lie under the visible ones of the pocket in front."""
    block = box((0, 0, 0), (30, 20, 20)).to_trimesh()
    pockets = [box((5, y0, 5), (15, y1, 12)).to_trimesh() for y0, y1 in ((-1, 4), (15, 21))]
    solid = trimesh.boolean.difference([block, *pockets])
    lines = redraw_mesh(make_mesh(solid.vertices, solid.faces), Role.FRONT, _PITCH)
    assert not len(lines.hidden.points)
    expected = _rectangle(0, 0, 30, 20) + _rectangle(5, 5, 15, 12)
    assert match_lines(expected, lines, 1.5 * _PITCH).agreement.worst == 1.0


def test_a_slanted_edge_and_a_low_roof_are_drawn() -> None:
    """A roof whose planes meet under 160 degrees: the ridge is a line."""
    rise = 10 * np.tan(np.radians(10.0))
    outline = [[0, 0], [20, 0], [20, 5], [10, 5 + rise], [0, 5]]
    prism = trimesh.creation.extrude_polygon(_polygon(outline), 12.0)
    vertices = prism.vertices[:, [0, 2, 1]] * [1, -1, 1] + [0, 12, 0]
    mesh = make_mesh(vertices, prism.faces).oriented_outward()
    lines = redraw_mesh(mesh, Role.TOP, 0.05)
    ridge = Segment((10, 0), (10, 12), Linetype.VISIBLE)
    expected = [*_rectangle(0, 0, 20, 12), ridge]
    assert match_lines(expected, lines, 0.1).agreement.worst == 1.0


def test_the_facets_of_a_cylinder_are_no_lines() -> None:
    rod = trimesh.creation.cylinder(5.0, 30.0, sections=48)
    rod.apply_translation((5, 5, 15))
    lines = redraw_mesh(make_mesh(rod.vertices, rod.faces), Role.FRONT, 0.1)
    assert match_lines(_rectangle(0, 0, 10, 30), lines, 0.2).agreement.worst == 1.0
    assert not len(lines.hidden.points)


def test_a_fine_pitch_is_made_coarser(blind_hole: TriangleMesh) -> None:
    lines = redraw_mesh(blind_hole, Role.TOP, 1e-4)
    assert lines.visible.lengths[0] == pytest.approx(40 / 900)


def test_drawing_is_deterministic(rounded_block: TriangleMesh) -> None:
    first, second = (redraw_mesh(rounded_block, Role.RIGHT, _PITCH) for _ in range(2))
    assert (first.visible.points == second.visible.points).all()
    assert (first.hidden.points == second.hidden.points).all()


def _polygon(outline: list[list[float]]) -> "object":
    from shapely.geometry import Polygon

    return Polygon(outline)
