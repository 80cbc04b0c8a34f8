"""The hand that a sheet is drawn in: widths, darkness, dashes, arrowheads, letters.

Lengths are px of the sheet.
"""

import random
from dataclasses import dataclass, replace
from enum import Enum, auto

from learning.sheets.letter_fonts import Fonts
from learning.sheets.text_pixels import Lettering, random_lettering

Pattern = tuple[float, ...]
"""Px on, off, on, off and so on."""

ENDLESS: Pattern = (1e5, 1.0)
"""A line without gaps."""

_GREYS = (29, 76, 150, 105, 128, 179, 226, 255, 60, 200)
"""Brightness of colours of pens when they are turned grey."""

_PALEST = 75
"""Darkness of ink at least: paler ink would be none."""


class Head(Enum):
    """What ends a dimension line."""

    FILLED = auto()
    OPEN = auto()
    TICK = auto()
    DOT = auto()
    HOLLOW = auto()
    NONE = auto()


class TextPosition(Enum):
    """Where the number of a dimension stands."""

    ABOVE = auto()
    GAP = auto()
    ON = auto()
    BESIDE = auto()
    MIXED = auto()


@dataclass(frozen=True)
class Widths:
    """Px of lines of each kind."""

    visible: float
    thin: float
    hidden: float
    centre: float


@dataclass(frozen=True)
class Darkness:
    """How dark ink of each kind is, to 255, black."""

    visible: int
    hidden: int
    centre: int
    dimension: int
    hatching: int
    text: int
    frame: int


@dataclass(frozen=True)
class Dashes:
    """How lines are interrupted.

    Attributes:
        hidden, centre, phantom: their patterns.
        square: whether dashes have square ends.
        under_visible: whether hidden lines run along visible ones as well.
    """

    hidden: Pattern
    centre: Pattern
    phantom: Pattern
    square: bool
    under_visible: bool


@dataclass(frozen=True)
class Heads:
    """Arrowheads: their form, length and half their width."""

    form: Head
    length: float
    half_width: float


@dataclass(frozen=True)
class Numbers:
    """How dimensions are written.

    Attributes:
        position: of the number.
        upright: whether it is never turned.
        gap: between an edge and its extension line.
        over: of an extension line beyond the dimension line.
    """

    position: TextPosition
    upright: bool
    gap: float
    over: float


@dataclass(frozen=True)
class Style:
    """All of it.

    Attributes:
        widths, darkness, dashes, heads, numbers: see there.
        height: of the capitals of numbers.
        lettering: of all texts but some.
        han: lettering of Chinese texts; None where there are none.
        smooth: whether the edges of lines are.
    """

    widths: Widths
    darkness: Darkness
    dashes: Dashes
    heads: Heads
    numbers: Numbers
    height: float
    lettering: Lettering
    han: Lettering | None
    smooth: bool


def random_style(chance: random.Random, fonts: Fonts) -> Style:
    """A hand by chance.

    Args:
        chance: says which.
        fonts: to letter in.
    """
    widths = _widths(chance)
    height = _height(chance)
    pen = widths.visible * chance.uniform(0.8, 1.2)
    if chance.random() < 0.7:
        pen = widths.thin * chance.uniform(0.8, 1.3)
    lettering = random_lettering(chance, fonts, height, pen)
    han = None
    if fonts.han and chance.random() < 0.12:
        han = replace(lettering, font=chance.choice(fonts.han))
    return Style(
        widths,
        _darkness(chance),
        _dashes(chance, widths),
        _heads(chance, height),
        _numbers(chance),
        height,
        lettering,
        han,
        chance.random() < 0.8,
    )


def _widths(chance: random.Random) -> Widths:
    spans = ((2.4, 3.8), (1.8, 5.0), (1.1, 2.2), (4.5, 8.0))
    visible = chance.uniform(*chance.choices(spans, (0.45, 0.27, 0.2, 0.08))[0])
    share = chance.random()
    if share < 0.3:
        thin = visible
    elif share < 0.82:
        thin = visible * chance.uniform(0.28, 0.8)
    elif share < 0.88:
        thin = visible * chance.uniform(0.8, 1.0)
    else:
        thin = min(visible, chance.uniform(0.5, 1.2))
    thin = max(thin, 0.5)
    hidden = max(0.7, chance.choice([visible, thin, visible * chance.uniform(0.5, 1.0)]))
    return Widths(visible, thin, hidden, chance.choice([thin, thin, max(0.5, 0.8 * thin)]))


