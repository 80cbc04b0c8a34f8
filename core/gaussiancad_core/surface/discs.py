"""The flat discs that Gaussians are, and the creases in which those of two faces meet."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.hull.visual_hull import DEFAULT_CELLS
from gaussiancad_core.splatting.gaussians import Gaussians

Array = npt.NDArray[np.float64]

NEIGHBOURS = 8
"""Neighbours that tell how the surface bends at a place, and how far discs are apart there."""

_ALIKE = 0.97
"""Cosine from which on discs belong to one face."""

_OF_TWO = 0.7
"""Share of the neighbours that belong to one of two faces where these meet in an edge."""

_BETWEEN = 0.1
"""By how much the cosine of two faces is less than those of a disc that faces between them."""

_ROUND = 90.0
"""Bend in degrees where neighbours face in many directions."""


@dataclass(frozen=True)
class DiscSampling:
    """How points are set on the Gaussians' discs.

    Attributes:
        per_disc: points on each.
        reach: the farthest from the centre, in standard deviations.
        share: largest standard deviation, as a share of the distance between discs: training
            enlarges discs until they hang over edges, where others stand for the surface.
        smallest_opacity: Gaussians that are more transparent show no surface.
        steepest: largest angle between a disc's normal and that of its start, degrees; a disc that
            turned farther no longer lies on the surface that it stood for.
        crease: neighbouring discs whose normals differ by more, in degrees, meet in an edge.
        neighbours: discs around one that may meet it in an edge.
        edge_reach: how far a disc's edges are looked for, in standard deviations.
        bevel: largest distance of a disc's centre from the planes of two faces between which it is
            a bevel that the hull left along their edge, in cells of the hull's grid.
        face: mean angle between neighbouring discs, in degrees, up to which they make a face that
            can have such a bevel.
    """

    per_disc: int = 6
    reach: float = 1.2
    share: float = 0.5
    smallest_opacity: float = 0.02
    steepest: float = 60.0
    crease: float = 30.0
    neighbours: int = 16
    edge_reach: float = 2.0
    bevel: float = 1.0
    face: float = 10.0


@dataclass(frozen=True, eq=False)
class Discs:
    """Flat discs.

    Attributes:
        centres: (n, 3) mm.
        normals: (n, 3) unit vectors that point outward.
        axes: (n, 3, 2) the two directions in the disc, each as long as its standard deviation, mm.
    """

    centres: Array
    normals: Array
    axes: Array

    def __len__(self) -> int:
        return len(self.centres)

    def chosen(self, kept: npt.NDArray[np.bool_]) -> "Discs":
        """Those that (n,) flags keep."""
        return Discs(self.centres[kept], self.normals[kept], self.axes[kept])

    @property
    def sigmas(self) -> Array:
        """(n,) mean standard deviations in the disc, mm."""
        return np.linalg.norm(self.axes, axis=1).mean(axis=1)


@dataclass(frozen=True, eq=False)
class Creases:
    """Points of edges, each where the planes of two neighbouring discs meet.

    Attributes:
        points: (n, 3) mm.
        normals: (n, 3) of the disc that the point was found from.
        others: (n, 3) normals of the disc on the other side.
        convex: (n,) whether the material lies within both planes, not within either.
        bends: (n,) mean angle in degrees between neighbouring discs beside the edge, of the two
            sides the larger one; 0 between planes, 90 where discs face in many directions.
    """

    points: Array
    normals: Array
    others: Array
    convex: npt.NDArray[np.bool_]
    bends: Array

    def __len__(self) -> int:
        return len(self.points)

    def between_planes(self, most: float) -> "Creases":
        """Those beside which the surface bends by less than ``most`` degrees."""
        kept = self.bends < most
        return Creases(
            self.points[kept],
            self.normals[kept],
            self.others[kept],
            self.convex[kept],
            self.bends[kept],
        )


@dataclass(frozen=True, eq=False)
class Crossing:
    """Where each disc's plane, from a point in it, meets the plane of another disc.

    Attributes:
        points: (n, 3) nearest points that lie in both planes.
        beyond: (n,) distance of the point from the other plane, positive on its outer side.
        creased: (n,) whether the planes differ enough to meet in an edge.
    """

    points: Array
    beyond: Array
    creased: npt.NDArray[np.bool_]


def disc_normals(gaussians: Gaussians) -> Array:
    """(n, 3) the thinnest axis of each Gaussian, on the side of its start's normal."""
    thinnest = np.argmin(gaussians.log_scales, axis=1)
    normals = gaussians.rotations[np.arange(len(gaussians)), :, thinnest]
    inward = (normals * gaussians.normals).sum(axis=1) < 0.0
    return np.where(inward[:, None], -normals, normals)


