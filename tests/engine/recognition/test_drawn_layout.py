"""Views that stand in line with none are views where they are sure by what they show."""

import pytest
from engine.views.plain_views import drawn

from gaussiancad_core.model.axes import Role
from gaussiancad_core.recognition.drawn_layout import chosen_views
from gaussiancad_core.views.drawn_groups import DrawnView
from gaussiancad_core.views.role_search import arranged_views

_ACROSS = (12.0, 31.0, 40.0, 58.0)
"""mm of edges along the axis that both views share."""


def _pair(levels: tuple[float, ...]) -> list[DrawnView]:
    """A front view, and a drawing below it and to the right that is as wide."""
    front = drawn((20.0, 20.0), (75.0, 50.0), _ACROSS, (10.0,))
    return [front, drawn((22.0, 90.0), (75.0, 30.0), levels, (8.0,))]


@pytest.mark.parametrize(("levels", "count"), [(_ACROSS, 2), ((), None)])
def test_views_out_of_line(levels: tuple[float, ...], count: int | None) -> None:
    views = _pair(levels)
    best = chosen_views(views, arranged_views(views), {}, 0.0)
    assert (None if best is None else len(best.placed)) == count


def test_two_views_that_the_user_names_are_taken_as_they_are() -> None:
    views = _pair(())
    best = chosen_views(views, None, {0: Role.TOP, 1: Role.REAR}, 0.0)
    assert best is not None
    assert {number: placed.role for number, placed in best.placed.items()} == {
        0: Role.TOP,
        1: Role.REAR,
    }
