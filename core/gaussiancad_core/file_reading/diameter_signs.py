"""Signs of diameters that a file draws: a circle and a bar slanted through its middle (ISO 129-1).

Without pens nothing else tells them from holes: circle and bar enclose two faces.
"""

from collections import defaultdict

import numpy as np

from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes

_LARGEST = 3.0
"""mm of the circle's radius at most: of letters of 7 mm (ISO 3098)."""

_OFF = 0.2
"""Distance of the bar's middle from the circle's at most, in its radius."""

_SHORTEST, _LONGEST = 2.2, 4.5
"""Length of the bar in the circle's radius: it goes out on both sides."""

_SLANTED = 0.2
"""Sine of the angle between the bar and the sheet's axes at least."""


def diameter_signs_apart(labelled: LabelledStrokes) -> LabelledStrokes:
    """The strokes, those of diameter signs told: of a centre mark two lines cross in the middle.

    Args:
        labelled: the strokes, dimension lines told, which go through holes as well.
    """
    numbers = labelled.numbers(Label.OPEN)
    rings = [
        (number, curve)
        for number in numbers
        if isinstance(curve := labelled.strokes[number].curve, CircularArc)
        and curve.is_closed
        and curve.radius <= _LARGEST
    ]
    lines = [
        number
        for number in numbers
        if labelled.strokes[number].is_line
        and labelled.strokes[number].length <= _LONGEST * _LARGEST
    ]
    if not rings or not lines:
        return labelled
    middles = np.array([labelled.strokes[number].points.mean(axis=0) for number in lines])
    of_bars = defaultdict(list)
    for number, curve in rings:
        away = np.hypot(*(middles - np.array(curve.centre)).T)
        near = np.flatnonzero(away <= _OFF * curve.radius).tolist()
        if len(near) == 1:
            bar = labelled.strokes[lines[near[0]]]
            is_out = _SHORTEST < bar.length / curve.radius < _LONGEST
            if is_out and np.abs(bar.way).min() > _SLANTED:
                of_bars[lines[near[0]]].append(number)
    found = [number for bar, held in of_bars.items() if len(held) == 1 for number in (bar, *held)]
    return labelled.with_label(found, Label.TEXT, "diameter sign")
