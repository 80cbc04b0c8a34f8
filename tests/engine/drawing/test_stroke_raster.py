from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.drawing.sheet_style import Cap, SheetStyle
from gaussiancad_core.drawing.stroke_raster import dashed, rasterise
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.views import Arc, Linetype, Segment

STYLE = SheetStyle(width=160, height=120, cap=Cap.BUTT)
VISIBLE, HIDDEN = Linetype.VISIBLE, Linetype.HIDDEN
CENTRES_X, CENTRES_Y = np.meshgrid(np.arange(160) + 0.5, np.arange(120) + 0.5)


@given(st.floats(20.0, 140.0), st.floats(1.0, 6.0))
def test_a_line_along_an_axis_lies_where_it_is_and_is_as_wide_as_asked(
    x: float, width: float
) -> None:
    style = replace(STYLE, visible_width=width)
    ink = rasterise((Segment((x, 10.0), (x, 110.0), VISIBLE),), style)
    row = ink[60].astype(np.float64)
    assert row.sum() == pytest.approx(width, abs=1e-4)
    assert (row @ (np.arange(160) + 0.5)) / row.sum() == pytest.approx(x, abs=1e-3)
    # The ends, too, are cut off where they are.
    assert ink.sum() == pytest.approx(width * 100.0, rel=1e-4)


@settings(max_examples=40)
@given(st.floats(-1.5, 1.5), st.floats(-0.5, 0.5), st.floats(1.5, 5.0))
def test_a_slanted_line_lies_where_it_is(angle: float, shift: float, width: float) -> None:
    centre = np.array([80.0 + shift, 60.0 - shift])
    way = np.array([np.cos(angle), np.sin(angle)])
    ends = centre - 45.0 * way, centre + 45.0 * way
    ink = rasterise(
        (Segment(tuple(ends[0]), tuple(ends[1]), VISIBLE),), replace(STYLE, visible_width=width)
    )
    along = (CENTRES_X - centre[0]) * way[0] + (CENTRES_Y - centre[1]) * way[1]
    across = (CENTRES_Y - centre[1]) * way[0] - (CENTRES_X - centre[0]) * way[1]
    middle = np.abs(along) < 35.0
    mass = ink[middle].sum()
    assert (ink * across)[middle].sum() / mass == pytest.approx(0.0, abs=0.05)
    assert mass / 70.0 == pytest.approx(width, rel=0.03)


@settings(max_examples=30)
@given(st.floats(8.0, 45.0), st.floats(-0.5, 0.5))
def test_a_circle_has_its_radius_and_its_centre(radius: float, shift: float) -> None:
    centre = (80.0 + shift, 60.0 + shift / 3.0)
    ink = rasterise((Arc(centre, radius, 1.0, 2.0 * np.pi, VISIBLE),), STYLE).astype(np.float64)
    mass = ink.sum()
    assert (ink * CENTRES_X).sum() / mass == pytest.approx(centre[0], abs=0.02)
    assert (ink * CENTRES_Y).sum() / mass == pytest.approx(centre[1], abs=0.02)
    away = np.hypot(CENTRES_X - centre[0], CENTRES_Y - centre[1])
    # Each pixel stands for the same length of the circle only after division by its radius.
    weight = ink / np.maximum(away, 1.0)
    assert (weight * away).sum() / weight.sum() == pytest.approx(radius, abs=0.05)


def test_an_arc_ends_where_it_ends() -> None:
    arc = Arc((80.0, 60.0), 40.0, 0.0, np.pi / 2.0, VISIBLE)
    ink = rasterise((arc,), STYLE)
    assert ink[:59].sum() == 0.0
    assert ink[:, :79].sum() == 0.0
    assert ink.sum() == pytest.approx(3.0 * 40.0 * np.pi / 2.0, rel=0.01)
    assert ink[99:101, 81].min() > 0.85


