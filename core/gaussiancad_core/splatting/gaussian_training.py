"""Training: Adam on all parameters of all Gaussians, until the loss falls no more."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from gaussiancad_core.model.cameras import PAPER_DISTANCE, Camera, CameraModel
from gaussiancad_core.splatting.checkpoints import CheckpointPlace, Checkpoints, training_key
from gaussiancad_core.splatting.density import Density
from gaussiancad_core.splatting.gaussian_model import Arrays, GaussianModel, Roots
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.splatting.losses import Targets, total_loss
from gaussiancad_core.splatting.projection import CameraBatch, batch_of
from gaussiancad_core.splatting.rasterizer import Parameters, rasteriser
from gaussiancad_core.splatting.settings import TrainingSettings
from gaussiancad_core.splatting.ssim import similarity_with

SCENE_EDGE = 5.0
"""Longest edge of the Gaussians' box, in units of the scene, under parallel projection."""

_EXTENT_MARGIN = 1.1
"""By how much 3DGS takes the cameras' positions to be farther apart than they are."""

_LOSSES_HELD = 25
"""Losses that a GPU keeps to itself: when it is asked, it must have done all its work."""

ProgressCallback = Callable[[float, float | None], None]


@dataclass(frozen=True, eq=False)
class TrainingResult:
    """What came out.

    Attributes:
        gaussians: in mm; without density control in the order of the start.
        iterations: how many were made.
        losses: (iterations,) the loss before each.
        settled: whether it ended because the loss fell no more.
        resumed: iterations that an earlier run had made.
        passed_over: whether there was a checkpoint of another training.
    """

    gaussians: Gaussians
    iterations: int
    losses: tuple[float, ...]
    settled: bool = False
    resumed: int = 0
    passed_over: bool = False


def train(
    gaussians: Gaussians,
    cameras: tuple[Camera, ...],
    targets: Targets,
    settings: TrainingSettings,
    progress: ProgressCallback,
    *,
    place: CheckpointPlace | None = None,
) -> TrainingResult:
    """Fit Gaussians to the targets.

    Args:
        gaussians: the start, mm.
        cameras: v cameras of one model and image size.
        targets: v images each, in the order of the cameras.
        settings: recipe and amount of work.
        progress: told the fraction done and the loss after each iteration.
        place: where checkpoints go; none are written without it.

    Returns:
        The trained Gaussians; the same input gives the same bits on a processor, with or without a
        break between.
    """
    checkpoints = None
    if place is not None:
        checkpoints = Checkpoints(place, training_key(gaussians, cameras, targets, settings))
    with _one_torch_thread():
        training = _Training(gaussians, cameras, targets, settings)
        state, passed_over = checkpoints.load() if checkpoints else (None, False)
        if state is not None:
            training.restore(state)
        resumed = training.done
        while not training.ended:
            training.iterate()
            if checkpoints and checkpoints.due():
                checkpoints.save(training.state())
            progress(training.done / settings.iterations, training.losses.newest)
    losses = training.losses.all()
    return TrainingResult(
        training.trainee.gaussians(),
        len(losses),
        tuple(losses),
        settled=training.settled,
        resumed=resumed,
        passed_over=passed_over,
    )


@dataclass(frozen=True, eq=False)
class _Look:
    """What one iteration looks at: some views and what they should show."""

    cameras: CameraBatch
    targets: Targets
    similarity: Callable[[Tensor], Tensor]


class _Losses:
    """The losses of a training, fetched from its device some at a time.

    Args:
        held: losses that may stay on the device.
    """

    def __init__(self, held: int) -> None:
        self._held = held
        self._fetched: list[float] = []
        self._waiting: list[Tensor] = []

    def __len__(self) -> int:
        return len(self._fetched) + len(self._waiting)

    @property
    def fetched(self) -> list[float]:
        """Those that need not be waited for, from the first on."""
        return self._fetched

    @property
    def newest(self) -> float | None:
        """The last of these."""
        return self._fetched[-1] if self._fetched else None

    def add(self, loss: Tensor) -> None:
        """Note one more."""
        self._waiting.append(loss.detach())
        if len(self._waiting) > self._held:
            self.all()

    def all(self) -> list[float]:
        """All, for which the device may have to be waited for."""
        if self._waiting:
            self._fetched += torch.stack(self._waiting).tolist()
            self._waiting.clear()
        return self._fetched

    def restore(self, losses: list[float]) -> None:
        """Begin with these."""
        self._fetched, self._waiting = losses, []


