"""Visual hull of the views as a signed-distance field, and its surface.

Each mask becomes a 2D signed distance in millimetres (exact Euclidean, the outline between pixel
centres).  The hull's field at a point is the largest of the views' distances where they see the
point and of the distance to the part's bounding box: the intersection of the masks' sweeps
(Laurentini 1994).  Marching cubes (Lorensen and Cline 1987, in scikit-image) finds its zero level.

Marching cubes cuts off the edges of a max-field by up to a cell.  So the grid is rectilinear, with
two planes of nodes close to each side of the box and to each straight, axis-parallel part of an
outline: edges between such faces are cut by a fiftieth of a cell only.
"""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.axes import Axis
from gaussiancad_core.cameras import Camera, CameraModel
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.meshes import TriangleMesh, connected_pieces, joined, make_mesh
from gaussiancad_core.views import View, ViewSet

DEFAULT_CELLS = 160
"""Grid cells along the longest edge of the box."""

_PAD_PX = 4
"""Blank border around a mask, so that its distances are right up to the outline."""

_TOUCH_PX = 1.0
"""An outline that comes this near to a side of the box lies in it: a mask is whole pixels."""

_SHARP = 0.02
"""Distance of the two planes of nodes beside a flat face, in cells."""

_STRAIGHT = 0.04
"""Shortest straight part of an outline that draws planes of nodes, as a share of the mask."""

_SMALLEST_PIECE = 1e-3
"""Pieces below this share of the hull's area are crumbs of the masks' pixels."""

_CHUNK = 1 << 20
"""Points that a pinhole camera projects at once: bounds the memory."""


@dataclass(frozen=True)
class OutlineDistance:
    """Signed distance to the outline of a view's mask.

    Attributes:
        distances: (h, w) float32, mm at the pixels' centres, negative inside.
        origin: (right, up) in mm of the upper left corner of the first pixel.
        mm_per_pixel: size of a pixel.
    """

    distances: npt.NDArray[np.float32]
    origin: tuple[float, float]
    mm_per_pixel: float

    def at(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float32]:
        """(n, 2) (right, up) in mm -> (n,) mm, bilinear; beyond the border as on the border."""
        pixels = (points - np.array(self.origin)) / self.mm_per_pixel * np.array([1.0, -1.0]) - 0.5
        height, width = self.distances.shape
        x = np.clip(pixels[:, 0], 0.0, width - 1.0)
        y = np.clip(pixels[:, 1], 0.0, height - 1.0)
        column = np.minimum(x.astype(np.int64), width - 2)
        row = np.minimum(y.astype(np.int64), height - 2)
        right, down = (x - column).astype(np.float32), (y - row).astype(np.float32)
        field = self.distances
        upper = field[row, column] * (1 - right) + field[row, column + 1] * right
        lower = field[row + 1, column] * (1 - right) + field[row + 1, column + 1] * right
        return upper * (1 - down) + lower * down


