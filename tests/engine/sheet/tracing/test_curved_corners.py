"""Round corners between a line and an arc are arcs that touch both; sharp and cut ones stay."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from gaussiancad_core.drawing.degrade import finished
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

V = Linetype.VISIBLE
CENTRE = np.array([200.3, 120.6])
BELOW = 190.0


def _arc(centre: np.ndarray, radius: float, start: np.ndarray, end: np.ndarray, long: bool) -> Arc:
    """The shorter or longer arc between two places."""
    first, last = (float(np.arctan2(*(place - centre)[::-1])) for place in (start, end))
    sweep = (last - first) % (2.0 * np.pi)
    if (sweep > np.pi) is not long:
        first, sweep = last, 2.0 * np.pi - sweep
    return Arc((float(centre[0]), float(centre[1])), radius, first, sweep, V)


def _cap(around: float, radius: float, cut: float = 0.0) -> list[Stroke]:
    """A disc whose lower part a line cuts off, its corners rounded or cut."""
    height = 20.0
    middle = np.array([np.sqrt((around - radius) ** 2 - (height - radius) ** 2), height - radius])
    on_line, on_arc = np.array([middle[0], height]), middle * around / (around - radius)
    if cut:
        corner = np.array([np.sqrt(around**2 - height**2), height])
        on_line = corner - np.array([cut, 0.0])
        angle = np.arctan2(corner[1], corner[0]) - cut / around
        on_arc = around * np.array([np.cos(angle), np.sin(angle)])
    flip = np.array([-1.0, 1.0])
    strokes: list[Stroke] = [
        Segment(tuple(CENTRE + on_line * flip), tuple(CENTRE + on_line), V),
        _arc(CENTRE, around, CENTRE + on_arc, CENTRE + on_arc * flip, True),
    ]
    for side in (np.ones(2), flip):
        ends = CENTRE + on_line * side, CENTRE + on_arc * side
        if cut:
            strokes.append(Segment(tuple(ends[0]), tuple(ends[1]), V))
        elif radius:
            strokes.append(_arc(CENTRE + middle * side, radius, *ends, False))
    return strokes


def _knob(around: float, radius: float) -> list[Stroke]:
    """The upper side of a plate with half a disc on it, its feet rounded."""
    middle = np.array([np.sqrt((around + radius) ** 2 - radius**2), -radius])
    on_line, on_arc = np.array([middle[0], 0.0]), middle * around / (around + radius)
    flip = np.array([-1.0, 1.0])
    far = np.array([120.0, 0.0])
    strokes: list[Stroke] = [_arc(CENTRE, around, CENTRE + on_arc * flip, CENTRE + on_arc, False)]
    for side in (np.ones(2), flip):
        strokes.append(Segment(tuple(CENTRE + on_line * side), tuple(CENTRE + far * side), V))
        if radius:
            feet = CENTRE + on_line * side, CENTRE + on_arc * side
            strokes.append(_arc(CENTRE + middle * side, radius, *feet, False))
    left, right = CENTRE - far, CENTRE + far
    down = np.array([0.0, BELOW - CENTRE[1]])
    outline = [left, left + down, right + down, right]
    return [*strokes, *(Segment(tuple(a), tuple(b), V) for a, b in pairwise(outline))]


def _read(strokes: list[Stroke], preset: str, width: float = 2.0) -> list[Stroke]:
    style = replace(PRESETS[preset], width=400, height=280, visible_width=width, skew=0.0)
    image = finished(rasterise(tuple(strokes), style), style, 0)
    sheet = clean_sheet(image.mean(axis=2).astype(np.uint8) if image.ndim == 3 else image)
    points = np.concatenate([stroke.sample(1.0) for stroke in strokes])
    box = (*(points.min(0) - 10.0), *(points.max(0) + 10.0))
    view = find_shapes(sheet, box)
    return list(classify_strokes(view, view_rhythm([view], sheet.stroke_width)))


def _radii(found: list[Stroke]) -> list[float]:
    return sorted(stroke.radius for stroke in found if isinstance(stroke, Arc))


@pytest.mark.parametrize("preset", ["clean", "scan"])
@pytest.mark.parametrize("radius", [8.0, 10.4, 12.0])
def test_corners_of_a_disc_that_a_line_cuts_are_rounded(radius: float, preset: str) -> None:
    found = _read(_cap(80.0, radius), preset)
    assert _radii(found) == pytest.approx([radius, radius, 80.0], abs=0.7)
    assert len(found) == 4


@pytest.mark.parametrize(("around", "radius"), [(13.1, 6.6), (30.0, 8.0), (60.0, 10.0)])
def test_feet_of_a_round_knob_are_rounded(around: float, radius: float) -> None:
    found = _read(_knob(around, radius), "clean")
    assert _radii(found) == pytest.approx([radius, radius, around], abs=0.7)


@pytest.mark.parametrize("preset", ["clean", "scan"])
def test_sharp_corners_beside_arcs_stay_sharp(preset: str) -> None:
    assert _radii(_read(_cap(80.0, 0.0), preset)) == pytest.approx([80.0], abs=0.3)
    assert _radii(_read(_knob(30.0, 0.0), preset)) == pytest.approx([30.0], abs=0.3)


@pytest.mark.parametrize("cut", [10.0, 14.0])
def test_cut_corners_beside_arcs_are_no_arcs(cut: float) -> None:
    found = _read(_cap(80.0, 0.0, cut), "clean")
    assert _radii(found) == pytest.approx([80.0], abs=0.3)
    assert len(found) == 4
