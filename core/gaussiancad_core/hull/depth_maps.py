"""Depth maps of exact solids: how deep their first and last surface lies in the regions of a view.

Each pixel of a view's mask is a ray.  What it meets first, and what it leaves last, belongs to a
smooth patch of the solid; pixels of one patch that hang together are a region.  Where several
solids fit the sheet, a ray counts with the one that it meets first: only what all of them leave
empty is void for certain.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gaussiancad_core.hull.visual_hull import DepthMap
from gaussiancad_core.lines.line_agreement import MatchedLines
from gaussiancad_core.lines.mesh_rays import RayCaster, RayGrid
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.model.views import View

if TYPE_CHECKING:
    from OCP.TopoDS import TopoDS_Shape

DEFLECTION = 2e-4
"""Distance of the triangles from their solid, as a share of the longest extent."""

CHORD = 0.15
"""Radians between neighbouring chords of a curve."""

_SMOOTH = np.radians(20.0)
"""Bend between triangles up to which they belong to one patch."""

_BESIDE_PX = 1.5
"""px from a region's border within which a line is a line of that border."""

Depths = npt.NDArray[np.float32]
Numbers = npt.NDArray[np.int32]


class CastSolid:
    """A solid made ready for rays.

    Args:
        shape: mm, in the model's axes.
        size: (3,) of the box in mm.
    """

    def __init__(self, shape: "TopoDS_Shape", size: tuple[float, float, float]) -> None:
        from gaussiancad_core.kernel.brep import tessellate

        mesh = make_mesh(*tessellate(shape, DEFLECTION * max(size), CHORD))
        self._caster = RayCaster(mesh)
        self._patches = _smooth_patches(mesh)
        self._size = size

    def seen(self, view: View, behind: bool) -> tuple[Depths, Numbers]:
        """Depths and patches on the pixels of a view's mask, as :class:`DepthMap` counts them.

        Args:
            view: whose pixels are rays.
            behind: whether to look from the far side.

        Returns:
            (h, w) mm, infinite where there is nothing, and (h, w) numbers of patches, from 0; -1.
        """
        depths, triangles = first_surface(self._caster, view, behind, self._size)
        patches = np.where(triangles >= 0, self._patches[triangles], -1)
        return depths, patches.astype(np.int32)


def first_surface(
    caster: RayCaster, view: View, behind: bool, size: tuple[float, float, float]
) -> tuple[Depths, npt.NDArray[np.int64]]:
    """Depth and triangle that each pixel of a view's mask meets first.

    Args:
        caster: of the mesh, mm.
        view: whose pixels are rays.
        behind: whether to look from the far side.
        size: (3,) of the box in mm.

    Returns:
        (h, w) mm from the side of the box that is nearest to the viewer, infinite where there is
        nothing, and (h, w) triangles, or -1.
    """
    frame = view.role.frame
    height, width = view.mask.shape
    axis, sign = frame.look_axis
    sign = -sign if behind else sign
    x, y, z = (-component if behind else component for component in frame.look)
    grid = RayGrid(frame.right, frame.up, (x, y, z), *view.origin, view.mm_per_pixel, width, height)
    hits = caster.first_hits(grid)
    along = caster.mesh.corners[:, :, axis.value].astype(np.float32)
    depths = (along[hits.triangle] * hits.weights).sum(axis=-1)
    if sign < 0:
        depths = size[axis.value] - depths
    return np.where(hits.triangle >= 0, depths, np.float32(np.inf)), hits.triangle


