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

from gaussiancad_core.hull.depth_maps import (
    CastSolid,
    Depths,
    confidence,
    depth_map_of,
    first_surface,
    trusted,
)
from gaussiancad_core.hull.visual_hull import DepthMap, visual_hull
from gaussiancad_core.lines.line_agreement import agreeing_share, match_lines
from gaussiancad_core.lines.mesh_lines import RedrawSettings, redraw_mesh
from gaussiancad_core.lines.mesh_rays import RayCaster
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import Camera, CameraModel
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import View, ViewSet
from gaussiancad_protocol.modes import Status

if TYPE_CHECKING:
    from gaussiancad_core.solid.exact import ExactResult

_LEAST_CONFIDENCE = 0.8
"""Share of a region's lines that the sheet must have for its depth to be believed."""

_SLACK_PX = 3.0
"""px by which the solid must lie deeper than the hull for a region to be carved."""

_COARSE_PX = 480
_MOST_STEP = 3
"""px of the longest side of a view for a first look, and how many become one at most."""

_SPOT = np.ones((5, 5), np.uint8)
_COARSE_SPOT = np.ones((2, 2), np.uint8)
"""Pixels that count where hulls and solids differ: narrower strips are the outlines' own noise."""

_LOST_SPOT = np.ones((3, 3), np.uint8)
"""Coarse pixels that count where an outline is lost; at corners a few always are."""

_PIXELS = 420
"""Longest side in px of the drawings that are compared."""

_TOLERANCE = 2.5
"""px of those drawings within which lines agree."""

