"""First or third angle, by how much of the lines either reading's hull shows."""

import pytest

import gaussiancad_core.projection_choice as choice
from gaussiancad_core.axes import Projection
from gaussiancad_core.projection_choice import choose_projection
from gaussiancad_core.sheet.options import ReadingOptions


@pytest.mark.parametrize(
    ("scores", "projection", "inferred"),
    [
        ((0.90, 0.80), Projection.THIRD, True),
        ((0.80, 0.90), Projection.FIRST, True),
        ((0.90, 0.91), Projection.THIRD, False),
        # Most sheets with many hidden lines agree no better with the hull, and tell all the same.
        ((0.41, 0.46), Projection.FIRST, True),
        # What hardly fits is no better for fitting a little less badly.
        ((0.33, 0.36), Projection.THIRD, False),
        ((0.36, 0.33), Projection.THIRD, False),
    ],
)
def test_a_reading_is_told_where_it_explains_the_lines(
    monkeypatch: pytest.MonkeyPatch,
    scores: tuple[float, float],
    projection: Projection,
    inferred: bool,
) -> None:
    told = iter(scores)
    monkeypatch.setattr(choice, "register_views", lambda drawn, options: object())
    monkeypatch.setattr(choice, "_agreement", lambda registered: next(told))
    found = choose_projection((), Projection.THIRD, ReadingOptions())
    assert (found.projection, found.inferred) == (projection, inferred)
