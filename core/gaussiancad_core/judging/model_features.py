"""Bores, round and flat faces along the axes of a solid, as its triangles tell them.

They are what single changes of a model are made of, whatever file it came from.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats, Numbers
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE

_ALONG = 1e-3
"""Largest share of a normal along an axis for a face to run along it."""

_ROUND = 3e-3
"""Share of a radius by which the corners of a round face may lie beside its circle."""

_WHOLE = 5.5
"""Radians of its circle that the steps of a bore go round together at least."""

_TOUCH = 1e-4
"""Share of the longest extent within which two places are one."""


@dataclass(frozen=True)
class RoundFace:
    """A cylinder along an axis, whole or a part of one.

    Attributes:
        axis: that it runs along.
        centre: (2,) mm in the plane across.
        radius: mm.
        low, high: mm along the axis.
        turn: radians of its circle that it goes round.
        is_hole: whether the material is around it.
    """

    axis: Axis
    centre: tuple[float, float]
    radius: float
    low: float
    high: float
    turn: float
    is_hole: bool


@dataclass(frozen=True)
class Bore:
    """A round hole along an axis, with all its steps.

    Attributes:
        axis: that it runs along.
        centre: (2,) mm in the plane across.
        radius: mm, of its narrowest step.
        widest: mm, of its widest step.
        low, high: mm along the axis.
    """

    axis: Axis
    centre: tuple[float, float]
    radius: float
    widest: float
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class FlatFace:
    """A flat face across an axis.

    Attributes:
        axis: that it lies across.
        at: mm along it.
        side: +1 where the material lies below, -1 where it lies above.
        triangles: numbers of the solid's triangles.
        area: mm^2.
    """

    axis: Axis
    at: float
    side: int
    triangles: Numbers
    area: float


def bores_of(solid: FacetedSolid) -> tuple[Bore, ...]:
    """The round holes of a solid along the axes, the widest first."""
    touch = _TOUCH * float(solid.extent.max())
    steps: dict[Axis, list[RoundFace]] = {}
    for face in round_faces(solid):
        if face.is_hole:
            steps.setdefault(face.axis, []).append(face)
    normals, areas = _normals(solid)
    found = [
        _with_cones(bore, solid, normals, areas, touch)
        for of_axis in steps.values()
        for bore in _bores(of_axis, touch)
    ]
    return tuple(sorted(found, key=lambda bore: -bore.widest))


def _with_cones(
    bore: Bore, solid: FacetedSolid, normals: Floats, areas: Floats, touch: float
) -> Bore:
    """The same bore with the cones that go on at its ends: countersinks, tips of drills."""
    corners = solid.vertices[solid.triangles]
    along = corners[..., bore.axis.value]
    away = corners[..., list(IN_PLANE[bore.axis])] - np.array(bore.centre)
    radius = np.hypot(away[..., 0], away[..., 1])
    inward = (away.mean(axis=1) * normals[:, list(IN_PLANE[bore.axis])]).sum(axis=1) < 0.0
    grown = True
    while grown:
        grown = False
        near = (along.min(axis=1) <= bore.high + touch) & (along.max(axis=1) >= bore.low - touch)
        near &= (radius.min(axis=1) <= bore.widest + touch) & inward & (areas > 0.0)
        for surface in np.unique(solid.surfaces[near]).tolist():
            chosen = (solid.surfaces == surface) & (areas > 0.0)
            low, high = float(along[chosen].min()), float(along[chosen].max())
            beyond = low < bore.low - touch or high > bore.high + touch
            if beyond and inward[chosen].all() and _is_cone(along[chosen], radius[chosen], touch):
                widest = max(bore.widest, float(radius[chosen].max()))
                bore = replace(
                    bore, widest=widest, low=min(bore.low, low), high=max(bore.high, high)
                )
                grown = True
    return bore


def _is_cone(along: Floats, radius: Floats, touch: float) -> bool:
    """Whether the radii of places grow evenly along an axis."""
    fit = np.polyfit(along.reshape(-1), radius.reshape(-1), 1)
    return bool(np.abs(np.polyval(fit, along) - radius).max() <= touch)


def flat_faces(solid: FacetedSolid) -> tuple[FlatFace, ...]:
    """The flat faces of a solid across the axes, the largest first."""
    normals, areas = _normals(solid)
    found = []
    for surface in range(len(solid.smooth)):
        of_surface = np.flatnonzero((solid.surfaces == surface) & (areas > 0.0))
        for axis in Axis:
            along = normals[of_surface, axis.value] if len(of_surface) else np.zeros(0)
            if not len(along) or np.abs(along).min() < 1.0 - _ALONG:
                continue
            for side in (1, -1):
                chosen = of_surface[side * along > 0.0]
                if len(chosen):
                    at = float(solid.vertices[solid.triangles[chosen], axis.value].mean())
                    area = float(areas[chosen].sum())
                    found.append(FlatFace(axis, at, side, chosen, area))
    return tuple(sorted(found, key=lambda face: -face.area))


def _normals(solid: FacetedSolid) -> tuple[Floats, Floats]:
    """(m, 3) outward unit normals of the triangles, and (m,) their areas in mm^2."""
    a, b, c = (solid.vertices[solid.triangles[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    length = np.linalg.norm(across, axis=1)
    return across / np.maximum(length, 1e-300)[:, None], length / 2.0


def round_faces(solid: FacetedSolid) -> Iterator[RoundFace]:
    """The cylinders of a solid along the axes, whole or parts of one."""
    normals, areas = _normals(solid)
    for surface in range(len(solid.smooth)):
        chosen = np.flatnonzero((solid.surfaces == surface) & (areas > 0.0))
        if len(chosen) < 2:
            continue
        for axis in Axis:
            if np.abs(normals[chosen, axis.value]).max() < _ALONG:
                yield from _round_face(solid, normals, chosen, axis)


def _round_face(
    solid: FacetedSolid, normals: Floats, chosen: Numbers, axis: Axis
) -> Iterator[RoundFace]:
    """A surface that runs along an axis, where it is a cylinder."""
    plane = list(IN_PLANE[axis])
    points = solid.vertices[solid.triangles[chosen]].reshape(-1, 3)
    flat = points[:, plane]
    matrix = np.column_stack([2.0 * flat, np.ones(len(flat))])
    values, _, rank, _ = np.linalg.lstsq(matrix, (flat**2).sum(axis=1), rcond=None)
    if rank < 3:
        return
    centre = values[:2]
    radius = float(np.sqrt(max(values[2] + centre @ centre, 0.0)))
    if radius <= 0.0 or np.abs(np.hypot(*(flat - centre).T) - radius).max() > _ROUND * radius:
        return
    middles = flat.reshape(-1, 3, 2).mean(axis=1) - centre
    # Where normals point away from the axis the material is within.
    outward = (middles * normals[chosen][:, plane]).sum(axis=1)
    angles = np.sort(np.arctan2(*(flat - centre).T[::-1]))
    gaps = np.diff(np.append(angles, angles[0] + 2.0 * np.pi))
    along = points[:, axis.value]
    # Of a whole circle the largest gap is that between two corners of it.
    turn = 2.0 * np.pi - (float(gaps.max()) if gaps.max() > 0.3 else 0.0)
    low, high = float(along.min()), float(along.max())
    at = float(centre[0]), float(centre[1])
    yield RoundFace(axis, at, radius, low, high, turn, bool(outward.max() < 0.0))


def _bores(faces: list[RoundFace], touch: float) -> Iterator[Bore]:
    """The faces about one line that touch each other, as bores."""
    left = sorted(faces, key=lambda face: face.low)
    while left:
        run = [left.pop(0)]
        rest = []
        for face in left:
            near = np.hypot(*np.subtract(face.centre, run[0].centre)) <= touch
            if near and face.low <= max(each.high for each in run) + touch:
                run.append(face)
            else:
                rest.append(face)
        left = rest
        turns: dict[int, float] = {}
        for face in run:
            step = round(face.radius / touch)
            turns[step] = turns.get(step, 0.0) + face.turn
        whole = [face.radius for face in run if turns[round(face.radius / touch)] >= _WHOLE]
        if whole:
            widest = max(face.radius for face in run)
            low, high = min(face.low for face in run), max(face.high for face in run)
            yield Bore(run[0].axis, run[0].centre, min(whole), widest, low, high)
