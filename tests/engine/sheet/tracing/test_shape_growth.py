"""Lines and circles that are grown along points of ridges."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.tracing import shape_growth, view_shapes
from gaussiancad_core.sheet.tracing.grown_shapes import Grown
from gaussiancad_core.sheet.tracing.ridges import RidgePoints, ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import GrowthRules, grow_shapes, warm_up

Sketch = Any
"""The class that the fixture gives."""


def _grown(drawn: Sketch) -> tuple[RidgePoints, list[Grown]]:
    ridges = ridge_points(drawn.weight, 3.0)
    return ridges, grow_shapes(ridges, GrowthRules.of_width(3.0))


def test_every_shape_has_points_of_its_own_near_it(sketch: Sketch) -> None:
    ridges, grown = _grown(sketch().box(30, 30, 160, 120).arc((95, 75), 30))
    assert [isinstance(item.geometry, Line) for item in grown].count(True) == 4
    for item in grown:
        assert len(np.unique(item.members)) == len(item.members)
        assert item.geometry.distances(ridges.points[item.members]).max() < 1.4
    explained = np.unique(np.concatenate([entry.members for entry in grown]))
    assert len(explained) > 0.97 * len(ridges.points)


def test_growth_is_the_same_every_time_and_the_strongest_come_first(sketch: Sketch) -> None:
    drawn = sketch().line((20, 30), (180, 30)).line((20, 60), (90, 60)).line((20, 90), (50, 90))
    noise = np.random.default_rng(1).normal(0.0, 0.05, drawn.weight.shape)
    drawn.weight = np.clip(drawn.weight + noise, 0.0, 1.0).astype(np.float32)
    (_, first), (_, second) = _grown(drawn), _grown(drawn)
    assert [item.geometry for item in first] == [item.geometry for item in second]
    assert [round(item.geometry.point[1]) for item in first[:3]] == [30, 60, 90]
    for one, other in zip(first, second, strict=True):
        assert np.array_equal(one.members, other.members)


def test_no_points_no_shapes(sketch: Sketch) -> None:
    warm_up()
    dot = sketch()
    assert _grown(dot)[1] == []
    dot.weight[50, 50] = 1.0
    assert _grown(dot)[1] == []


@pytest.mark.parametrize(("limit", "most"), [("_MOST_LINES", 13), ("_MOST_MEMBERS", 1_000)])
def test_more_lines_than_any_drawing_has_end_the_growth(
    sketch: Sketch, monkeypatch: pytest.MonkeyPatch, limit: str, most: int
) -> None:
    drawn = sketch(160, 160)
    for at in range(10, 150, 10):
        drawn.line((10.0, float(at)), (150.0, float(at)))
    assert len(_grown(drawn)[1]) == 14
    monkeypatch.setattr(shape_growth, limit, most)
    with pytest.raises(NoModelError, match="too many") as stated:
        _grown(drawn)
    assert stated.value.code == "part-too-complex"


def test_more_lines_than_any_part_has_are_refused_before_they_are_looked_at(
    sketch: Sketch, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn = sketch().box(20, 20, 180, 140)
    monkeypatch.setattr(view_shapes, "_MOST_LINES", 3)
    with pytest.raises(NoModelError) as caught:
        drawn.strokes()
    assert caught.value.code == "part-too-complex"


def test_members_of_lines_count_as_those_of_other_shapes(sketch: Sketch) -> None:
    ridges, shapes = _grown(sketch(160, 160).line((10, 20), (150, 60)).line((10, 60), (150, 20)))
    for shape, worth in zip(shapes, shape_growth._worth(shapes, ridges.points), strict=True):
        away = shape.geometry.distances(ridges.points[shape.members])
        assert np.allclose(worth, shape_growth._closeness(away))
