"""Outlines of views as an exact solid has them, where the sheet leaves one open.

A mask is what the ink of the part encloses.  Where lines end short of a corner, or a piece of one
was taken for annotation, nothing does, though the others still tell the solid: then its shadow is
the better mask.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.hull.depth_maps import CHORD, DEFLECTION, first_surface
from gaussiancad_core.kernel.brep import tessellate
from gaussiancad_core.lines.mesh_rays import RayCaster
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.meshes import make_mesh
from gaussiancad_core.model.views import View, ViewSet
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.registration.view_registration import Placement

if TYPE_CHECKING:
    from gaussiancad_core.solid.exact import ExactResult

_SPOT = np.ones((5, 5), np.uint8)
"""Pixels that count where mask and shadow differ: narrower strips are the outlines' own noise."""

_DIFFERENT = 0.01
"""Share of the shadow that such pixels make where an outline was open."""


_INKED = 0.98
"""Share of a shadow's outline that lies on ink of the sheet where that encloses it."""


@dataclass(frozen=True, eq=False)
class PlacedInk:
    """All ink of a sheet, annotations too, and where the views stand on it.

    Attributes:
        sheet: upright.
        placements: sheet px -> plane mm of each view.
    """

    sheet: CleanSheet
    placements: Mapping[Role, Placement]


@dataclass(frozen=True, eq=False)
class OutlinedViews:
    """Views, some with the outline of a solid.

    Attributes:
        views: those of the sheet, with whole masks.
        closed: the views whose mask is the solid's.
    """

    views: ViewSet
    closed: tuple[Role, ...] = ()


def with_solid_outlines(
    views: ViewSet, result: "ExactResult | None", ink: PlacedInk | None = None
) -> OutlinedViews:
    """The views, whose masks are an exact solid's where the two are not alike.

    A solid whose lines are all the sheet's, and that has all of them, knows outlines better than
    the part's ink.  So does any solid whose outline runs along the sheet's ink all around a mask:
    that mask leaked where a line was taken for annotation.

    Args:
        views: of the sheet.
        result: their exact solid, if there is one.
        ink: of the sheet; without it only a solid that explains all lines counts.
    """
    if result is None or result.shape is None or not (result.explains or ink):
        return OutlinedViews(views)
    deflection = DEFLECTION * max(views.size)
    caster = RayCaster(make_mesh(*tessellate(result.shape, deflection, CHORD)))
    outlined, closed = [], []
    for view in views.views:
        depths, _ = first_surface(caster, view, False, views.size)
        shadow = np.isfinite(depths)
        is_better = result.explains or (ink is not None and _is_enclosed(view, shadow, ink))
        if _alike(view.mask, shadow) or not is_better:
            outlined.append(view)
        else:
            outlined.append(replace(view, mask=shadow))
            closed.append(view.role)
    return OutlinedViews(replace(views, views=tuple(outlined)), tuple(closed))


def _is_enclosed(view: View, shadow: npt.NDArray[np.bool_], ink: PlacedInk) -> bool:
    """Whether the outline of a shadow runs along ink, and the view's mask lies within it."""
    contours, _ = cv2.findContours(
        shadow.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE
    )
    if not contours:
        return False
    # An outline that is open may leave what the hole in it encloses.
    filled = cv2.drawContours(np.zeros(shadow.shape, np.uint8), contours, -1, 1, cv2.FILLED)
    outside = cv2.morphologyEx((view.mask & (filled == 0)).astype(np.uint8), cv2.MORPH_OPEN, _SPOT)
    if outside.sum() > _DIFFERENT * shadow.sum():
        return False
    pixels = np.concatenate([contour[:, 0] for contour in contours]) + 0.5
    plane = view.origin + pixels * view.mm_per_pixel * (1.0, -1.0)
    columns, rows = np.floor(ink.placements[view.role].to_sheet(plane)).astype(int).T
    height, width = ink.sheet.ink.shape
    away = cv2.distanceTransform((~ink.sheet.ink).astype(np.uint8), cv2.DIST_L2, 5)
    there = away[np.clip(rows, 0, height - 1), np.clip(columns, 0, width - 1)]
    return bool((there <= ink.sheet.stroke_width).mean() >= _INKED)


def _alike(mask: npt.NDArray[np.bool_], shadow: npt.NDArray[np.bool_]) -> bool:
    different = cv2.morphologyEx((mask ^ shadow).astype(np.uint8), cv2.MORPH_OPEN, _SPOT)
    return bool(different.sum() <= _DIFFERENT * shadow.sum())
