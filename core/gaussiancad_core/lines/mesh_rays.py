"""Parallel rays through a grid of pixels, and what they hit of a mesh."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.lines.mesh_scan_kernels import scan_all, scan_first
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.meshes import TriangleMesh

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

    def corners(self, mesh: TriangleMesh) -> npt.NDArray[np.float64]:
        """(m, 3, 3) of the triangles: px right and down from where the first ray runs, mm deep."""
        axes = np.array([self.right, self.up, self.look], dtype=np.float64)
        across, along, deep = axes @ mesh.vertices.T
        places = np.stack(
            [
                (across - self.left) / self.pitch - 0.5 - _OFF_CENTRE[0],
                (self.top - along) / self.pitch - 0.5 - _OFF_CENTRE[1],
                deep - deep.min() + 0.01 * np.ptp(mesh.bounds),
            ],
            axis=1,
        )
        return places[mesh.triangles]


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
    """A mesh, and the rays that are sent through it.

    Args:
        mesh: at least one triangle.
    """

    def __init__(self, mesh: TriangleMesh) -> None:
        self.mesh = mesh

    def first_hits(self, grid: RayGrid) -> FirstHits:
        """What each ray of the grid hits first."""
        depth = np.full((grid.height, grid.width), np.inf)
        triangle = np.full(depth.shape, -1, dtype=np.int64)
        weights = np.zeros((*depth.shape, 3), dtype=np.float32)
        scan_first(grid.corners(self.mesh), depth, triangle, weights)
        return FirstHits(depth.astype(np.float32), triangle, weights)

    def all_hits(self, grid: RayGrid) -> AllHits:
        """All crossings of each ray of the grid; those of one surface at one depth count once."""
        look = np.array(grid.look, dtype=np.float64)
        facing = self.mesh.area_vectors @ look < 0.0
        same = 1e-5 * float(np.ptp(self.mesh.bounds, axis=0).max())
        ray, depth, triangle = scan_all(grid.corners(self.mesh), grid.height, grid.width)
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


def warm_up() -> None:
    """Compile the kernels, or load them from numba's cache, so that the first picture is quick."""
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    caster = RayCaster(TriangleMesh(corners, np.array([[0, 1, 2]])))
    grid = RayGrid.of_view(Role.TOP, (0.0, 0.0, 1.0, 1.0), 0.5)
    caster.first_hits(grid)
    caster.all_hits(grid)
