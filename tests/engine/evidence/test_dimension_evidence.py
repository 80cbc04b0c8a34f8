"""The numbers of dimensions in the model's axes."""

import math
from types import SimpleNamespace

import pytest

from gaussiancad_core.evidence.dimension_constraints import LengthDimension, RadiusDimension
from gaussiancad_core.evidence.dimension_evidence import contradicts, dimension_constraints, trusted
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.sheet.registration.view_registration import Placement
from gaussiancad_core.writing.dimension_texts import Span
from gaussiancad_core.writing.scale_agreement import Measure
from gaussiancad_core.writing.sheet_scale import ScaleSource, SheetScale

PIXEL = 0.5
SHEET = SimpleNamespace(
    mm_per_pixel=PIXEL,
    unseen=None,
    placements={
        # 60 mm wide, 20 deep, 40 high; the left view's right is -Y.
        Role.FRONT: Placement(Role.FRONT, (100.0, 200.0, 220.0, 280.0), (0.0, 60.0), (0.0, 40.0)),
        Role.LEFT: Placement(Role.LEFT, (20.0, 200.0, 60.0, 280.0), (-20.0, 0.0), (0.0, 40.0)),
        Role.BOTTOM: Placement(
            Role.BOTTOM, (100.0, 300.0, 220.0, 340.0), (0.0, 60.0), (-20.0, 0.0)
        ),
    },
)


@pytest.mark.parametrize(
    ("span", "stated"),
    [
        (Span(True, 110.0, 220.5), (Axis.X, 5.0, 60.25)),
        (Span(False, 200.0, 270.0), (Axis.Z, 5.0, 40.0)),
        (Span(True, 20.0, 30.0), (Axis.Y, 15.0, 20.0)),
        (Span(False, 320.0, 340.0), (Axis.Y, 10.0, 20.0)),
    ],
)
def test_a_dimension_measures_along_the_axis_of_its_column_or_row(
    span: Span, stated: tuple[Axis, float, float]
) -> None:
    found = dimension_constraints(SHEET, [Measure(span, 7.0, 0.1)], 0.0)
    axis, low, high = stated
    (item,) = found.lengths
    assert item == LengthDimension(axis, pytest.approx(low), pytest.approx(high), 7.0)


def test_of_two_numbers_for_one_length_the_longer_counts() -> None:
    span = Span(True, 100.0, 220.0)
    measures = [
        Measure(span, value, digit)
        for value, digit in ((60.0, 1.0), (60.1, 0.1), (59.98, 0.01), (60.12, 0.01))
    ]
    found = dimension_constraints(SHEET, measures, 0.0)
    # Zeros at the end may be left out: all are rounded like it.
    assert found.digit == 0.01
    assert [length.value for length in found.lengths] == [59.98, 60.12, 60.1, 60.0]


def test_a_circle_lies_in_the_plane_of_its_view() -> None:
    bore = Arc((30.0, 220.0), 8.0, 0.0, 6.28, Linetype.VISIBLE)
    (item,) = dimension_constraints(SHEET, [Measure(bore, 4.1, 0.1)], 0.0).lengths
    assert item == RadiusDimension(Axis.X, pytest.approx((15.0, 30.0)), 4.0, 4.1)


def test_what_is_beside_all_views_measures_nothing() -> None:
    bore = Arc((400.0, 220.0), 8.0, 0.0, 6.28, Linetype.VISIBLE)
    measures = [Measure(Span(True, 60.0, 160.0), 50.0, 0.1), Measure(bore, 4.0, 0.1)]
    assert dimension_constraints(SHEET, measures, 0.0) is None
    assert dimension_constraints(SHEET, [], 0.0) is None


@pytest.mark.parametrize(("noise", "reach"), [(0.01, 0.5), (0.12, 0.6), (0.4, 0.75)])
def test_the_rougher_the_lines_the_more_a_number_may_differ(noise: float, reach: float) -> None:
    found = dimension_constraints(SHEET, [Measure(Span(True, 100.0, 220.0), 60.0, 0.1)], noise)
    assert found.reach == pytest.approx(reach * PIXEL)


@pytest.mark.parametrize(
    ("off", "used", "is_given"), [(0.002, True, False), (0.005, False, False), (0.02, False, True)]
)
def test_numbers_count_only_at_the_scale_that_was_taken(
    off: float, used: bool, is_given: bool
) -> None:
    measures = (Measure(Span(True, 100.0, 220.0), 60.0, 0.1),)
    for sign in (1.0, -1.0):
        scale = SheetScale(PIXEL * math.exp(sign * off), ScaleSource.DIMENSION, measures=measures)
        assert trusted(SHEET, scale) == (measures if used else ())
        assert contradicts(SHEET, scale) is is_given
    assert trusted(SHEET, None) == ()
    assert not contradicts(SHEET, SheetScale(None, ScaleSource.DEFAULT))
