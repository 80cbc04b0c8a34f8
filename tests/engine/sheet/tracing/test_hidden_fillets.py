"""Round corners of hidden lines are arcs, though these are a dash or two; others stay."""

from dataclasses import replace

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
LEFT, UPPER, RIGHT, LOWER = 100.3, 80.6, 300.4, 190.2


def _pocket(radius: float, cut: float = 0.0) -> list[Stroke]:
    """A rectangle of hidden lines with its corners rounded, or cut."""
    at = radius + cut
    (x0, x1), (y0, y1) = (LEFT + at, RIGHT - at), (UPPER + at, LOWER - at)
    sides = [
        Segment((x0, UPPER), (x1, UPPER), H),
        Segment((x0, LOWER), (x1, LOWER), H),
        Segment((LEFT, y0), (LEFT, y1), H),
        Segment((RIGHT, y0), (RIGHT, y1), H),
    ]
    corners = [(x1, y1), (x0, y1), (x0, y0), (x1, y0)]
    if radius:
        turns = [quarter * np.pi / 2.0 for quarter in range(4)]
        arcs = [
            Arc(corner, radius, turn, np.pi / 2.0, H)
            for corner, turn in zip(corners, turns, strict=True)
        ]
        return [*sides, *arcs]
    ends = [(RIGHT, LOWER), (LEFT, LOWER), (LEFT, UPPER), (RIGHT, UPPER)]
    cuts = [
        Segment((outer[0], inner[1]), (inner[0], outer[1]), H)
        for inner, outer in zip(corners, ends, strict=True)
    ]
    return [*sides, *(cuts if cut else [])]


def _read(strokes: list[Stroke], preset: str) -> list[Stroke]:
    """The hidden strokes of a framed drawing."""
    style = replace(PRESETS[preset], width=400, height=280, visible_width=3.0)
    corners = [(60.0, 50.0), (340.0, 50.0), (340.0, 220.0), (60.0, 220.0)]
    frame = [
        Segment(one, other, V)
        for one, other in zip(corners, [*corners[1:], corners[0]], strict=True)
    ]
    image = finished(rasterise((*frame, *strokes), style), style, 0)
    sheet = clean_sheet(image.mean(axis=2).astype(np.uint8) if image.ndim == 3 else image)
    view = find_shapes(sheet, (50.0, 40.0, 350.0, 230.0))
    found = classify_strokes(view, view_rhythm([view], sheet.stroke_width))
    return [stroke for stroke in found if stroke.linetype is H]


@pytest.mark.parametrize("radius", [9.0, 11.0, 13.0, 17.0])
def test_small_hidden_fillets_are_arcs(radius: float) -> None:
    found = _read(_pocket(radius), "clean")
    arcs = [stroke for stroke in found if isinstance(stroke, Arc)]
    assert [arc.radius for arc in arcs] == [pytest.approx(radius, abs=0.12 * radius)] * 4
    assert [arc.sweep for arc in arcs] == [pytest.approx(np.pi / 2.0, abs=0.1)] * 4
    lengths = sorted(stroke.length for stroke in found if isinstance(stroke, Segment))
    width, height = RIGHT - LEFT - 2.0 * radius, LOWER - UPPER - 2.0 * radius
    assert lengths == pytest.approx([height, height, width, width], abs=0.3 * radius)


@pytest.mark.parametrize("preset", ["clean", "scan"])
def test_sharp_hidden_corners_stay_sharp(preset: str) -> None:
    found = _read(_pocket(0.0), preset)
    assert [type(stroke) for stroke in found] == [Segment] * 4
    assert {round(stroke.length / 10.0) for stroke in found} == {20, 11}


@pytest.mark.parametrize("cut", [9.0, 13.0])
def test_cut_hidden_corners_are_no_arcs(cut: float) -> None:
    assert not [stroke for stroke in _read(_pocket(0.0, cut), "clean") if isinstance(stroke, Arc)]


@pytest.mark.parametrize("radius", [15.0, 17.0, 22.0])
@pytest.mark.parametrize("rounded", [True, False])
def test_a_hidden_line_comes_to_the_outline_by_an_arc_or_a_chamfer(
    rounded: bool, radius: float
) -> None:
    wall = 60.0
    corner = (
        Arc((wall + radius, 120.0 + radius), radius, np.pi, np.pi / 2.0, H)
        if rounded
        else Segment((wall, 120.0 + radius), (wall + radius, 120.0), H)
    )
    level = Segment((300.0, 120.0), (wall + radius, 120.0), H)
    lines = [Segment((300.0, 120.0), (300.0, 150.0), H), *_pocket(0.0)[:2]]
    found = _read([level, corner, *lines], "clean")
    arcs = [stroke for stroke in found if isinstance(stroke, Arc)]
    assert [arc.radius for arc in arcs] == [pytest.approx(radius, abs=0.5)] * rounded