def _smooth_patches(mesh: TriangleMesh) -> npt.NDArray[np.int64]:
    """(m,) number of the smooth patch that each triangle belongs to."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    whole = mesh.to_trimesh()
    pairs = whole.face_adjacency[whole.face_adjacency_angles < _SMOOTH]
    count = len(mesh.triangles)
    graph = coo_matrix((np.ones(len(pairs), dtype=np.int8), pairs.T), (count, count))
    return connected_components(graph, directed=False)[1].astype(np.int64)


def depth_map_of(solids: Sequence[CastSolid], view: View, behind: bool) -> DepthMap:
    """What all of some solids leave empty in front of a view, or behind it.

    Args:
        solids: one at least; the first one's patches count where all are alike.
        view: one view.
        behind: whether the view is looked at from the far side.
    """
    depths, patches = solids[0].seen(view, behind)
    offset = int(patches.max()) + 1
    for other in solids[1:]:
        deeper, its_patches = other.seen(view, behind)
        nearer = deeper < depths - 0.5 * view.mm_per_pixel
        depths = np.where(nearer, deeper, depths)
        patches = np.where(nearer, its_patches + offset, patches)
        offset += int(its_patches.max()) + 1
    return DepthMap(view.role, _regions(patches, view), _finite(depths), behind)


def _finite(depths: Depths) -> Depths:
    return np.where(np.isfinite(depths), depths, np.float32(0.0)).astype(np.float32)


def _regions(patches: Numbers, view: View) -> Numbers:
    """Numbers from 1 for pixels of the mask that hang together and meet one patch."""
    from skimage.measure import label

    known = np.where(view.mask & (patches >= 0), patches + 1, 0)
    return label(known, background=0, connectivity=1).astype(np.int32)


@dataclass(frozen=True)
class Confidence:
    """How sure the regions of a depth map are.

    Attributes:
        shares: (n + 1,) by number of the region: share of the lines of its border that the sheet
            has, 0 to 1; 1 where there is no line.
    """

    shares: npt.NDArray[np.float64]


def confidence(depth_map: DepthMap, view: View, matched: MatchedLines) -> Confidence:
    """How much of what bounds each region is on the sheet.

    Args:
        depth_map: of a solid.
        view: of the depth map.
        matched: the solid's lines in that view and the sheet's.
    """
    regions = depth_map.regions
    count = int(regions.max()) + 1
    total, agreeing = np.zeros(count), np.zeros(count)
    for lines, explained in (
        (matched.result.visible, matched.visible_explained),
        (matched.result.hidden, matched.hidden_explained),
    ):
        if not len(lines.points):
            continue
        pixels = view.to_pixels(lines.points)
        for numbers, lengths, agree in _adjacent(regions, pixels, lines.lengths, explained):
            total += np.bincount(numbers, weights=lengths, minlength=count)
            agreeing += np.bincount(numbers, weights=lengths * agree, minlength=count)
    shares = np.ones(count)
    np.divide(agreeing, total, out=shares, where=total > 0.0)
    return Confidence(shares)


def _adjacent(
    regions: Numbers,
    pixels: npt.NDArray[np.float64],
    lengths: npt.NDArray[np.float64],
    explained: npt.NDArray[np.bool_],
) -> list[tuple[npt.NDArray[np.int64], npt.NDArray[np.float64], npt.NDArray[np.bool_]]]:
    """Regions on either side of points, where the two sides differ: (region, length, explained)."""
    height, width = regions.shape
    found = []
    for dx, dy in ((_BESIDE_PX, 0.0), (0.0, _BESIDE_PX)):
        sides = []
        for way in (-1.0, 1.0):
            columns = np.clip(np.floor(pixels[:, 0] + way * dx), 0, width - 1).astype(np.int64)
            rows = np.clip(np.floor(pixels[:, 1] + way * dy), 0, height - 1).astype(np.int64)
            sides.append(regions[rows, columns].astype(np.int64))
        border = sides[0] != sides[1]
        found += [(side[border], lengths[border], explained[border]) for side in sides]
    return found


def trusted(depth_map: DepthMap, sure: Confidence, least: float) -> DepthMap:
    """The depth map without the regions that are less sure: nothing is known there."""
    kept = sure.shares[depth_map.regions] >= least
    return replace(depth_map, regions=np.where(kept, depth_map.regions, 0).astype(np.int32))
