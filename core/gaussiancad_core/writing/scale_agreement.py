"""One scale from all dimensions of a sheet, whatever few of them say.

Texts are misread and lines mistaken, but seldom so that several agree: the scale is that of the
largest group of dimensions that agree.
"""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.model.views import Arc
from gaussiancad_core.sheet.picture_noise import ONE_PLACE
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.writing.dimension_texts import Span
from gaussiancad_core.writing.numbers import DimensionText, Sign, Unit

AGREE = 0.01
"""Share by which dimensions that agree may differ."""

EXACT = 0.003
"""Share by which those may differ from their median of which the scale is taken."""

_SHARE = 0.34
"""Share of the measured dimensions that agree at least: fewer may do so by chance."""

_CHANCE = 0.05
"""Probability at most with which a number whose first digits are lost fits a length by chance."""

_WHOLE = re.compile(r"\d+")
"""The digits before the point of the first number of a text."""

PAPER = 0.03
"""Share by which two scales that are one may differ, as that of a dimension and that of the paper:
copies shrink."""


@dataclass(frozen=True)
class Candidate:
    """A length on the sheet that a dimension may belong to.

    Attributes:
        pixels: its length.
        weight: 1 for the likeliest one.
        place: what it is the length of, px of the upright sheet: a span, or a circle whose radius
            or diameter it is; None where only its length is known.
    """

    pixels: float
    weight: float = 1.0
    place: Span | Arc | None = None


@dataclass(frozen=True)
class Dimension:
    """A dimension's text and what it may measure.

    Attributes:
        text: as it was read.
        said: the length that it gives.
        box: around the text, px.
        candidates: lengths on the sheet, the likeliest first; empty if none was found.
        cut: whether a line runs through its beginning, so that its first digits may be lost.
    """

    text: str
    said: DimensionText
    box: Box
    candidates: tuple[Candidate, ...]
    cut: bool = False

    def value_mm(self, unit: Unit, wanted_mm: float) -> float:
        """What it gives, with the digits before those that were read that come nearest to a length.

        Args:
            unit: of texts that do not name theirs.
            wanted_mm: the length.
        """
        read = self.said.millimetres(unit)
        digits = _WHOLE.search(self.text) if self.cut else None
        if digits is None:
            return read
        step = 10.0 ** len(digits[0]) * read / self.said.value
        lost = round((wanted_mm - read) / step)
        by_chance = 2.0 * AGREE * wanted_mm / step
        return read + lost * step if lost > 0 and by_chance <= _CHANCE else read


@dataclass(frozen=True)
class Measure:
    """What a dimension says of a place.

    Attributes:
        place: px of the upright sheet.
        value_mm: length of the span, or radius of the circle.
        digit_mm: the last one that is told of it.
    """

    place: Span | Arc
    value_mm: float
    digit_mm: float


@dataclass(frozen=True)
class ReadDimension:
    """What became of a dimension.

    Attributes:
        text: as it was read.
        value_mm: that it gives.
        box: around the text, px.
        mm_per_pixel: that follows from it; nothing where it was not found what it measures.
        used: whether the sheet's scale is taken from it.
        sign: what kind of length it says it is.
        place: what it was found to measure, px of the upright sheet.
        measure: what it says of that; nothing where it does not agree with the others.
    """

    text: str
    value_mm: float
    box: Box
    mm_per_pixel: float | None
    used: bool
    sign: Sign = Sign.LENGTH
    place: Span | Arc | None = None
    measure: Measure | None = None


@dataclass(frozen=True)
class Agreement:
    """The scale on which dimensions agree.

    Attributes:
        mm_per_pixel: of the sheet; nothing where they do not agree.
        dimensions: all of them.
    """

    mm_per_pixel: float | None
    dimensions: tuple[ReadDimension, ...]

    @property
    def measures(self) -> tuple[Measure, ...]:
        """What those say that agree."""
        return tuple(dimension.measure for dimension in self.dimensions if dimension.measure)

    @property
    def disagreeing(self) -> tuple[ReadDimension, ...]:
        """Dimensions that give another scale."""
        if self.mm_per_pixel is None:
            return ()
        return tuple(
            dimension
            for dimension in self.dimensions
            if dimension.mm_per_pixel and not dimension.used
        )


def fitting_unit(dimensions: Sequence[Dimension], paper_scale: float | None) -> Unit | None:
    """The unit in which more texts that do not name theirs say the lengths that are drawn.

    Args:
        dimensions: of the sheet.
        paper_scale: mm per px by the paper's size and the scale note, or by the unit in which the
            file says that it is drawn; None where neither is known.
    """
    if paper_scale is None:
        return None
    inch, millimetre = (
        sum(
            any(
                _fits(dimension, unit, candidate, paper_scale, PAPER)
                for candidate in dimension.candidates
            )
            for dimension in dimensions
        )
        for unit in (Unit.INCH, Unit.MILLIMETRE)
    )
    if inch == millimetre:
        return None
    return Unit.INCH if inch > millimetre else Unit.MILLIMETRE


