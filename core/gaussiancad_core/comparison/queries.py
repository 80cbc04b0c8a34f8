"""Questions to one surface: the nearest point of it, and what lies inside it."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.meshes import TriangleMesh

if TYPE_CHECKING:
    import open3d

Points = npt.NDArray[np.float64]

# Oblique to each other and to all faces that parts usually have, so that rays miss their edges.
_PARITY_DIRECTIONS = np.array(
    [[0.5377, 0.6231, 0.5679], [-0.7251, 0.3119, -0.6140], [0.2683, -0.8821, 0.3870]],
    dtype=np.float32,
)


_THIN = 0.05
"""Height over longest side below which a triangle is a sliver."""

_CHUNK = 20_000
"""Points that are looked at together: around holes many slivers share a corner."""


@dataclass(frozen=True, eq=False)
class Nearest:
    """The nearest points of a surface to given points.

    Attributes:
        points: (n, 3) on the surface.
        distances: (n,) from the given points.
        triangles: (n,) int64, the triangle that holds each point.
    """

    points: Points
    distances: npt.NDArray[np.float64]
    triangles: npt.NDArray[np.int64]


class SurfaceQueries:
    """A mesh made ready for many questions.

    The search tree works in single precision.  It only picks the triangle; the nearest point on
    that triangle is then computed in double precision, so that a point of the surface is at
    distance zero to rounding.  Of slivers the tree computes wrong distances and picks what lies
    beside them; so slivers that share a corner with the picked triangle are tried as well.  Keep
    coordinates near the origin for the search.

    Args:
        mesh: at least one triangle.
    """

    def __init__(self, mesh: TriangleMesh) -> None:
        from gaussiancad_core.kernel.bare_open3d import open3d

        self.mesh = mesh
        self._scene = open3d.t.geometry.RaycastingScene()
        vertices, triangles = mesh.vertices.astype(np.float32), mesh.triangles.astype(np.uint32)
        self._scene.add_triangles(vertices, triangles)  # type: ignore[call-overload] # stub: Tensor

    @cached_property
    def closed(self) -> bool:
        """Whether the mesh is watertight, so that it has an inside."""
        return self.mesh.watertight

    def nearest(self, points: Points) -> Nearest:
        """The nearest points of the surface to (n, 3) points, in double precision."""
        import trimesh

        found = self._scene.compute_closest_points(_tensor(points))
        triangles = found["primitive_ids"].numpy().astype(np.int64)
        on_surface = trimesh.triangles.closest_point(self.mesh.corners[triangles], points)
        distances = np.linalg.norm(points - on_surface, axis=1)
        nearest = Nearest(on_surface, distances, triangles)
        for start in range(0, len(points), _CHUNK):
            self._try_slivers(points, nearest, slice(start, start + _CHUNK))
        return nearest

    def _try_slivers(self, points: Points, nearest: Nearest, chunk: slice) -> None:
        """Put slivers that lie nearer into what was found for a chunk of the points."""
        import trimesh

        picked, values, reach = nearest.triangles[chunk], points[chunk], nearest.distances[chunk]
        which, slivers = self._slivers.nearby(picked, values, reach)
        if not len(which):
            return
        places = trimesh.triangles.closest_point(self.mesh.corners[slivers], values[which])
        sizes = np.linalg.norm(values[which] - places, axis=1)
        # The nearest sliver of each point comes first.
        order = np.lexsort((sizes, which))
        _, first = np.unique(which[order], return_index=True)
        best = order[first]
        best = best[sizes[best] < reach[which[best]]]
        target = which[best] + chunk.start
        nearest.points[target], nearest.triangles[target] = places[best], slivers[best]
        nearest.distances[target] = sizes[best]

    @cached_property
    def _slivers(self) -> "_Slivers":
        return _Slivers(self.mesh)

    def distances(self, points: Points) -> npt.NDArray[np.float64]:
        """(n,) distances of (n, 3) points from the surface, in single precision but quick."""
        return self._scene.compute_distance(_tensor(points)).numpy().astype(np.float64)

    def inside(self, points: Points) -> npt.NDArray[np.bool_]:
        """(n,) whether each of (n, 3) points is enclosed.

        Most of the rays must have an odd number of crossings.  Of an open mesh their opposites
        count as well: what is flat lies on one side of a point, and encloses none.
        """
        votes = np.zeros(len(points), dtype=np.int64)
        directions = _PARITY_DIRECTIONS
        if not self.closed:
            directions = np.concatenate([directions, -directions])
        for direction in directions:
            rays = np.empty((len(points), 6), dtype=np.float32)
            rays[:, :3] = points
            rays[:, 3:] = direction
            votes += self._scene.count_intersections(_tensor(rays)).numpy() % 2
        return votes > len(directions) // 2


class _Slivers:
    """The thin triangles of a mesh, by their corners.

    Args:
        mesh: at least one triangle.
    """

    def __init__(self, mesh: TriangleMesh) -> None:
        corners = mesh.corners
        sides = np.square(corners - np.roll(corners, 1, axis=1)).sum(axis=2)
        thin = 2.0 * mesh.areas < _THIN * sides.max(axis=1)
        self._triangles = mesh.triangles
        numbers = np.flatnonzero(thin)
        vertices = mesh.triangles[numbers].ravel()
        order = np.argsort(vertices, kind="stable")
        self._numbers = np.repeat(numbers, 3)[order]
        self._starts = np.searchsorted(vertices[order], np.arange(len(mesh.vertices) + 1))
        self._low, self._high = corners.min(axis=1), corners.max(axis=1)

    def nearby(
        self,
        triangles: npt.NDArray[np.int64],
        points: Points,
        distances: npt.NDArray[np.float64],
    ) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
        """Slivers that may lie nearer to points than the triangles that were picked for them.

        Args:
            triangles, points, distances: (n,), (n, 3) and (n,); what was picked, for which points.

        Returns:
            Pairs (k,) and (k,) of points and slivers.
        """
        vertices = self._triangles[triangles]
        counts = (self._starts[vertices + 1] - self._starts[vertices]).ravel()
        total = int(counts.sum())
        which = np.repeat(np.repeat(np.arange(len(points)), 3), counts)
        # The places 0, 1, 2 ... within each corner's run.
        within = np.arange(total) - np.repeat(np.cumsum(counts) - counts, counts)
        slivers = self._numbers[np.repeat(self._starts[vertices].ravel(), counts) + within]
        away = np.maximum(self._low[slivers] - points[which], points[which] - self._high[slivers])
        near = np.square(np.maximum(away, 0.0)).sum(axis=1) < np.square(distances[which])
        return which[near], slivers[near]


def _tensor(values: npt.NDArray[np.floating]) -> "open3d.core.Tensor":
    from gaussiancad_core.kernel.bare_open3d import open3d

    plain = np.ascontiguousarray(values, dtype=np.float32)
    return open3d.core.Tensor(plain)  # type: ignore[call-overload] # the stub has another's array
