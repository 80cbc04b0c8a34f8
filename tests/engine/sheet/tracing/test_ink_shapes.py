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
    fit_circle,
    following,
    line_support,
    radial_profile,
    refit_circle,
    refit_line,
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
@given(
    st.floats(0.0, np.pi), st.floats(-20.0, 20.0), st.sampled_from([2.0, 3.0, 5.0]), st.booleans()
)
def test_a_line_is_fitted_to_the_middle_of_its_stroke(
    angle: float, shift: float, width: float, left: bool
) -> None:
    direction = np.array([np.cos(angle), np.sin(angle)])
    normal = np.array([-direction[1], direction[0]])
    middle = np.array([160.0, 120.0]) + shift * normal
    ends = middle - 70 * direction, middle + 70 * direction
    sheet = _sheet(_segment(*ends[0], *ends[1]), width=width)
    # Positions are px from the centre of the first pixel.
    start_point = middle - 0.5 + (0.6 if left else -0.6) * normal
    start = Line(
        (float(start_point[0]), float(start_point[1])), (float(direction[0]), float(direction[1]))
    )
    refitted = refit_line(sheet, start, [(-60.0, 60.0)])
    _, across = refitted.coordinates(
        np.array([middle - 60 * direction, middle + 60 * direction]) - 0.5
    )
    assert np.abs(across).max() < 0.1
    assert line_support(sheet, refitted, [(-60.0, 60.0)]) == pytest.approx(121, abs=3)


def test_a_chord_of_a_circle_is_followed_by_little_ink() -> None:
    """Over a few px alone it looks straight."""
    sheet = _sheet(_arc(160, 120, 60))
    chord = Line((159.5, 179.0), (1.0, 0.0))
    assert line_support(sheet, chord, [(-60.0, 60.0)]) < 40


@settings(max_examples=15, deadline=None)
@given(st.floats(100.0, 220.0), st.floats(100.0, 140.0), st.floats(8.0, 90.0))
def test_a_circle_is_fitted_to_a_tenth_of_a_pixel(x: float, y: float, radius: float) -> None:
    sheet = _sheet(_arc(x, y, radius))
    found = fit_circle(sheet, Circle((x - 0.2, y - 1.1), radius + 0.7))
    assert found is not None
    assert max(_near(found, x, y, radius)) < 0.1


def test_of_circles_around_one_centre_each_keeps_its_own_ink() -> None:
    radii = [12.0, 25.0, 41.0, 70.0]
    sheet = _sheet(*[_arc(160, 120, radius) for radius in radii])
    for radius in radii:
        found = fit_circle(sheet, Circle((159.0, 119.8), radius + 0.8))
        assert found is not None
        assert max(_near(found, 160, 120, radius)) < 0.1


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
    # The circle that all three touch.
    assert fit_circle(sheet, Circle((105.0, 105.0), 45.0)) is None


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
