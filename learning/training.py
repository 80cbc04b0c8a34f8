"""The training of the labels network: batch by batch, with a mean of its weights over time."""

import math
import queue
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from copy import deepcopy
from dataclasses import dataclass
from typing import Any

import torch
from torch import Tensor
from torch.optim import AdamW, Optimizer
from torch.optim.swa_utils import AveragedModel

from gaussiancad_core.errors import LimitError
from gaussiancad_protocol.codes import Code
from learning.feeding import Batch
from learning.loss import labels_loss
from learning.schedule import Course, rate_at
from learning.unet import LabelsNetwork

Tell = Callable[[str], None]

_Tensors = tuple[Tensor, ...] | list[Tensor]

_DECAY, _YOUNG = 0.999, 10
"""What the mean keeps at each step, and steps in which it keeps less, for the weights of the
beginning are bad ones."""

_DECAY_OF_WEIGHTS = 1e-2
_LONGEST_GRADIENT = 2.0

_LOOK = 20
"""Steps from one look at the loss to the next: each look waits for the GPU."""

_KEEP = 200
"""Steps after which weights are kept to go back to."""

_MOST_RETURNS = 5
"""Times that a training goes back; the next time it ends with the weights that it has."""

_SAY_S = 10.0
"""s between two lines that tell how it goes."""

_PREPARED = 3
"""Batches that wait for the network."""


@dataclass(frozen=True, eq=False)
class Trained:
    """What came of a training.

    Attributes:
        network: with the mean of the weights, on the CPU, in its mode of use.
        steps: batches learnt from.
        samples: made until the last of them.
        losses: each step's at which one looked.
    """

    network: LabelsNetwork
    steps: int
    samples: int
    losses: tuple[float, ...]


def train(
    network: LabelsNetwork,
    batches: Iterable[Batch],
    course: Course,
    *,
    most: float,
    device: torch.device,
    tell: Tell,
) -> Trained:
    """Train a network; it is changed.

    Args:
        network: with the weights to start from.
        batches: without end.
        course: how long.
        most: the highest rate of learning.
        device: where.
        tell: takes a line about how it goes.

    Raises:
        EngineError: ``worker-lost``.
        LimitError: ``out-of-memory``.
    """
    # torch's stub lacks the format of memory.
    network = network.to(device, memory_format=torch.channels_last).train()  # type: ignore[call-overload]
    run = _Run(network, most, device)
    said, samples = time.monotonic(), 0
    prepared = _Prepared(batches, device)
    try:
        while not run.stuck and (share := course.share(run.step)) < 1.0:
            batch = prepared.next()
            samples = batch.made
            run.learn(batch, share)
            if time.monotonic() - said > _SAY_S:
                said = time.monotonic()
                tell(f"step {run.step}, {share:.0%}: loss {run.recent():.4f}, {samples} samples")
    except torch.OutOfMemoryError as error:
        raise LimitError(
            Code.OUT_OF_MEMORY, "the memory of the GPU does not suffice: use a smaller --batch"
        ) from error
    finally:
        prepared.stop()
    return Trained(run.averaged(), run.step, samples, tuple(run.losses))


@dataclass(frozen=True, eq=False)
class _Pinned:
    """A batch as tensors, in memory from which a GPU takes it by itself."""

    maps: Tensor
    gain: Tensor
    made: int