def outline_distance(mask: npt.NDArray[np.bool_], view: View) -> OutlineDistance:
    """Signed distance to the outline of ``mask``, which lies on the pixels of ``view``.

    A mask is padded with blank pixels unless it is as large as the view's own mask plus padding.
    """
    inside = mask.astype(np.uint8)
    outer = cv2.distanceTransform(1 - inside, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    inner = cv2.distanceTransform(inside, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    # Half a pixel less: the outline runs between the centres, not through those of one side.
    distances = np.where(mask, 0.5 - inner, outer - 0.5) * np.float32(view.mm_per_pixel)
    pad = _PAD_PX * view.mm_per_pixel
    origin = (view.origin[0] - pad, view.origin[1] + pad)
    return OutlineDistance(distances.astype(np.float32), origin, view.mm_per_pixel)


def visual_hull(
    views: ViewSet, cameras: tuple[Camera, ...], cells: int = DEFAULT_CELLS
) -> TriangleMesh:
    """Surface of the largest body that all masks and the bounding box allow.

    Args:
        views: two to six views; a direction that no mask bounds ends at the box.
        cameras: one for each view, in any order; orthographic or pinhole.
        cells: grid cells along the longest edge of the box.

    Returns:
        A watertight mesh in model mm, oriented outward; its flat sides lie exactly in the box.

    Raises:
        NoModelError: ``empty-hull``, no point lies inside all masks.
    """
    of_role = {camera.role: camera for camera in cameras}
    outlines = [_padded(view, of_role[view.role], views.size) for view in views.views]
    coordinates = _grid(views, outlines, cells)
    field = _box_field(coordinates, views.size)
    for view, outline in zip(views.views, outlines, strict=True):
        distance = outline_distance(outline, view)
        np.maximum(field, _sweep(distance, of_role[view.role], coordinates), out=field)
    if not (field < 0.0).any():
        raise NoModelError(
            "empty-hull",
            "the views have no part in common: check which view is which and the projection",
        )
    return _zero_level(field, coordinates, views.size)


def _padded(view: View, camera: Camera, size: tuple[float, float, float]) -> npt.NDArray[np.bool_]:
    """The mask with a border; where it reaches a side of the box it goes on beyond it.

    The box is known better than the pixels are: a mask that ends less than a pixel before a side
    means the side.  A pinhole's sweep widens with depth, so that its sides are no planes: there the
    border stays blank.
    """
    mask = np.pad(view.mask, _PAD_PX)
    if camera.model is CameraModel.PINHOLE or not mask.any():
        return mask
    for axis, sides in ((1, _box_pixels(view, size, 0)), (0, _box_pixels(view, size, 1))):
        lines = np.moveaxis(mask, axis, 0)
        filled = np.flatnonzero(lines.any(axis=1))
        first, last = filled[0], filled[-1]
        if abs(first - sides[0]) <= _TOUCH_PX:
            lines[:first] = lines[first]
        if abs(last + 1 - sides[1]) <= _TOUCH_PX:
            lines[last + 1 :] = lines[last]
    return mask


def _box_pixels(view: View, size: tuple[float, float, float], index: int) -> tuple[float, float]:
    """Where the box's two sides lie along x (0) or y (1) in pixels of the padded mask."""
    frame = view.role.frame
    axis, sign = (frame.right_axis, frame.up_axis)[index]
    ends = np.zeros((2, 2))
    ends[:, index] = sorted((0.0, sign * size[axis.value]))
    low, high = sorted(view.to_pixels(ends)[:, index] + _PAD_PX)
    return float(low), float(high)


def _grid(
    views: ViewSet, outlines: list[npt.NDArray[np.bool_]], cells: int
) -> tuple[npt.NDArray[np.float64], ...]:
    """Coordinates of the nodes along each axis in mm, ascending, one node outside the box."""
    step = max(views.size) / cells
    grids = []
    for axis in Axis:
        extent = views.size[axis.value]
        faces = {0.0, extent}
        for view, outline in zip(views.views, outlines, strict=True):
            faces.update(_flat_faces(view, outline, axis))
        grids.append(_nodes(sorted(faces), extent, step))
    return tuple(grids)


def _flat_faces(view: View, outline: npt.NDArray[np.bool_], axis: Axis) -> list[float]:
    """Coordinates on ``axis`` in mm of the straight parts of the outline that stand across it."""
    frame = view.role.frame
    for index, (own, sign) in enumerate((frame.right_axis, frame.up_axis)):
        if own is not axis:
            continue
        lines = np.moveaxis(outline, 1 - index, 0)
        changes = (lines[1:] != lines[:-1]).sum(axis=1)
        straight = np.flatnonzero(changes >= _STRAIGHT * max(outline.shape)) + 1 - _PAD_PX
        along = view.origin[index] + straight * view.mm_per_pixel * (1.0, -1.0)[index]
        return [float(value) for value in along * sign]
    return []


def _nodes(faces: list[float], extent: float, step: float) -> npt.NDArray[np.float64]:
    """Nodes about ``step`` apart from ``-step`` to ``extent + step``, two beside each face."""
    kept = [0.0]
    for face in faces:
        if face - kept[-1] > 0.5 * step and extent - face > 0.5 * step:
            kept.append(face)
    kept.append(extent)
    sharp = _SHARP * step
    nodes = [np.array([-step])]
    for low, high in zip(kept[:-1], kept[1:], strict=True):
        count = max(1, round((high - low) / step))
        inner = np.linspace(low, high, count + 1)[1:-1]
        nodes.append(np.concatenate([[low - sharp, low + sharp], inner]))
    nodes.append(np.array([extent - sharp, extent + sharp, extent + step]))
    return np.unique(np.concatenate(nodes))


def _box_field(
    coordinates: tuple[npt.NDArray[np.float64], ...], size: tuple[float, float, float]
) -> npt.NDArray[np.float32]:
    """(nx, ny, nz) distance to the nearest side of the box in mm, negative inside."""
    sides = [
        np.maximum(-c, c - s).astype(np.float32) for c, s in zip(coordinates, size, strict=True)
    ]
    return np.maximum(
        np.maximum(sides[0][:, None, None], sides[1][None, :, None]), sides[2][None, None, :]
    )


def _sweep(
    distance: OutlineDistance, camera: Camera, coordinates: tuple[npt.NDArray[np.float64], ...]
) -> npt.NDArray[np.float32]:
    """The view's distance at the nodes; an array that broadcasts to (nx, ny, nz)."""
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
        values[start : start + _CHUNK] = distance.at(camera.plane_coordinates(points))
    return values.reshape(shape)


def _zero_level(
    field: npt.NDArray[np.float32],
    coordinates: tuple[npt.NDArray[np.float64], ...],
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
