"""Measures that most likely are round make a solid better, and its status no surer."""

from types import SimpleNamespace

import pytest
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox

from gaussiancad_core.modes import Status
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.solid import exact
from gaussiancad_core.solid.exact import ExactResult, Limits

_VIEWS = DrawnViews({}, (50.0, 40.0, 30.0), 0.1, noise=0.02)
_INEXACT = ("lines-inexact", "its measures may not be right")


def _solved(share: float = 0.99, *, sound: bool = True, close: bool = False) -> ExactResult:
    verification = SimpleNamespace(sound=sound, close=close, share=share, flaws=())
    status = Status.VERIFIED if close else Status.APPROXIMATE
    box = BRepPrimAPI_MakeBox(50.0, 40.0, 30.0).Shape()
    return ExactResult(status, box, verification, (), () if close else (_INEXACT,), {"label": 1.0})


@pytest.fixture
def likely(monkeypatch: pytest.MonkeyPatch):  # noqa: ANN201
    """Makes measures move, and tells what the solid with them is."""

    def arrange(other: ExactResult, moved: float = 0.1) -> None:
        monkeypatch.setattr(exact, "find_supports", lambda views: SimpleNamespace(moved=moved))
        monkeypatch.setattr(exact, "_found", lambda views, limits: other if views.likely else None)

    return arrange


def test_a_solid_with_likely_measures_is_no_surer(likely) -> None:  # noqa: ANN001
    found, other = _solved(), _solved(close=True)
    likely(other)
    result = exact._with_likely_measures(found, _VIEWS, Limits())
    assert result.shape is other.shape
    assert result.status is Status.APPROXIMATE and result.reasons == (_INEXACT,)


def test_one_that_agrees_less_or_is_unsound_is_not_taken(likely) -> None:  # noqa: ANN001
    found = _solved()
    failed = ExactResult(Status.FAILED, None, None, (), (("no-solid-fits", ""),), {})
    for other in (_solved(0.9), _solved(sound=False), failed):
        likely(other)
        assert exact._with_likely_measures(found, _VIEWS, Limits()) is found


def test_certain_measures_stay(likely) -> None:  # noqa: ANN001
    found = _solved(close=True)
    likely(_solved())
    assert exact._with_likely_measures(found, _VIEWS, Limits()) is found
    doubted = _solved()
    likely(_solved(), moved=0.0)
    assert exact._with_likely_measures(doubted, _VIEWS, Limits()) is doubted
