"""Questions to one surface: the nearest point of it, and what lies inside it."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gaussiancad_core.meshes import TriangleMesh

if TYPE_CHECKING:
    import open3d

Points = npt.NDArray[np.float64]

# Oblique to each other and to all faces that parts usually have, so that rays miss their edges.
_PARITY_DIRECTIONS = np.array(
    [[0.5377, 0.6231, 0.5679], [-0.7251, 0.3119, -0.6140], [0.2683, -0.8821, 0.3870]],
    dtype=np.float32,
)


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
    distance zero to rounding.  Beside a sliver the tree may pick the next triangle; the error is
    then at most the sliver's width.  Keep coordinates near the origin for the search.

    Args:
        mesh: at least one triangle.
    """

    def __init__(self, mesh: TriangleMesh) -> None:
        import open3d

        self.mesh = mesh
        self._scene = open3d.t.geometry.RaycastingScene()
        self._scene.add_triangles(
            mesh.vertices.astype(np.float32), mesh.triangles.astype(np.uint32)
        )

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
        return Nearest(on_surface, distances, triangles)

    def distances(self, points: Points) -> npt.NDArray[np.float64]:
        """(n,) distances of (n, 3) points from the surface, in single precision but quick."""
        return self._scene.compute_distance(_tensor(points)).numpy().astype(np.float64)

    def inside(self, points: Points) -> npt.NDArray[np.bool_]:
        """(n,) whether each of (n, 3) points is enclosed.

        Two of three rays with an odd number of crossings decide, so that a small gap in the surface
        spoils few answers.
        """
        votes = np.zeros(len(points), dtype=np.int64)
        for direction in _PARITY_DIRECTIONS:
            rays = np.empty((len(points), 6), dtype=np.float32)
            rays[:, :3] = points
            rays[:, 3:] = direction
            votes += self._scene.count_intersections(_tensor(rays)).numpy() % 2
        return votes >= 2


def _tensor(values: npt.NDArray[np.floating]) -> "open3d.core.Tensor":
    import open3d

    return open3d.core.Tensor(np.ascontiguousarray(values, dtype=np.float32))
