"""What is drawn on a sheet, before it is pixels: marks, each with what it stands for.

Coordinates and widths are px of the sheet.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.chains_of_points import Points, across, norm

SUPERSAMPLING = 2
"""Pixels of a drawing along a pixel of the sheet."""

_LEAST_PX = 0.2
"""Shorter dashes are no marks."""


@dataclass(frozen=True, eq=False)
class Lines:
    """Lines of one width."""

    chains: tuple[Points, ...]
    width: float


@dataclass(frozen=True, eq=False)
class Filled:
    """A filled ring (n, 2)."""

    ring: Points


@dataclass(frozen=True, eq=False)
class Stamp:
    """Ink of its own pixels, such as a text's.

    Attributes:
        mask: (h, w) 0 to 255, :data:`SUPERSAMPLING` pixels a px.
        x, y: where its upper left corner is, in the same pixels.
    """

    mask: npt.NDArray[np.uint8]
    x: int
    y: int


@dataclass(frozen=True, eq=False)
class Mark:
    """Something drawn.

    Attributes:
        shape: where.
        ink: what it stands for.
        darkness: 0 to 255, black.
    """

    shape: Lines | Filled | Stamp
    ink: InkClass
    darkness: int


@dataclass(frozen=True, eq=False)
class Tint:
    """An area in grey, which is no ink.

    Attributes:
        ring: (n, 2).
        left, right: darkness at the left and the right border of the sheet, 0 to 255.
    """

    ring: Points
    left: float
    right: float


@dataclass(frozen=True, eq=False)
class Track:
    """Hidden lines, dashes and gaps.

    Attributes:
        chains: each (n, 2).
        width: px that count as on them.
    """

    chains: tuple[Points, ...]
    width: float


class Canvas:
    """A sheet of so many px, empty at first.

    Attributes:
        width, height: px.
        marks: in the order they were drawn.
        tints: areas in grey.
        tracks: hidden lines.
        corners: where lines of the part end or meet, each (2,).
    """

    def __init__(self, width: int, height: int) -> None:
        self.width, self.height = width, height
        self.marks: list[Mark] = []
        self.tints: list[Tint] = []
        self.tracks: list[Track] = []
        self.corners: list[Points] = []

    def lines(self, chains: Iterable[Points], ink: InkClass, width: float, darkness: int) -> None:
        """Lines with round ends."""
        kept = tuple(chain for chain in chains if len(chain) > 1)
        if kept:
            self.marks.append(Mark(Lines(kept, width), ink, darkness))

    def square_lines(
        self, chains: Iterable[Points], ink: InkClass, width: float, darkness: int
    ) -> None:
        """Lines of which the straight ones have square ends."""
        chains = list(chains)
        self.lines([chain for chain in chains if len(chain) > 2], ink, width, darkness)
        for start, end in (chain for chain in chains if len(chain) == 2):
            if norm(end - start) < _LEAST_PX:
                continue
            aside = across(end - start) / norm(end - start) * width / 2.0
            ring = np.array([start + aside, end + aside, end - aside, start - aside])
            self.fill(ring, ink, darkness)

    def fill(self, ring: Points, ink: InkClass, darkness: int) -> None:
        """A ring and all within."""
        self.marks.append(Mark(Filled(ring), ink, darkness))

    def stamp(
        self, mask: npt.NDArray[np.uint8], corner: npt.ArrayLike, ink: InkClass, darkness: int
    ) -> None:
        """Ink of its own pixels.

        Args:
            mask: (h, w) 0 to 255, :data:`SUPERSAMPLING` pixels a px.
            corner: (2,) its upper left one, in px.
            ink: what it stands for.
            darkness: where the mask is 255.
        """
        x, y = (int(value * SUPERSAMPLING) for value in np.asarray(corner))
        self.marks.append(Mark(Stamp(mask, x, y), ink, darkness))

    def tint(self, ring: Points, left: float, right: float) -> None:
        """An area in grey, which may change from the sheet's left to its right."""
        self.tints.append(Tint(ring, left, right))

    def track(self, chains: Iterable[Points], width: float) -> None:
        """Tell where hidden lines run."""
        self.tracks.append(Track(tuple(chains), width))
