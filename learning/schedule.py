"""How long training goes on, and how fast it learns on the way."""

import math
import time
from dataclasses import dataclass, field
from typing import Protocol

_WARM_UP = 0.02
"""Share of the training in which the rate rises: the first steps know nothing of the gradients."""

_LEAST = 1e-5
"""Rate at the beginning and at the end."""

_BEST, _BEST_PX = 2.2e-3, 32 * 640 * 640
"""The rate that was best for a batch of so many px."""


class Course(Protocol):
    """What says how much of the training is done."""

    def share(self, step: int) -> float:
        """Share that is done before a step, 1 or more at the end."""
        ...


@dataclass(frozen=True)
class BySteps:
    """Training of so many steps, which can be repeated.

    Attributes:
        steps: of one batch each.
    """

    steps: int

    def share(self, step: int) -> float:
        """Share that is done before a step."""
        return step / self.steps if self.steps else 1.0


@dataclass(frozen=True)
class ByClock:
    """Training of so many seconds from its making, whatever the machine does in them.

    Attributes:
        seconds: s of the clock.
        begun: its reading at the beginning, s.
    """

    seconds: float
    begun: float = field(default_factory=time.monotonic)

    def share(self, step: int) -> float:
        """Share that is done now."""
        return (time.monotonic() - self.begun) / self.seconds if self.seconds else 1.0


def best_rate(batch: int, size: int) -> float:
    """The highest rate for batches of so many crops of so many px: it goes with the square root of
    a batch's pixels."""
    return _BEST * math.sqrt(batch * size * size / _BEST_PX)


def rate_at(share: float, most: float) -> float:
    """The rate of learning: it rises quickly and falls along a cosine (Loshchilov 2017).

    Args:
        share: of the training that is done.
        most: the highest rate.
    """
    falling = 0.5 + 0.5 * math.cos(math.pi * min(share, 1.0))
    return _LEAST + most * min(1.0, share / _WARM_UP) * falling
