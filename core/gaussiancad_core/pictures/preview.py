"""Shaded pictures of a mesh, seen from its front, right and top at once; cast by rays."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.lines.mesh_rays import FirstHits, RayCaster, RayGrid
from gaussiancad_core.lines.tessellation_quality import is_rounded
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.pictures.preview_kernels import (
    interpolated,
    make_units,
    mark_edges,
    shaded,
)

Image = npt.NDArray[np.uint8]
Colour = tuple[int, int, int]

_RIGHT = np.array([1.0, 1.0, 0.0]) / np.sqrt(2.0)
_UP = np.array([-1.0, 1.0, 2.0]) / np.sqrt(6.0)
_LOOK = np.cross(_UP, _RIGHT)

_BACKGROUND = (250, 250, 251)
_LIGHT = np.array([0.10, -0.62, 0.78])
_CONTRAST = 0.60
_CREASE = np.cos(np.radians(30.0))
_SUPERSAMPLING = 2


@dataclass(frozen=True)
class PreviewSize:
    """Size of a picture.

    Attributes:
        width, height: px.
        margin: blank border on each side, as a share of the picture.
    """

    width: int = 1200
    height: int = 900
    margin: float = 0.07


def render_preview(
    mesh: TriangleMesh,
    colours: Colour | npt.NDArray[np.uint8],
    size: PreviewSize = PreviewSize(),
) -> Image:
    """Picture a mesh in an isometric view (ISO 5456-3): x to the right and towards the viewer.

    Args:
        mesh: at least one triangle, z up.
        colours: RGB of the whole part, or (n, 3) RGB of its vertices.
        size: of the picture.

    Returns:
        (height, width, 3) RGB.
    """
    import cv2

    grid = _fitted_grid(mesh, size)
    hits = RayCaster(mesh).first_hits(grid)
    corner_normals = smooth_corner_normals(mesh).astype(np.float32)
    normals = interpolated(hits.triangle, hits.weights, corner_normals)
    make_units(normals)
    contrast = _CONTRAST
    if isinstance(colours, tuple):
        base = np.array(colours, dtype=np.float32)[None, None]
    else:
        corner_colours = colours[mesh.triangles].astype(np.float32)
        base = interpolated(hits.triangle, hits.weights, corner_colours)
        # Colours that mean something must stay what they are.
        contrast = _CONTRAST / 2.0
    # A rounded mesh has no creases to draw, only scraps of them.
    edges = _edges(hits, normals, grid, creases=not is_rounded(mesh))
    light = (_LIGHT / np.linalg.norm(_LIGHT)).astype(np.float32)
    background = np.array(_BACKGROUND, dtype=np.float32)
    lighting = light, np.float32(contrast), background
    image = shaded(hits.triangle, normals, base, edges, lighting)
    small = cv2.resize(image, (size.width, size.height), interpolation=cv2.INTER_AREA)
    return np.rint(np.clip(small, 0.0, 255.0)).astype(np.uint8)


def smooth_corner_normals(
    mesh: TriangleMesh, crease_degrees: float = 35.0
) -> npt.NDArray[np.float64]:
    """(m, 3, 3) normal at each corner of each triangle, not normalised.

    At a corner those triangles count, by their area, that bend from this one by less than the
    crease angle: curved surfaces look smooth and edges stay sharp.
    """
    areas = mesh.area_vectors
    lengths = np.linalg.norm(areas, axis=1, keepdims=True)
    units = areas / np.where(lengths > 0.0, lengths, 1.0)
    corner_vertex = mesh.triangles.ravel()
    order = np.argsort(corner_vertex, kind="stable")
    counts = np.bincount(corner_vertex, minlength=len(mesh.vertices))
    starts = np.concatenate([[0], np.cumsum(counts)])

    # All pairs (corner, triangle at the same vertex), corner by corner.
    pairs = counts[corner_vertex]
    corner = np.repeat(np.arange(len(corner_vertex)), pairs)
    place = np.arange(len(corner)) - np.repeat(np.cumsum(pairs) - pairs, pairs)
    other = order[starts[corner_vertex[corner]] + place] // 3
    bend = np.einsum("ij,ij->i", units[corner // 3], units[other])
    weight = bend > np.cos(np.radians(crease_degrees))
    sums = np.stack(
        [
            np.bincount(corner, weights=areas[other, axis] * weight, minlength=len(corner_vertex))
            for axis in range(3)
        ],
        axis=1,
    )
    return np.asarray(sums.reshape(-1, 3, 3), dtype=np.float64)


def _fitted_grid(mesh: TriangleMesh, size: PreviewSize) -> RayGrid:
    across, along = mesh.vertices @ _RIGHT, mesh.vertices @ _UP
    width, height = size.width * _SUPERSAMPLING, size.height * _SUPERSAMPLING
    share = 1.0 - 2.0 * size.margin
    pitch = max(np.ptp(across) / (width * share), np.ptp(along) / (height * share), 1e-9)
    left = (across.min() + across.max() - width * pitch) / 2.0
    top = (along.min() + along.max() + height * pitch) / 2.0
    right, up, look = (tuple(vector.tolist()) for vector in (_RIGHT, _UP, _LOOK))
    return RayGrid(right, up, look, float(left), float(top), float(pitch), width, height)


def _edges(
    hits: FirstHits, normals: npt.NDArray[np.float32], grid: RayGrid, creases: bool
) -> npt.NDArray[np.uint8]:
    """(h, w) not 0 at outlines, at steps of depth and, for creases, where the surface bends."""
    import cv2

    # Without creases the surface is bumpy, and its limbs would be full of small steps.
    room = (2.0 if creases else 10.0) * grid.pitch
    axes = np.array([grid.right, grid.up, grid.look], dtype=np.float32)
    crease = _CREASE if creases else -2.0
    marked = mark_edges(hits.depth, normals, axes, (grid.pitch, room, crease))
    return np.asarray(cv2.dilate(marked, np.ones((3, 3), np.uint8)), dtype=np.uint8)


def warm_up() -> None:
    """Compile the kernels, or load them from numba's cache, so that the first picture is quick."""
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    mesh = TriangleMesh(corners, np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))
    render_preview(mesh, (120, 160, 210), PreviewSize(16, 12))
