"""Oriented points on the discs of Gaussians: what Poisson reconstruction starts from."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.splatting.gaussians import Gaussians


@dataclass(frozen=True, eq=False)
class OrientedPoints:
    """Points on a surface.

    Attributes:
        points: (n, 3) mm.
        normals: (n, 3) unit vectors that point outward.
    """

    points: npt.NDArray[np.float64]
    normals: npt.NDArray[np.float64]


@dataclass(frozen=True)
class DiscSampling:
    """How points are set on the Gaussians' discs.

    Attributes:
        per_disc: points on each.
        reach: the farthest from the centre, in standard deviations.
        smallest_opacity: Gaussians that are more transparent show no surface.
        steepest: largest angle between a disc's normal and that of its start, degrees; a disc that
            turned farther no longer lies on the surface that it stood for.
    """

    per_disc: int = 6
    reach: float = 1.2
    smallest_opacity: float = 0.3
    steepest: float = 60.0


def disc_normals(gaussians: Gaussians) -> npt.NDArray[np.float64]:
    """(n, 3) the thinnest axis of each Gaussian, on the side of its start's normal."""
    thinnest = np.argmin(gaussians.log_scales, axis=1)
    normals = gaussians.rotations[np.arange(len(gaussians)), :, thinnest]
    inward = (normals * gaussians.normals).sum(axis=1) < 0.0
    return np.where(inward[:, None], -normals, normals)


def disc_points(gaussians: Gaussians, sampling: DiscSampling) -> OrientedPoints:
    """Points spread over the Gaussians' discs, each in the disc's plane.

    The points of a disc follow a sunflower (Vogel 1979), turned from disc to disc by the golden
    angle: even, and the same every time.
    """
    normals = disc_normals(gaussians)
    upright = np.cos(np.radians(sampling.steepest))
    kept = gaussians.opacities >= sampling.smallest_opacity
    kept &= (normals * gaussians.normals).sum(axis=1) >= upright
    flat = _flat_axes(gaussians)[kept]
    centres = gaussians.means[kept].astype(np.float64)
    golden = np.pi * (3.0 - np.sqrt(5.0))
    turns = golden * np.arange(len(centres))
    rings = []
    for k in range(sampling.per_disc):
        radius = sampling.reach * np.sqrt((k + 0.5) / sampling.per_disc)
        angles = turns + golden * k
        offsets = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        rings.append(centres + np.einsum("nij,nj->ni", flat, offsets))
    return OrientedPoints(np.concatenate(rings), np.tile(normals[kept], (sampling.per_disc, 1)))


def _flat_axes(gaussians: Gaussians) -> npt.NDArray[np.float64]:
    """(n, 3, 2) the two larger axes of each Gaussian, as long as its standard deviations."""
    order = np.argsort(gaussians.log_scales, axis=1)[:, 1:]
    rows = np.arange(len(gaussians))[:, None]
    axes = gaussians.rotations.transpose(0, 2, 1)[rows, order]
    lengths = np.exp(gaussians.log_scales.astype(np.float64))[rows, order]
    return (axes * lengths[:, :, None]).transpose(0, 2, 1)
