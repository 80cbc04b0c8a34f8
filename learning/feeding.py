"""Samples from worker processes to batches, through memory that they share.

Each worker has a ring of slots.  It writes one sample after the other into it, and is stopped
before it would write over what may be read: at most a quarter of the ring ahead of what the
training is due.  A batch is drawn at random from the other three quarters, so that the crops of
one sheet go into many batches, and each sample into one or two.
"""

import mmap
import multiprocessing
import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing.process import BaseProcess

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import EngineError
from gaussiancad_protocol.codes import Code
from learning.training_samples import Sample

Stream = Callable[[int], Iterator[Sample]]
"""Samples without end of a worker, by its number."""

_FRESH = 0.75
"""Samples that come anew for each one in a batch: so often is one seen 4 times in 3."""

_FIRST = 300
"""Samples before the first batch."""

_AHEAD = 4
"""A ring's share that is being written, as one part in so many."""

_GAIN = (0.75, 1.1)
"""Factors between which a sample's ink is made paler or darker."""

_PAUSE = 0.004
"""s between two looks at what the others did."""


@dataclass(frozen=True)
class FeedPlan:
    """How samples become batches.

    Attributes:
        size: px of the sides of a sample.
        batch: samples of a batch.
        workers: processes that make samples.
        slots: samples held at a time; 1.2 MB each at 640 px.
        paced: whether batches wait for the workers, each having made what is due and no more: then
            they are the same in every run.  Else they are drawn from what is there.
        seed: of the draws.
    """

    size: int
    batch: int
    workers: int = 1
    slots: int = 2048
    paced: bool = False
    seed: int = 0

    @property
    def ring(self) -> int:
        """Slots of a worker."""
        return max(self.slots, 4 * self.batch) // self.workers + _AHEAD

    @property
    def ahead(self) -> int:
        """Slots of a worker that it may be writing."""
        return self.ring // _AHEAD

    def due(self, step: int) -> int:
        """Samples that each worker has made before a step."""
        first = max(self.batch, min(_FIRST, self.slots // 2))
        return -(-(first + int(_FRESH * self.batch * step)) // self.workers)


@dataclass(frozen=True, eq=False)
class Batch:
    """Samples to learn from at once.

    Attributes:
        maps: (3, n, h, w) uint8: grey levels, classes, extra, as in :class:`.Sample`.
        gain: (n,) float32, factor of the ink of each.
        made: samples that the workers had made.
    """

    maps: npt.NDArray[np.uint8]
    gain: npt.NDArray[np.float32]
    made: int


class _Rings:
    """What the processes share: samples, and how far each worker is and may go.

    Attributes:
        maps: (3, workers, ring, size, size) uint8.
        made: (workers,) samples made so far.
        limit: (workers,) samples up to which each may go.
        stopped: (1,) not 0 at the end.
    """

    def __init__(self, plan: FeedPlan) -> None:
        shape = (3, plan.workers, plan.ring, plan.size, plan.size)
        self.maps = _shared(shape, np.uint8)
        self.made, self.limit = (_shared((plan.workers,), np.int64) for _ in range(2))
        self.stopped = _shared((1,), np.int64)
        self.limit[:] = plan.due(0) + plan.ahead


class Feed:
    """Batches without end.  Made by :func:`feeding`."""

    def __init__(self, plan: FeedPlan, rings: _Rings, processes: list[BaseProcess]) -> None:
        self._plan = plan
        self._rings = rings
        self._processes = processes

    def __iter__(self) -> Iterator[Batch]:
        """One batch after the other, each from what came until then.

        Raises:
            EngineError: ``worker-lost``.
        """
        rng = np.random.default_rng(self._plan.seed)
        step = 0
        while True:
            yield self._batch(step, rng)
            step += 1

    def _batch(self, step: int, rng: np.random.Generator) -> Batch:
        plan, rings = self._plan, self._rings
        newest = self._newest(step)
        oldest = np.maximum(0, rings.limit - plan.ring)
        borders = np.cumsum(newest - oldest)
        picked = rng.choice(int(borders[-1]), plan.batch, replace=False)
        workers = np.searchsorted(borders, picked, side="right")
        slots = (newest[workers] - (borders[workers] - picked)) % plan.ring
        maps = _turned(rings.maps[:, workers, slots], rng)
        gain = rng.uniform(*_GAIN, plan.batch).astype(np.float32)
        # Only now may anything that was read be written over.
        due = plan.due(step + 1)
        rings.limit[:] = (due if plan.paced else np.minimum(newest, due)) + plan.ahead
        return Batch(maps, gain, int(newest.sum()))

    def _newest(self, step: int) -> npt.NDArray[np.int64]:
        """(workers,) samples of each worker from which the batch of a step is drawn."""
        plan = self._plan
        due = np.full(plan.workers, plan.due(step), np.int64)
        least = due if plan.paced else np.full(plan.workers, plan.due(0), np.int64)
        while True:
            made = self._rings.made.copy()
            if (made >= least).all():
                return due if plan.paced else made
            lost = next((process for process in self._processes if not process.is_alive()), None)
            if lost is not None:
                raise EngineError(
                    Code.WORKER_LOST,
                    "a process that makes sheets ended with {status}: what it printed says why",
                    status=lost.exitcode,
                )
            time.sleep(_PAUSE)


@contextmanager
def feeding(plan: FeedPlan, stream: Stream) -> Iterator[Feed]:
    """Start the workers, and end them with the block.

    They are forked, so that what the stream holds is there at once: nothing may have used a GPU
    before.

    Args:
        plan: how.
        stream: what each worker makes.

    Raises:
        EngineError: ``engine-incomplete`` on a system that has no forks.
    """
    if "fork" not in multiprocessing.get_all_start_methods():
        raise EngineError(
            Code.ENGINE_INCOMPLETE, "training forks its processes: use Linux, or WSL on Windows"
        )
    rings = _Rings(plan)
    context = multiprocessing.get_context("fork")
    # A fork would inherit a pool of threads without its threads.
    threads = cv2.getNumThreads()
    cv2.setNumThreads(1)
    processes: list[BaseProcess] = [
        context.Process(target=_work, args=(number, plan, rings, stream), daemon=True)
        for number in range(plan.workers)
    ]
    for process in processes:
        process.start()
    cv2.setNumThreads(threads)
    try:
        yield Feed(plan, rings, processes)
    finally:
        rings.stopped[0] = 1
        for this_process in processes:
            this_process.join(1.0)
            if this_process.is_alive():
                this_process.kill()
                this_process.join()


def _work(number: int, plan: FeedPlan, rings: _Rings, stream: Stream) -> None:
    """Fill a ring, as far as it may be filled, until the end of the parent."""
    cv2.setNumThreads(1)
    os.nice(5)
    parent = os.getppid()
    for sample in stream(number):
        made = int(rings.made[number])
        while made >= rings.limit[number]:
            if rings.stopped[0] or os.getppid() != parent:
                return
            time.sleep(_PAUSE)
        if rings.stopped[0]:
            return
        values = rings.maps[:, number, made % plan.ring]
        values[0], values[1], values[2] = sample.grey, sample.classes, sample.extra
        rings.made[number] = made + 1


def _turned(maps: npt.NDArray[np.uint8], rng: np.random.Generator) -> npt.NDArray[np.uint8]:
    """(3, n, h, w) the same, turned or mirrored in one of eight ways."""
    across, down, swapped = rng.random(3) < 0.5
    if across:
        maps = maps[..., ::-1]
    if down:
        maps = maps[..., ::-1, :]
    if swapped:
        maps = maps.swapaxes(-1, -2)
    return np.ascontiguousarray(maps)


def _shared(shape: tuple[int, ...], kind: type[np.generic]) -> npt.NDArray:
    """An array of zeros that forks share."""
    size = int(np.prod(shape)) * np.dtype(kind).itemsize
    return np.frombuffer(mmap.mmap(-1, size), kind).reshape(shape)
