"""Ellipses that are drawn are found, visible or dashed; nothing else is one."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.ridges import ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import GrowthRules, grow_all
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

FULL = 2.0 * np.pi
VISIBLE, HIDDEN = Linetype.VISIBLE, Linetype.HIDDEN


def _read(*strokes: Stroke, width: float = 3.0) -> tuple[Stroke, ...]:
    """The strokes of a sheet with a frame of known lines around them, so that dashes are known."""
    style = SheetStyle(width=420, height=320, visible_width=width, hidden_width=0.7 * width)
    corners = [(20.0, 20.0), (400.0, 20.0), (400.0, 300.0), (20.0, 300.0)]
    frame = [
        Segment(a, b, VISIBLE) for a, b in zip(corners, corners[1:] + corners[:1], strict=True)
    ]
    frame += [Segment((20.0, y), (400.0, y), HIDDEN) for y in (32.0, 288.0)]
    ink = rasterise((*frame, *strokes), style)
    sheet = clean_sheet(np.clip(np.rint(255 * (1 - ink)), 0, 255).astype(np.uint8))
    view = find_shapes(sheet, (15.0, 15.0, 405.0, 305.0))
    found = classify_strokes(view, view_rhythm([view], sheet.stroke_width))
    inside = [s for s in found if np.ptp(s.sample(1.0), axis=0).max() < 370.0]
    assert len(found) - len(inside) == 4
    return tuple(s for s in inside if not (isinstance(s, Segment) and s.length > 270.0))


def _away(one: Ellipse, other: Ellipse) -> float:
    """The largest distance in px of a stroke's points from another's ellipse."""
    return float(other.carrier.distances(one.sample(1.0)).max())


@settings(max_examples=12, deadline=None)
@given(
    st.floats(190.0, 230.0),
    st.floats(140.0, 180.0),
    st.floats(30.0, 95.0),
    st.floats(0.35, 0.85),
    st.floats(0.0, np.pi),
    st.sampled_from([2.0, 3.0, 4.0]),
    st.sampled_from([VISIBLE, HIDDEN]),
)
def test_an_ellipse_is_read_as_itself(  # noqa: PLR0917
    x: float, y: float, major: float, ratio: float, rotation: float, width: float, kind: Linetype
) -> None:
    minor = max(ratio * major, 15.0)
    drawn = Ellipse((x, y), major, minor, rotation, 0.0, FULL, kind)
    (found,) = _read(drawn, width=width)
    assert isinstance(found, Ellipse)
    assert found.linetype is kind
    assert found.sweep == pytest.approx(FULL)
    assert _away(found, drawn) < (0.1 if kind is VISIBLE else 0.35)


@pytest.mark.parametrize("rotation", [0.0, 0.4, 1.2, 2.0])
def test_half_visible_and_half_hidden(rotation: float) -> None:
    """The end of a cylinder that leans: its lines touch the ellipse where visible ends."""
    half = Ellipse((210.0, 160.0), 70.0, 30.0, rotation, 0.0, np.pi, VISIBLE)
    other = Ellipse((210.0, 160.0), 70.0, 30.0, rotation, np.pi, np.pi, HIDDEN)
    ends = half.carrier.at(np.array([0.0, np.pi]))
    way = half.carrier.tangents(np.array([0.0]))[0] * -75.0
    lines = [Segment(tuple(end), tuple(end + way), VISIBLE) for end in ends]
    strokes = _read(half, other, *lines)
    curves = {s.linetype: s for s in strokes if isinstance(s, Ellipse)}
    assert len(strokes) == 4 and set(curves) == {VISIBLE, HIDDEN}
    for kind, drawn in ((VISIBLE, half), (HIDDEN, other)):
        assert _away(curves[kind], drawn) < 0.3
        found, true = curves[kind].sample(1e9)[[0, -1]], drawn.sample(1e9)[[0, -1]]
        assert np.abs(found - true).max() < 1.5


def test_circles_lines_and_fillets_are_no_ellipses(sketch: Sketch) -> None:
    drawn = sketch(300, 260).arc((60, 60), 40.0).arc((60, 60), 25.0, 3.0, 0.5, 2.0)
    drawn.line((150, 40), (260, 40)).line((150, 100), (260, 100))
    drawn.arc((150, 70), 30, 3.0, np.pi / 2, np.pi).arc((260, 70), 30, 3.0, -np.pi / 2, np.pi)
    for k, radius in enumerate((8.0, 14.0, 20.0, 30.0)):
        x, y = 30.0 + 65.0 * k, 140.0
        drawn.line((x, y + radius), (x, y + radius + 25)).line((x + radius, y), (x + 55, y))
        drawn.arc((x + radius, y + radius), radius, 3.0, np.pi, np.pi / 2)
        drawn.line((x, y + radius + 25), (x + 12, y + 100))
    grown = grow_all(ridge_points(drawn.weight, 3.0), GrowthRules.of_width(3.0))
    assert [g for g in grown if isinstance(g.geometry, WholeEllipse)] == []


def test_a_circle_stays_one_beside_an_ellipse() -> None:
    circle = Arc((140.0, 160.0), 60.0, 0.0, FULL, VISIBLE)
    ellipse = Ellipse((300.0, 160.0), 60.0, 45.0, 1.0, 0.0, FULL, VISIBLE)
    found = _read(circle, ellipse)
    assert sorted(type(s).__name__ for s in found) == ["Arc", "Ellipse"]


@pytest.mark.parametrize("width", [2.0, 3.0])
@pytest.mark.parametrize("radius", [6.0, 9.0, 15.0, 40.0])
@pytest.mark.parametrize("kind", [VISIBLE, HIDDEN])
def test_circles_down_to_six_px(radius: float, kind: Linetype, width: float) -> None:
    """A dashed circle of 6 px has two dashes."""
    (found,) = _read(Arc((210.3, 160.2), radius, 0.0, FULL, kind), width=width)
    assert isinstance(found, Arc) and found.linetype is kind
    assert found.sweep == pytest.approx(FULL)
    assert found.radius == pytest.approx(radius, abs=0.3)
    assert found.centre == pytest.approx((210.3, 160.2), abs=0.3)


@pytest.mark.parametrize("sweep", [90.0, 180.0, 270.0])
@pytest.mark.parametrize("radius", [15.0, 30.0, 70.0])
def test_a_dashed_arc_is_one_hidden_stroke(radius: float, sweep: float) -> None:
    drawn = Arc((210.3, 160.2), radius, 0.4, np.radians(sweep), HIDDEN)
    (found,) = _read(drawn, width=2.0)
    assert isinstance(found, Arc) and found.linetype is HIDDEN
    assert found.radius == pytest.approx(radius, abs=0.5)
    ends, true = found.sample(1e9)[[0, -1]], drawn.sample(1e9)[[0, -1]]
    assert np.hypot(*(ends - true).T).max() < 1.5


@pytest.mark.parametrize("kinds", [(VISIBLE, VISIBLE), (HIDDEN, HIDDEN), (VISIBLE, HIDDEN)])
@pytest.mark.parametrize("angle", [0.0, 37.0])
@pytest.mark.parametrize("gap", [4.0, 5.0])
def test_lines_four_px_apart_are_two(
    gap: float, angle: float, kinds: tuple[Linetype, Linetype]
) -> None:
    way = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    normal, middle = np.array([-way[1], way[0]]), np.array([210.3, 160.2])
    drawn = [
        Segment(tuple(m - 70.0 * way), tuple(m + 70.0 * way), kind)
        for m, kind in zip(
            (middle - gap / 2 * normal, middle + gap / 2 * normal), kinds, strict=True
        )
    ]
    found = _read(*drawn, width=2.0)
    assert len(found) == 2
    for true in drawn:
        near = [
            np.abs((np.array([item.start, item.end]) - true.start) @ normal).max()
            for item in found
            if item.linetype is true.linetype
        ]
        assert min(near) < 0.2
