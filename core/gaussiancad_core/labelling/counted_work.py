"""Counted work: how far a search has come, the same on every machine.

What a search does is counted in units of which an ordinary core does about one a second: what the
solver counts itself, and the pieces, clauses, faces and lines that are made.  All limits are limits
of that, so that a drawing has the same answer however busy the machine is.  A clock only guards,
and what it ends is told.
"""

import time
from dataclasses import dataclass
from enum import Enum
from math import inf


class Counted(Enum):
    """What is made, and the units that one of it counts.

    Measured on parts of six classes with 8 to 60 faces.
    """

    PIECE = 1.5e-4
    """A piece of a line with what is looked up beside it, and its rule."""

    CROSSING = 5e-6
    """A group of crossings of a rule, as clauses."""

    PATCH = 5e-3
    """A face that is fused with the others."""

    EDGE = 8e-3
    """An edge of a solid that is drawn again, and matched."""


class Meter:
    """What a search has done so far, by step.

    Args:
        guard: s after which it ends all the same.

    Attributes:
        spent: units of work.
        work: the same by step.
        seconds: of the clock by step, to be told.
    """

    def __init__(self, guard: float = inf) -> None:
        self.spent = 0.0
        self.work: dict[str, float] = {}
        self.seconds: dict[str, float] = {}
        self._counted = 0.0
        self._start = self._last = time.perf_counter()
        self._guard = guard
        self._is_overrun = False

    def add(self, units: float) -> None:
        """Count so many units."""
        self.spent += units

    def count(self, what: Counted, number: int = 1) -> None:
        """Count so many things of a kind."""
        self.spent += what.value * number

    def lap(self, step: str) -> None:
        """What was done since the last lap belongs to a step."""
        now = time.perf_counter()
        self.seconds[step] = self.seconds.get(step, 0.0) + now - self._last
        self.work[step] = self.work.get(step, 0.0) + self.spent - self._counted
        self._last, self._counted = now, self.spent

    @property
    def is_overrun(self) -> bool:
        """Whether the clock ended the search; once it has, it stays ended."""
        self._is_overrun |= self.guarded_left <= 0.0
        return self._is_overrun

    @property
    def guarded_left(self) -> float:
        """s until the clock ends the search."""
        return max(0.0, self._start + self._guard - time.perf_counter())

    def until(self, units: float) -> "Deadline":
        """What ends once so many units are done, from the start on."""
        return Deadline(self, units)


@dataclass(frozen=True)
class Deadline:
    """An amount of work by which a step ends.

    Attributes:
        meter: that counts it; None where nothing is counted.
        at: units.
    """

    meter: Meter | None = None
    at: float = inf

    @property
    def left(self) -> float:
        """Units until then; 0 when it is over, or the clock has ended the search."""
        if self.meter is None:
            return max(0.0, self.at)
        return 0.0 if self.meter.is_overrun else max(0.0, self.at - self.meter.spent)

    @property
    def seconds_left(self) -> float:
        """s until the clock ends the search."""
        return inf if self.meter is None else self.meter.guarded_left

    def add(self, units: float) -> None:
        """Count so many units."""
        if self.meter is not None:
            self.meter.add(units)

    def count(self, what: Counted, number: int = 1) -> None:
        """Count so many things of a kind."""
        if self.meter is not None:
            self.meter.count(what, number)


NEVER = Deadline()
"""Of what is neither counted nor ended."""

OVER = Deadline(at=0.0)
"""Of what ends at once."""
