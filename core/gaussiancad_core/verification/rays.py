"""Parallel rays through a grid of pixels, and what they hit of a mesh."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gaussiancad_core.axes import Role
from gaussiancad_core.meshes import TriangleMesh

if TYPE_CHECKING:
    import open3d

_OFF_CENTRE = (0.0137, 0.0071)
"""Rays leave the pixels' centres by this share of a pixel, or they would run along triangle edges
of parts whose edges lie on round coordinates."""


@dataclass(frozen=True)
class RayGrid:
    """Pixels on a plane, seen along its normal.

    Attributes:
        right, up, look: (3,) unit vectors of the plane and of the rays; ``look = up x right``.
        left, top: mm along ``right`` and ``up`` of the grid's upper left corner.
        pitch: mm per pixel.
        width, height: px.
    """

    right: tuple[float, float, float]
    up: tuple[float, float, float]
    look: tuple[float, float, float]
    left: float
    top: float
    pitch: float
    width: int
    height: int

    @classmethod
    def of_view(
        cls, role: Role, area: tuple[float, float, float, float], pitch: float
    ) -> "RayGrid":
        """A grid in a principal view.

        Args:
            role: the view.
            area: least right, least up, greatest right, greatest up that it must cover, mm.
            pitch: mm per pixel.
        """
        left, bottom, right, top = area
        frame = role.frame
        return cls(
            frame.right,
            frame.up,
            frame.look,
            left,
            top,
            pitch,
            max(1, int(np.ceil((right - left) / pitch - 1e-9))),
            max(1, int(np.ceil((top - bottom) / pitch - 1e-9))),
        )

    def plane(self, lattice: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, 2) px from the upper left corner (x right, y down) -> (n, 2) mm (right, up)."""
        return np.array([self.left, self.top]) + lattice * np.array([self.pitch, -self.pitch])

    def rays(self, mesh: TriangleMesh, rows: slice) -> npt.NDArray[np.float32]:
        """(k, 6) origins before the mesh, relative to its middle, and directions; row by row."""
        columns = (np.arange(self.width) + 0.5 + _OFF_CENTRE[0]) * self.pitch + self.left
        lines = self.top - (np.arange(self.height)[rows] + 0.5 + _OFF_CENTRE[1]) * self.pitch
        right, up, look = (np.array(each) for each in (self.right, self.up, self.look))
        nearest = (mesh.vertices @ look).min() - 0.01 * np.ptp(mesh.bounds)
        start = nearest * look - mesh.bounds.mean(axis=0)
        rays = np.empty((len(lines), len(columns), 6), dtype=np.float32)
        rays[..., :3] = (columns[:, None] * right) + (lines[:, None] * up + start)[:, None]
        rays[..., 3:] = look
        return rays.reshape(-1, 6)


@dataclass(frozen=True, eq=False)
class FirstHits:
    """What the rays hit first.

    Attributes:
        depth: (h, w) mm from a common plane before the mesh; infinite where there is nothing.
        triangle: (h, w) int64, or -1.
        weights: (h, w, 3) barycentric weights of the triangle's corners.
    """

    depth: npt.NDArray[np.float32]
    triangle: npt.NDArray[np.int64]
    weights: npt.NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class AllHits:
    """All that the rays cross, ray by ray in the order of depth.

    Attributes:
        splits: (h * w + 1,) the hits of ray i are ``splits[i]`` to ``splits[i + 1]``.
        depth: (n,) mm from a common plane before the mesh.
        triangle: (n,) int64.
        entering: (n,) whether the ray goes into the material there.
    """

    splits: npt.NDArray[np.int64]
    depth: npt.NDArray[np.float32]
    triangle: npt.NDArray[np.int64]
    entering: npt.NDArray[np.bool_]


class RayCaster:
    """A mesh made ready for rays.

    Args:
        mesh: at least one triangle.
    """

    def __init__(self, mesh: TriangleMesh) -> None:
        import open3d

        self.mesh = mesh
        self._scene = open3d.t.geometry.RaycastingScene()
        # About the middle, where single precision is finest.
        middle = mesh.bounds.mean(axis=0)
        self._scene.add_triangles(
            (mesh.vertices - middle).astype(np.float32), mesh.triangles.astype(np.uint32)
        )

    def first_hits(self, grid: RayGrid) -> FirstHits:
        """What each ray of the grid hits first."""
        depth = np.full((grid.height, grid.width), np.inf, dtype=np.float32)
        triangle = np.full(depth.shape, -1, dtype=np.int64)
        weights = np.zeros((*depth.shape, 3), dtype=np.float32)
        for rows in _strips(grid):
            answer = self._scene.cast_rays(_tensor(grid.rays(self.mesh, rows)))
            shape = depth[rows].shape
            depth[rows] = answer["t_hit"].numpy().reshape(shape)
            hit = np.isfinite(depth[rows])
            found = answer["primitive_ids"].numpy().reshape(shape).astype(np.int64)
            triangle[rows] = np.where(hit, found, -1)
            second_third = answer["primitive_uvs"].numpy().reshape(*shape, 2)
            weights[rows, :, 0] = 1.0 - second_third.sum(axis=-1)
            weights[rows, :, 1:] = second_third
        return FirstHits(depth, triangle, weights)

    def all_hits(self, grid: RayGrid) -> AllHits:
        """All crossings of each ray of the grid; those of one surface at one depth count once."""
        look = np.array(grid.look, dtype=np.float64)
        facing = self.mesh.area_vectors @ look < 0.0
        same = 1e-5 * float(np.ptp(self.mesh.bounds, axis=0).max())
        rays, depths, triangles = [], [], []
        for rows in _strips(grid):
            answer = self._scene.list_intersections(_tensor(grid.rays(self.mesh, rows)))
            rays.append(answer["ray_ids"].numpy().astype(np.int64) + rows.start * grid.width)
            depths.append(answer["t_hit"].numpy())
            triangles.append(answer["primitive_ids"].numpy().astype(np.int64))
        ray, depth, triangle = (np.concatenate(parts) for parts in (rays, depths, triangles))
        order = np.lexsort((depth, ray))
        ray, depth, triangle = ray[order], depth[order], triangle[order]
        entering = facing[triangle]

        touching = np.zeros(len(ray), dtype=bool)
        touching[1:] = (ray[1:] == ray[:-1]) & (depth[1:] - depth[:-1] < same)
        equal = np.zeros(len(ray), dtype=bool)
        equal[1:] = entering[1:] == entering[:-1]
        # Of two hits on a common edge one stays; of a wall or gap without thickness neither side.
        gone = touching.copy()
        gone[:-1] |= touching[1:] & ~equal[1:]
        keep = ~gone
        splits = np.searchsorted(ray[keep], np.arange(grid.width * grid.height + 1))
        return AllHits(splits, depth[keep], triangle[keep], entering[keep])


def _strips(grid: RayGrid, most: int = 1_000_000) -> list[slice]:
    """Rows in portions of at most about ``most`` rays, which bounds the memory."""
    rows = max(1, most // grid.width)
    return [slice(start, min(start + rows, grid.height)) for start in range(0, grid.height, rows)]


def _tensor(values: npt.NDArray[np.float32]) -> "open3d.core.Tensor":
    import open3d

    return open3d.core.Tensor(np.ascontiguousarray(values))
