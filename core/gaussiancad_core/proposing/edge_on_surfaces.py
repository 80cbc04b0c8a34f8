"""Surfaces that strokes are seen edge-on as: each has a number, and those that are one have one.

A stroke of a view is a surface that runs along the look: a straight one a plane, an arc a cylinder.
What a search puts together is made of these surfaces, so that two of them are the same exactly
where the sheet says so, whatever features they belong to.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.axes import Axis

_ONE = 3.0
"""Tolerances within which two surfaces are one."""


class SurfaceKind(Enum):
    """How a surface lies to its axis."""

    ACROSS = "across"
    """A plane across it: where it lies along it."""

    ALONG = "along"
    """A plane along it that leans to the other axes: its direction and its distance."""

    CYLINDER = "cylinder"
    """About a line along it: where that is, and the radius."""

    CONE = "cone"
    """About a line along it: where that is, and the profile's line in radius and height."""

    TORUS = "torus"
    """The same with a circle as its profile."""

    FREE = "free"
    """A curve that is neither a line nor a circle, along it: the number of its stroke."""


@dataclass(frozen=True)
class Surface:
    """A surface.

    Attributes:
        kind: how it lies.
        axis: to which axis.
        values: mm, what its kind needs.
    """

    kind: SurfaceKind
    axis: Axis
    values: tuple[float, ...]


class _Alike:
    """Surfaces of one kind to one axis, in a table that grows.

    Args:
        width: how many values each has.
    """

    def __init__(self, width: int) -> None:
        self._values = np.zeros((8, width))
        self._numbers = np.zeros(8, np.int64)
        self._count = 0

    def nearest(self, values: Sequence[float], most: float) -> int | None:
        """The number of the nearest one, where no value of it is farther away than the most."""
        if not self._count:
            return None
        away = np.abs(self._values[: self._count] - values).max(axis=1)
        row = int(away.argmin())
        return int(self._numbers[row]) if away[row] <= most else None

    def add(self, number: int, values: Sequence[float]) -> None:
        """Take one more."""
        if self._count == len(self._numbers):
            self._values = np.vstack([self._values, np.zeros_like(self._values)])
            self._numbers = np.concatenate([self._numbers, np.zeros_like(self._numbers)])
        self._values[self._count], self._numbers[self._count] = values, number
        self._count += 1


class SurfaceTable:
    """The surfaces of a sheet in the order in which they were met.

    Args:
        tolerance: mm by which strokes may miss where they belong.
    """

    def __init__(self, tolerance: float) -> None:
        self._tolerance = tolerance
        self._surfaces: list[Surface] = []
        self._joined: list[int] = []
        self._alike: dict[tuple[SurfaceKind, Axis], _Alike] = {}

    def __getitem__(self, number: int) -> Surface:
        return self._surfaces[number]

    def __len__(self) -> int:
        return len(self._surfaces)

    def number(self, kind: SurfaceKind, axis: Axis, *values: float) -> int:
        """The number of a surface: that of a known one, where both are one."""
        alike = self._alike.setdefault((kind, axis), _Alike(len(values)))
        found = alike.nearest(values, _ONE * self._tolerance)
        if found is not None:
            return found
        number = len(self._surfaces)
        self._surfaces.append(Surface(kind, axis, tuple(map(float, values))))
        self._joined.append(number)
        alike.add(number, values)
        return number

    def join(self, one: int, other: int) -> None:
        """Say that two surfaces pass into each other smoothly."""
        first, second = self._root(one), self._root(other)
        self._joined[max(first, second)] = min(first, second)

    def roots(self) -> npt.NDArray[np.int64]:
        """(n,) of each surface, the first that it passes into smoothly."""
        return np.array([self._root(number) for number in range(len(self._joined))], np.int64)

    def _root(self, number: int) -> int:
        while self._joined[number] != number:
            number = self._joined[number]
        return number
