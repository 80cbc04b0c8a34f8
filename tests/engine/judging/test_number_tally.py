"""Numbers of a sheet against what a solid measures where they stand."""

import pytest

from gaussiancad_core.evidence.dimension_constraints import (
    DimensionConstraints,
    LengthDimension,
    RadiusDimension,
)
from gaussiancad_core.judging.faceted_solids import faceted_shape
from gaussiancad_core.judging.number_tally import NumberDifference, differing_numbers
from gaussiancad_core.model.axes import Axis, Role
from sample_parts.modelling import box, cut, cylinder

_ROLES = (Role.FRONT, Role.TOP)

_PART = faceted_shape(
    cut(
        box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0)),
        box((40.0, -1.0, 18.0), (61.0, 41.0, 31.0)),
        cylinder(Axis.Z, (15.0, 12.0), 5.0, -1.0, 31.0),
    )
)


def _differing(
    *dimension: LengthDimension | RadiusDimension, digit: float = 0.1
) -> tuple[NumberDifference, ...]:
    return differing_numbers(_PART, DimensionConstraints(dimension, 0.1, digit), _ROLES)


def test_numbers_that_the_part_keeps_are_none() -> None:
    assert not _differing(
        LengthDimension(Axis.X, 0.0, 60.0, 60.0),
        LengthDimension(Axis.X, 0.0, 15.0, 15.0),
        LengthDimension(Axis.Z, 0.0, 18.0, 18.0),
        RadiusDimension(Axis.Z, (15.0, 12.0), 5.0, 5.0),
    )


def test_a_step_at_another_level_is_told_with_what_it_measures() -> None:
    (found,) = _differing(LengthDimension(Axis.Z, 0.0, 18.4, 18.4))
    assert (found.stated, found.measured) == pytest.approx((18.4, 18.0))
    assert found.role is Role.FRONT
    assert found.ends == ((0.0, 0.0), (0.0, 18.4))
    assert not found.is_radius


def test_the_middle_of_a_bore_is_a_place_that_is_measured_to() -> None:
    (found,) = _differing(LengthDimension(Axis.X, 0.0, 15.5, 15.5))
    assert found.measured == pytest.approx(15.0, abs=1e-3)


def test_a_radius_is_told_in_the_view_that_shows_its_circle() -> None:
    (found,) = _differing(RadiusDimension(Axis.Z, (15.0, 12.0), 5.5, 5.5))
    assert found.is_radius
    assert (found.role, found.measured) == (Role.TOP, pytest.approx(5.0, abs=0.01))
    assert found.ends == ((9.5, 12.0), (20.5, 12.0))


def test_a_number_is_as_exact_as_its_last_digit() -> None:
    assert not _differing(LengthDimension(Axis.X, 0.0, 15.5, 15.5), digit=1.0)


def test_where_the_solid_has_nothing_near_lines_tell_and_no_number() -> None:
    assert not _differing(LengthDimension(Axis.X, 0.0, 25.0, 25.0))
    assert not _differing(RadiusDimension(Axis.Z, (45.0, 12.0), 5.0, 5.5))
    assert not differing_numbers(_PART, None, _ROLES)


def test_the_farthest_off_comes_first() -> None:
    found = _differing(
        LengthDimension(Axis.Z, 0.0, 18.4, 18.4), LengthDimension(Axis.X, 0.0, 59.0, 59.0)
    )
    assert [each.stated for each in found] == [59.0, 18.4]