def discs_of(gaussians: Gaussians, sampling: DiscSampling) -> Discs:
    """The discs of all Gaussians that show a surface, each about as large as its share of it."""
    normals = disc_normals(gaussians)
    upright = np.cos(np.radians(sampling.steepest))
    kept = gaussians.opacities >= sampling.smallest_opacity
    kept &= (normals * gaussians.normals).sum(axis=1) >= upright
    order = np.argsort(gaussians.log_scales, axis=1)[:, 1:]
    rows = np.arange(len(gaussians))[:, None]
    axes = gaussians.rotations.transpose(0, 2, 1)[rows, order]
    lengths = np.exp(gaussians.log_scales.astype(np.float64))[rows, order]
    flat = (axes * lengths[:, :, None]).transpose(0, 2, 1)
    discs = Discs(gaussians.means[kept].astype(np.float64), normals[kept], flat[kept])
    return _shared_out(_without_bevels(_without_lone(discs, sampling), sampling), sampling)


def _without_lone(discs: Discs, sampling: DiscSampling) -> Discs:
    """The discs but those that face as none around them does.

    Hulls are bevelled along their edges by a cell of their grid: a disc that started there belongs
    to neither face, and its plane would make edges where there are none.
    """
    if len(discs) <= NEIGHBOURS:
        return discs
    _, near = cKDTree(discs.centres).query(discs.centres, k=NEIGHBOURS + 1)
    cosines = np.einsum("nj,nkj->nk", discs.normals, discs.normals[near[:, 1:]])
    kept = (cosines > np.cos(np.radians(sampling.crease))).any(axis=1)
    return discs.chosen(kept)


def _without_bevels(discs: Discs, sampling: DiscSampling) -> Discs:
    """The discs but those whose place the planes of two faces on either side already take.

    Along a hull's edges several bevelled discs may be neighbours.  They face between the two faces
    that meet there and lie within a cell of the hull's grid on the planes of both.  Discs of a
    small fillet do, too, but they lie among others that bend as much.
    """
    if len(discs) <= sampling.neighbours:
        return discs
    _, near = cKDTree(discs.centres).query(discs.centres, k=sampling.neighbours)
    near = near[:, 1:]
    normals = discs.normals[near]
    cell = float(np.ptp(discs.centres, axis=0).max()) / DEFAULT_CELLS
    above = ((discs.centres[:, None] - discs.centres[near]) * normals).sum(axis=2)
    facing = np.einsum("nj,nkj->nk", discs.normals, normals)
    through = np.abs(above) < sampling.bevel * cell
    through &= facing < np.cos(np.radians(sampling.crease))
    through &= (_bends(discs, near[:, :NEIGHBOURS], sampling) < sampling.face)[near]
    apart = np.einsum("nkj,nmj->nkm", normals, normals)
    between = apart < np.minimum(facing[:, :, None], facing[:, None, :]) - _BETWEEN
    kept = ~(between & through[:, :, None] & through[:, None, :]).any(axis=(1, 2))
    return discs.chosen(kept)


