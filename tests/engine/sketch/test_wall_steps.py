"""Whether a wall goes on between two sight lines, or there is a step."""

from collections.abc import Callable

import numpy as np
import pytest

from gaussiancad_core.sketch.wall_steps import Sight, goes_on

_RADIUS = 20.0
_GAIN = 1.45


def _round(place: float) -> float:
    """Depth of a cylinder beside its silhouette, where its wall is steep."""
    return _RADIUS - float(np.sqrt(_RADIUS**2 - (_RADIUS - place) ** 2))


def _step(place: float) -> float:
    return 10.0 if place < 0.5 else 10.0 - _GAIN


@pytest.mark.parametrize(("depth", "is_one"), [(_round, True), (_step, False)])
def test_a_steep_wall_is_no_step(depth: Callable[[float], float], is_one: bool) -> None:
    def look(place: float) -> Sight:
        return Sight((0,), np.array([depth(place)]), np.array([False]))

    places = np.array([0.35, 0.75])
    met = [look(place) for place in places]
    # A line that is drawn between the two makes one look closer.
    _, between, _ = goes_on(met, places, [0.0, 0.5, 2.0 * _RADIUS], look, 1.0)
    assert abs(depth(0.4) - depth(0.75)) > 1.0
    assert between.tolist() == [[is_one]]


def test_what_lies_between_two_sights_alone_is_no_wall_that_goes_on() -> None:
    """A slot between two prongs: beside the edge the sights meet one region less."""

    def look(place: float) -> Sight:
        if 0.95 < place < 2.0:
            return Sight((1,), np.array([8.0]), np.array([False]))
        depths = np.array([0.0, 8.0]) if place < 1.5 else np.array([6.0, 8.0])
        return Sight((0, 1), depths, np.array([False, False]))

    places = np.array([0.5, 2.5])
    _, between, _ = goes_on([look(place) for place in places], places, [1.0], look, 0.1)
    assert not between[0, 0]
