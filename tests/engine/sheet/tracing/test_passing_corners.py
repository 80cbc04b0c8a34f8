"""Strokes that are rounded into a line which runs past end in arcs; those that meet it do not."""

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

V, H = Linetype.VISIBLE, Linetype.HIDDEN
FRAME = [(60.3, 50.6), (340.4, 50.6), (340.4, 220.2), (60.3, 220.2), (60.3, 50.6)]
BASE, LEFT, RIGHT = 220.2, 150.4, 240.7
TOP = 50.6


def _rib(radius: float, kind: Linetype, outward: bool = True) -> list[Stroke]:
    """Two lines from top to base of a frame; each is rounded into the base, outward or inward."""
    strokes: list[Stroke] = []
    for x, side in ((LEFT, -1.0), (RIGHT, 1.0)):
        way = side if outward else -side
        strokes.append(Segment((x, TOP), (x, BASE - radius), kind))
        if radius:
            centre = (x + way * radius, BASE - radius)
            start = 0.0 if way < 0.0 else np.pi / 2.0
            strokes.append(Arc(centre, radius, start, np.pi / 2.0, kind))
    return strokes


def _read(strokes: list[Stroke], preset: str, width: float = 2.0) -> list[Stroke]:
    style = replace(PRESETS[preset], width=400, height=280, visible_width=width, skew=0.0)
    frame = [Segment(one, other, V) for one, other in pairwise(FRAME)]
    image = finished(rasterise((*frame, *strokes), style), style, 0)
    sheet = clean_sheet(image.mean(axis=2).astype(np.uint8) if image.ndim == 3 else image)
    view = find_shapes(sheet, (50.0, 40.0, 350.0, 230.0))
    return list(classify_strokes(view, view_rhythm([view], sheet.stroke_width)))


@pytest.mark.parametrize("outward", [True, False])
@pytest.mark.parametrize(("width", "radius"), [(2.0, 8.0), (2.0, 10.4), (3.0, 14.0), (4.0, 18.0)])
@pytest.mark.parametrize("preset", ["clean", "scan"])
def test_strokes_rounded_into_a_line_end_in_arcs(
    preset: str, width: float, radius: float, outward: bool
) -> None:
    found = _read(_rib(radius, V, outward), preset, width)
    arcs = [stroke for stroke in found if isinstance(stroke, Arc)]
    assert [arc.radius for arc in arcs] == [pytest.approx(radius, abs=0.5)] * 2
    assert [arc.sweep for arc in arcs] == [pytest.approx(np.pi / 2.0, abs=0.1)] * 2
    # The base runs past.
    base = [
        stroke
        for stroke in found
        if isinstance(stroke, Segment)
        and abs(stroke.start[1] - BASE) < 0.3 > abs(stroke.end[1] - BASE)
    ]
    assert sum(stroke.length for stroke in base) == pytest.approx(280.1, abs=1.0)
    ribs = [
        stroke
        for stroke in found
        if isinstance(stroke, Segment)
        and LEFT - 1 < stroke.start[0] < RIGHT + 1
        and LEFT - 1 < stroke.end[0] < RIGHT + 1
    ]
    assert [rib.length for rib in ribs] == [pytest.approx(BASE - TOP - radius, abs=1.0)] * 2


@pytest.mark.parametrize("radius", [24.0, 31.0])
def test_hidden_strokes_rounded_into_an_edge_end_in_arcs(radius: float) -> None:
    found = _read(_rib(radius, H), "clean", 3.0)
    arcs = [stroke for stroke in found if isinstance(stroke, Arc)]
    assert [arc.linetype for arc in arcs] == [H, H]
    assert [arc.radius for arc in arcs] == [pytest.approx(radius, abs=0.12 * radius)] * 2
    assert [arc.sweep for arc in arcs] == [pytest.approx(np.pi / 2.0, abs=0.1)] * 2


@pytest.mark.parametrize("kind", [V, H])
@pytest.mark.parametrize("preset", ["clean", "scan"])
def test_strokes_that_meet_a_line_stay_straight(kind: Linetype, preset: str) -> None:
    found = _read(_rib(0.0, kind), preset, 3.0)
    assert not [stroke for stroke in found if isinstance(stroke, Arc)]
    assert sum(stroke.length for stroke in found) == pytest.approx(
        2 * (280.1 + 169.6) + 2 * 169.6, abs=2.0
    )


def test_a_rib_rounded_on_both_sides_has_both_arcs() -> None:
    flared = [
        *_rib(12.0, V),
        *(arc for arc in _rib(12.0, V, outward=False) if isinstance(arc, Arc)),
    ]
    found = _read(flared, "clean")
    arcs = [stroke for stroke in found if isinstance(stroke, Arc)]
    assert [arc.radius for arc in arcs] == [pytest.approx(12.0, abs=0.5)] * 4
