"""Where, and by how much, the result leaves the reference: a mesh with a number at every vertex.

The file ``deviation.ply`` is binary little-endian PLY 1.0.  Its layout is fixed, so that a reader
needs no PLY library:

* header lines ``comment unit mm``, ``comment signed 0|1`` and ``comment range R``: the colours run
  from -R (blue: the result lies inside the reference) over light grey to +R (red: outside);
* per vertex ``float x, y, z`` in the reference's coordinates, ``uchar red, green, blue`` and
  ``float deviation`` in mm: 19 bytes, no padding;
* per face ``uchar`` 3 and three ``int`` indices: 13 bytes.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.mesh_edges import mesh_edges
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

LONGEST_EDGE_SHARE = 1.0 / 60.0
"""Triangles are split until no edge is longer than this share of the model's longest edge."""

_MOST_TRIANGLES = 400_000

_SMALLEST_RANGE_SHARE = 1e-4

_ROUND = (1.0, 1.2, 1.6, 2.0, 2.4, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)

# Blue, light grey, red: equally light at equal distance from the middle, distinct to colour-blind
# eyes (after the diverging maps of Moreland 2009).
COLOUR_STOPS = np.array(
    [[33, 76, 178], [122, 160, 225], [225, 225, 225], [232, 139, 108], [175, 24, 38]],
    dtype=np.float64,
)


@dataclass(frozen=True, eq=False)
class Deviation:
    """Distances of the result's vertices from the reference.

    Attributes:
        mesh: the result, finely split, in the reference's coordinates, mm.
        distances: (n,) mm at each vertex; negative where the vertex lies inside the reference.
        signed: False where the reference encloses no volume; then all distances are positive.
        limit: mm, the end of the colour scale; a few distances may lie beyond.
        scale: by which the result was scaled to lie over the reference.
    """

    mesh: TriangleMesh
    distances: npt.NDArray[np.float64]
    signed: bool
    limit: float
    scale: float = 1.0

    @property
    def colours(self) -> npt.NDArray[np.uint8]:
        """(n, 3) RGB of the vertices."""
        return diverging_colours(self.distances / self.limit)


def measure_deviation(result: TriangleMesh, reference: SurfaceQueries, unit: float) -> Deviation:
    """Measure the result against the reference, both in the box of the comparison.

    Args:
        result: registered, in units.
        reference: in units.
        unit: mm per unit; distances and the mesh come in mm, still centred on the box.
    """
    longest = float(np.ptp(reference.mesh.bounds, axis=0).max())
    fine = split_long_edges(result, longest * LONGEST_EDGE_SHARE, _MOST_TRIANGLES)
    distances = reference.nearest(fine.vertices).distances
    signed = reference.closed
    if signed:
        # What touches the reference has no side.
        inner = reference.inside(fine.vertices) & (distances > 1e-9 * longest)
        distances = np.where(inner, -distances, distances)
    distances = distances * unit
    sizes = np.abs(distances)
    # A few stray vertices may leave the scale, but never by more than four times.
    reach = max(float(np.quantile(sizes, 0.99)), float(sizes.max()) / 4.0)
    limit = _round_up(max(reach, longest * unit * _SMALLEST_RANGE_SHARE))
    return Deviation(make_mesh(fine.vertices * unit, fine.triangles), distances, signed, limit)


def diverging_colours(values: npt.NDArray[np.float64]) -> npt.NDArray[np.uint8]:
    """(n,) values from -1 to 1 -> (n, 3) RGB, blue over light grey to red; clipped outside."""
    places = (np.clip(values, -1.0, 1.0) + 1.0) * (len(COLOUR_STOPS) - 1) / 2.0
    stops = np.arange(len(COLOUR_STOPS))
    channels = [np.interp(places, stops, COLOUR_STOPS[:, channel]) for channel in range(3)]
    return np.rint(np.stack(channels, axis=-1)).astype(np.uint8)


def split_long_edges(mesh: TriangleMesh, longest: float, most: int) -> TriangleMesh:
    """Halve every edge longer than ``longest``, again and again, without opening cracks.

    Args:
        mesh: any triangles; those with short edges stay as they are.
        longest: in the mesh's unit.
        most: no further round once there are this many triangles.
    """
    while len(mesh.triangles) < most:
        edges = mesh_edges(mesh.triangles)
        ends = mesh.vertices[edges.ends]
        long = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) > longest
        if not long.any():
            break
        middles = np.full(len(edges.ends), -1)
        middles[long] = len(mesh.vertices) + np.arange(int(long.sum()))
        vertices = np.concatenate([mesh.vertices, ends[long].mean(axis=1)])
        mesh = make_mesh(vertices, _split(mesh.triangles, middles[edges.of_triangle]))
    return mesh


def ply_bytes(deviation: Deviation) -> bytes:
    """The content of ``deviation.ply``; its layout is in this module's docstring."""
    mesh = deviation.mesh
    vertices = np.zeros(
        len(mesh.vertices), dtype=[("point", "<f4", 3), ("colour", "u1", 3), ("deviation", "<f4")]
    )
    vertices["point"] = mesh.vertices
    vertices["colour"] = deviation.colours
    vertices["deviation"] = deviation.distances
    faces = np.zeros(len(mesh.triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"] = 3
    faces["corners"] = mesh.triangles
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"comment unit mm\ncomment signed {int(deviation.signed)}\n"
        f"comment range {deviation.limit:.9g}\n"
        f"element vertex {len(vertices)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "property float deviation\n"
        f"element face {len(faces)}\n"
        "property list uchar int vertex_indices\nend_header\n"
    )
    return header.encode("ascii") + vertices.tobytes() + faces.tobytes()


def _split(
    triangles: npt.NDArray[np.int64], middles: npt.NDArray[np.int64]
) -> npt.NDArray[np.int64]:
    """Triangles cut at the middles (-1: none) of their sides 0-1, 1-2, 2-0."""
    cut = middles >= 0
    count = cut.sum(axis=1)
    # Turned so that one cut side is 0-1, and of two cut sides the other one is 1-2.
    turn = np.where(
        count == 1, cut.argmax(axis=1), np.where(count == 2, (~cut).argmax(axis=1) + 1, 0)
    )
    order = (np.arange(3) + turn[:, None]) % 3
    a, b, c = np.take_along_axis(triangles, order, axis=1).T
    ab, bc, ca = np.take_along_axis(middles, order, axis=1).T
    pieces = {
        0: [(a, b, c)],
        1: [(a, ab, c), (ab, b, c)],
        2: [(ab, b, bc), (a, ab, bc), (a, bc, c)],
        3: [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)],
    }
    parts = [
        np.stack(corners, axis=1)[count == number]
        for number, patterns in pieces.items()
        for corners in patterns
    ]
    return np.concatenate(parts)


def _round_up(value: float) -> float:
    """The next number with few digits at or above a positive value."""
    decade = 10.0 ** np.floor(np.log10(value))
    step = next(step for step in _ROUND if value <= step * decade * (1.0 + 1e-12))
    return float(f"{step * decade:.9g}")
