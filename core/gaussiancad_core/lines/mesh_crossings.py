"""What changes between neighbouring rays through a mesh, by the rule of :mod:`.two_rays`."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from numba import njit, prange

from gaussiancad_core.lines.mesh_rays import AllHits, RayGrid
from gaussiancad_core.lines.two_rays import difference

_STEEPEST = 0.05
"""Least share of a normal along the rays: a slope of 20, of which a mesh's normals know no more."""

_NO_FACES = np.zeros(0, dtype=np.int64)
"""Triangles are no faces: their normals alone tell what goes on."""


@dataclass(frozen=True, eq=False)
class Layers:
    """The crossings of all rays of a grid.

    Attributes:
        splits: (h * w + 1,) the crossings of ray i are ``splits[i]`` to ``splits[i + 1]``.
        depth: (n,) in px.
        entering: (n,) whether the ray goes into the material.
        normals: (n, 3) unit normals along the grid's columns (right), rows (down) and rays.
        width, height: px of the grid.
    """

    splits: npt.NDArray[np.int64]
    depth: npt.NDArray[np.float32]
    entering: npt.NDArray[np.bool_]
    normals: npt.NDArray[np.float32]
    width: int
    height: int


@dataclass(frozen=True)
class Rule:
    """When two rays differ.

    Attributes:
        apart: px between the two pixels of a pair; odd, so that the line runs between pixels.
        crease: cosine of the angle from which a bend is a line.
        steps: whether a crossing without a match makes a line; without it only bends do.
        room: px by which matching depths may leave the range of the tangent planes.
    """

    apart: int
    crease: float
    steps: bool
    room: float = 1.0


def layers_of(hits: AllHits, normals: npt.NDArray[np.float64], grid: RayGrid) -> Layers:
    """Crossings with depths in px and normals in the grid's own axes.

    Args:
        hits: of the grid's rays.
        normals: (m, 3) unit normals of the mesh's triangles, in model axes.
        grid: of the rays.
    """
    axes = np.array([grid.right, -np.array(grid.up), grid.look])
    item = (normals @ axes.T).astype(np.float32)[hits.triangle]
    depth = (hits.depth / grid.pitch).astype(np.float32)
    return Layers(hits.splits, depth, hits.entering, item, grid.width, grid.height)


def compare_rows(layers: Layers, rule: Rule) -> npt.NDArray[np.uint8]:
    """(h, w + 1) the :class:`.Difference` between columns x - 1 and x of each row; pairs are
    centred there."""
    return _compare(layers, 0, rule)


def compare_columns(layers: Layers, rule: Rule) -> npt.NDArray[np.uint8]:
    """(h + 1, w) the same between rows y - 1 and y of each column."""
    return _compare(layers, 1, rule)


def _compare(layers: Layers, axis: int, rule: Rule) -> npt.NDArray[np.uint8]:
    slopes = _slopes(layers.normals, axis) * np.float32(rule.apart)
    crossings = (layers.depth, layers.entering, slopes, layers.normals, _NO_FACES)
    return _compare_all(
        crossings,
        layers.splits,
        (layers.height, layers.width),
        (axis, rule.apart),
        (rule.room, rule.crease, rule.steps),
    )


def _slopes(normals: npt.NDArray[np.float32], axis: int) -> npt.NDArray[np.float32]:
    """(n,) growth of depth per px along an axis, on the tangent planes; at most 20."""
    towards = normals[:, 2]
    steep = np.abs(towards) < _STEEPEST
    held = np.where(steep, np.where(towards > 0.0, _STEEPEST, -_STEEPEST), towards)
    return np.divide(-normals[:, axis], held, dtype=np.float32)


def warm_up() -> None:
    """Compile the kernels, or load them from numba's cache, so that the first drawing is quick."""
    blank = Layers(
        np.zeros(2, dtype=np.int64),
        np.zeros(0, dtype=np.float32),
        np.zeros(0, dtype=np.bool_),
        np.zeros((0, 3), dtype=np.float32),
        1,
        1,
    )
    for compare in (compare_rows, compare_columns):
        compare(blank, Rule(1, 1.0, True))


@njit(parallel=True, cache=True)
def _compare_all(crossings, splits, shape, pair, rule):  # noqa: ANN001, ANN202
    height, width = shape
    axis, apart = pair
    down, right = (1, 0) if axis == 1 else (0, 1)
    lines = np.zeros((height + down, width + right), dtype=np.uint8)
    before, after = (apart + 1) // 2, (apart - 1) // 2
    for y in prange(height + down):
        for x in range(width + right):
            y0, x0 = y - before * down, x - before * right
            y1, x1 = y + after * down, x + after * right
            if y0 < 0 or x0 < 0 or y1 >= height or x1 >= width:
                continue
            one, two = y0 * width + x0, y1 * width + x1
            lines[y, x] = difference(
                crossings, (splits[one], splits[one + 1]), (splits[two], splits[two + 1]), rule
            )
    return lines
