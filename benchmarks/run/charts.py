"""Small line charts as PNG, for figures that the documentation shows beside their table."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.draw_command import write_image

_SIZE = (460, 760)
_FRAME = (70, 56, 560, 400)
"""Left, top, right and bottom of the plot in px."""

_COLOURS = ((31, 119, 180), (214, 39, 40), (44, 160, 44), (255, 127, 14), (148, 103, 189))
_FONT = cv2.FONT_HERSHEY_SIMPLEX
_GREY = (150, 150, 150)
_TICKS = 5
_STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)
"""Round steps between ticks, times a power of ten."""

_DODGE = 5
"""px by which the dots of each line stand beside those of the line before: equal ones show."""


@dataclass(frozen=True)
class Series:
    """One line of a chart; not finite values are left out.

    Attributes:
        name: beside the chart.
        values: one a place.
        hollow: places whose dot is a ring, as of values that stand for less than others.
    """

    name: str
    values: Sequence[float]
    hollow: Sequence[bool] = ()


@dataclass(frozen=True)
class Chart:
    """What a chart shows.

    Attributes:
        title: above it.
        ticks: labels of the places along the horizontal axis.
        series: one value a place each.
        logarithmic: whether the vertical axis is.
    """

    title: str
    ticks: Sequence[str]
    series: Sequence[Series]
    logarithmic: bool = False


def write_chart(chart: Chart, path: Path) -> None:
    """Draw a chart."""
    image = np.full((*_SIZE, 3), 255, np.uint8)
    low, high, ticks = _range(chart)
    left, top, right, bottom = _FRAME
    cv2.rectangle(image, (left, top), (right, bottom), _GREY)
    _write(image, chart.title, (left, top - 24), 0.55)
    for level in np.linspace(low, high, ticks).tolist():
        y = round(bottom - (bottom - top) * (level - low) / (high - low))
        cv2.line(image, (left, y), (right, y), (225, 225, 225))
        shown = 10.0**level if chart.logarithmic else level
        _write(image, f"{shown:.3g}", (8, y + 4))
    places = np.linspace(left + 30, right - 30, len(chart.ticks)).round().astype(int)
    for place, label in zip(places, chart.ticks, strict=True):
        for row, word in enumerate(label.split("\n")):
            _write(image, word, (int(place) - 4 * len(word), bottom + 18 + 16 * row))
    for number, series in enumerate(chart.series):
        colour = _COLOURS[number % len(_COLOURS)]
        levels = _levels(series.values, chart.logarithmic)
        heights = bottom - (bottom - top) * (levels - low) / (high - low)
        shown = np.isfinite(heights)
        neighbour = places + round(_DODGE * (number - (len(chart.series) - 1) / 2.0))
        points = np.stack([neighbour[shown], heights[shown].round()], axis=1).astype(np.int32)
        cv2.polylines(image, [points], False, colour, 2, cv2.LINE_AA)
        rings = np.array(series.hollow or [False] * len(places))[shown]
        for (x, y), ring in zip(points.tolist(), rings.tolist(), strict=True):
            cv2.circle(image, (x, y), 4, colour, cv2.FILLED, cv2.LINE_AA)
            if ring:
                cv2.circle(image, (x, y), 2, (255, 255, 255), cv2.FILLED, cv2.LINE_AA)
        _write(image, series.name, (right + 14, top + 14 + 22 * number), colour=colour)
    write_image(image, path)


def _levels(values: Sequence[float], logarithmic: bool) -> npt.NDArray[np.float64]:
    found = np.array(values, dtype=float)
    return np.log10(found) if logarithmic else found


def _range(chart: Chart) -> tuple[float, float, int]:
    """Lowest and highest level, and how many ticks there are."""
    found = np.concatenate([_levels(item.values, chart.logarithmic) for item in chart.series])
    found = found[np.isfinite(found)]
    if chart.logarithmic:
        low, high = float(np.floor(found.min())), float(np.ceil(found.max() + 1e-9))
        return low, high, round(high - low) + 1
    top, ticks = round_scale(float(found.max()))
    return 0.0, top, ticks


def round_scale(greatest: float) -> tuple[float, int]:
    """A round number not below another, and how many round ticks there are from zero to it."""
    # Where all is zero the lines lie on the axis.
    rough = (greatest or 1.0) / _TICKS
    power = 10.0 ** np.floor(np.log10(rough))
    step = next(each * power for each in _STEPS if each * power >= rough * (1.0 - 1e-9))
    count = int(np.ceil((greatest or 1.0) / step - 1e-9))
    return float(count * step), count + 1


def _write(
    image: npt.NDArray[np.uint8],
    text: str,
    place: tuple[int, int],
    size: float = 0.42,
    colour: tuple[int, int, int] = (0, 0, 0),
) -> None:
    cv2.putText(image, text, place, _FONT, size, colour, 1, cv2.LINE_AA)
