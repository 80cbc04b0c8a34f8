"""Whether a wall goes on between two sight lines, or there is a step."""

from collections.abc import Callable

import numpy as np
import pytest

from gaussiancad_core.sketch.steps import Sight, goes_on

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
    met = [look(own) for own in places]
    # A line that is drawn between the two makes one look closer.
    _, between, _ = goes_on(met, places, [0.0, 0.5, 2.0 * _RADIUS], look, 1.0)
    assert abs(depth(0.4) - depth(0.75)) > 1.0
    assert between.tolist() == [[is_one]]