_WORSE = 0.005
"""Share of the lines by which a carved hull may agree less: the noise of its drawing."""


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
        views: one to six.
        cameras: one for each view; with others than orthographic ones the hull stays plain.
        result: the exact solid of these views, if there is one.

    Raises:
        NoModelError: ``empty-hull``, see :func:`gaussiancad_core.hull.visual_hull`.
    """
    plain = visual_hull(views, cameras)
    parallel = all(camera.model is CameraModel.ORTHOGRAPHIC for camera in cameras)
    if result is None or result.shape is None or not parallel:
        return CarvedHull(plain)
    coarse = _Coarse(plain, views)
    depth_maps, doubted = _depth_maps(coarse, result)
    regions = sum(len(depth_map.chosen or ()) for depth_map in depth_maps)
    if not regions:
        return CarvedHull(plain, doubted=doubted)
    carved = visual_hull(views, cameras, depth_maps)
    refused = _loses(coarse, carved)
    if not refused and result.status is not Status.VERIFIED:
        refused = _contradicts(views, plain, carved)
    if refused:
        return CarvedHull(plain, doubted=doubted, refused=refused)
    return CarvedHull(carved, result.status, regions, doubted)


class _Coarse:
    """The plain hull, seen through every few pixels of the views.

    Args:
        plain: watertight, mm.
        views: of the sheet.

    Attributes:
        views: as given.
        step: pixels of a view between two that are seen through.
    """

    def __init__(self, plain: TriangleMesh, views: ViewSet) -> None:
        self.views = views
        largest = max(max(view.mask.shape) for view in views.views)
        self.step = int(np.clip(largest // _COARSE_PX, 1, _MOST_STEP))
        self._own = {view.role: self._thinned(view) for view in views.views}
        caster = RayCaster(plain)
        self._depths = {
            (view.role, behind): first_surface(caster, self._own[view.role], behind, views.size)[0]
            for view in views.views
            for behind in (False, True)
        }

    def _thinned(self, view: View) -> View:
        """The view with few pixels, each as large as ``step`` of its own."""
        mask = view.mask[:: self.step, :: self.step]
        return replace(view, mask=mask, mm_per_pixel=view.mm_per_pixel * self.step)

    def view(self, role: Role) -> View:
        """The coarse view of a role."""
        return self._own[role]

    def depths(self, role: Role, behind: bool) -> Depths:
        """(h, w) mm to the plain hull's first surface on the coarse view's pixels."""
        return self._depths[role, behind]

    def fine_depths(self, role: Role, behind: bool) -> Depths:
        """The same on the pixels of the view itself, in steps."""
        height, width = self.views[role].mask.shape
        found = self.depths(role, behind).repeat(self.step, axis=0).repeat(self.step, axis=1)
        return found[:height, :width]


def _depth_maps(coarse: _Coarse, result: "ExactResult") -> tuple[tuple[DepthMap, ...], int]:
    """Depths from all sides that have regions worth carving; how many were doubted."""
    views = coarse.views
    solids = [CastSolid(shape, views.size) for shape in (result.shape, *result.alternatives)]
    found, doubted = [], 0
    for view in views.views:
        for behind in (False, True):
            few = coarse.view(view.role)
            slack = _SLACK_PX * view.mm_per_pixel
            rough = depth_map_of(solids, few, behind)
            if not _filled_regions(rough, coarse.depths(view.role, behind), slack, _COARSE_SPOT):
                continue
            depth_map = depth_map_of(solids, view, behind)
            worth = _filled_regions(depth_map, coarse.fine_depths(view.role, behind), slack, _SPOT)
            if result.status is not Status.VERIFIED and worth:
                sure = confidence(depth_map, view, result.checked.matched[view.role])
                depth_map = trusted(depth_map, sure, _LEAST_CONFIDENCE)
                left = frozenset(n for n in worth if sure.shares[n] >= _LEAST_CONFIDENCE)
                doubted += len(worth) - len(left)
                worth = left
            found.append(replace(depth_map, chosen=worth))
    return tuple(found), doubted


def _filled_regions(
    depth_map: DepthMap, hull: Depths, slack: float, spot: npt.NDArray[np.uint8]
) -> frozenset[int]:
    """The regions of a depth map that the hull fills by more than ``slack`` mm.

    Args:
        depth_map: of the solid.
        hull: (h, w) mm, the hull's first surface.
        slack: mm.
        spot: the smallest group of pixels that counts.
    """
    deeper = (depth_map.depths - hull > slack) & (depth_map.regions > 0)
    filled = depth_map.regions[_spots(deeper, spot)]
    return frozenset(int(number) for number in np.unique(filled))


def _spots(mask: npt.NDArray[np.bool_], spot: npt.NDArray[np.uint8]) -> npt.NDArray[np.bool_]:
    """A mask without its narrow strips."""
    return cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_OPEN, spot) > 0


def _loses(coarse: _Coarse, carved: TriangleMesh) -> str:
    """Why a carved hull is no body with the outlines of the plain one; empty if it is."""
    if not carved.watertight:
        return "not-watertight"
    caster = RayCaster(carved)
    for view in coarse.views.views:
        few = coarse.view(view.role)
        before = np.isfinite(coarse.depths(view.role, False))
        after = np.isfinite(first_surface(caster, few, False, coarse.views.size)[0])
        if _spots(before & ~after, _LOST_SPOT).any():
            return "outline-lost"
    return ""


def _contradicts(views: ViewSet, plain: TriangleMesh, carved: TriangleMesh) -> str:
    """Why a carved hull is not what is drawn; empty if its lines are no worse than before."""
    better = mesh_agreement(carved, views) >= mesh_agreement(plain, views) - _WORSE
    return "" if better else "lines-worse"


def mesh_agreement(mesh: TriangleMesh, views: ViewSet) -> float:
    """Share of all lines, the sheet's and the mesh's, that the other drawing has."""
    pitch = max(views.size) / _PIXELS
    matches = []
    for view in views.views:
        lines = redraw_mesh(mesh, view.role, pitch, RedrawSettings(most_pixels=_PIXELS))
        matches.append(match_lines(view.strokes, lines, _TOLERANCE * pitch))
    return agreeing_share(matches)
