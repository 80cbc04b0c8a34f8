"""What lines of sight meet once something is added to a solid, or cut from it."""

from enum import IntEnum

import numpy as np

from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats, Numbers
from gaussiancad_core.judging.lines_of_sight import Met
from gaussiancad_core.judging.sight_kernels import merge
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE

_SIDES = 96
"""Sides of a cylinder."""


class Change(IntEnum):
    """What is done with a tool."""

    ADD = 0
    CUT = 1


def changed(met: Met, tool: Met, change: Change, same: float) -> Met:
    """What is met of a solid with a tool added to it, or cut from it.

    Args:
        met: of the solid.
        tool: of the tool, by the same lines of sight; its surfaces are numbered on from the
            solid's, or those of the solid where both lie on one.
        change: what is done.
        same: mm within which two crossings are one.
    """
    count = met.count.copy()
    surface, depth = met.surface.copy(), met.depth.copy()
    touched = np.flatnonzero(tool.count > 0)
    merge(
        (met.count, met.surface, met.depth),
        (tool.count, tool.surface, tool.depth),
        touched,
        (int(change), same),
        (count, surface, depth),
    )
    return Met(count, surface, depth)


def cylinder(
    axis: Axis,
    centre: tuple[float, float],
    radius: float,
    ends: tuple[float, float],
    surfaces: tuple[int, int, int],
) -> FacetedSolid:
    """A cylinder along an axis, mm.

    Args:
        axis: that it runs along.
        centre: in the plane across.
        radius: mm.
        ends: low and high, mm.
        surfaces: numbers of the wall, the low and the high end.
    """
    angles = 2.0 * np.pi * (np.arange(_SIDES) + 0.5) / _SIDES
    ring = np.array(centre) + radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    points = np.zeros((2, _SIDES, 3))
    points[:, :, list(IN_PLANE[axis])] = ring
    points[0, :, axis.value], points[1, :, axis.value] = ends
    one = np.arange(_SIDES)
    two = (one + 1) % _SIDES
    wall = np.concatenate(
        [np.stack([one, two, one + _SIDES], 1), np.stack([two, two + _SIDES, one + _SIDES], 1)]
    )
    fan = np.stack([np.zeros(_SIDES - 2, int), one[1:-1], one[2:]], axis=1)
    triangles = np.concatenate([wall, fan, fan + _SIDES])
    numbers = np.repeat(surfaces, [2 * _SIDES, _SIDES - 2, _SIDES - 2])
    return _tool(points.reshape(-1, 3), triangles, numbers)


def extruded(
    solid: FacetedSolid, triangles: Numbers, axis: Axis, to: float, surfaces: tuple[int, int]
) -> FacetedSolid:
    """What a flat face of a solid sweeps on its way along an axis.

    The face keeps its surface where it starts, and its walls those of the faces beside it that run
    along the axis.

    Args:
        solid: mm.
        triangles: of the face.
        axis: across the face.
        to: mm along the axis.
        surfaces: numbers of the surface at its other end, and of other walls.
    """
    corners = solid.triangles[triangles]
    directed = corners[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    ordered = np.sort(directed, axis=1)
    _, index, counts = np.unique(ordered, axis=0, return_index=True, return_counts=True)
    border = directed[index[counts == 1]]
    walls = _walls_beside(solid, triangles, border, axis, surfaces[1])
    used, local = np.unique(corners, return_inverse=True)
    local = local.reshape(-1, 3)
    start = solid.vertices[used]
    end = start.copy()
    end[:, axis.value] = to
    shift = len(used)
    one, two = (np.searchsorted(used, border[:, k]) for k in (0, 1))
    sides = np.concatenate(
        [np.stack([one, two, one + shift], 1), np.stack([two, two + shift, one + shift], 1)]
    )
    numbers = np.concatenate(
        [solid.surfaces[triangles], np.full(len(local), surfaces[0]), walls, walls]
    )
    return _tool(np.vstack([start, end]), np.concatenate([local, local + shift, sides]), numbers)


def _walls_beside(
    solid: FacetedSolid, face: Numbers, border: Numbers, axis: Axis, other: int
) -> Numbers:
    """(b,) surfaces of the faces along an axis at the border of a face; ``other`` elsewhere."""
    rest = np.setdiff1d(np.arange(len(solid.triangles)), face)
    directed = solid.triangles[rest][:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    count = len(solid.vertices)
    keys = np.sort(directed, axis=1) @ np.array([count, 1])
    order = np.argsort(keys)
    wanted = np.sort(border, axis=1) @ np.array([count, 1])
    place = np.minimum(np.searchsorted(keys[order], wanted), len(keys) - 1)
    triangle = rest[order[place] // 3]
    a, b, c = (solid.vertices[solid.triangles[triangle, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    length = np.maximum(np.linalg.norm(across, axis=1), 1e-300)
    upright = np.abs(across[:, axis.value]) < 1e-3 * length
    known = (keys[order[place]] == wanted) & upright
    return np.where(known, solid.surfaces[triangle], other)


def _tool(vertices: Floats, triangles: Numbers, surfaces: Numbers) -> FacetedSolid:
    none = np.zeros(0, int)
    return FacetedSolid(vertices, triangles, surfaces, none, np.zeros((0, 2, 3)), none)
