"""Edges that Poisson reconstruction rounded, made sharp again by the planes that meet in them.

Poisson blurs an edge over some cells of its octree.  The discs on either side still know their
planes: vertices near a crease are moved onto the wedge of its two planes, those next to its line
onto the line.  The idea is that of edge-sharpening filters (Attene et al. 2005), but the planes are
those of the Gaussians instead of being guessed from the triangles.  No triangle is made or removed,
so that a closed mesh stays closed.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.surface.discs import NEIGHBOURS, Array, Creases
from gaussiancad_core.surface.moving import vertex_normals, without_folds

_ALIKE = 0.9
"""Cosine from which on two points belong to one crease."""

_SPREAD = 0.2
"""Share of the reach along a crease over which the moves to its points are evened out."""

_ALONG = 0.65
"""Sine of the most by which a vertex's normal may point along the crease: else it belongs to a
third face at a corner."""

_FACING, _AVERTED = 0.5, -0.3
"""Cosines: a vertex faces as one of the two planes does, and does not turn its back on the other,
as that of a thin wall's far side."""

Flags = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class Sharpening:
    """How far edges are made sharp, lengths in cells of the octree.

    Attributes:
        zone: distance from a crease within which vertices are moved.
        farthest: the most by which one is moved in a round.
        snap: vertices that would lie nearer to the crease are put onto it.
        rounds: times that all are moved; at corners a vertex goes from wedge to wedge.
        bend: degrees; where the surface beside a crease bends by more, its discs' planes are no
            measure, and all stays as it is.
    """

    zone: float = 6.0
    farthest: float = 2.0
    snap: float = 0.6
    rounds: int = 2
    bend: float = 3.0


@dataclass(frozen=True, eq=False)
class _Wedges:
    """For each of m vertices k wedges of two planes: the places of their creases, mm.

    Attributes:
        points: (m, k, 3) of the creases.
        normals, others: (m, k, 3) of the two planes.
        convex: (m, k).
    """

    points: Array
    normals: Array
    others: Array
    convex: Flags


def sharpened(
    mesh: TriangleMesh, creases: Creases, cell: float, reach: float, settings: Sharpening
) -> TriangleMesh:
    """A mesh with its vertices near creases moved onto the planes that meet there.

    Args:
        mesh: of a Poisson reconstruction, oriented outward, mm.
        creases: of the discs that it was made of, mm.
        cell: edge of the octree's cells, mm.
        reach: distance along a crease in which it is taken for straight, mm.
        settings: how far.

    Returns:
        The same triangles; none is turned over by more than a right angle.
    """
    flat = creases.between_planes(settings.bend)
    if len(flat) < NEIGHBOURS:
        return mesh
    tree = cKDTree(flat.points)
    normals = vertex_normals(mesh)
    moved = mesh.vertices.copy()
    for _ in range(settings.rounds):
        distances, near = tree.query(
            moved, k=NEIGHBOURS, distance_upper_bound=reach + settings.zone * cell
        )
        rows = np.flatnonzero(np.isfinite(distances[:, 0]))
        near = np.minimum(near[rows], len(flat) - 1)
        wedges = _Wedges(
            flat.points[near], flat.normals[near], flat.others[near], flat.convex[near]
        )
        moved[rows] += _moves(
            moved[rows], normals[rows], wedges, (distances[rows], reach, cell), settings
        )
    return without_folds(mesh, moved)


def _moves(
    vertices: Array,
    normals: Array,
    wedges: _Wedges,
    lengths: tuple[Array, float, float],
    settings: Sharpening,
) -> Array:
    """(m, 3) mm: how each vertex gets onto its wedge; zero where it belongs to none.

    Args:
        vertices, normals: (m, 3).
        wedges: k for each, the nearest first.
        lengths: (m, k) distances of the creases' points, infinite where there is none; the reach
            along a crease; the size of a cell.
        settings: how far.
    """
    distances, reach, cell = lengths
    places = vertices[:, None]
    targets, from_line = _onto(wedges, places, settings.snap * cell)
    moves = targets - places
    fits = _belongs(normals[:, None], wedges) & np.isfinite(distances)
    fits &= from_line < settings.zone * cell
    fits &= np.linalg.norm(moves, axis=2) < settings.farthest * cell
    # The nearest that fits leads; what else belongs to its crease evens out the discs' noise.
    rows, leader = np.arange(len(vertices)), np.argmax(fits, axis=1)
    alike = _same_crease(wedges, rows, leader) & fits
    spread = _SPREAD * reach
    nearness = np.where(alike, distances - distances[rows, leader][:, None], np.inf)
    weights = np.where(alike, np.exp(-((nearness / spread) ** 2)), 0.0)
    total = weights.sum(axis=1)
    return np.einsum("mk,mkj->mj", weights, moves) / np.where(total > 0.0, total, 1.0)[:, None]


def _belongs(normals: Array, wedges: _Wedges) -> Flags:
    """(m, k) whether vertices with these (m, 1, 3) normals may lie on the wedges."""
    along = np.cross(wedges.normals, wedges.others)
    along /= np.linalg.norm(along, axis=2, keepdims=True)
    facing = [(normals * values).sum(axis=2) for values in (wedges.normals, wedges.others)]
    return (
        (np.abs((normals * along).sum(axis=2)) < _ALONG)
        & (np.maximum(*facing) > _FACING)
        & (np.minimum(*facing) > _AVERTED)
    )


def _same_crease(
    wedges: _Wedges, rows: npt.NDArray[np.int64], leader: npt.NDArray[np.int64]
) -> Flags:
    """(m, k) whether each wedge has the planes of the vertex's leading one."""
    first, second = wedges.normals[rows, leader], wedges.others[rows, leader]

    def alike(values: Array, other: Array) -> Flags:
        return np.einsum("mkj,mj->mk", values, other) > _ALIKE

    straight = alike(wedges.normals, first) & alike(wedges.others, second)
    swapped = alike(wedges.normals, second) & alike(wedges.others, first)
    return (straight | swapped) & (wedges.convex == wedges.convex[rows, leader][:, None])


def _onto(wedges: _Wedges, places: Array, snap: float) -> tuple[Array, Array]:
    """Nearest points of wedges, and the distances from their creases.

    Args:
        wedges: m times k.
        places: (m, 1, 3) mm.
        snap: distance from the crease below which its own point is taken, mm.

    Returns:
        (m, k, 3) points on the surface of the wedges and (m, k) distances of the places.
    """
    away = places - wedges.points
    first = (away * wedges.normals).sum(axis=2)
    second = (away * wedges.others).sum(axis=2)
    cosines = (wedges.normals * wedges.others).sum(axis=2)
    sines = 1.0 - cosines**2
    along_first = ((first - cosines * second) / sines)[..., None]
    along_second = ((second - cosines * first) / sines)[..., None]
    line = places - along_first * wedges.normals - along_second * wedges.others
    # What is below one plane of a convex edge may lie on the other; of a concave one, above.
    side = np.where(wedges.convex, 1.0, -1.0)
    on_first = side * (second - cosines * first) <= 0.0
    on_second = side * (first - cosines * second) <= 0.0
    prefer_first = on_first & (~on_second | (np.abs(first) <= np.abs(second)))
    points = np.where(
        prefer_first[..., None],
        places - first[..., None] * wedges.normals,
        np.where(on_second[..., None], places - second[..., None] * wedges.others, line),
    )
    neighbour = np.linalg.norm(points - line, axis=2) < snap
    return np.where(neighbour[..., None], line, points), np.linalg.norm(places - line, axis=2)
