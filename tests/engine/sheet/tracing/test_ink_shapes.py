"""Lines and circles under the ink, to a tenth of a pixel."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.sheet.image.clean_ink import CleanSheet, clean_sheet
from gaussiancad_core.sheet.tracing.ink_shapes import (
    Circle,
    Line,
    circle_support,
    edge_map,
    find_circles,
    find_lines,
    fit_circle,
    following,
    line_support,
    radial_profile,
    refit_circle,
    refit_line,
    same_circle,
    sample,
)

FULL = 2 * np.pi


def _sheet(*strokes: Stroke, width: float = 3.0) -> CleanSheet:
    """Strokes in px whose corners are at integers: a pixel's centre is at .5."""
    style = SheetStyle(width=320, height=240, visible_width=width)
    ink = rasterise(strokes, style)
    return clean_sheet(np.clip(np.rint(255 * (1 - ink)), 0, 255).astype(np.uint8))


def _segment(x0: float, y0: float, x1: float, y1: float) -> Segment:
    return Segment((x0, y0), (x1, y1), Linetype.VISIBLE)


def _arc(x: float, y: float, radius: float, start: float = 0.0, sweep: float = FULL) -> Arc:
    return Arc((x, y), radius, start, sweep, Linetype.VISIBLE)


def _near(circle: Circle, x: float, y: float, radius: float) -> list[float]:
    """Errors in px; shapes count from the centre of the first pixel."""
    return [
        float(np.hypot(circle.centre[0] + 0.5 - x, circle.centre[1] + 0.5 - y)),
        abs(circle.radius - radius),
    ]


@settings(max_examples=15, deadline=None)
@given(st.floats(0.0, np.pi), st.floats(-20.0, 20.0), st.sampled_from([2.0, 3.0, 5.0]))
def test_a_stroke_is_found_as_the_line_through_its_middle(
    angle: float, shift: float, width: float
) -> None:
    direction = np.array([np.cos(angle), np.sin(angle)])
    normal = np.array([-direction[1], direction[0]])
    middle = np.array([160.0, 120.0]) + shift * normal
    ends = middle - 70 * direction, middle + 70 * direction
    sheet = _sheet(_segment(*ends[0], *ends[1]), width=width)
    found = find_lines(sheet, edge_map(sheet))
    assert found
    # Positions along a line count from its point, px from the centre of the first pixel.
    along, _ = found[0].coordinates(np.array([middle]) - 0.5)
    refitted = refit_line(sheet, found[0], [(along[0] - 60, along[0] + 60)])
    _, across = refitted.coordinates(
        np.array([middle - 60 * direction, middle + 60 * direction]) - 0.5
    )
    assert np.abs(across).max() < 0.1
    span = [(along[0] - 60, along[0] + 60)]
    assert line_support(sheet, refitted, span) == pytest.approx(121, abs=3)


def test_a_short_line_between_two_others_is_straight() -> None:
    """The bottom of a slot: both sides go up from its ends and pull a fit towards them."""
    slot = [(150, 80, 150, 140), (150, 140, 176, 140), (176, 140, 176, 80)]
    sheet = _sheet(*[_segment(*ends) for ends in slot])
    level = [
        line
        for line in find_lines(sheet, edge_map(sheet))
        if abs(line.direction[1]) < 0.02 and abs(line.point[1] + 0.5 - 140) < 0.5
    ]
    assert level


def test_a_circle_gives_no_line() -> None:
    """Only chords over a few px look straight."""
    sheet = _sheet(_arc(160, 120, 60))
    for line in find_lines(sheet, edge_map(sheet)):
        assert line_support(sheet, line, [(-60.0, 60.0)]) < 40


@settings(max_examples=15, deadline=None)
@given(st.floats(100.0, 220.0), st.floats(100.0, 140.0), st.floats(8.0, 90.0))
def test_a_circle_is_found_to_a_tenth_of_a_pixel(x: float, y: float, radius: float) -> None:
    sheet = _sheet(_arc(x, y, radius))
    found = find_circles(sheet)
    assert min(max(_near(circle, x, y, radius)) for circle in found) < 0.1


