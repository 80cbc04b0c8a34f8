"""Lattices that most measures of a part lie on."""

import numpy as np
import pytest

from gaussiancad_core.coordinates.coordinate_clustering import CoordinateReading, Snapped, snapped
from gaussiancad_core.coordinates.grid_fitting import Roughness, fitted_lattice, likely_numbers
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import UNITS

_PIXEL = UNITS / 800.0
"""Units of a px, of a part that is 800 px long."""

_NOISE = 0.035 * _PIXEL
"""Units by which views of such pictures seem to be off."""

_ROUGH = Roughness(_PIXEL, _NOISE)

_STEPS = 150.5
"""Of the part along its longest extent, which is no multiple of its step."""

_STEP = UNITS / _STEPS

_MULTIPLES = {Axis.X: (7, 19, 31, 46, 68, 94, 121), Axis.Y: (11, 26, 40, 59), Axis.Z: (5, 17, 23)}

_ODD = {Axis.X: (33.31, 80.77), Axis.Y: (21.4,), Axis.Z: (9.63,)}
"""Other measures, in steps."""

_EXTENTS = {Axis.X: _STEPS, Axis.Y: 78.0, Axis.Z: 29.0}


def _rounded(number: float, parts: float = 4.0) -> float:
    """Units of what is drawn on the nearest quarter of a pixel, or another part of one."""
    return round(number / _PIXEL * parts) / parts * _PIXEL


def _readings(parts: float = 4.0) -> list[CoordinateReading]:
    readings = []
    for axis in Axis:
        items = [0.0, *_MULTIPLES[axis], *_ODD[axis], _EXTENTS[axis]]
        readings += [
            CoordinateReading(axis, _rounded(number * _STEP, parts), 1.0) for number in items
        ]
    return readings


def _beside(snap: Snapped) -> list[float]:
    """px by which values are beside the part's."""
    return [
        min(abs(value - number * _STEP) for value in snap.values[axis]) / _PIXEL
        for axis in Axis
        for number in _MULTIPLES[axis]
    ]


def test_measures_on_quarters_of_a_pixel_become_what_they_were_meant_to_be() -> None:
    """Fourteen of eighteen are multiples of a step that the longest extent is none of."""
    snap = snapped(_readings(), [], _PIXEL, noise=_NOISE)
    drawn = [abs(_rounded(n * _STEP) - n * _STEP) for item in _MULTIPLES.values() for n in item]
    assert max(drawn) > 0.1 * _PIXEL
    assert max(_beside(snap)) < 0.03


def test_measures_on_whole_pixels_do_if_the_scale_is_known() -> None:
    """A step of five pixels, of which chance comes within half of one too often otherwise."""
    millimetre = _STEP
    snap = snapped(_readings(1.0), [], _PIXEL, millimetre=millimetre, noise=0.12 * _PIXEL)
    drawn = [
        abs(_rounded(n * _STEP, 1.0) - n * _STEP) for item in _MULTIPLES.values() for n in item
    ]
    assert max(drawn) > 0.4 * _PIXEL
    assert max(_beside(snap)) < 0.15
    assert snap.step is None and not snap.nominal
    # What is known better than that is not moved so far.
    assert snapped(_readings(1.0), [], _PIXEL, millimetre=millimetre, noise=_NOISE).moved == 0.0


def test_such_measures_are_not_certain() -> None:
    snap = snapped(_readings(), [], _PIXEL, noise=_NOISE)
    assert snap.step is None and not snap.nominal
    assert 0.03 < snap.moved / _PIXEL < 0.13


def test_other_measures_stay_where_they_were_read() -> None:
    snap = snapped(_readings(), [], _PIXEL, noise=_NOISE)
    for axis in Axis:
        for number in _ODD[axis]:
            at = number * _STEP
            assert min(abs(value - at) for value in snap.values[axis]) < 0.3 * _PIXEL


def test_measures_move_only_where_that_is_asked_for() -> None:
    assert snapped(_readings(), [], _PIXEL).moved == 0.0


@pytest.mark.parametrize("count", [5, 9, 16, 30])
@pytest.mark.parametrize("noise", [0.035, 0.12, 0.25])
def test_random_measures_lie_on_no_lattice(count: int, noise: float) -> None:
    stated = 0
    rough = Roughness(_PIXEL, noise * _PIXEL, UNITS / 90.0)
    for seed in range(60):
        random = np.random.default_rng(1000 * count + seed)
        groups = [sorted(random.uniform(0.0, UNITS, count // 2)) for _ in range(2)]
        stated += fitted_lattice([*groups, [], random.uniform(1.0, 20.0, 2)], rough) is not None
    assert stated == 0


def test_what_follows_from_other_measures_is_no_evidence() -> None:
    """Circles about random places, their sides on one axis, and their mirror images."""
    stated = 0
    for seed in range(40):
        random = np.random.default_rng(seed)
        numbers, circles = [0.0, UNITS], []
        values = {Axis.X: [0, 1], Axis.Y: [], Axis.Z: []}
        for centre, radius in random.uniform((15.0, 3.0), (40.0, 10.0), (3, 2)):
            for x in (centre, UNITS - centre):
                at = len(numbers)
                numbers += [x, UNITS / 2.0, radius, x - radius, x + radius]
                circles.append((Axis.Y, at, at + 1, at + 2))
                values[Axis.X] += [at + 3, at + 4]
        stated += likely_numbers(np.array(numbers), values, circles, _ROUGH) is not None
    assert stated == 0