def usual_unit(dimensions: Sequence[Dimension]) -> Unit:
    """The unit of texts that do not name theirs, by those that do."""
    inches = sum(dimension.said.unit is Unit.INCH for dimension in dimensions)
    return Unit.INCH if 2 * inches > len(dimensions) else Unit.MILLIMETRE


def agree(dimensions: Sequence[Dimension], unit: Unit, paper_scale: float | None) -> Agreement:
    """The scale on which most dimensions agree.

    Args:
        dimensions: of the sheet.
        unit: of texts that do not name theirs.
        paper_scale: mm per px by the paper's size and the scale note, where both are known.
    """
    measured = [dimension for dimension in dimensions if dimension.candidates]
    scale = _group(measured, unit, _commonest(measured, unit), AGREE, 2)
    if scale is None:
        scale = _group(measured, unit, paper_scale, PAPER, 1)
    read_dimensions = tuple(_read_dimension(dimension, unit, scale) for dimension in dimensions)
    return Agreement(scale, read_dimensions)


def _measure(
    dimension: Dimension, unit: Unit, scale: float, best: Candidate | None
) -> Measure | None:
    if best is None or best.place is None:
        return None
    share = best.place.radius / best.pixels if isinstance(best.place, Arc) else 1.0
    value = dimension.value_mm(unit, scale * best.pixels)
    return Measure(best.place, share * value, share * dimension.said.digit(unit))


def _group(
    measured: Sequence[Dimension], unit: Unit, scale: float | None, share: float, least: int
) -> float | None:
    """The scale of the dimensions that fit one, if they are enough."""
    if scale is None:
        return None
    members = [dimension for dimension in measured if _best(dimension, unit, scale, share)]
    if len(members) < max(least, _SHARE * len(measured)):
        return None
    return _refined(members, unit, scale, share)


def _scale(
    dimension: Dimension, unit: Unit, candidate: Candidate, scale: float | None = None
) -> float:
    """mm per px by a dimension; where a scale is known, with the digits that it lacks."""
    if scale is None:
        return dimension.said.millimetres(unit) / candidate.pixels
    return dimension.value_mm(unit, scale * candidate.pixels) / candidate.pixels


def _fits(
    dimension: Dimension, unit: Unit, candidate: Candidate, scale: float, share: float = AGREE
) -> bool:
    """Whether a length is what a dimension says, at a scale."""
    off = abs(math.log(_scale(dimension, unit, candidate, scale) / scale))
    return off <= max(share, ONE_PLACE / candidate.pixels)


def _best(dimension: Dimension, unit: Unit, scale: float, share: float = AGREE) -> Candidate | None:
    """The length of a dimension that fits a scale best; nothing if none does."""
    best, least = None, (math.inf, math.inf)
    for candidate in dimension.candidates:
        off = abs(math.log(_scale(dimension, unit, candidate, scale) / scale))
        if off <= max(share, ONE_PLACE / candidate.pixels) and (-candidate.weight, off) < least:
            best, least = candidate, (-candidate.weight, off)
    return best


def _commonest(dimensions: Sequence[Dimension], unit: Unit) -> float | None:
    """The scale that most dimensions fit; nothing if two fit as many."""
    votes: list[tuple[float, float]] = []
    for dimension in dimensions:
        for candidate in dimension.candidates:
            scale = _scale(dimension, unit, candidate)
            fitting = (_best(other, unit, scale) for other in dimensions)
            votes.append((sum(best.weight for best in fitting if best), scale))
    if not votes:
        return None
    most, scale = max(votes)
    rivals = [vote for vote, other in votes if abs(math.log(other / scale)) > 2 * AGREE]
    return scale if all(vote < most - 1e-9 for vote in rivals) else None


def _refined(members: Sequence[Dimension], unit: Unit, scale: float, share: float) -> float:
    """The scale that fits dimensions best; long ones count more."""
    pairs = [
        (member.value_mm(unit, scale * best.pixels), best.pixels)
        for member in members
        if (best := _best(member, unit, scale, share))
    ]
    values, pixels = np.array(pairs).T
    order = np.argsort(values / pixels)
    values, pixels = values[order], pixels[order]
    middle = float((values / pixels)[np.searchsorted(np.cumsum(pixels), 0.5 * pixels.sum())])
    near = np.abs(values / pixels / middle - 1.0) <= np.maximum(EXACT, 0.5 * ONE_PLACE / pixels)
    # Least squares: every length is wrong by about as many px.
    return float((values * pixels)[near].sum() / (pixels**2)[near].sum())


def _read_dimension(dimension: Dimension, unit: Unit, scale: float | None) -> ReadDimension:
    best = _best(dimension, unit, scale) if scale else None
    candidate = best or next(iter(dimension.candidates), None)
    if scale and best:
        value = dimension.value_mm(unit, scale * best.pixels)
    else:
        value = dimension.said.millimetres(unit)
    return ReadDimension(
        dimension.text,
        value,
        dimension.box,
        _scale(dimension, unit, candidate, scale if best else None) if candidate else None,
        best is not None,
        dimension.said.sign,
        candidate.place if candidate else None,
        _measure(dimension, unit, scale, best) if scale else None,
    )
