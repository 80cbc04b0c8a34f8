"""The Gaussians that are trained, and how they start on the hull's surface.

Parameters are stored as 3D Gaussian splatting stores them (Kerbl et al. 2023): logarithms of the
axes' standard deviations, logits of the opacities, quaternions with the scalar first.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.meshes import TriangleMesh


@dataclass(frozen=True, eq=False)
class Gaussians:
    """n Gaussians in model millimetres.

    Attributes:
        means: (n, 3) centres, mm.
        quaternions: (n, 4) w x y z, of any length but zero; they turn the axes into the model's.
        log_scales: (n, 3) natural logarithms of the standard deviations along the axes in mm.
        logit_opacities: (n,) logits of the opacities.
        colours: (n, 3) RGB, 0 to 1.
        normals: (n, 3) unit outward normals of the surface on which the Gaussians started.
    """

    means: npt.NDArray[np.float32]
    quaternions: npt.NDArray[np.float32]
    log_scales: npt.NDArray[np.float32]
    logit_opacities: npt.NDArray[np.float32]
    colours: npt.NDArray[np.float32]
    normals: npt.NDArray[np.float32]

    def __len__(self) -> int:
        return len(self.means)

    @property
    def opacities(self) -> npt.NDArray[np.float32]:
        """(n,) 0 to 1."""
        return np.asarray(1.0 / (1.0 + np.exp(-self.logit_opacities)), dtype=np.float32)

    @property
    def rotations(self) -> npt.NDArray[np.float64]:
        """(n, 3, 3) matrices whose columns are the Gaussians' axes in the model."""
        return rotation_matrices(self.quaternions)


@dataclass(frozen=True)
class Start:
    """How Gaussians start on a surface.

    Attributes:
        count: number of Gaussians.
        spread: standard deviation in the surface, in mean distances between Gaussians.
        thickness: standard deviation across the surface, as a share of that in it.
        opacity: 0 to 1.
        colour: RGB, 0 to 1.
        seed: of the places.
    """

    count: int = 5_000
    spread: float = 0.6
    thickness: float = 0.04
    opacity: float = 0.88
    colour: tuple[float, float, float] = (0.5, 0.5, 0.5)
    seed: int = 0


def gaussians_on(surface: TriangleMesh, start: Start) -> Gaussians:
    """Flat Gaussians spread evenly over a surface, their third axis along its normal.

    Args:
        surface: watertight, oriented outward, mm.
        start: how many, how wide, which colour.
    """
    means, normals = spread_points(surface, start.count, start.seed)
    sigma = start.spread * np.sqrt(surface.area / start.count)
    scales = np.array([sigma, sigma, start.thickness * sigma])
    logit = np.log(start.opacity / (1.0 - start.opacity))
    count = len(means)
    return Gaussians(
        means=means.astype(np.float32),
        quaternions=quaternions_to(normals).astype(np.float32),
        log_scales=np.tile(np.log(scales), (count, 1)).astype(np.float32),
        logit_opacities=np.full(count, logit, dtype=np.float32),
        colours=np.tile(np.array(start.colour), (count, 1)).astype(np.float32),
        normals=normals.astype(np.float32),
    )


def spread_points(
    surface: TriangleMesh, count: int, seed: int
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Points spread evenly over a surface, and the unit normals there.

    Four times as many independent points are thinned out, the most crowded first (sample
    elimination, Yuksel 2015, in open3d).

    Args:
        surface: at least one triangle with area.
        count: number of points.
        seed: of the independent points.

    Returns:
        (count, 3) points in mm and (count, 3) normals.
    """
    from gaussiancad_core.kernel.bare_open3d import open3d

    mesh = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(surface.vertices),
        open3d.utility.Vector3iVector(surface.triangles.astype(np.int32)),
    )
    mesh.compute_triangle_normals()
    open3d.utility.random.seed(seed)
    cloud = mesh.sample_points_poisson_disk(count, init_factor=4, use_triangle_normal=True)
    return np.asarray(cloud.points).copy(), np.asarray(cloud.normals).copy()


def quaternions_to(normals: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """(n, 3) unit vectors -> (n, 4) unit quaternions that turn the third axis there."""
    x, y, z = normals.T
    zero = np.zeros(len(normals))
    upward = np.stack([1.0 + z, -y, x, zero], axis=1)
    # Near straight down 1 + z loses its digits: half a turn about the first axis goes ahead.
    downward = np.stack([-y, 1.0 - z, zero, x], axis=1)
    quaternions = np.where((z < 0.0)[:, None], downward, upward)
    return quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)


def rotation_matrices(quaternions: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """(n, 4) quaternions w x y z of any length but zero -> (n, 3, 3) rotation matrices."""
    unit = np.asarray(quaternions, dtype=np.float64)
    w, x, y, z = (unit / np.linalg.norm(unit, axis=1, keepdims=True)).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)
