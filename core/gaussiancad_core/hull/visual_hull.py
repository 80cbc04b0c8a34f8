"""Visual hull of the views as a signed-distance field, and its surface.

Each mask becomes a 2D signed distance in millimetres (exact Euclidean, the outline between pixel
centres).  The hull's field at a point is the largest of the views' distances where they see the
point and of the distance to the part's bounding box: the intersection of the masks' sweeps
(Laurentini 1994).  Marching cubes (Lorensen and Cline 1987, in scikit-image) finds its zero level.

Marching cubes cuts off the edges of a max-field by up to a cell.  So the grid is rectilinear, with
two planes of nodes close to each side of the box and to each straight, axis-parallel part of an
outline: edges between such faces are cut by a fiftieth of a cell only.

Masks alone cannot show pockets, nor that a boss is round.  Where the depth of a view's regions is
known (a :class:`DepthMap`), what lies in front of it is carved away, or what lies behind the last
surface there.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from scipy.ndimage import distance_transform_edt

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.evidence.mask_outlines import (
    PAD_PX,
    Field,
    Mask,
    PlaneField,
    padded_mask,
    plane_field,
    signed_distance,
    straight_parts,
)
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.cameras import Camera, CameraModel
from gaussiancad_core.model.meshes import TriangleMesh, connected_pieces, joined, make_mesh
from gaussiancad_core.model.views import View, ViewSet
from gaussiancad_protocol.codes import Code

DEFAULT_CELLS = 160
"""Grid cells along the longest edge of the box."""

_SHARP = 0.02
"""Distance of the two planes of nodes beside a flat face, in cells."""

_SMALLEST_PIECE = 1e-3
"""Pieces below this share of the hull's area are crumbs of the masks' pixels."""

_CHUNK = 1 << 20
"""Points that a pinhole camera projects at once: bounds the memory."""

_SAME_DEPTH_PX = 1.5
"""Depths that differ by less are the same: masks and depths are whole pixels."""

_REACH = 3.0
"""Cells around a region in which its carving is worked out."""

_CRUMB_PX = 4
"""Regions of fewer pixels say nothing that can be trusted."""

Coordinates = tuple[npt.NDArray[np.float64], ...]


@dataclass(frozen=True, eq=False)
class DepthMap:
    """How deep the part's first surface, or its last one, lies in the regions of a view.

    Attributes:
        role: the view.
        regions: (h, w) int, on the pixels of the view's mask: which region a pixel belongs to; 0
            where nothing is known.  Neighbouring regions touch: what is unknown between them stays.
        depths: (h, w) float, mm from the side of the box that is nearest to the viewer.
        behind: whether it is the surface that is farthest from the viewer, and the depths count
            from the side of the box that is farthest, towards the viewer.
        chosen: numbers of the regions that are carved, where the hull has too much; all if None.
    """

    role: Role
    regions: npt.NDArray[np.int32]
    depths: npt.NDArray[np.float32]
    behind: bool = False
    chosen: frozenset[int] | None = None


def visual_hull(
    views: ViewSet,
    cameras: tuple[Camera, ...],
    depth_maps: tuple[DepthMap, ...] = (),
    cells: int = DEFAULT_CELLS,
) -> TriangleMesh:
    """Surface of the largest body that all masks, the box and the depth maps allow.

    Args:
        views: one to six views; a direction that no mask bounds ends at the box.
        cameras: one for each view, in any order; orthographic or pinhole.
        depth_maps: known depths; those of views with a pinhole camera are not used.
        cells: grid cells along the longest edge of the box.

    Returns:
        A watertight mesh in model mm, oriented outward; its flat sides lie exactly in the box.

    Raises:
        NoModelError: ``empty-hull``, no point lies inside all masks.
    """
    of_role = {camera.role: camera for camera in cameras}
    parallel = {camera.role for camera in cameras if camera.model is CameraModel.ORTHOGRAPHIC}
    # A pinhole's sweep widens with depth: its sides are not the box's.
    masks = {
        view.role: padded_mask(view, views.size, view.role in parallel) for view in views.views
    }
    carvings = [
        carving
        for depth_map in depth_maps
        if depth_map.role in parallel
        for carving in _carvings(depth_map, views[depth_map.role], max(views.size) / cells)
    ]
    coordinates = _grid(views, masks, carvings, cells)
    field = _box_field(coordinates, views.size)
    for view in views.views:
        distances = signed_distance(masks[view.role], view.mm_per_pixel)
        camera = of_role[view.role]
        np.maximum(field, _sweep(plane_field(distances, view), camera, coordinates), out=field)
    for carving in carvings:
        _carve(field, carving, of_role[carving.view.role], coordinates, views.size)
    if not (field < 0.0).any():
        raise NoModelError(
            Code.EMPTY_HULL,
            "the views have no part in common: check which view is which and the projection",
        )
    return _zero_level(field, coordinates, views.size)


@dataclass(frozen=True, eq=False)
class _Carving:
    """One region of a depth map, made ready for the grid.

    Attributes:
        view: whose region it is.
        upward: whether depth grows with the coordinate along the view.
        inside: distance from the border of what may be carved, mm, positive inside.
        depths: mm from the near side, continued beyond the region.
        mask_field: 1 in the region, 0 elsewhere; as the others on a window around the region.
        mask: (h, w) the region on the padded mask's pixels.
        flat: the depth where it is the same all over, else nothing.
    """

    view: View
    upward: bool
    inside: PlaneField
    depths: PlaneField
    mask_field: PlaneField
    mask: Mask
    flat: float | None


def _carvings(depth_map: DepthMap, view: View, step: float) -> list[_Carving]:
    """The regions of a depth map; ``step`` is the size of a cell in mm."""
    regions = np.pad(depth_map.regions, PAD_PX)
    depths = np.pad(depth_map.depths.astype(np.float32), PAD_PX)
    blank = ~np.pad(view.mask, PAD_PX)
    margin = int(np.ceil(_REACH * step / view.mm_per_pixel)) + 2
    found = []
    upward = (view.role.frame.look_axis[1] > 0) != depth_map.behind
    for number in np.unique(regions[regions > 0]):
        if depth_map.chosen is not None and int(number) not in depth_map.chosen:
            continue
        mask = regions == number
        if mask.sum() < _CRUMB_PX:
            continue
        rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
        corner = (max(0, rows[0] - margin), max(0, columns[0] - margin))
        window = (
            slice(corner[0], rows[-1] + margin + 1),
            slice(corner[1], columns[-1] + margin + 1),
        )
        item = mask[window]
        nearest = distance_transform_edt(~item, return_distances=False, return_indices=True)
        continued = depths[window][tuple(nearest)]
        # Beyond the outline there is nothing, and a deeper neighbour is carved there as well: the
        # border of what is carved lies elsewhere, and no skin is left between the two.
        tolerance = _SAME_DEPTH_PX * view.mm_per_pixel
        neighbour = (regions[window] > 0) & ~item
        deeper = neighbour & (depths[window] >= continued - tolerance)
        free = item | blank[window] | deeper
        continued = np.where(deeper, np.minimum(continued, depths[window]), continued)
        inside = -signed_distance(free, view.mm_per_pixel)
        level = float(np.ptp(depths[mask])) < 0.5 * view.mm_per_pixel
        found.append(
            _Carving(
                view,
                upward,
                plane_field(inside, view, corner),
                plane_field(continued, view, corner),
                plane_field(item.astype(np.float32), view, corner),
                mask,
                float(np.median(depths[mask])) if level else None,
            )
        )
    return found


def _grid(
    views: ViewSet, masks: dict[Role, Mask], carvings: list[_Carving], cells: int
) -> Coordinates:
    """Coordinates of the nodes along each axis in mm, ascending, one node outside the box."""
    step = max(views.size) / cells
    grids = []
    for axis in Axis:
        extent = views.size[axis.value]
        faces = {0.0, extent}
        for view in views.views:
            faces.update(straight_parts(masks[view.role], view, axis))
        for carving in carvings:
            faces.update(straight_parts(carving.mask, carving.view, axis))
            if carving.view.role.frame.look_axis[0] is axis and carving.flat is not None:
                faces.add(carving.flat if carving.upward else extent - carving.flat)
        grids.append(_nodes(sorted(faces), extent, step))
    return tuple(grids)


def _nodes(faces: list[float], extent: float, step: float) -> npt.NDArray[np.float64]:
    """Nodes about ``step`` apart from ``-step`` to ``extent + step``, two beside each face."""
    kept = [0.0]
    for face in faces:
        if face - kept[-1] > 0.5 * step and extent - face > 0.5 * step:
            kept.append(face)
    kept.append(extent)
    sharp = _SHARP * step
    nodes = [np.array([-step])]
    for low, high in pairwise(kept):
        count = max(1, round((high - low) / step))
        inner = np.linspace(low, high, count + 1)[1:-1]
        nodes.append(np.concatenate([[low - sharp, low + sharp], inner]))
    nodes.append(np.array([extent - sharp, extent + sharp, extent + step]))
    return np.unique(np.concatenate(nodes))


def _box_field(coordinates: Coordinates, size: tuple[float, float, float]) -> Field:
    """(nx, ny, nz) distance to the nearest side of the box in mm, negative inside."""
    sides = [
        np.maximum(-c, c - s).astype(np.float32) for c, s in zip(coordinates, size, strict=True)
    ]
    return np.maximum(
        np.maximum(sides[0][:, None, None], sides[1][None, :, None]), sides[2][None, None, :]
    )


def _sweep(plane: PlaneField, camera: Camera, coordinates: Coordinates) -> Field:
    """A view's values at the nodes; an array that broadcasts to (nx, ny, nz)."""
    along = list(coordinates)
    if camera.model is CameraModel.ORTHOGRAPHIC:
        # Nothing changes along the view: one layer stands for all.
        look = camera.role.frame.look_axis[0].value
        along[look] = coordinates[look][:1]
    shape = tuple(len(nodes) for nodes in along)
    values = np.empty(int(np.prod(shape)), dtype=np.float32)
    for start in range(0, len(values), _CHUNK):
        indices = np.unravel_index(np.arange(start, min(start + _CHUNK, len(values))), shape)
        points = np.stack([nodes[index] for nodes, index in zip(along, indices, strict=True)], 1)
        values[start : start + _CHUNK] = plane.at(camera.plane_coordinates(points))
    return values.reshape(shape)


