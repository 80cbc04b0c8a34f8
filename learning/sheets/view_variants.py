"""Views on a sheet: whole ones, halves, and ones whose middle is broken out."""

import random
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import SectionKind
from learning.sheets.chains_of_points import Points, beyond
from learning.training_parts import Circle, PartView

_HALVES, _BROKEN = 0.05, 0.08
"""Shares of the views of which half is drawn, and whose middle is broken out if they are long."""

_LONG = 1.3
"""Lengths of a view in its widths, from which its middle is broken out."""


@dataclass(frozen=True)
class Border:
    """Where a view ends that would go on.

    Attributes:
        axis: 0, an upright border; 1, a level one.
        at: its coordinate, in the unit of the view.
        broken: whether the rest is left out, or else the rest mirrors what is drawn.
    """

    axis: int
    at: float
    broken: bool


@dataclass(frozen=True, eq=False)
class SheetView:
    """A view, in px of the sheet once it is placed, y down.

    Attributes:
        role: which.
        lines: of the part.
        section: how it is cut; None, not at all.
        borders: where it ends too soon.
    """

    role: Role
    lines: PartView
    section: SectionKind | None = None
    borders: tuple[Border, ...] = ()

    @cached_property
    def box(self) -> tuple[float, float, float, float]:
        """x0, y0, x1, y1."""
        x0, y0, x1, y1 = (float(item) for item in self.lines.box().ravel())
        return x0, y0, x1, y1

    @cached_property
    def size(self) -> npt.NDArray[np.float32]:
        """(2,) extent."""
        low, high = self.lines.box()
        return high - low

    @cached_property
    def points(self) -> list[Points]:
        """Ends of visible lines, each (2,)."""
        return [chain[0] for chain in self.lines.visible] + [
            chain[-1] for chain in self.lines.visible
        ]

    @cached_property
    def segments(self) -> list[Points]:
        """Straight visible lines, each (2, 2)."""
        return [chain for chain in self.lines.visible if len(chain) == 2]

    def moved(self, matrix: npt.NDArray[np.floating], offset: npt.ArrayLike) -> "SheetView":
        """After a turn by right angles, a mirroring and a change of size: (2, 2), and then a way
        (2,); borders follow in size and way only."""
        way = np.asarray(offset)
        borders = tuple(
            replace(
                border, at=float(matrix[border.axis, border.axis] * border.at + way[border.axis])
            )
            for border in self.borders
        )
        return replace(self, lines=self.lines.moved(matrix, offset), borders=borders)


def shortened(view: SheetView, chance: random.Random) -> SheetView:
    """The view, or now and then half of it, or without its middle."""
    share = chance.random()
    if share < _HALVES:
        return _half(view, chance)
    return _broken(view, chance) if share < _HALVES + _BROKEN else view


def _half(view: SheetView, chance: random.Random) -> SheetView:
    low, high = view.lines.box()
    axis, sign = chance.randrange(2), chance.choice([-1, 1])
    middle = float(low[axis] + high[axis]) / 2.0
    lines = view.lines.each(lambda chain: beyond(chain, axis, middle, sign))
    circles = tuple(
        circle for circle in view.lines.circles if sign * (circle.centre[axis] - middle) > -1e-3
    )
    if len(lines.visible) < 2:
        return view
    border = Border(axis, middle, broken=False)
    return replace(view, lines=replace(lines, circles=circles), borders=(border,))


def _broken(view: SheetView, chance: random.Random) -> SheetView:
    low, high = view.lines.box()
    size = high - low
    axis = int(size[1] > size[0])
    if size[axis] < _LONG * size[1 - axis]:
        return view
    first = float(low[axis] + size[axis] * chance.uniform(0.3, 0.5))
    second = first + float(size[axis]) * chance.uniform(0.1, 0.3)
    gap = float(size[axis]) * chance.uniform(0.01, 0.05)
    way = np.zeros(2, np.float32)
    way[axis] = first + gap - second

    def pieces(chain: Points) -> list[Points]:
        near, far = beyond(chain, axis, first, -1), beyond(chain, axis, second, 1)
        return near + [values + way for values in far]

    lines = view.lines.each(pieces)
    if len(lines.visible) < 2:
        return view
    circles = tuple(_left_over(view.lines.circles, axis, (first, second), way))
    borders = Border(axis, first, broken=True), Border(axis, first + gap, broken=True)
    return replace(view, lines=replace(lines, circles=circles), borders=borders)


def _left_over(
    circles: tuple[Circle, ...], axis: int, gap: tuple[float, float], way: Points
) -> list[Circle]:
    """The circles that a gap does not touch, those behind it moved."""
    near = [circle for circle in circles if circle.centre[axis] + circle.radius < gap[0]]
    far = [circle for circle in circles if circle.centre[axis] - circle.radius > gap[1]]
    return near + [circle.moved(np.eye(2), way) for circle in far]
