"""The hull with its pockets: carved by the depths of the exact solid's surfaces.

Masks alone leave pockets filled.  Where an exact solid was found, the depths of its first and last
surface in each view say what is void.  The surer the solid, the more is carved: of a verified one
everything, of others what is bounded by lines that the sheet has, and what all alternatives leave
empty.  A carved hull is taken only if it still fills the masks, and its lines agree with the
sheet's no less than those of the plain hull.
"""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.axes import Role
from gaussiancad_core.cameras import Camera, CameraModel
from gaussiancad_core.hull import Relief, visual_hull
from gaussiancad_core.meshes import TriangleMesh
from gaussiancad_core.modes import Status
from gaussiancad_core.reliefs import CastSolid, confidence, first_surface, relief_of, trusted
from gaussiancad_core.verification.agreement import match_lines
from gaussiancad_core.verification.rays import RayCaster
from gaussiancad_core.verification.redraw import RedrawSettings, redraw_mesh
from gaussiancad_core.views import View, ViewSet

if TYPE_CHECKING:
    from gaussiancad_core.solid.exact import ExactResult

_LEAST_CONFIDENCE = 0.8
"""Share of a region's lines that the sheet must have for its depth to be believed."""

_SLACK_PX = 3.0
"""px by which the solid must lie deeper than the hull for a region to be carved."""

_SPOT = np.ones((5, 5), np.uint8)
"""Pixels that count where hulls and solids differ: narrower strips are the outlines' own noise."""

_PIXELS = 420
"""Longest side in px of the drawings that are compared."""

_TOLERANCE = 2.5
"""px of those drawings within which lines agree."""

_WORSE = 0.005
"""Share of the lines by which a carved hull may agree less: the noise of its drawing."""

_Ends = dict[tuple[Role, bool], npt.NDArray[np.float32]]
"""(h, w) depth in mm of the plain hull's first surface, from the front and from behind of views."""


@dataclass(frozen=True, eq=False)
class CarvedHull:
    """A hull, and whether it was carved.

    Attributes:
        mesh: watertight, mm.
        source: status of the solid that it was carved from; None if it was not carved.
        regions: number of regions that were carved.
        doubted: number of regions that were left, as the sheet lacks what bounds them.
        refused: why a carved hull was not taken; empty if it was, or there was none.
    """

    mesh: TriangleMesh
    source: Status | None = None
    regions: int = 0
    doubted: int = 0
    refused: str = ""


def carved_hull(
    views: ViewSet, cameras: tuple[Camera, ...], result: "ExactResult | None"
) -> CarvedHull:
    """The hull of the views, carved where a solid was found.

    Args:
        views: two to six.
        cameras: one for each view; with others than orthographic ones the hull stays plain.
        result: the exact solid of these views, if there is one.

    Raises:
        NoModelError: ``empty-hull``, see :func:`gaussiancad_core.hull.visual_hull`.
    """
    plain = visual_hull(views, cameras)
    parallel = all(camera.model is CameraModel.ORTHOGRAPHIC for camera in cameras)
    if result is None or result.shape is None or not parallel:
        return CarvedHull(plain)
    ends = _ends_of(plain, views)
    reliefs, doubted = _reliefs(views, ends, result)
    regions = sum(len(relief.chosen or ()) for relief in reliefs)
    if not regions:
        return CarvedHull(plain, doubted=doubted)
    carved = visual_hull(views, cameras, reliefs)
    refused = _loses(views, ends, carved)
    if not refused and result.status is not Status.VERIFIED:
        refused = _contradicts(views, plain, carved)
    if refused:
        return CarvedHull(plain, doubted=doubted, refused=refused)
    return CarvedHull(carved, result.status, regions, doubted)


def _ends_of(plain: TriangleMesh, views: ViewSet) -> _Ends:
    caster = RayCaster(plain)
    return {
        (view.role, behind): first_surface(caster, view, behind, views.size)[0]
        for view in views.views
        for behind in (False, True)
    }


def _reliefs(views: ViewSet, ends: _Ends, result: "ExactResult") -> tuple[tuple[Relief, ...], int]:
    """Depths from all sides, with the regions that are worth carving; how many were doubted."""
    solids = [CastSolid(shape, views.size) for shape in (result.shape, *result.alternatives)]
    found, doubted = [], 0
    for view in views.views:
        for behind in (False, True):
            relief = relief_of(solids, view, behind)
            worth = _filled_regions(relief, ends[view.role, behind], view)
            if result.status is not Status.VERIFIED and worth:
                sure = confidence(relief, view, result.verification.matched[view.role])
                relief = trusted(relief, sure, _LEAST_CONFIDENCE)
                left = frozenset(n for n in worth if sure.shares[n] >= _LEAST_CONFIDENCE)
                doubted += len(worth) - len(left)
                worth = left
            found.append(replace(relief, chosen=worth))
    return tuple(found), doubted


def _filled_regions(relief: Relief, hull: np.ndarray, view: View) -> frozenset[int]:
    """The regions of a relief that the hull fills; ``hull`` is its (h, w) first surface, mm."""
    deeper = (relief.depths - hull > _SLACK_PX * view.mm_per_pixel) & (relief.regions > 0)
    return frozenset(int(number) for number in np.unique(relief.regions[_spots(deeper)]))


def _spots(mask: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """A mask without its narrow strips."""
    return cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_OPEN, _SPOT) > 0


def _loses(views: ViewSet, ends: _Ends, carved: TriangleMesh) -> str:
    """Why a carved hull is no body with the outlines of the plain one; empty if it is."""
    if not carved.watertight:
        return "not-watertight"
    caster = RayCaster(carved)
    for view in views.views:
        before = np.isfinite(ends[view.role, False])
        after = np.isfinite(first_surface(caster, view, False, views.size)[0])
        if _spots(before & ~after).any():
            return "outline-lost"
    return ""


def _contradicts(views: ViewSet, plain: TriangleMesh, carved: TriangleMesh) -> str:
    """Why a carved hull is not what is drawn; empty if its lines are no worse than before."""
    better = mesh_agreement(carved, views) >= mesh_agreement(plain, views) - _WORSE
    return "" if better else "lines-worse"


def mesh_agreement(mesh: TriangleMesh, views: ViewSet) -> float:
    """Share of all lines, the sheet's and the mesh's, that the other drawing has."""
    pitch = max(views.size) / _PIXELS
    agreeing = total = 0.0
    for view in views.views:
        lines = redraw_mesh(mesh, view.role, pitch, RedrawSettings(most_pixels=_PIXELS))
        matched = match_lines(view.strokes, lines, _TOLERANCE * pitch)
        for points, agree in (
            (matched.sheet.visible, matched.visible_found),
            (matched.sheet.hidden, matched.hidden_found),
            (matched.result.visible, matched.visible_explained),
            (matched.result.hidden, matched.hidden_explained),
        ):
            agreeing += float(points.lengths[agree].sum())
            total += float(points.lengths.sum())
    return agreeing / total if total else 0.0
