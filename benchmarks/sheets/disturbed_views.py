"""Views of a part made straight from its solid, and what can go wrong with their masks."""

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt
from OCP.TopoDS import TopoDS_Shape

from benchmarks.sheets.clean_sheets import ROLES
from gaussiancad_core.evidence.mask_outlines import signed_distance
from gaussiancad_core.kernel.brep import moved_to_origin, tessellate
from gaussiancad_core.lines.mesh_rays import RayCaster, RayGrid
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.model.views import View, ViewSet

LONGEST_PX = 500
"""px of the longest edge: what a view has on a sheet of 1920 px."""

_MARGIN_PX = 12
_WAVE_PX = 4.0
"""Standard deviation in px of what smooths the noise of an outline."""

_BITES = 3
_BITE_PX = (6, 14)
"""Bites in each outline, and their radii."""

_COLOUR = (120, 160, 210)

Mask = npt.NDArray[np.bool_]
Disturbance = Callable[[Mask, np.random.Generator], Mask]


@dataclass(frozen=True)
class Case:
    """What is wrong with all masks.

    Attributes:
        name: of the row.
        disturb: a mask and chance to another mask.
    """

    name: str
    disturb: Disturbance


def cases() -> tuple[Case, ...]:
    """Noise of 0 to 4 px, views that disagree by 1 and 2 px, broken outlines."""
    noise = [Case(f"noise {px} px", _noise(float(px))) for px in range(5)]
    shifts = [Case(f"views off by {px} px", _shifted(px)) for px in (1, 2)]
    return (*noise, *shifts, Case("broken outlines", _bitten))


def solid_mesh(shape: TopoDS_Shape) -> TriangleMesh:
    """The solid's surface; its box starts at the origin."""
    return make_mesh(*tessellate(moved_to_origin(shape), 0.005, 0.05))


def views_of(mesh: TriangleMesh, case: Case, seed: int) -> ViewSet:
    """Front, top and right views with disturbed masks, uniformly coloured."""
    size = tuple(float(extent) for extent in mesh.bounds[1])
    pitch = max(size) / LONGEST_PX
    caster = RayCaster(mesh)
    random = np.random.default_rng(seed)
    return ViewSet(tuple(_view(caster, role, pitch, case, random) for role in ROLES), size)


def _view(
    caster: RayCaster, role: Role, pitch: float, case: Case, random: np.random.Generator
) -> View:
    flat = caster.mesh.vertices @ np.array([role.frame.right, role.frame.up], dtype=float).T
    low = flat.min(axis=0) - _MARGIN_PX * pitch
    high = flat.max(axis=0) + _MARGIN_PX * pitch
    grid = RayGrid.of_view(role, (low[0], low[1], high[0], high[1]), pitch)
    mask = case.disturb(caster.first_hits(grid).triangle >= 0, random)
    colour = np.where(mask[..., None], np.uint8(_COLOUR), np.uint8(255))
    return View(role, (0, 0, 1, 1), (), mask, colour, (grid.left, grid.top), pitch)


def _noise(amplitude: float) -> Disturbance:
    """The outline moves to and fro by a smooth field of this standard deviation in px."""

    def disturb(mask: Mask, random: np.random.Generator) -> Mask:
        if amplitude == 0.0:
            return mask
        field = cv2.GaussianBlur(random.standard_normal(mask.shape), (0, 0), _WAVE_PX)
        return signed_distance(mask, 1.0) + amplitude * field / field.std() < 0.0

    return disturb


def _shifted(distance: int) -> Disturbance:
    """Each view lies beside its place, by as much in either direction, in one of eight ways."""

    def disturb(mask: Mask, random: np.random.Generator) -> Mask:
        ways = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if x or y]
        across, down = ways[random.integers(len(ways))]
        return np.roll(mask, (distance * down, distance * across), axis=(0, 1))

    return disturb


def _bitten(mask: Mask, random: np.random.Generator) -> Mask:
    """Bites out of the outline, as gaps leave them, and as much that does not belong there."""
    found = mask.astype(np.uint8)
    edge = np.argwhere(cv2.morphologyEx(found, cv2.MORPH_GRADIENT, np.ones((3, 3), np.uint8)))
    for number in range(2 * _BITES):
        y, x = edge[random.integers(len(edge))]
        radius = int(random.integers(*_BITE_PX))
        cv2.circle(found, (int(x), int(y)), radius, number % 2, cv2.FILLED)
    return found > 0
