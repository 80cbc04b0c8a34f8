"""Two readings of the same views."""

from dataclasses import dataclass

import pytest

import gaussiancad_core.evidence.projection_choice as choice
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.evidence.projection_choice import both_readings
from gaussiancad_core.model.axes import Role
from gaussiancad_core.sheet.reading_options import ReadingOptions


@dataclass(frozen=True)
class _View:
    role: Role


@dataclass(frozen=True)
class _Sheet:
    drawn: tuple[_View, ...]


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