class _Training:
    """A training between two iterations.

    Attributes:
        trainee: the Gaussians.
        losses: before each iteration that was made.
    """

    def __init__(
        self,
        gaussians: Gaussians,
        cameras: tuple[Camera, ...],
        targets: Targets,
        settings: TrainingSettings,
    ) -> None:
        device = settings.backend.device
        unit = _unit(gaussians, cameras)
        self.trainee = GaussianModel(gaussians, unit, settings.rates, device)
        self.losses = _Losses(0 if device == "cpu" else _LOSSES_HELD)
        self._settings = settings
        self._draw = rasteriser(settings.backend)
        self._random = np.random.default_rng(settings.seed)
        self._order: list[int] = []
        count = len(cameras)
        parts = [slice(v, v + 1) for v in range(count)] if settings.one_view else [slice(0, count)]
        self._looks = [_look(cameras[part], targets.part(part).on(device), unit) for part in parts]
        self._density = None
        if settings.density is not None:
            extent = _extent(cameras) / unit
            self._density = Density(settings.density, extent, self.trainee, self._random)

    @property
    def settled(self) -> bool:
        """Whether the loss has not become better by enough within the last iterations."""
        settings, losses = self._settings, self.losses.fetched
        if len(losses) <= settings.patience:
            return False
        before = min(losses[: -settings.patience])
        return min(losses[-settings.patience :]) > before * (1.0 - settings.least_gain)

    @property
    def ended(self) -> bool:
        """Whether all iterations were made, or no more are worth it."""
        return self.done >= self._settings.iterations or self.settled

    @property
    def done(self) -> int:
        """Iterations that were made."""
        return len(self.losses)

    def iterate(self) -> None:
        """Look, compare, and move the Gaussians."""
        settings, look = self._settings, self._next_look()
        parameters = self.trainee.parameters
        shifts = None
        if self._density:
            shape = (len(look.targets.masks), len(self.trainee), 2)
            shifts = parameters.means.new_zeros(shape).requires_grad_()
        rendering = self._draw(parameters, look.cameras, settings.optics, shifts)
        loss = total_loss(rendering, look.targets, look.similarity, settings.weights)
        (loss + _strayed(parameters, self.trainee.roots, settings.anchor)).backward()
        if settings.thin_axis_locked:
            gradient = parameters.log_scales.grad
            assert gradient is not None
            gradient[:, 2] = 0.0
        self.trainee.step(self._position_rate())
        self.losses.add(loss)
        if self._density and shifts is not None and shifts.grad is not None:
            self._density.note(shifts.grad, (look.cameras.width, look.cameras.height))
            self._density.after(self.done)

    def state(self) -> Arrays:
        """Everything that :meth:`restore` needs."""
        found = {**self.trainee.state(), "losses": np.array(self.losses.all())}
        found["order"] = np.array(self._order, dtype=np.int64)
        found["random"] = np.array(json.dumps(self._random.bit_generator.state))
        return {**found, **self._density.state()} if self._density else found

    def restore(self, state: Arrays) -> None:
        """Go on from where :meth:`state` was taken."""
        self.trainee.restore(state)
        self.losses.restore(state["losses"].tolist())
        self._order = state["order"].tolist()
        self._random.bit_generator.state = json.loads(str(state["random"]))
        if self._density:
            self._density.restore(state)

    def _next_look(self) -> _Look:
        """All views, or one after the other in a new random order each time."""
        if len(self._looks) == 1:
            return self._looks[0]
        if not self._order:
            self._order = self._random.permutation(len(self._looks)).tolist()
        return self._looks[self._order.pop()]

    def _position_rate(self) -> float:
        rates = self._settings.rates
        steps = rates.position_steps or self._settings.iterations - 1
        share = self.done / max(1, steps)
        return rates.position * (rates.position_end / rates.position) ** share


def _look(cameras: tuple[Camera, ...], targets: Targets, unit: float) -> _Look:
    batch = batch_of(cameras, unit).on(targets.colours.device.type)
    return _Look(batch, targets, similarity_with(targets.colours))


def _unit(gaussians: Gaussians, cameras: tuple[Camera, ...]) -> float:
    """Millimetres that become 1: the paper's for its cameras, else the box has a size of 5."""
    if cameras[0].model is CameraModel.PINHOLE:
        return cameras[0].reference_depth / PAPER_DISTANCE
    return float(np.ptp(gaussians.means, axis=0).max()) / SCENE_EDGE or 1.0


def _extent(cameras: tuple[Camera, ...]) -> float:
    """Radius of the cameras' positions about their mean, as 3DGS takes it, mm."""
    positions = np.array([camera.position for camera in cameras])
    away = np.linalg.norm(positions - positions.mean(axis=0), axis=1)
    return _EXTENT_MARGIN * float(away.max())


def _strayed(parameters: Parameters, roots: Roots, weight: float) -> Tensor | float:
    """Weighted mean distance of the discs from the tangent planes in which they started.

    That of their centres, and that by which a disc that tilts lifts its rim: what the views see of
    a tilt is less than what it does to the surface.
    """
    if weight == 0.0:
        return 0.0
    lifted = ((parameters.means - roots.points) * roots.normals).sum(1).abs()
    thin = _third_axes(parameters.quaternions)
    tilts = torch.linalg.cross(thin, roots.normals).norm(dim=1)
    radii = parameters.log_scales.detach()[:, :2].exp().mean(1)
    return weight * (lifted + radii * tilts).mean()


def _third_axes(quaternions: Tensor) -> Tensor:
    """(n, 3) the third axis of rotations given as (n, 4) quaternions, scalar first."""
    w, x, y, z = torch.nn.functional.normalize(quaternions, dim=1).unbind(1)
    return torch.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], dim=1)


@contextmanager
def _one_torch_thread() -> Iterator[None]:
    """Leave the processors to the kernels: torch's own threads would only spin beside them."""
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(before)
