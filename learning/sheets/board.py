"""A drawing board: the canvas, the style to draw in, and the chance that decides."""

import math
import random
from collections.abc import Iterable
from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.canvas import SUPERSAMPLING, Canvas
from learning.sheets.chains_of_points import Points, across, circle, dashed
from learning.sheets.letter_fonts import HERSHEY, Fonts
from learning.sheets.random_style import Head, Pattern, Style
from learning.sheets.text_pixels import Lettering, text_mask

Anchor = tuple[float, float]
"""Which point of a text's box is where it is written: shares of its width and height."""

MIDDLE, LEFT, RIGHT, TOP, FOOT = (0.5, 0.5), (0.0, 0.5), (1.0, 0.5), (0.5, 0.0), (0.5, 1.0)
"""Anchors."""

_SLOPES_DEG = (30, 45, 60, 120, 135, 150, -30, -45, -60, -120, -135, -150)
"""Of leaders."""


@dataclass(frozen=True)
class Look:
    """What a text looks like.

    Attributes:
        height: px of its capitals.
        lettering: how it is lettered.
        darkness: to 255, black.
        ink: what it stands for.
    """

    height: float
    lettering: Lettering
    darkness: int
    ink: InkClass = InkClass.TEXT

    def times(self, factor: float) -> "Look":
        """Higher by a factor."""
        return replace(self, height=factor * self.height)

    def in_letters(self, lettering: Lettering) -> "Look":
        """Lettered in another way."""
        return replace(self, lettering=lettering)


@dataclass(frozen=True, eq=False)
class Board:
    """What all that is drawn is drawn with.

    Attributes:
        canvas: takes the marks.
        style: of the sheet.
        chance: decides.
        fonts: to letter in.
    """

    canvas: Canvas
    style: Style
    chance: random.Random
    fonts: Fonts

    @property
    def look(self) -> Look:
        """Of usual texts."""
        return Look(self.style.height, self.style.lettering, self.style.darkness.text)

    def likely(self, share: float) -> bool:
        """True in a share of the cases."""
        return self.chance.random() < share

    def heights(self, low: float, high: float) -> float:
        """px of some heights of the text."""
        return self.style.height * self.chance.uniform(low, high)

    def other_look(self) -> Look:
        """Of texts that are lettered in some other way."""
        look, font = self.look, self.fonts.any(self.chance)
        steady = replace(look.lettering, shaking=0.0)
        pen = max(0.6, min(1.1 * self.style.widths.visible, self.style.height / 5.0))
        drawn = replace(look.lettering, font=None, pen=pen, hershey=self.chance.choice(HERSHEY))
        return replace(
            look, lettering=self.chance.choice([look.lettering, replace(steady, font=font), drawn])
        )

    def thin(
        self,
        chains: Iterable[Points],
        ink: InkClass = InkClass.DIMENSION,
        width: float | None = None,
        darkness: int | None = None,
    ) -> None:
        """Lines as of dimensions, if nothing else is said."""
        width = self.style.widths.thin if width is None else width
        darkness = self.style.darkness.dimension if darkness is None else darkness
        self.canvas.lines(chains, ink, width, darkness)

    def dashes(
        self, chain: Points, pattern: Pattern, phase: float, ink: InkClass, pen: tuple[float, int]
    ) -> None:
        """An interrupted line, with a pen of a width and a darkness."""
        square = self.style.dashes.square
        draw = self.canvas.square_lines if square else self.canvas.lines
        draw(dashed(chain, pattern, phase), ink, *pen)

    def arrow(
        self,
        tip: npt.ArrayLike,
        way: npt.ArrayLike,
        ink: InkClass = InkClass.DIMENSION,
        *,
        size: float = 1.0,
    ) -> None:
        """An arrowhead in the sheet's form.

        Args:
            tip: (2,).
            way: (2,) of length 1, towards the tip.
            ink: what it stands for.
            size: in usual sizes.
        """
        heads, darkness = self.style.heads, self.style.darkness.dimension
        tip, way = np.asarray(tip, dtype=np.float64), np.asarray(way, dtype=np.float64)
        aside, back = across(way) * size * heads.half_width, way * size * heads.length
        wings = tip - back + aside, tip - back - aside
        if heads.form is Head.FILLED:
            self.canvas.fill(np.array([tip, *wings]), ink, darkness)
        elif heads.form is Head.OPEN:
            self.thin([np.array([wings[0], tip, wings[1]])], ink)
        elif heads.form is Head.HOLLOW:
            self.thin([np.array([tip, *wings, tip])], ink)
        elif heads.form is Head.TICK:
            half = (way + across(way)) * size * heads.length * 0.45
            self.thin([np.array([tip - half, tip + half])], ink, 1.2 * self.style.widths.thin)
        elif heads.form is Head.DOT:
            radius = max(1.5, 0.9 * heads.half_width)
            self.canvas.fill(circle(tip, radius), ink, darkness)

    def write(
        self,
        text: str,
        at: npt.ArrayLike,
        anchor: Anchor = MIDDLE,
        degrees: float = 0.0,
        look: Look | None = None,
    ) -> tuple[float, float]:
        """Write a line of text.

        Args:
            text: what.
            at: (2,) where.
            anchor: which point of its box is there.
            degrees: counter-clockwise to the eye.
            look: how, as usual if None.

        Returns:
            Width and height of the box in px.
        """
        look = look or self.look
        if not text:
            return 0.0, 0.0
        mask = _turned(text_mask(text, look.height, look.lettering), degrees)
        size = np.array(mask.shape[::-1]) / SUPERSAMPLING
        corner = np.asarray(at, dtype=np.float64) - size * anchor
        self.canvas.stamp(mask, corner, look.ink, look.darkness)
        return float(size[0]), float(size[1])

    def near(self, point: npt.ArrayLike, low: float = 2.0, high: float = 9.0) -> Points:
        """(2,) a place some heights of the text away."""
        angle = self.chance.uniform(0.0, 2.0 * math.pi)
        if self.likely(0.5):
            angle = math.radians(self.chance.choice(_SLOPES_DEG))
        way = np.array([math.cos(angle), math.sin(angle)])
        return np.asarray(point, dtype=np.float64) + way * self.heights(low, high)


def _turned(mask: npt.NDArray[np.uint8], degrees: float) -> npt.NDArray[np.uint8]:
    """A mask turned counter-clockwise, larger where it has to be."""
    if degrees % 90 == 0:
        return np.rot90(mask, int(degrees // 90) % 4)
    height, width = mask.shape
    cosine, sine = (abs(function(math.radians(degrees))) for function in (math.cos, math.sin))
    size = int(width * cosine + height * sine) + 4, int(width * sine + height * cosine) + 4
    turn = cv2.getRotationMatrix2D((width / 2, height / 2), degrees, 1.0)
    turn[:, 2] += (size[0] - width) / 2, (size[1] - height) / 2
    return np.asarray(cv2.warpAffine(mask, turn, size), dtype=np.uint8)
