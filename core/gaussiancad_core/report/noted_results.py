"""Which notes a solid keeps: what was made from a note, compared with the note."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.kernel.solid_rays import RayCrossings, SolidRays
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.sheet.reading_options import Box

_BESIDE = 0.02
"""Radii inside and outside of a cylinder at which the solid is looked through."""

_SAME = 0.02
"""Share of a hole's radius and depth by which what is made may differ from what its note says."""

_FINE = 1e-4
"""Tolerance of sight lines and of extents as a share of the longest extent."""

_PLACES = 12
_KEPT = 0.5
"""Lines of sight around a hole, and the share of them that must find it: others pass through what
crosses it."""


def kept_notes(holes: Iterable[NotedHole], shape: TopoDS_Shape) -> frozenset[Box]:
    """The boxes of notes whose every cylinder a solid has, px of the upright sheet.

    Args:
        holes: of which notes speak.
        shape: the solid, mm.
    """
    low, high = bounding_box(shape)
    tolerance = _FINE * float(np.max(np.subtract(high, low)))
    by_role: dict[Role, list[NotedHole]] = {}
    for hole in holes:
        by_role.setdefault(hole.role, []).append(hole)
    kept: set[Box] = set()
    broken: set[Box] = set()
    for role, in_view in by_role.items():
        rays = SolidRays(shape, role.frame, tolerance)
        for hole in in_view:
            for step, is_kept in _compared(hole, rays, tolerance):
                (kept if is_kept else broken).update(step.notes)
    return frozenset(kept - broken)


def keeps_thickness(value: float, unseen: Unseen | None, shape: TopoDS_Shape) -> bool:
    """Whether a solid is as thick along the axis that no view shows as a note says, in mm."""
    if unseen is None or unseen.thickness is None:
        return False
    low, high = bounding_box(shape)
    axis = unseen.axis.value
    size = np.subtract(high, low)
    return abs(float(size[axis]) - value) <= _FINE * float(np.max(size))


def _compared(
    hole: NotedHole, rays: SolidRays, tolerance: float
) -> Iterator[tuple[HoleStep, bool]]:
    """Each cylinder of a hole, and whether the solid has it."""
    if not hole.steps:
        return
    around = rays.crossings_at(_circle(hole, hole.steps[-1].diameter, 1.0 + _BESIDE))
    for step in hole.steps:
        inner = rays.crossings_at(_circle(hole, step.diameter, 1.0 - _BESIDE))
        outer = rays.crossings_at(_circle(hole, step.diameter, 1.0 + _BESIDE))
        slack = _SAME * max(step.depth or 0.0, step.diameter / 2.0) + tolerance
        kept = [
            _has(step, inside, outside, face, slack)
            for inside, outside, face in zip(inner, outer, around, strict=True)
        ]
        yield step, float(np.mean(kept)) >= _KEPT


def _circle(hole: NotedHole, diameter: float, share: float) -> np.ndarray:
    """(n, 2) mm in the view, places on a circle around a hole."""
    angles = 0.1 + np.arange(_PLACES) * 2.0 * np.pi / _PLACES
    return hole.centre + share * diameter / 2.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _has(
    step: HoleStep, inside: RayCrossings, outside: RayCrossings, face: RayCrossings, slack: float
) -> bool:
    """Whether a cylinder is empty as far as its note says, and no farther, and stands in material.

    Args:
        step: of the hole.
        inside, outside: what is met on either side of the cylinder.
        face: what is met beside the hole's widest cylinder.
        slack: mm.
    """
    intervals = _material(face)
    if not intervals or not len(outside.depth):
        return False
    if step.depth is None:
        return any(
            _is_void(inside, low + slack, high - slack) and not _is_void(outside, low, high)
            for low, high in intervals
        )
    return any(
        _is_void(inside, low, floor - slack)
        and not _is_void(inside, floor - slack, floor + slack)
        and not _is_void(outside, low, floor - slack)
        for low, floor in ((low, low + step.depth) for low, _ in intervals)
    )


def _material(crossings: RayCrossings) -> Sequence[tuple[float, float]]:
    """mm from and to which a line of sight lies in material."""
    depths = crossings.depth.tolist()
    return list(zip(depths[::2], depths[1::2], strict=False))


def _is_void(crossings: RayCrossings, low: float, high: float) -> bool:
    """Whether a line of sight lies in no material between two depths."""
    return not any(start < high and end > low for start, end in _material(crossings))