def test_all_circles_around_one_centre() -> None:
    radii = [12.0, 25.0, 41.0, 70.0]
    sheet = _sheet(*[_arc(160, 120, radius) for radius in radii])
    found = find_circles(sheet)
    for radius in radii:
        assert min(max(_near(circle, 160, 120, radius)) for circle in found) < 0.1


def test_both_arcs_of_a_slot() -> None:
    """A fit pulled aside by the tangents does not keep the right circle out."""
    sheet = _sheet(
        _arc(100, 120, 40, np.pi / 2, np.pi),
        _arc(220, 120, 40, -np.pi / 2, np.pi),
        _segment(100, 80, 220, 80),
        _segment(100, 160, 220, 160),
    )
    found = find_circles(sheet)
    for x in (100, 220):
        assert min(max(_near(circle, x, 120, 40)) for circle in found) < 0.5
    for one in found:
        assert sum(same_circle(one, other) for other in found) == 1


def test_an_arc_is_fitted_without_its_tangents() -> None:
    """A fillet of 60 px: with the tangents in reach the radius comes out too large."""
    fillet = _arc(160, 120, 60, 0.0, np.pi / 2)
    sheet = _sheet(fillet, _segment(220, 20, 220, 120), _segment(60, 180, 160, 180))
    biased = fit_circle(sheet, Circle((159.5, 119.5), 60.0))
    assert biased is not None
    exact = refit_circle(sheet, biased, [(0.0, biased.radius * np.pi / 2)])
    assert max(_near(exact, 160, 120, 60)) < 0.1
    assert max(_near(exact, 160, 120, 60)) < 0.5 * max(_near(biased, 160, 120, 60))


def test_a_refit_without_enough_ink_changes_nothing() -> None:
    sheet = _sheet(_arc(160, 120, 60, 0.0, np.pi / 2))
    circle = Circle((159.0, 119.0), 61.0)
    assert refit_circle(sheet, circle, [(200.0, 210.0)]) == circle


def test_support_is_the_length_that_is_followed() -> None:
    sheet = _sheet(_arc(160, 120, 60, 0.0, np.pi))
    assert circle_support(sheet, Circle((159.5, 119.5), 60.0)) == pytest.approx(
        60 * np.pi, rel=0.03
    )
    assert circle_support(sheet, Circle((159.5, 119.5), 63.0)) == 0.0
    assert following(np.zeros(7)) == 7.0
    assert following(np.array([0.4, -0.8, 5.0])) == pytest.approx(0.5625)


def test_radial_profile_is_where_the_ink_is() -> None:
    sheet = _sheet(_arc(160, 120, 60, 0.0, np.pi / 2))
    angles, radii = radial_profile(sheet, Circle((159.5, 119.5), 58.0), 5.0)
    # Round caps reach half a stroke beyond both ends.
    signed = (angles + np.pi) % FULL - np.pi
    assert signed.min() == pytest.approx(-1.5 / 60, abs=0.02)
    assert signed.max() == pytest.approx(np.pi / 2 + 1.5 / 60, abs=0.02)
    assert len(angles) == pytest.approx(58 * (np.pi / 2 + 3 / 60), abs=3)
    assert radii == pytest.approx(60.0, abs=0.1)


def test_lines_are_no_circles() -> None:
    sheet = _sheet(_segment(60, 60, 260, 60), _segment(60, 60, 60, 200), _segment(60, 200, 260, 60))
    assert all(circle_support(sheet, circle) < 30 for circle in find_circles(sheet))


def test_positions_along_a_line() -> None:
    line = Line((10.0, 20.0), (0.6, 0.8))
    along, across = line.coordinates(np.array([[10.0, 20.0], [13.0, 24.0], [9.2, 20.6]]))
    assert along == pytest.approx([0, 5, 0]) and across == pytest.approx([0, 0, 1])
    assert line.at(5.0) == pytest.approx((13.0, 24.0))


def test_samples_are_bilinear_and_zero_outside() -> None:
    image = np.arange(12, dtype=np.float32).reshape(3, 4)
    xs = np.array([[0.0, 1.5], [3.0, -5.0]])
    ys = np.array([[0.0, 0.5], [2.0, 1.0]])
    assert sample(image, xs, ys) == pytest.approx(np.array([[0.0, 3.5], [11.0, 0.0]]))
