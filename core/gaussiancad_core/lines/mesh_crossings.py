"""What changes between two neighbouring rays: nothing, a visible line, or a hidden one.

Both rays cross surfaces, in the order of depth.  Two crossings match if both rays go the same way
through one surface: its depth differs by no more than the tangent planes at both crossings allow.
A discrepancy is a crossing without a match (a step), or a match whose normals differ by more than a
crease (a bend).  A line is visible if a discrepancy comes before any match, or is the first match
itself; it is hidden if matches come before.
"""

from dataclasses import dataclass
from enum import IntEnum

import numpy as np
import numpy.typing as npt
from numba import njit, prange

from gaussiancad_core.lines.mesh_rays import AllHits, RayGrid


class Line(IntEnum):
    """What is drawn between two rays."""

    NONE = 0
    VISIBLE_STEP = 1
    VISIBLE_BEND = 2
    HIDDEN_STEP = 3
    HIDDEN_BEND = 4


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
    """(h, w + 1) the line between columns x - 1 and x of each row; pairs are centred there."""
    return _compare(
        (layers.splits, layers.depth, layers.entering, layers.normals),
        (layers.height, layers.width),
        0,
        (rule.apart, rule.crease, rule.steps, rule.room),
    )


def compare_columns(layers: Layers, rule: Rule) -> npt.NDArray[np.uint8]:
    """(h + 1, w) the line between rows y - 1 and y of each column."""
    return _compare(
        (layers.splits, layers.depth, layers.entering, layers.normals),
        (layers.height, layers.width),
        1,
        (rule.apart, rule.crease, rule.steps, rule.room),
    )


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
def _compare(layers, shape, axis, rule):  # noqa: ANN001, ANN202
    splits = layers[0]
    height, width = shape
    apart = rule[0]
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
            lines[y, x] = _difference(
                layers, (splits[one], splits[one + 1]), (splits[two], splits[two + 1]), axis, rule
            )
    return lines


@njit(cache=True)
def _difference(layers, first, second, axis, rule):  # noqa: ANN001, ANN202
    """The line between two rays, given the ranges of their crossings."""
    _, depth, entering, normals = layers
    apart, crease, steps, room = rule
    i, j = first[0], second[0]
    matches = 0
    while i < first[1] or j < second[1]:
        if i < first[1] and j < second[1] and entering[i] == entering[j]:
            slope_i = _slope(normals[i], axis) * apart
            slope_j = _slope(normals[j], axis) * apart
            step = depth[j] - depth[i]
            if min(slope_i, slope_j) - room <= step <= max(slope_i, slope_j) + room:
                bend = (
                    normals[i, 0] * normals[j, 0]
                    + normals[i, 1] * normals[j, 1]
                    + normals[i, 2] * normals[j, 2]
                )
                if bend < crease:
                    return Line.VISIBLE_BEND if matches == 0 else Line.HIDDEN_BEND
                matches += 1
                i += 1
                j += 1
                continue
        if steps:
            return Line.VISIBLE_STEP if matches == 0 else Line.HIDDEN_STEP
        if matches == 0:
            # The wide comparison looks for bends of one surface; here two different ones begin.
            return Line.NONE
        if j >= second[1] or (i < first[1] and depth[i] <= depth[j]):
            i += 1
        else:
            j += 1
    return Line.NONE


@njit(cache=True)
def _slope(normal, axis):  # noqa: ANN001, ANN202
    """Growth of depth per px along the axis, on the tangent plane; at most 20."""
    toward = normal[2]
    if abs(toward) < 0.05:
        toward = 0.05 if toward > 0.0 else -0.05
    return -normal[axis] / toward