def _carve(
    field: Field,
    carving: _Carving,
    camera: Camera,
    coordinates: Coordinates,
    size: tuple[float, float, float],
) -> None:
    """Take what lies in front of a region out of the field, unless the hull ends there anyway."""
    window, nodes = _window(carving, coordinates)
    look = carving.view.role.frame.look_axis[0].value
    if min(len(node) for node in nodes) == 0:
        return
    inside, depths, values = (
        np.squeeze(_sweep(plane, camera, nodes), look)
        for plane in (carving.inside, carving.depths, carving.mask_field)
    )
    along = nodes[look]
    ways = along if carving.upward else size[look] - along
    in_front = depths[..., None] - ways.astype(np.float32)
    # A view along the axis: its last array axis is the depth.
    block = np.moveaxis(field[window], look, -1)
    tolerance = _SAME_DEPTH_PX * carving.view.mm_per_pixel
    solid = (block < 0.0) & (in_front > tolerance) & (values > 0.99)[..., None]
    if solid.any():
        np.maximum(block, np.minimum(inside[..., None], in_front), out=block)


def _window(
    carving: _Carving, coordinates: Coordinates
) -> tuple[tuple[slice, slice, slice], Coordinates]:
    """The part of the grid in front of and behind a carving's window, and its nodes."""
    frame = carving.view.role.frame
    plane = carving.inside
    height, width = (length * plane.mm_per_pixel for length in plane.values.shape)
    left, top = plane.origin
    slices = [slice(None), slice(None), slice(None)]
    for (axis, sign), ends in (
        (frame.right_axis, (left, left + width)),
        (frame.up_axis, (top - height, top)),
    ):
        low, high = sorted(sign * end for end in ends)
        nodes = coordinates[axis.value]
        slices[axis.value] = slice(
            int(np.searchsorted(nodes, low)), int(np.searchsorted(nodes, high, side="right"))
        )
    window = (slices[0], slices[1], slices[2])
    return window, tuple(
        coordinate[part] for coordinate, part in zip(coordinates, window, strict=True)
    )


def _zero_level(
    field: Field,
    coordinates: Coordinates,
    size: tuple[float, float, float],
) -> TriangleMesh:
    from skimage.measure import marching_cubes

    # A node exactly on the surface would give triangles without area.
    tiny = np.float32(1e-6 * max(size))
    field = np.where(np.abs(field) < tiny, tiny, field)
    vertices, triangles, _, _ = marching_cubes(field, 0.0)
    # Within a cell the field is linear in the index, and so is the coordinate.
    placed = np.stack(
        [np.interp(vertices[:, k], np.arange(len(c)), c) for k, c in enumerate(coordinates)], 1
    )
    for axis, extent in enumerate(size):
        for side in (0.0, extent):
            near = np.abs(placed[:, axis] - side) < 1e-4 * max(size)
            placed[near, axis] = side
    mesh = make_mesh(placed, triangles).oriented_outward()
    pieces = connected_pieces(mesh)
    limit = _SMALLEST_PIECE * mesh.area
    return joined([piece for piece in pieces if piece.area >= limit])