def _height(chance: random.Random) -> float:
    spans = ((10.0, 18.0), (14.0, 34.0), (7.0, 11.0), (30.0, 48.0))
    return chance.uniform(*chance.choices(spans, (0.4, 0.48, 0.07, 0.05))[0])


def _darkness(chance: random.Random) -> Darkness:
    """In shades of black, now and then of colours turned grey, each kind its own."""
    if chance.random() < 0.12:
        visible = max(110, chance.choice([255, 255, _turned_grey(chance)]))
        return Darkness(visible, *(_turned_grey(chance) for _ in range(6)))
    visible = 255 if chance.random() < 0.75 else chance.randint(190, 255)
    dimension = visible
    if chance.random() < 0.35:
        dimension = chance.randint(90, 220) if chance.random() < 0.6 else chance.randint(72, 160)
    return Darkness(
        visible,
        hidden=visible if chance.random() < 0.75 else chance.randint(85, 255),
        centre=chance.choice([dimension, chance.randint(80, 255), visible]),
        dimension=dimension,
        hatching=chance.choice([dimension, dimension, visible, chance.randint(80, 220)]),
        text=chance.choice([dimension, visible]),
        frame=chance.choice([visible, dimension, chance.randint(80, 255)]),
    )


def _turned_grey(chance: random.Random) -> int:
    """Darkness of some colour."""
    if chance.random() < 0.3:
        return 255
    darkness = 255 - chance.choice(_GREYS) + chance.randint(-10, 10)
    return min(255, max(_PALEST, darkness))


def _dashes(chance: random.Random, widths: Widths) -> Dashes:
    unit = widths.visible if chance.random() < 0.7 else 3.0
    dotted = chance.random() < 0.27
    square = chance.random() < (0.75 if dotted else 0.35)
    hidden = (_dots if dotted else _strokes)(chance, widths.hidden, unit, square)
    long, gap = unit * chance.uniform(7.0, 26.0), unit * chance.uniform(0.9, 2.5)
    short = unit * chance.choice([0.5, 1.0, chance.uniform(1.0, 4.0)])
    gap = max(gap, widths.centre + 1.2)
    phantom = (long, gap, short, gap, short, gap)
    chain = (long, gap, short, gap)
    centre = chance.choice([chain, chain, phantom, (long, gap), ENDLESS])
    if chance.random() < 0.15:
        dash, between = hidden
        centre = (dash * chance.uniform(1.2, 2.0), between, 0.3 * dash, between)
    under = chance.random() < (0.35 if dotted else 0.08)
    return Dashes(hidden, centre, phantom, square, under)


def _dots(chance: random.Random, width: float, unit: float, square: bool) -> Pattern:
    """Dashes about as long as they are wide."""
    dash, gap = (max(1.2, width * chance.uniform(*pair)) for pair in ((0.8, 2.6), (0.6, 2.6)))
    # Round ends make a dash longer by its width.
    return (dash, gap) if square else (max(0.7, dash - width), gap + 0.8 * width)


def _strokes(chance: random.Random, width: float, unit: float, square: bool) -> Pattern:
    """Dashes as standards have them."""
    dash = unit * (chance.uniform(2.6, 9.0) if chance.random() < 0.8 else chance.uniform(1.6, 16.0))
    gap = dash * chance.uniform(0.13, 0.75)
    return dash, max(gap, 1.5 if square else width + 1.2)


def _heads(chance: random.Random, height: float) -> Heads:
    forms = tuple(Head)
    form = chance.choices(forms, (6.5, 2.0, 1.0, 1.0, 1.0, 0.5))[0]
    if chance.random() < 0.28:
        length = chance.uniform(1.5, 6.0)
        return Heads(form, length, length * chance.uniform(0.2, 0.6))
    length = height * chance.uniform(0.6, 1.5)
    return Heads(form, length, length * chance.uniform(0.1, 0.28))


def _numbers(chance: random.Random) -> Numbers:
    position = chance.choices(tuple(TextPosition), (3, 2, 1, 1, 1))[0]
    gap = chance.choice([0.0, 0.0, chance.uniform(1.0, 4.0), chance.uniform(3.0, 9.0)])
    return Numbers(position, chance.random() < 0.35, gap, chance.uniform(0.0, 10.0))
