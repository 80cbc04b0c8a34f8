"""The histogram and the colour scale of a comparison's page: places and colours of an SVG."""

from typing import Any

import numpy as np

from gaussiancad_core.comparison.comparison_report import DeviationFacts
from gaussiancad_core.comparison.deviation import diverging_colours
from gaussiancad_core.comparison.findings import Histogram
from gaussiancad_core.comparison.page_tables import millimetres

_PLOT = (720, 190)
"""Width and height, px."""

_MARGINS = (54, 12, 30)
"""Left, top and bottom of the histogram's axes, px."""

_RIGHT = 10
"""Blank px beyond the last bar."""


def histogram_plot(histogram: Histogram, limit: float) -> dict[str, Any]:
    """Share of the surface over the deviation, in the colours of the scale.

    Args:
        histogram: of the deviation, mm.
        limit: mm at the ends of the scale.
    """
    width, height = _PLOT
    left, top, bottom = _MARGINS
    foot = height - bottom
    span = width - left - _RIGHT
    step = span / len(histogram.shares)
    most = max(*histogram.shares, 1e-9)
    bars = []
    for index, share in enumerate(histogram.shares):
        low, end = histogram.edges_mm[index], histogram.edges_mm[index + 1]
        middle = (low + end) / 2.0
        tall = (foot - top) * share / most
        bars.append(
            {
                "x": f"{left + index * step:.2f}",
                "y": f"{foot - tall:.2f}",
                "width": f"{step:.2f}",
                "height": f"{tall:.2f}",
                "colour": _colour(middle / limit),
                "middle": f"{middle:.9g}",
                "text": f"{low:.4g} to {end:.4g} mm: {100.0 * share:.2f} %",
            }
        )
    first, last = histogram.edges_mm[0], histogram.edges_mm[-1]
    marks = [
        {
            "x": f"{left + span * part / 4.0:.1f}",
            "y": height - 10,
            "anchor": anchor,
            "text": millimetres(first + (last - first) * part / 4.0, first < 0.0),
        }
        for part, anchor in enumerate(("start", "middle", "middle", "middle", "end"))
    ]
    sides = ((top + 10, f"{100.0 * most:.3g} %"), (foot, "0"))
    marks += [{"x": left - 6, "y": y, "anchor": "end", "text": text} for y, text in sides]
    beyond = histogram.below + histogram.above
    return {
        "width": width,
        "height": height,
        "left": left,
        "right": width - _RIGHT,
        "foot": foot,
        "bars": bars,
        "marks": marks,
        "note": f"; {100.0 * beyond:.2g} % lie beyond the scale" if beyond > 0.0 else "",
    }


def colour_scale(deviation: DeviationFacts) -> dict[str, Any]:
    """The colour scale; the viewer rewrites its numbers when the range changes."""
    low = -1.0 if deviation.signed else 0.0
    shares = [1.0 - (1.0 - low) * part / 4.0 for part in range(5)]
    return {
        "colours": [_colour(low + (1.0 - low) * part / 8.0) for part in range(9)],
        "ticks": [
            {
                "share": f"{share:g}",
                "text": millimetres(share * deviation.range_mm, deviation.signed),
            }
            for share in shares
        ],
        "note": "Red lies outside the reference, blue inside."
        if deviation.signed
        else "Red is far.",
    }


def _colour(share: float) -> str:
    """CSS of the colour at a share of the scale, -1 to 1."""
    return "rgb({},{},{})".format(*diverging_colours(np.array([share]))[0])