class _Run:
    """A training under way.

    Attributes:
        step: batches learnt from.
        losses: each step's at which one looked.
        stuck: whether the loss was no number again and again.
    """

    def __init__(self, network: LabelsNetwork, most: float, device: torch.device) -> None:
        self.step = 0
        self.losses: list[float] = []
        self.stuck = False
        self._network = network
        self._most = most
        self._device = device
        self._optimizer = AdamW(network.parameters(), weight_decay=_DECAY_OF_WEIGHTS)
        self._mean = AveragedModel(network, multi_avg_fn=self._average, use_buffers=True)
        self._kept = self._weights()
        self._returns = 0

    def learn(self, batch: _Pinned, share: float) -> None:
        """One step, at a share of the training."""
        cuda = self._device.type == "cuda"
        for group in self._optimizer.param_groups:
            group["lr"] = rate_at(share, self._most)
        ink, classes, extra = _on_device(batch, self._device)
        with torch.autocast(self._device.type, dtype=torch.bfloat16, enabled=cuda):
            logits = self._network(ink)
        loss = labels_loss(logits, classes, extra)
        _follow(self._network, self._optimizer, loss)
        self.step += 1
        self._mean.update_parameters(self._network)
        if cuda and self.step % _LOOK:
            return
        value = float(loss.detach())
        if not math.isfinite(value):
            self._go_back()
            return
        self.losses.append(value)
        if self.step % _KEEP == 0:
            self._kept = self._weights()

    def recent(self) -> float:
        """Mean of the last losses."""
        last = self.losses[-_LOOK:]
        return sum(last) / max(len(last), 1)

    def averaged(self) -> LabelsNetwork:
        """The network with the mean of the weights."""
        network = deepcopy(self._mean.module).cpu().eval()
        assert isinstance(network, LabelsNetwork)
        return network

    def _go_back(self) -> None:
        """To the last weights that were good, and slower from there."""
        self._returns += 1
        self.stuck = self._returns > _MOST_RETURNS
        network, mean = self._kept
        self._network.load_state_dict(network)
        self._mean.module.load_state_dict(mean)
        self._optimizer.state.clear()
        self._most *= 0.5

    def _weights(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Copies of the network's and of their mean."""
        return deepcopy(self._network.state_dict()), deepcopy(self._mean.module.state_dict())

    @torch.no_grad()
    def _average(self, mean: _Tensors, current: _Tensors, _: Tensor | int) -> None:
        """Move the mean of all tensors of one kind towards the current ones."""
        decay = min(_DECAY, self.step / (self.step + _YOUNG))
        if mean[0].is_floating_point():
            torch._foreach_lerp_(mean, current, 1.0 - decay)
        else:
            torch._foreach_copy_(mean, current)


def _follow(network: LabelsNetwork, optimizer: Optimizer, loss: Tensor) -> None:
    """One step down the gradient."""
    optimizer.zero_grad(set_to_none=True)
    loss.backward()
    torch.nn.utils.clip_grad_norm_(network.parameters(), _LONGEST_GRADIENT)
    optimizer.step()


def _on_device(batch: _Pinned, device: torch.device) -> tuple[Tensor, Tensor, Tensor]:
    """(n, 1, h, w) float32 ink, and (n, h, w) uint8 classes and extra."""
    grey, classes, extra = batch.maps.to(device, non_blocking=True)
    gain = batch.gain.to(device, non_blocking=True)[:, None, None, None]
    ink = (1.0 - grey[:, None].float() / 255.0) * gain
    return ink.contiguous(memory_format=torch.channels_last), classes, extra


class _Prepared:
    """Batches that a thread prepares while the network learns from others."""

    def __init__(self, batches: Iterable[Batch], device: torch.device) -> None:
        self._queue: queue.Queue[_Pinned | BaseException] = queue.Queue(_PREPARED)
        self._stopped = threading.Event()
        self._pinned = device.type == "cuda"
        self._thread = threading.Thread(target=self._prepare, args=(iter(batches),), daemon=True)
        self._thread.start()

    def next(self) -> _Pinned:
        """The next one; what went wrong with it is raised here."""
        exception = self._queue.get()
        if isinstance(exception, BaseException):
            raise exception
        return exception

    def stop(self) -> None:
        """Prepare no more."""
        self._stopped.set()
        self._thread.join()

    def _prepare(self, batches: Iterator[Batch]) -> None:
        try:
            for batch in batches:
                maps, gain = torch.from_numpy(batch.maps), torch.from_numpy(batch.gain)
                if self._pinned:
                    maps, gain = maps.pin_memory(), gain.pin_memory()
                if not self._put(_Pinned(maps, gain, batch.made)):
                    return
        except Exception as error:
            self._put(error)

    def _put(self, pinned: _Pinned | BaseException) -> bool:
        """Whether it was wanted."""
        while not self._stopped.is_set():
            try:
                self._queue.put(pinned, timeout=0.1)
            except queue.Full:
                continue
            return True
        return False
