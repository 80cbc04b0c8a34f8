"""Training: Adam on all parameters of all Gaussians, every view in every iteration."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial

import numpy as np
import torch
from torch import Tensor

from gaussiancad_core.cameras import Camera
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.splatting.losses import Targets, total_loss
from gaussiancad_core.splatting.projection import batch_of
from gaussiancad_core.splatting.rasteriser import Parameters, parameters_of, rasteriser
from gaussiancad_core.splatting.settings import TrainingSettings
from gaussiancad_core.splatting.ssim import FastSsim, plain_ssim

SCENE_EDGE = 5.0
"""Longest edge of the Gaussians' box in the units in which the rates are given."""

ProgressCallback = Callable[[float, float | None], None]


@dataclass(frozen=True, eq=False)
class TrainingResult:
    """What came out.

    Attributes:
        gaussians: in mm, in the order of the start.
        iterations: how many were made.
        losses: (iterations,) the loss before each.
    """

    gaussians: Gaussians
    iterations: int
    losses: tuple[float, ...]


def train(
    gaussians: Gaussians,
    cameras: tuple[Camera, ...],
    targets: Targets,
    settings: TrainingSettings,
    progress: ProgressCallback,
) -> TrainingResult:
    """Fit Gaussians to the targets.

    Args:
        gaussians: the start, mm.
        cameras: v cameras of one model and image size.
        targets: v images each, in the order of the cameras.
        settings: recipe and amount of work.
        progress: told the fraction done and the loss after each iteration.

    Returns:
        The trained Gaussians; the same input gives the same bits.
    """
    unit = float(np.ptp(gaussians.means, axis=0).max()) / SCENE_EDGE or 1.0
    device = settings.backend.device
    batch = batch_of(cameras, unit).on(device)
    targets = targets.on(device)
    parameters = parameters_of(gaussians, unit, device=device)
    anchor = _Anchor(gaussians, unit, settings)
    draw = rasteriser(settings.backend)
    losses: list[float] = []
    with _one_torch_thread():
        similarity = _similarity_with(targets.colours)
        optimiser = _optimiser(parameters, settings)
        for iteration in range(settings.iterations):
            optimiser.param_groups[0]["lr"] = _position_rate(settings, iteration)
            rendering = draw(parameters, batch, settings.optics)
            loss = total_loss(rendering, targets, similarity, settings.weights)
            objective = loss + anchor(parameters.means)
            optimiser.zero_grad()
            objective.backward()
            if settings.thin_axis_locked:
                parameters.log_scales.grad[:, 2] = 0.0
            optimiser.step()
            losses.append(float(loss.detach()))
            progress((iteration + 1) / settings.iterations, losses[-1])
            if _settled(losses, settings):
                break
    return TrainingResult(_trained(gaussians, parameters, unit), len(losses), tuple(losses))


class _Anchor:
    """Pulls the means back to the tangent planes in which they started."""

    def __init__(self, gaussians: Gaussians, unit: float, settings: TrainingSettings) -> None:
        device = settings.backend.device
        self._means = torch.from_numpy(gaussians.means / np.float32(unit)).to(device)
        self._normals = torch.from_numpy(gaussians.normals).to(device)
        self._weight = settings.anchor

    def __call__(self, means: Tensor) -> Tensor | float:
        if self._weight == 0.0:
            return 0.0
        return self._weight * ((means - self._means) * self._normals).sum(1).abs().mean()


def _optimiser(parameters: Parameters, settings: TrainingSettings) -> torch.optim.Optimizer:
    rates = settings.rates
    of_tensor = (rates.position, rates.quaternion, rates.log_scale, rates.opacity, rates.colour)
    groups = [
        {"params": [tensor], "lr": rate}
        for tensor, rate in zip(parameters.tensors, of_tensor, strict=True)
    ]
    return torch.optim.Adam(groups, eps=rates.epsilon)


def _position_rate(settings: TrainingSettings, iteration: int) -> float:
    rates = settings.rates
    share = iteration / max(1, settings.iterations - 1)
    return rates.position * (rates.position_end / rates.position) ** share


def _settled(losses: list[float], settings: TrainingSettings) -> bool:
    """Whether the loss has not become better by enough within the last iterations."""
    if len(losses) <= settings.patience:
        return False
    before = min(losses[: -settings.patience])
    return min(losses[-settings.patience :]) > before * (1.0 - settings.least_gain)


def _trained(start: Gaussians, parameters: Parameters, unit: float) -> Gaussians:
    means, quaternions, log_scales, logits, colours = (
        tensor.detach().cpu().numpy().copy() for tensor in parameters.tensors
    )
    return Gaussians(
        means=means * np.float32(unit),
        quaternions=quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True),
        log_scales=log_scales + np.float32(np.log(unit)),
        logit_opacities=logits,
        colours=np.clip(colours, 0.0, 1.0),
        normals=start.normals,
    )


def _similarity_with(targets: Tensor) -> Callable[[Tensor], Tensor]:
    """SSIM with fixed targets: the compiled one reads the processor's memory only."""
    if targets.device.type == "cpu":
        return FastSsim(targets)
    return partial(plain_ssim, targets=targets)


@contextmanager
def _one_torch_thread() -> Iterator[None]:
    """Leave the processors to the kernels: torch's own threads would only spin beside them."""
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(before)
