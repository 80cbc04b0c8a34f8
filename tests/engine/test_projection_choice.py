"""First or third angle, by how much of the lines either reading's hull shows."""

from dataclasses import dataclass

import pytest

import gaussiancad_core.projection_choice as choice
from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.projection_choice import both_readings, choose_projection
from gaussiancad_core.sheet.options import ReadingOptions


@dataclass(frozen=True)
class _View:
    role: Role


@dataclass(frozen=True)
class _Sheet:
    drawn: tuple[_View, ...]


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
    monkeypatch.setattr(choice, "_agreement", lambda registered: next(told))
    found = choose_projection(_Sheet(()), _Sheet(()), Projection.THIRD)
    assert (found.projection, found.inferred) == (projection, inferred)


@pytest.mark.parametrize(
    ("scores", "below", "projection", "inferred"),
    [
        # Third angle would have a view from below, unless the lines tell it clearly.
        ((0.71, 0.74), (Role.TOP, Role.RIGHT), Projection.FIRST, False),
        ((0.71, 0.77), (Role.TOP, Role.RIGHT), Projection.THIRD, True),
        ((0.74, 0.71), (Role.TOP, Role.RIGHT), Projection.FIRST, True),
        # Views of both kinds, or of neither, are usual in either angle.
        ((0.71, 0.74), (Role.TOP, Role.BOTTOM), Projection.THIRD, True),
        ((0.71, 0.74), (Role.LEFT, Role.RIGHT), Projection.THIRD, True),
    ],
)
def test_an_unusual_reading_must_explain_more(
    monkeypatch: pytest.MonkeyPatch,
    scores: tuple[float, float],
    below: tuple[Role, Role],
    projection: Projection,
    inferred: bool,
) -> None:
    told = iter(scores)
    monkeypatch.setattr(choice, "register_views", lambda drawn, options: _Sheet(drawn))
    monkeypatch.setattr(choice, "_agreement", lambda registered: next(told))
    views = tuple(_View(role) for role in (Role.FRONT, *below))
    found = choose_projection(*both_readings(views, ReadingOptions()), Projection.FIRST)
    assert (found.projection, found.inferred) == (projection, inferred)


def test_views_that_contradict_each_other_otherwise_leave_one_reading(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def register(drawn: tuple[_View, ...], _options: ReadingOptions) -> _Sheet:
        if Role.BOTTOM in {view.role for view in drawn}:
            raise NoModelError("views-contradict", "")
        return _Sheet(drawn)

    monkeypatch.setattr(choice, "register_views", register)
    views = (_View(Role.FRONT), _View(Role.TOP))
    readings = both_readings(views, ReadingOptions())
    assert readings == (_Sheet(views), None)
    # No hull is drawn where there is nothing to choose.
    monkeypatch.setattr(choice, "_agreement", None)
    found = choose_projection(*readings, Projection.FIRST)
    assert (found.projection, found.inferred, found.other) == (Projection.FIRST, True, None)
