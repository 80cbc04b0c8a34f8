"""Outlines of views as an exact solid has them, where the sheet leaves one open.

A mask is what the ink encloses.  Where lines end short of a corner, nothing does, though their
directions still tell the solid: then its shadow is the better mask.
"""

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
from gaussiancad_core.model.views import ViewSet

if TYPE_CHECKING:
    from gaussiancad_core.solid.exact import ExactResult

_SPOT = np.ones((5, 5), np.uint8)
"""Pixels that count where mask and shadow differ: narrower strips are the outlines' own noise."""

_DIFFERENT = 0.01
"""Share of the shadow that such pixels make where an outline was open."""


@dataclass(frozen=True, eq=False)
class OutlinedViews:
    """Views, some with the outline of a solid.

    Attributes:
        views: those of the sheet, with whole masks.
        closed: the views whose mask is the solid's.
    """

    views: ViewSet
    closed: tuple[Role, ...] = ()


def with_solid_outlines(views: ViewSet, result: "ExactResult | None") -> OutlinedViews:
    """The views, whose masks are an exact solid's where the two are not alike.

    Args:
        views: of the sheet.
        result: their exact solid, if there is one; only one whose lines are all the sheet's, and
            that has all of them, knows outlines better than the ink.
    """
    if result is None or not result.explains:
        return OutlinedViews(views)
    deflection = DEFLECTION * max(views.size)
    caster = RayCaster(make_mesh(*tessellate(result.shape, deflection, CHORD)))
    outlined, closed = [], []
    for view in views.views:
        depths, _ = first_surface(caster, view, False, views.size)
        shadow = np.isfinite(depths)
        if _alike(view.mask, shadow):
            outlined.append(view)
        else:
            outlined.append(replace(view, mask=shadow))
            closed.append(view.role)
    return OutlinedViews(replace(views, views=tuple(outlined)), tuple(closed))


def _alike(mask: npt.NDArray[np.bool_], shadow: npt.NDArray[np.bool_]) -> bool:
    different = cv2.morphologyEx((mask ^ shadow).astype(np.uint8), cv2.MORPH_OPEN, _SPOT)
    return bool(different.sum() <= _DIFFERENT * shadow.sum())
