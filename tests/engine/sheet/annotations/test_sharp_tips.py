"""Sharp tips of outlines, whose ink is one long before it ends."""

from math import cos, radians, sin
from typing import Any

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.loose import LooseRule, split_loose
from gaussiancad_core.sheet.annotations.sharp_tips import sharp_tips
from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""


def _line(degrees: float, low: float, high: float, at: tuple[float, float]) -> InkedShape:
    """A run between two distances from a point."""
    way = cos(radians(degrees)), sin(radians(degrees))
    return InkedShape(Line(at, way), (InkedRun(Run(low, high), 3.0),))


_LEVEL = _line(0.0, 0.0, 160.0, (40.0, 30.0))


@pytest.mark.parametrize(("degrees", "is_tip"), [(2, False), (8, True), (35, True), (60, False)])
def test_two_lines_that_end_in_each_other_at_a_small_angle_are_a_tip(
    degrees: float, is_tip: bool
) -> None:
    found = sharp_tips([_LEVEL, _line(degrees, 1.0, 160.0, (40.0, 30.0))])
    assert set(found) == ({(0, 0), (1, 0)} if is_tip else set())
    for (tip,) in found.values():
        assert tip.at in (0.0, 1.0)
        # As far as a pen's width and what is beside it are between the lines.
        assert tip.reach == pytest.approx(7.0 / sin(radians(degrees)))


def test_lines_that_end_elsewhere_go_on_or_are_short_make_none() -> None:
    apart = _line(18.0, 12.0, 160.0, (40.0, 30.0))
    opposite = _line(18.0, -160.0, 0.0, (40.0, 30.0))
    short = _line(18.0, 0.0, 30.0, (40.0, 30.0))
    for other in (apart, opposite, short):
        assert sharp_tips([_LEVEL, other]) == {}


@pytest.mark.parametrize("closed", [True, False])
def test_the_tip_of_a_wedge_is_no_extension_line(sketch: Sketch, closed: bool) -> None:
    """Without its third side nothing shuts an area off, and neither line parts two."""
    tip, far = np.array([40.0, 30.0]), 160.0
    low = tip + far * np.array([cos(radians(18.0)), sin(radians(18.0))])
    drawn = sketch(240, 120).line(tuple(tip), (tip[0] + far, tip[1]), 3.0)
    drawn.line(tuple(tip), tuple(low), 3.0)
    if closed:
        drawn.line((tip[0] + far, tip[1]), tuple(low), 3.0)
    ink = clean_sheet(drawn.grey).ink
    shapes = [_LEVEL, _line(18.0, 0.0, far, (40.0, 30.0))]
    _, kinds = split_loose(shapes, [[None], [None]], ink, LooseRule(16.0, everywhere=True, faded=5))
    told = {kind for own in kinds for kind in own}
    assert told == ({None} if closed else {AnnotationKind.EXTENSION})
