"""The fast back end: compiled tile kernels behind torch's automatic differentiation."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from gaussiancad_core.model.cameras import CameraModel
from gaussiancad_core.splatting import projection_kernels, tile_kernels, tile_sorting
from gaussiancad_core.splatting.kernel_threads import KERNELS
from gaussiancad_core.splatting.projection import CameraBatch, half_field
from gaussiancad_core.splatting.rasterizer import Parameters, RasterSettings, Rendering

PARTS = 96
"""Runs of tiles that the threads share out; a number that many numbers of threads divide."""

TILE_WORK = 8
"""What an empty tile costs, in Gaussians."""

Array = npt.NDArray[Any]


def draw_tiles(
    parameters: Parameters,
    cameras: CameraBatch,
    optics: RasterSettings,
    shifts: Tensor | None = None,
) -> Rendering:
    """Draw the Gaussians in every view; see :mod:`.rasterizer` for the compositing.

    Works in float32 and float64 on the CPU; the same input gives the same bits.
    """
    return Rendering(
        *_Draw.apply(
            parameters.means,
            parameters.quaternions,
            parameters.log_scales,
            torch.sigmoid(parameters.logit_opacities),
            parameters.colours,
            shifts,
            cameras,
            optics,
        )
    )


@dataclass(frozen=True, eq=False)
class _Tiling:
    """Which Gaussians lie in which tile, from front to back.

    Attributes:
        grid: lines and columns of tiles.
        starts: (tiles + 1,) places in ``members`` where each tile's list begins.
        members: (pairs,) rows of the Gaussians' records.
        pairs: (pairs,) places in ``members`` of the first Gaussian's tiles, then of the second's.
        spans: (pairs, 2) lines of the tile that the Gaussian reaches; known after compositing.
        counts: (v, n) tiles of a Gaussian.
        first_slots: (v, n) its first place in ``pairs``; the others follow.
        parts: (parts + 1,) tiles at which runs of tiles with as much to do begin and end.
    """

    grid: tuple[int, int]
    starts: Array
    members: Array
    pairs: Array
    spans: Array
    counts: Array
    first_slots: Array
    parts: Array


@dataclass(frozen=True, eq=False)
class _Scene:
    """All inputs of the kernels as arrays of one precision."""

    gaussians: tuple[Array, Array, Array]
    cameras: tuple[Array, Array, Array, Array, Array]
    pinhole: bool
    nearest: float
    opacities: Array
    colours: Array
    limits: tuple[float, float, float]


class _Draw(torch.autograd.Function):
    @staticmethod
    def forward(  # noqa: PLR0917
        ctx: Any,  # noqa: ANN401
        means: Tensor,
        quaternions: Tensor,
        log_scales: Tensor,
        opacities: Tensor,
        colours: Tensor,
        shifts: Tensor | None,
        cameras: CameraBatch,
        optics: RasterSettings,
    ) -> tuple[Tensor, Tensor, Tensor]:
        scene = _scene((means, quaternions, log_scales), opacities, colours, cameras, optics)
        size = (cameras.height, cameras.width)
        moved = None if shifts is None else _array(shifts)
        with KERNELS:
            tiling, projected, images = _forward(scene, size, optics, moved)
        ctx.state = (scene, size, tiling, projected, images)
        colour, alpha, depth = (torch.from_numpy(image) for image in images)
        return colour, alpha, depth

    @staticmethod
    def backward(ctx: Any, *upstream: Tensor) -> tuple[Tensor | None, ...]:  # noqa: ANN401
        arrays = tuple(np.ascontiguousarray(gradient.numpy()) for gradient in upstream)
        with KERNELS:
            gradients = _backward(ctx.state, arrays)
        found = [torch.from_numpy(gradient) for gradient in gradients]
        shifted = ctx.needs_input_grad[5]
        return (*found[:5], found[5] if shifted else None, None, None)


@dataclass(frozen=True, eq=False)
class _Projected:
    """What is known of all Gaussians in all views.

    Attributes:
        conics: (v, n, 3).
        depths: (v, n).
        records: (v n, fields) what compositing reads, see :mod:`.tile_sorting`.
    """

    conics: Array
    depths: Array
    records: Array


def _forward(
    scene: _Scene, size: tuple[int, int], optics: RasterSettings, shifts: Array | None
) -> tuple[_Tiling, _Projected, tuple[Array, Array, Array]]:
    """Tiling; Gaussians in the views; colour, alpha and depth images."""
    views, number, kind = len(scene.cameras[0]), len(scene.opacities), scene.opacities.dtype
    shapes = ((views, number, 2), (views, number, 3), (views, number, 3), (views, number))
    means, covariances, conics, depths = (np.empty(shape, kind) for shape in shapes)
    projection_kernels.project_forward(
        scene.gaussians,
        scene.cameras,
        scene.pinhole,
        scene.nearest,
        kind.type(optics.dilation),
        (means, covariances, conics, depths),
    )
    if shifts is not None:
        means += shifts
    boxes = np.empty((views, number, 4), dtype=np.int32)
    counts = np.empty((views, number), dtype=np.int32)
    smallest = scene.limits[0]
    tile_sorting.find_boxes(size, means, covariances, scene.opacities, smallest, boxes, counts)
    records = np.empty((views * number, tile_sorting.RECORD_FIELDS), kind)
    tile_sorting.fill_records(
        (means, conics, depths), scene.opacities, scene.colours, smallest, counts, records
    )
    tiling = _sort_into_tiles(size, boxes, counts, depths)
    images: tuple[Array, Array, Array] = (
        np.empty((views, 3, *size), kind),
        np.empty((views, *size), kind),
        np.empty((views, *size), kind),
    )
    tile_kernels.composite_forward(
        size,
        tiling.grid,
        (tiling.starts, tiling.members, tiling.parts),
        records,
        scene.limits,
        tiling.spans,
        images,
    )
    return tiling, _Projected(conics, depths, records), images


def _backward(state: tuple[Any, ...], upstream: tuple[Array, ...]) -> tuple[Array, ...]:
    """Gradients of means, quaternions, log scales, opacities, colours and shifts."""
    scene, size, tiling, projected, images = state
    kind = scene.opacities.dtype
    of_pairs = np.empty((len(tiling.members), tile_kernels.PAIR_FIELDS), kind)
    tile_kernels.composite_backward(
        size,
        tiling.grid,
        (tiling.starts, tiling.members, tiling.parts),
        projected.records,
        scene.limits,
        tiling.spans,
        images,
        upstream,
        of_pairs,
    )
    views, number = projected.depths.shape
    shapes = ((views, number, 2), (views, number, 3), (views, number))
    to_projection = tuple(np.empty(shape, kind) for shape in shapes)
    to_opacities, to_colours = np.empty_like(scene.opacities), np.empty_like(scene.colours)
    tile_kernels.add_pairs(
        tiling.counts,
        tiling.first_slots,
        tiling.pairs,
        of_pairs,
        to_projection,
        to_opacities,
        to_colours,
    )
    gradients = tuple(np.empty_like(array) for array in scene.gaussians)
    projection_kernels.project_backward(
        scene.gaussians,
        scene.cameras,
        scene.pinhole,
        scene.nearest,
        projected.conics,
        projected.depths,
        to_projection,
        gradients,
    )
    return (*gradients, to_opacities, to_colours, to_projection[0])


def _array(tensor: Tensor) -> Array:
    return np.ascontiguousarray(tensor.detach().numpy())


def _scene(
    gaussians: tuple[Tensor, Tensor, Tensor],
    opacities: Tensor,
    colours: Tensor,
    cameras: CameraBatch,
    optics: RasterSettings,
) -> _Scene:
    kind = _array(opacities).dtype.type
    return _Scene(
        gaussians=(_array(gaussians[0]), _array(gaussians[1]), _array(gaussians[2])),
        cameras=(
            _array(cameras.rotations),
            _array(cameras.translations),
            _array(cameras.focals),
            _array(cameras.centres),
            _array(half_field(cameras)),
        ),
        pinhole=cameras.model is CameraModel.PINHOLE,
        nearest=kind(cameras.nearest),
        opacities=_array(opacities),
        colours=_array(colours),
        limits=(
            kind(optics.smallest_alpha),
            kind(optics.largest_alpha),
            kind(optics.smallest_transmittance),
        ),
    )


def _sort_into_tiles(size: tuple[int, int], boxes: Array, counts: Array, depths: Array) -> _Tiling:
    """List the Gaussians of each tile by their boxes (v, n, 4) and numbers of tiles (v, n)."""
    views, number = depths.shape
    grid = (-(-size[0] // tile_sorting.TILE_HEIGHT), -(-size[1] // tile_sorting.TILE_WIDTH))
    ends = np.cumsum(counts.ravel(), dtype=np.int64)
    count = int(ends[-1]) if len(ends) else 0
    first_slots = (ends - counts.ravel()).reshape(views, number)
    order = tile_sorting.depth_order(depths)
    totals = np.zeros((views, tile_sorting.CHUNKS, grid[0] * grid[1]), dtype=np.int64)
    tile_sorting.count_tiles(grid, order, boxes, counts, totals)
    # A tile's list has the chunks one after the other.
    listed = totals.transpose(0, 2, 1)
    after = np.cumsum(listed, dtype=np.int64).reshape(listed.shape)
    places = np.ascontiguousarray((after - listed).transpose(0, 2, 1))
    starts = np.concatenate([[0], after[:, :, -1].ravel()])
    members, pairs = np.empty(count, dtype=np.int32), np.empty(count, dtype=np.int32)
    tile_sorting.fill_tiles(grid, order, boxes, counts, first_slots, places, members, pairs)
    spans = np.empty((count, 2), dtype=np.uint8)
    return _Tiling(grid, starts, members, pairs, spans, counts, first_slots, even_parts(starts))


def even_parts(starts: Array) -> Array:
    """Where to divide the tiles, so that threads with as many parts have as much to do.

    Args:
        starts: (tiles + 1,) places where the tiles' lists of Gaussians begin.

    Returns:
        (PARTS + 1,) tiles, ascending from the first to the number of tiles.
    """
    work = starts + TILE_WORK * np.arange(len(starts))
    return np.searchsorted(work, np.linspace(0, work[-1], PARTS + 1)).astype(np.int64)


def warm_up() -> None:
    """Compile the kernels for single precision, so that no run has to wait for it.

    The compiled code is kept beside the package, or in numba's cache of the user where that folder
    cannot be written.
    """
    from gaussiancad_core.model.axes import Role
    from gaussiancad_core.model.cameras import orthographic_camera
    from gaussiancad_core.splatting.losses import LossWeights, Targets, total_loss
    from gaussiancad_core.splatting.projection import batch_of
    from gaussiancad_core.splatting.ssim import similarity_with

    batch = batch_of((orthographic_camera(Role.FRONT, (1.0, 1.0, 1.0), tile_sorting.TILE_WIDTH),))
    parameters = Parameters(
        *(
            torch.full(shape, 0.5).requires_grad_()
            for shape in ((1, 3), (1, 4), (1, 3), (1,), (1, 3))
        )
    )
    rendering = draw_tiles(parameters, batch, RasterSettings())
    targets = Targets(torch.zeros_like(rendering.colours), torch.zeros_like(rendering.alphas))
    loss = total_loss(rendering, targets, similarity_with(targets.colours), LossWeights())
    (loss + rendering.depths.mean()).backward()