def test_crossings_are_no_darker_than_lines_and_repeats_change_nothing() -> None:
    lines = (
        Segment((10.0, 60.3), (150.0, 60.3), VISIBLE),
        Segment((80.0, 10.0), (80.0, 110.0), VISIBLE),
    )
    ink = rasterise(lines, STYLE)
    assert ink.max() == 1.0
    np.testing.assert_array_equal(ink, rasterise(lines * 2, STYLE))


def test_round_ends_reach_half_a_width_further_and_fill_corners() -> None:
    corner = (
        Segment((40.0, 40.0), (80.0, 40.0), VISIBLE),
        Segment((40.0, 40.0), (40.0, 80.0), VISIBLE),
    )
    round_ink = rasterise(corner, replace(STYLE, cap=Cap.ROUND, visible_width=6.0))
    butt_ink = rasterise(corner, replace(STYLE, visible_width=6.0))
    assert round_ink[38, 38] > 0.9
    assert butt_ink[38, 38] == 0.0
    assert round_ink[40, 80:82].min() > 0.9
    assert butt_ink[40, 81] == 0.0


def test_a_chain_looks_like_the_curve_it_follows() -> None:
    angles = np.linspace(0.0, 2.0 * np.pi, 241)
    points = np.stack([80.0 + 40.0 * np.cos(angles), 60.0 + 40.0 * np.sin(angles)], axis=1)
    chain = Polyline((*map(tuple, points[:-1]), tuple(points[0])), VISIBLE)
    circle = Arc((80.0, 60.0), 40.0, 0.0, 2.0 * np.pi, VISIBLE)
    apart = np.abs(rasterise((chain,), STYLE) - rasterise((circle,), STYLE))
    assert apart.max() < 0.05


def test_hidden_strokes_are_dashed_and_their_end_dashes_overlap_corners() -> None:
    stroke = Segment((20.0, 60.0), (140.0, 60.0), HIDDEN)
    row = rasterise((stroke,), STYLE)[60]
    assert row[20:30].min() > 0.85
    assert row[129:140].min() > 0.85
    runs = np.flatnonzero(np.diff((row > 0.5).astype(int)))
    assert len(runs) == 2 * 7
    columns = rasterise((stroke,), STYLE).sum(axis=0)
    assert columns[20:30].max() == pytest.approx(STYLE.hidden_width, abs=1e-4)


@pytest.mark.parametrize(
    "stroke",
    [
        Segment((10.0, 10.0), (100.0, 90.0), HIDDEN),
        Arc((80.0, 60.0), 40.0, 1.0, 2.5, HIDDEN),
        Arc((80.0, 60.0), 40.0, 0.0, 2.0 * np.pi, HIDDEN),
        Polyline(((10.0, 10.0), (60.0, 30.0), (70.0, 90.0)), HIDDEN),
    ],
)
def test_dashes_lie_on_their_stroke(stroke: Segment | Arc | Polyline) -> None:
    pieces = dashed(stroke, STYLE)
    dense = stroke.sample(0.01)
    assert len(pieces) > 2
    for piece in pieces[1:-1]:
        for point in piece.sample(2.0):
            assert np.hypot(*(dense - point).T).min() < 0.02
    whole = sum(piece.length for piece in pieces)
    assert whole / stroke.length == pytest.approx(12.0 / 18.0, abs=0.08)


def test_without_antialiasing_pixels_are_ink_or_paper() -> None:
    circle = Arc((80.2, 60.4), 33.3, 0.0, 2.0 * np.pi, VISIBLE)
    ink = rasterise((circle,), replace(STYLE, antialiasing=False))
    assert set(np.unique(ink)) == {0.0, 1.0}


def test_strokes_beside_the_sheet_leave_it_blank() -> None:
    strokes = (
        Segment((-50.0, -20.0), (-10.0, -5.0), VISIBLE),
        Arc((300.0, 60.0), 20.0, 0.0, 2.0 * np.pi, HIDDEN),
    )
    assert rasterise(strokes, STYLE).sum() == 0.0
