"""How far a mesh's shadows are from the masks of the views."""

from dataclasses import replace

import numpy as np

from gaussiancad_core.lines.mesh_rays import RayCaster, RayGrid
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import View, ViewSet


def silhouette_difference(mesh: TriangleMesh, views: ViewSet) -> float:
    """Pixels that either a mesh's shadow has or the mask, as a share of the mask's.

    Args:
        mesh: mm.
        views: whose masks are compared, in parallel projection.

    Returns:
        The mean over the views, 0 if all are alike.
    """
    caster = RayCaster(mesh)
    shares = []
    for view in views.views:
        shadow = caster.first_hits(_pixels(view)).triangle >= 0
        shares.append((shadow ^ view.mask).sum() / max(1, view.mask.sum()))
    return float(np.mean(shares))


def _pixels(view: View) -> RayGrid:
    """The pixels of a view's mask."""
    height, width = view.mask.shape
    (left, top), pitch = view.origin, view.mm_per_pixel
    area = (left, top - height * pitch, left + width * pitch, top)
    return replace(RayGrid.of_view(view.role, area, pitch), width=width, height=height)
