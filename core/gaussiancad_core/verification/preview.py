"""Shaded pictures of a mesh, seen from its front, right and top at once; cast by rays."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.meshes import TriangleMesh
from gaussiancad_core.verification.fineness import is_rounded
from gaussiancad_core.verification.rays import FirstHits, RayCaster, RayGrid

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
    hit = hits.triangle >= 0
    normals = np.zeros((*hit.shape, 3), dtype=np.float32)
    normals[hit] = _unit(_interpolated(smooth_corner_normals(mesh), hits, hit))
    contrast = _CONTRAST
    if isinstance(colours, tuple):
        base = np.broadcast_to(np.array(colours, dtype=np.float32), (int(hit.sum()), 3))
    else:
        base = _interpolated(colours[mesh.triangles], hits, hit)
        # Colours that mean something must stay what they are.
        contrast = _CONTRAST / 2.0
    # Half-Lambert: faces that look away from the light keep their form.
    facing = (1.0 + normals[hit] @ (_LIGHT / np.linalg.norm(_LIGHT)).astype(np.float32)) / 2.0
    shade = 1.02 - contrast * (1.0 - facing[:, None] ** 1.3)
    image = np.full((*hit.shape, 3), _BACKGROUND, dtype=np.float32)
    # A rounded mesh has no creases to draw, only scraps of them.
    edges = _edges(hits, normals, grid, creases=not is_rounded(mesh))
    image[hit] = np.where(edges[hit][:, None], _edge_colours(base), base * shade)
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
    return sums.reshape(-1, 3, 3)


def png_bytes(image: Image) -> bytes:
    """The (h, w, 3) RGB or (h, w) grey image as PNG."""
    import cv2

    ordered = image if image.ndim == 2 else image[..., ::-1]
    _, content = cv2.imencode(".png", ordered)
    return content.tobytes()


def _fitted_grid(mesh: TriangleMesh, size: PreviewSize) -> RayGrid:
    across, along = mesh.vertices @ _RIGHT, mesh.vertices @ _UP
    width, height = size.width * _SUPERSAMPLING, size.height * _SUPERSAMPLING
    share = 1.0 - 2.0 * size.margin
    pitch = max(np.ptp(across) / (width * share), np.ptp(along) / (height * share), 1e-9)
    left = (across.min() + across.max() - width * pitch) / 2.0
    top = (along.min() + along.max() + height * pitch) / 2.0
    vectors = (tuple(vector.tolist()) for vector in (_RIGHT, _UP, _LOOK))
    return RayGrid(*vectors, float(left), float(top), float(pitch), width, height)


def _interpolated(
    corner_values: npt.NDArray, hits: FirstHits, hit: npt.NDArray[np.bool_]
) -> npt.NDArray[np.float32]:
    """(n, k) of (m, 3, k) values at the triangles' corners, at the pixels that hit something."""
    values = corner_values.astype(np.float32)[hits.triangle[hit]]
    return np.einsum("nij,ni->nj", values, hits.weights[hit])


def _unit(vectors: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    lengths = np.sqrt(np.einsum("ij,ij->i", vectors, vectors))
    return vectors / np.maximum(lengths, 1e-12)[:, None]


def _edge_colours(base: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """Darker than the part, or lighter where the part is nearly black."""
    dark = base.mean(axis=1, keepdims=True) < 48.0
    return np.where(dark, 0.55 * base + 80.0, 0.28 * base)


def _edges(
    hits: FirstHits, normals: npt.NDArray[np.float32], grid: RayGrid, creases: bool
) -> npt.NDArray[np.bool_]:
    """(h, w) outlines, and where neighbouring pixels differ in depth or, for creases, bend."""
    import cv2

    hit = hits.triangle >= 0
    depth = np.where(hit, hits.depth, 0.0)
    marked = np.zeros(hit.shape, dtype=np.uint8)
    # Without creases the surface is bumpy, and its limbs would be full of small steps.
    room = (2.0 if creases else 10.0) * grid.pitch
    look = np.array(grid.look, dtype=np.float32)
    for axis, across in ((1, np.array(grid.right)), (0, -np.array(grid.up))):
        one = tuple(slice(None, -1) if k == axis else slice(None) for k in range(2))
        two = tuple(slice(1, None) if k == axis else slice(None) for k in range(2))
        both = hit[one] & hit[two]
        rim = hit[one] != hit[two]
        marked[one] |= rim
        marked[two] |= rim
        if creases:
            bend = np.einsum("ijk,ijk->ij", normals[one], normals[two])
            marked[one] |= both & (bend < _CREASE)
        step = depth[two] - depth[one]
        far = np.nonzero(both & (np.abs(step) > room))
        reach = across.astype(np.float32) * grid.pitch
        slopes = [_slope(normals[part][far], reach, look) for part in (one, two)]
        step = step[far]
        jump = (step < np.minimum(*slopes) - room) | (step > np.maximum(*slopes) + room)
        marked[one][tuple(index[jump] for index in far)] = 1
    return cv2.dilate(marked, np.ones((3, 3), np.uint8)) > 0


def _slope(
    normals: npt.NDArray[np.float32], reach: npt.NDArray[np.float32], look: npt.NDArray[np.float32]
) -> npt.NDArray[np.float32]:
    """Growth of depth along ``reach`` on surfaces with (n, 3) normals; at most 10 times it."""
    facing = np.minimum(normals @ look, -0.1)
    return -(normals @ reach) / facing