def _shared_out(discs: Discs, sampling: DiscSampling) -> Discs:
    """The discs, none larger than its share of the surface."""
    if len(discs) <= NEIGHBOURS:
        return discs
    distances, _ = cKDTree(discs.centres).query(discs.centres, k=NEIGHBOURS + 1)
    # So many neighbours lie in the circle through the farthest of them.
    spacing = distances[:, -1] * np.sqrt(np.pi / NEIGHBOURS)
    sigmas = np.linalg.norm(discs.axes, axis=1)
    scales = np.minimum(1.0, sampling.share * spacing[:, None] / sigmas)
    return Discs(discs.centres, discs.normals, discs.axes * scales[:, None, :])


def crossing(
    points: Array, discs: Discs, other: npt.NDArray[np.int64], sampling: DiscSampling
) -> Crossing:
    """Follow each disc's plane to another's.

    Args:
        points: (n, 3) one in the plane of each disc, mm.
        discs: n.
        other: (n,) the disc whose plane is met.
        sampling: from which angle on two discs meet in an edge.
    """
    normals = discs.normals[other]
    cosines = (normals * discs.normals).sum(axis=1)
    creased = np.abs(cosines) < np.cos(np.radians(sampling.crease))
    beyond = ((points - discs.centres[other]) * normals).sum(axis=1)
    slope = normals - cosines[:, None] * discs.normals
    steps = beyond / np.where(creased, (slope**2).sum(axis=1), 1.0)
    return Crossing(points - steps[:, None] * slope, beyond, creased)


def creases_of(discs: Discs, sampling: DiscSampling) -> Creases:
    """For each disc near an edge, the points of the edge next to it, one a disc across the edge."""
    if len(discs) <= sampling.neighbours:
        none = np.zeros((0, 3))
        return Creases(none, none, none, np.zeros(0, bool), np.zeros(0))
    reach = sampling.edge_reach * discs.sigmas
    _, near = cKDTree(discs.centres).query(discs.centres, k=sampling.neighbours)
    neighbour = near[:, 1 : NEIGHBOURS + 1]
    bends = _bends(discs, neighbour, sampling)
    columns = []
    for other in near.T[1:]:
        met = crossing(discs.centres, discs, other, sampling)
        there = np.linalg.norm(met.points - discs.centres, axis=1) < reach
        back = np.linalg.norm(met.points - discs.centres[other], axis=1) < reach
        found = met.creased & there & back
        across = other[found]
        across_normals = discs.normals[across]
        columns.append(
            (
                met.points[found],
                discs.normals[found],
                across_normals,
                met.beyond[found] < 0.0,
                np.where(
                    _two_faces(
                        discs.normals[neighbour[found]], discs.normals[found], across_normals
                    ),
                    np.maximum(bends[found], bends[across]),
                    _ROUND,
                ),
            )
        )
    return Creases(*(np.concatenate(parts) for parts in zip(*columns, strict=True)))


def _two_faces(around: Array, values: Array, others: Array) -> npt.NDArray[np.bool_]:
    """(m,) whether most normals (m, k, 3) around an edge are one of its two (m, 3).

    Around a slender pin neighbours may differ by as much as two faces do, and meet in no edge.
    """
    alike = np.einsum("mkj,mj->mk", around, values) > _ALIKE
    alike |= np.einsum("mkj,mj->mk", around, others) > _ALIKE
    return alike.mean(axis=1) >= _OF_TWO


def bends_of(discs: Discs, sampling: DiscSampling) -> Array:
    """(n,) mean angle in degrees of each disc, of more than 8, to the discs beside it.

    Those beyond an edge do not count.
    """
    _, near = cKDTree(discs.centres).query(discs.centres, k=NEIGHBOURS + 1)
    return _bends(discs, near[:, 1:], sampling)


def _bends(discs: Discs, near: npt.NDArray[np.int64], sampling: DiscSampling) -> Array:
    """(n,) mean angle in degrees to the neighbours (n, k) that are not beyond an edge."""
    cosines = np.einsum("nj,nkj->nk", discs.normals, discs.normals[near])
    item = cosines >= np.cos(np.radians(sampling.crease))
    angles = np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0)))
    return np.where(item, angles, 0.0).sum(axis=1) / np.maximum(item.sum(axis=1), 1)
