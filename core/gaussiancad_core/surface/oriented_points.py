"""Oriented points on the discs of Gaussians: what Poisson reconstruction starts from."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from gaussiancad_core.surface.discs import Array, Creases, Discs, DiscSampling, crossing


@dataclass(frozen=True, eq=False)
class OrientedPoints:
    """Points on a surface.

    Attributes:
        points: (n, 3) mm.
        normals: (n, 3) unit vectors that point outward.
    """

    points: Array
    normals: Array


def disc_points(discs: Discs, creases: Creases, sampling: DiscSampling) -> OrientedPoints:
    """Points spread over discs, each in its disc's plane, and those of the creases.

    The points of a disc follow a sunflower (Vogel 1979), turned from disc to disc by the golden
    angle: even, and the same every time.  Where two faces meet in an edge, discs of one hang over
    the other or end before it: their points are drawn back onto the edge, and others are set there,
    which keeps it straight and sharp.
    """
    golden = np.pi * (3.0 - np.sqrt(5.0))
    turns = golden * np.arange(len(discs))
    rings = []
    for k in range(sampling.per_disc):
        radius = sampling.reach * np.sqrt((k + 0.5) / sampling.per_disc)
        angles = turns + golden * k
        offsets = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        rings.append(discs.centres + np.einsum("nij,nj->ni", discs.axes, offsets))
    if len(discs) > sampling.neighbours:
        rings = [_drawn_back(ring, discs, sampling) for ring in rings]
    normals = np.tile(discs.normals, (sampling.per_disc, 1))
    return OrientedPoints(
        np.concatenate([*rings, creases.points]), np.concatenate([normals, creases.normals])
    )


def _drawn_back(points: Array, discs: Discs, sampling: DiscSampling) -> Array:
    """One point a disc, moved within the disc's plane so that it does not cross another face."""
    _, near = cKDTree(discs.centres).query(points, k=sampling.neighbours)
    drawn = points.copy()
    for other in near.T:
        met = crossing(drawn, discs, other, sampling)
        own_side = ((discs.centres - discs.centres[other]) * discs.normals[other]).sum(axis=1)
        crossed = met.creased & (own_side * met.beyond < 0.0)
        drawn[crossed] = met.points[crossed]
    return drawn
