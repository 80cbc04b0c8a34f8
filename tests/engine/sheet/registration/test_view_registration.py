"""Strokes from sheet pixels to a view's plane."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment
from gaussiancad_core.sheet.registration.view_masks import Outline
from gaussiancad_core.sheet.registration.view_registration import (
    Placement,
    strokes_in_plane,
    view_box,
)

PLACE = Placement(Role.FRONT, (100.0, 200.0, 500.0, 440.0), (0.0, 80.0), (0.0, 48.0))
ANGLE = st.floats(-4.0, 4.0)


@given(ANGLE, ANGLE, st.floats(0.2, 6.2), st.sampled_from([Arc, Ellipse, Segment]))
def test_a_stroke_in_the_plane_is_where_its_points_are(
    rotation: float, start: float, sweep: float, kind: type
) -> None:
    item = {
        Arc: Arc((250.0, 300.0), 40.0, start, sweep, Linetype.HIDDEN, 0.7),
        Ellipse: Ellipse((250.0, 300.0), 40.0, 15.0, rotation, start, sweep, Linetype.HIDDEN, 0.7),
        Segment: Segment((120.0, 210.0), (480.0, 330.0 + 10 * rotation), Linetype.HIDDEN, 0.7),
    }[kind]
    (placed,) = strokes_in_plane((item,), PLACE)
    assert isinstance(placed, kind)
    assert (placed.linetype, placed.confidence) == (Linetype.HIDDEN, 0.7)
    assert placed.length == pytest.approx(item.length / 5.0)
    # The sheet's y runs down: what goes around goes around the other way.
    expected = PLACE.to_plane(item.sample(item.length / 7.5))
    found = placed.sample(placed.length / 7.5)
    assert found == pytest.approx(expected if kind is Segment else expected[::-1], abs=1e-6)


def test_the_box_reaches_as_far_as_an_ellipse() -> None:
    ellipse = Ellipse((50.0, 40.0), 30.0, 10.0, 0.5, 0.0, 2 * np.pi, Linetype.VISIBLE)
    points = ellipse.sample(0.01)
    low, high = points.min(0), points.max(0)
    depth = np.full((80, 100), -1.0, np.float32)
    x, y = np.rint(low).astype(int)
    depth[y : round(high[1]), x : round(high[0])] = 1.0
    assert view_box((ellipse,), Outline(depth, (), 1, (0.0, 0.0))) == pytest.approx(
        (*low, *high), abs=1e-3
    )


@pytest.mark.parametrize(("exact", "inset"), [(True, 0.0), (False, 1.7)])
def test_exact_lines_count_where_the_outline_closed_a_narrow_gap(exact: bool, inset: float) -> None:
    # A narrow chamfer around the view: the outline runs between its two lines.
    sides = [((10.0, y), (90.0, y)) for y in (8.3, 11.7, 68.3, 71.7)]
    sides += [((x, 10.0), (x, 70.0)) for x in (8.3, 11.7, 88.3, 91.7)]
    strokes = tuple(Segment(*ends, Linetype.VISIBLE) for ends in sides)
    depth = np.full((80, 100), -1.0, np.float32)
    depth[10:70, 10:90] = 1.0
    found = view_box(strokes, Outline(depth, (), 1, (0.0, 0.0)), exact=exact)
    expected = (8.3 + inset, 8.3 + inset, 91.7 - inset, 71.7 - inset)
    assert found == pytest.approx(expected, abs=0.51 if inset else 1e-9)


@pytest.mark.parametrize("beyond", [2.0, 3.0, 5.0])
def test_strokes_drawn_too_long_leave_the_side_where_its_edge_is(beyond: float) -> None:
    far = 90.0 + beyond
    depth = np.full((80, 110), -1.0, np.float32)
    depth[10:70, 10 : int(far)] = 1.0
    outline = Outline(depth, (), 1, (0.0, 0.0))
    edges = [((10.0, 10.0), (10.0, 70.0)), ((90.0, 10.0), (90.0, 70.0))]
    level = [((10.0, y), (far, y)) for y in (10.0, 40.0, 70.0)]
    strokes = tuple(Segment(*ends, Linetype.VISIBLE) for ends in (*edges, *level))
    assert view_box(strokes, outline) == pytest.approx((10.0, 10.0, 90.0, 70.0))
    # A roof begins at its edge and does not cross it.
    whole = [((10.0, y), (90.0, y)) for y in (10.0, 70.0)]
    roof = [((90.0, y), (far, 40.0)) for y in (10.0, 70.0)]
    gabled = tuple(Segment(*ends, Linetype.VISIBLE) for ends in (*edges, *whole, *roof))
    assert view_box(gabled, outline) == pytest.approx((10.0, 10.0, far, 70.0))


def test_the_rim_of_a_cone_is_no_stroke_drawn_too_long() -> None:
    """It ends in corners a few px beyond the edges of a shaft's other parts."""
    depth = np.full((110, 110), -1.0, np.float32)
    depth[10:100, 6:96] = 1.0
    rows = [(10.0, 90.0, 10.0), (10.0, 90.0, 50.0), (18.0, 82.0, 70.0), (5.0, 95.0, 100.0)]
    lines = [((x0, y), (x1, y)) for x0, x1, y in rows]
    lines += [((10.0, 10.0), (10.0, 50.0)), ((90.0, 10.0), (90.0, 50.0))]
    lines += [((18.0, 50.0), (18.0, 70.0)), ((82.0, 50.0), (82.0, 70.0))]
    lines += [((18.0, 70.0), (5.0, 100.0)), ((82.0, 70.0), (95.0, 100.0))]
    strokes = tuple(Segment(*ends, Linetype.VISIBLE) for ends in lines)
    found = view_box(strokes, Outline(depth, (), 1, (0.0, 0.0)))
    assert found == pytest.approx((5.0, 10.0, 95.0, 100.0))
