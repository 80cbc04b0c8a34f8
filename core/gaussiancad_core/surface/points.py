"""Oriented points on the discs of Gaussians: what Poisson reconstruction starts from."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.splatting.gaussians import Gaussians

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class OrientedPoints:
    """Points on a surface.

    Attributes:
        points: (n, 3) mm.
        normals: (n, 3) unit vectors that point outward.
    """

    points: Array
    normals: Array


@dataclass(frozen=True)
class DiscSampling:
    """How points are set on the Gaussians' discs.

    Attributes:
        per_disc: points on each.
        reach: the farthest from the centre, in standard deviations.
        smallest_opacity: Gaussians that are more transparent show no surface.
        steepest: largest angle between a disc's normal and that of its start, degrees; a disc that
            turned farther no longer lies on the surface that it stood for.
        crease: neighbouring discs whose normals differ by more, in degrees, meet in an edge.
        neighbours: discs around one that may meet it in an edge.
        edge_reach: how far a disc's edges are looked for, in standard deviations.
    """

    per_disc: int = 6
    reach: float = 1.2
    smallest_opacity: float = 0.02
    steepest: float = 60.0
    crease: float = 30.0
    neighbours: int = 16
    edge_reach: float = 2.0


@dataclass(frozen=True, eq=False)
class _Discs:
    """Centres (n, 3) in mm, unit normals (n, 3), and the flat axes (n, 3, 2), as long as sigma."""

    centres: Array
    normals: Array
    axes: Array


def disc_normals(gaussians: Gaussians) -> Array:
    """(n, 3) the thinnest axis of each Gaussian, on the side of its start's normal."""
    thinnest = np.argmin(gaussians.log_scales, axis=1)
    normals = gaussians.rotations[np.arange(len(gaussians)), :, thinnest]
    inward = (normals * gaussians.normals).sum(axis=1) < 0.0
    return np.where(inward[:, None], -normals, normals)


def disc_points(gaussians: Gaussians, sampling: DiscSampling) -> OrientedPoints:
    """Points spread over the Gaussians' discs, each in the disc's plane.

    The points of a disc follow a sunflower (Vogel 1979), turned from disc to disc by the golden
    angle: even, and the same every time.  Where two faces meet in an edge, discs of one hang over
    the other or end before it: their points are drawn back onto the edge, and others are set there,
    which keeps it straight and sharp.
    """
    discs = _discs(gaussians, sampling)
    golden = np.pi * (3.0 - np.sqrt(5.0))
    turns = golden * np.arange(len(discs.centres))
    rings = []
    for k in range(sampling.per_disc):
        radius = sampling.reach * np.sqrt((k + 0.5) / sampling.per_disc)
        angles = turns + golden * k
        offsets = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        rings.append(discs.centres + np.einsum("nij,nj->ni", discs.axes, offsets))
    normals = [np.tile(discs.normals, (sampling.per_disc, 1))]
    if len(discs.centres) > sampling.neighbours:
        rings = [_drawn_back(ring, discs, sampling) for ring in rings]
        edge = _edge_points(discs, sampling)
        rings.append(edge.points)
        normals.append(edge.normals)
    return OrientedPoints(np.concatenate(rings), np.concatenate(normals))


def _discs(gaussians: Gaussians, sampling: DiscSampling) -> _Discs:
    normals = disc_normals(gaussians)
    upright = np.cos(np.radians(sampling.steepest))
    kept = gaussians.opacities >= sampling.smallest_opacity
    kept &= (normals * gaussians.normals).sum(axis=1) >= upright
    order = np.argsort(gaussians.log_scales, axis=1)[:, 1:]
    rows = np.arange(len(gaussians))[:, None]
    axes = gaussians.rotations.transpose(0, 2, 1)[rows, order]
    lengths = np.exp(gaussians.log_scales.astype(np.float64))[rows, order]
    flat = (axes * lengths[:, :, None]).transpose(0, 2, 1)
    return _Discs(gaussians.means[kept].astype(np.float64), normals[kept], flat[kept])


def _drawn_back(points: Array, discs: _Discs, sampling: DiscSampling) -> Array:
    """One point a disc, moved within the disc's plane so that it does not cross another face."""
    _, near = cKDTree(discs.centres).query(points, k=sampling.neighbours)
    drawn = points.copy()
    for other in near.T:
        crossing = _towards(drawn, discs, other, sampling)
        own_side = ((discs.centres - discs.centres[other]) * discs.normals[other]).sum(axis=1)
        crossed = crossing.creased & (own_side * crossing.beyond < 0.0)
        drawn[crossed] = crossing.points[crossed]
    return drawn


def _edge_points(discs: _Discs, sampling: DiscSampling) -> OrientedPoints:
    """For each disc near an edge, the points of the edge next to it, one a disc across the edge."""
    reach = sampling.edge_reach * np.linalg.norm(discs.axes, axis=1).mean(axis=1)
    _, near = cKDTree(discs.centres).query(discs.centres, k=sampling.neighbours)
    points, normals = [], []
    for other in near.T[1:]:
        crossing = _towards(discs.centres, discs, other, sampling)
        there = np.linalg.norm(crossing.points - discs.centres, axis=1) < reach
        back = np.linalg.norm(crossing.points - discs.centres[other], axis=1) < reach
        found = crossing.creased & there & back
        points.append(crossing.points[found])
        normals.append(discs.normals[found])
    return OrientedPoints(np.concatenate(points), np.concatenate(normals))


@dataclass(frozen=True, eq=False)
class _Crossing:
    """Where each disc's plane, from a point in it, meets the plane of another disc.

    Attributes:
        points: (n, 3) nearest points that lie in both planes.
        beyond: (n,) distance of the point from the other plane, positive on its outer side.
        creased: (n,) whether the planes differ enough to meet in an edge.
    """

    points: Array
    beyond: Array
    creased: npt.NDArray[np.bool_]


def _towards(
    points: Array, discs: _Discs, other: npt.NDArray[np.int64], sampling: DiscSampling
) -> _Crossing:
    normals = discs.normals[other]
    cosines = (normals * discs.normals).sum(axis=1)
    creased = np.abs(cosines) < np.cos(np.radians(sampling.crease))
    beyond = ((points - discs.centres[other]) * normals).sum(axis=1)
    slope = normals - cosines[:, None] * discs.normals
    steps = beyond / np.where(creased, (slope**2).sum(axis=1), 1.0)
    return _Crossing(points - steps[:, None] * slope, beyond, creased)
