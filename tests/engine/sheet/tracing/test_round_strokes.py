"""Circles, arcs, slots and ellipses, visible and dashed, and what touches them."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment

Sketch = Any
"""The class that the fixture gives."""

V, H = Linetype.VISIBLE, Linetype.HIDDEN
FULL, HALF = 2.0 * np.pi, np.pi


def _plate(sketch: Sketch) -> Any:  # noqa: ANN401
    """An outline with two hidden lines, so that dashes are known."""
    drawn = sketch(420, 320).box(20, 20, 400, 300)
    return drawn.inked(*(Segment((20.5, y), (400.5, y), H) for y in (32.0, 288.0)))


@pytest.mark.parametrize(
    ("kind", "radius", "width"),
    [(V, 6.0, 2.0), (V, 9.0, 3.0), (V, 40.0, 3.0), (V, 110.0, 1.0), (H, 6.0, 2.0), (H, 9.0, 2.0),
     (H, 15.0, 1.4), (H, 40.0, 2.0), (H, 110.0, 2.0)],
)  # fmt: skip
def test_circles(sketch: Sketch, kind: Linetype, radius: float, width: float) -> None:
    circle = Arc((210.3, 160.2), radius, 0.0, FULL, kind)
    assert _plate(sketch).inked(circle, width=width, hidden=width).misread() == []


def test_circles_around_one_centre(sketch: Sketch) -> None:
    drawn = sketch(240, 220).box(20, 20, 220, 200)
    for radius in (8.0, 14.0, 30.0, 44.0, 50.0, 70.0):
        drawn.arc((120.3, 110.6), radius, 2.0)
    assert drawn.misread(0.3) == []


@pytest.mark.parametrize("radius", [122.6, 150.9])
def test_dashes_of_a_large_circle_are_no_chords(sketch: Sketch, radius: float) -> None:
    middle = radius + 35.0
    circle = Arc((middle, middle), radius, 0.0, FULL, H)
    drawn = sketch(int(2 * middle), int(2 * middle)).box(15, 15, 2 * middle - 16, 2 * middle - 16)
    assert drawn.inked(circle, hidden=3.0, dash=(17.25, 9.75)).misread(0.5) == []


@pytest.mark.parametrize(
    ("kind", "radius", "sweep"),
    [(V, 40.0, 60.0), (V, 70.0, 40.0), (V, 40.0, 270.0), (H, 15.0, 90.0), (H, 30.0, 180.0),
     (H, 70.0, 90.0), (H, 70.0, 270.0)],
)  # fmt: skip
def test_arcs(sketch: Sketch, kind: Linetype, radius: float, sweep: float) -> None:
    arc = Arc((210.3, 160.2), radius, 0.4, np.radians(sweep), kind)
    assert _plate(sketch).inked(arc, width=2.0).misread(2.0) == []


def test_holes_that_overlap_end_where_they_cross(sketch: Sketch) -> None:
    turn = float(np.arccos(20.0 / 30.0))
    drawn = sketch().box(20, 20, 180, 140).arc((80, 80), 30.0, start=turn, sweep=FULL - 2 * turn)
    assert drawn.arc((120, 80), 30.0, start=turn - HALF, sweep=FULL - 2 * turn).misread() == []


def test_two_arcs_of_an_s_end_where_they_touch(sketch: Sketch) -> None:
    drawn = sketch(300, 200).box(20, 20, 280, 180)
    drawn.arc((100, 100), 40.0, start=0.0, sweep=0.5 * HALF).arc(
        (200, 100), 60.0, start=HALF, sweep=1.2
    )
    assert drawn.misread(1.5) == []


@pytest.mark.parametrize(
    ("radius", "side", "off"),
    [(12.8, 0.8, 0.1), (12.8, 1.5, 0.6), (15.7, 1.0, 0.6), (31.9, 0.8, 0.6), (31.9, 1.5, 0.1)],
)
def test_slots(sketch: Sketch, radius: float, side: float, off: float) -> None:
    length, x, y = side * radius + 4.0, 100.0 + off, 80.0 + off
    drawn = sketch(260, 180).box(12, 12, 248, 168, 2.0)
    drawn.arc((x, y), radius, 2.0, HALF / 2.0, HALF)
    drawn.arc((x + length, y), radius, 2.0, -HALF / 2.0, HALF)
    for level in (y - radius, y + radius):
        drawn.line((x, level), (x + length, level), 2.0)
    assert drawn.misread(1.0) == []


@pytest.mark.parametrize("height", [40.0, 47.0])
def test_the_dashed_end_of_a_slot_behind_a_groove(sketch: Sketch, height: float) -> None:
    end = 100.0 + height / 2.0
    drawn = sketch(300, 200).box(20, 20, 280, 180)
    drawn.line((20, end - 7.0), (280, end - 7.0)).line((20, end), (280, end))
    for x in (133.0, 167.0):
        drawn.ink((x, end - 40.0), (x, end - 26.0), width=2.0)
        drawn.ink((x, end - 12.0), (x, end), width=2.0)
    for first in (0.0, 1.2, 2.4):
        drawn.arc((150.0, end), 17.0, 2.0, first, 0.74)
    arcs = [stroke for stroke in drawn.strokes() if isinstance(stroke, Arc)]
    assert [arc.radius for arc in arcs] == [pytest.approx(17.0, abs=0.4)]
    assert arcs[0].linetype is H
    assert arcs[0].sweep == pytest.approx(HALF, abs=0.3)


def test_an_edge_that_touches_the_dashed_end_of_a_slot_closes_no_circle(sketch: Sketch) -> None:
    """Between it and the sides are gaps as long as those of dashes, but no dash."""
    radius, (x, y) = 22.0, (120.3, 100.6)
    drawn = sketch(240, 200).box(20, 20, 220, 180, 2.7).broken((20, 160), (218, 160), (11, 6), 2.3)
    drawn.line((20, y - radius), (220, y - radius), 2.7)
    for k in range(4):
        drawn.arc((x, y), radius, 2.3, k * (HALF - 0.5) / 3.0, 0.5)
    for side in (-radius, radius):
        drawn.broken((x + side, y), (x + side, 20.0), (11.0, 6.0), 2.3)
    (arc,) = (stroke for stroke in drawn.strokes() if isinstance(stroke, Arc))
    assert (arc.radius, arc.sweep) == pytest.approx((radius, HALF), abs=0.2)


@pytest.mark.parametrize("shift", [0.0, 0.45])
def test_a_line_between_arcs_to_both_sides_is_not_turned(sketch: Sketch, shift: float) -> None:
    x, top, bottom = 120.0 + shift, 110.0, 250.0
    drawn = sketch(240, 480).line((x, top), (x, bottom), width=2.0)
    drawn.arc((x - 90.0, top), 90.0, width=2.0, start=-0.5 * HALF, sweep=0.5 * HALF)
    drawn.arc((x + 1250.0, bottom), 1250.0, width=2.0, start=HALF - 0.16, sweep=0.16)
    [line] = [stroke for stroke in drawn.strokes() if isinstance(stroke, Segment)]
    assert [line.start[0], line.end[0]] == pytest.approx([x + 0.5] * 2, abs=0.05)


@pytest.mark.parametrize("radius", [34.0, 160.0])
def test_a_short_line_between_a_corner_and_an_arc_that_it_touches(
    sketch: Sketch, radius: float
) -> None:
    drawn = sketch(280, 260).line((30, 40), (30, 230), 2.0).line((30, 230), (65, 230), 2.0)
    drawn.arc((65, 230 - radius), radius, 2.0, 0.0, HALF / 2.0)
    drawn.lines((30, 40), (65 + radius, 40), (65 + radius, 230 - radius), width=2.0)
    assert drawn.misread(1.5) == []


@pytest.mark.parametrize("beyond", [30.0, 60.0])
def test_a_dashed_line_that_runs_into_tangents_is_no_arc(sketch: Sketch, beyond: float) -> None:
    """At both ends round edges bend away to the same side."""
    drawn = sketch(360, 160).broken((104, 120), (278, 120), (12, 6), 2.0)
    drawn.arc((104.0 - beyond, -10.0), 130.0, 2.0, 0.5 * HALF - 0.4, 0.3)
    drawn.arc((288.0, -10.0), 130.0, 3.0, 0.5 * HALF - 0.25, 0.55)
    found = drawn.strokes()
    assert [s.linetype for s in found if isinstance(s, Segment) and s.length > 100.0] == [H]
    radii = [stroke.radius for stroke in found if isinstance(stroke, Arc)]
    assert radii == pytest.approx([130.0] * len(radii), abs=2.0)


@pytest.mark.parametrize("length", [9.0, 14.0])
def test_where_a_circle_touches_a_line_there_is_no_piece_of_it(
    sketch: Sketch, length: float
) -> None:
    drawn = sketch().box(20, 20, 180, 140).arc((100.0, 40.0 + length), 19.0, 2.0)
    assert drawn.line((20, 21.0 + length), (180, 21.0 + length)).misread(0.6) == []


ELLIPSES = [
    (V, 60.0, 0.5, 0.3, 3.0),
    (V, 95.0, 0.8, 2.1, 2.0),
    (V, 32.0, 0.5, 1.0, 3.0),
    (V, 90.0, 0.35, 0.0, 4.0),
    (H, 70.0, 0.5, 2.0, 2.0),
    (H, 90.0, 0.8, 0.7, 2.0),
]


@pytest.mark.parametrize(("kind", "major", "ratio", "rotation", "width"), ELLIPSES)
def test_ellipses(  # noqa: PLR0917
    sketch: Sketch, kind: Linetype, major: float, ratio: float, rotation: float, width: float
) -> None:
    ellipse = Ellipse((206.4, 158.7), major, max(ratio * major, 15.0), rotation, 0.0, FULL, kind)
    assert _plate(sketch).inked(ellipse, width=width).misread() == []


@pytest.mark.parametrize("rotation", [0.0, 0.4, 1.2])
def test_an_ellipse_half_visible_and_half_hidden(sketch: Sketch, rotation: float) -> None:
    """The end of a cylinder that leans: its lines touch the ellipse where visible ends."""
    half = Ellipse((210.0, 160.0), 70.0, 30.0, rotation, 0.0, HALF, V)
    other = Ellipse((210.0, 160.0), 70.0, 30.0, rotation, HALF, HALF, H)
    way = half.carrier.tangents(np.array([0.0]))[0] * -75.0
    ends = half.carrier.at(np.array([0.0, HALF]))
    lines = [Segment(tuple(end), tuple(end + way), V) for end in ends]
    assert _plate(sketch).inked(half, other, *lines).misread(2.0) == []


def test_a_circle_stays_one_beside_an_ellipse(sketch: Sketch) -> None:
    circle = Arc((140.0, 160.0), 60.0, 0.0, FULL, V)
    ellipse = Ellipse((300.0, 160.0), 60.0, 45.0, 1.0, 0.0, FULL, V)
    assert _plate(sketch).inked(circle, ellipse).misread() == []


def test_solid_and_dashed_lines_and_a_circle_across_each_other(sketch: Sketch) -> None:
    drawn = (
        sketch(240, 180).box(20, 20, 220, 160).line((20, 40), (220, 110)).line((120, 20), (80, 160))
    )
    assert drawn.broken((20, 90), (212, 90), (12, 6), 3.0).arc((130, 85), 40.0).misread(8.1) == []


def test_a_free_curve_is_traced(sketch: Sketch) -> None:
    at = np.linspace(0.0, 1.0, 200)
    curve = np.stack([50.0 + 120.0 * at, 90.0 + 6.0 * np.sin(8.0 * FULL * at)], axis=1)
    drawn = sketch(240, 180).box(20, 20, 220, 160).ink(*map(tuple, curve.tolist()), width=2.5)
    found = [stroke.sample(0.5) - 0.5 for stroke in drawn.strokes() if stroke.length < 110.0]
    points = np.concatenate(found)
    away = np.hypot(*(points[:, None] - curve[None]).transpose(2, 0, 1))
    assert away.min(0).max() < 3.0
    assert away.min(1).max() < 3.0
