"""Measures that most likely are round make a solid better, and its status no surer."""

from types import SimpleNamespace

import pytest
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.solid import exact
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.limits import Limits
from gaussiancad_core.solid.measure_bounds import Measures, MeasureSource
from gaussiancad_protocol.modes import Status

_VIEWS = DrawnViews({}, (50.0, 40.0, 30.0), 0.1, noise=0.02)
_DOUBT = ("ambiguous", "there are others")


def _solved(share: float = 0.99, *, sound: bool = True, bound: float = 0.3) -> ExactResult:
    verification = SimpleNamespace(sound=sound, share=share, flaws=())
    measures = Measures(bound, (bound,) * 3, MeasureSource.DRAWING)
    box = BRepPrimAPI_MakeBox(50.0, 40.0, 30.0).Shape()
    return ExactResult(
        Status.VERIFIED, box, verification, (), (), {"label": 1.0}, measures=measures
    )


@pytest.fixture
def likely(monkeypatch: pytest.MonkeyPatch):  # noqa: ANN201
    """Makes measures move, and tells what the solid with them is."""

    def arrange(other: ExactResult, moved: float = 0.1) -> None:
        monkeypatch.setattr(exact, "find_carriers", lambda views: SimpleNamespace(moved=moved))
        monkeypatch.setattr(exact, "_found", lambda views, *_: (other, None))

    return arrange


def test_a_solid_with_likely_measures_is_no_surer(likely) -> None:  # noqa: ANN001
    found, other = _solved(), _solved(bound=0.001)
    likely(other)
    result = exact._with_likely_measures(found, _VIEWS, Limits())
    assert result.shape is other.shape
    assert (result.status, result.measures) == (Status.VERIFIED, found.measures)
    doubted = found.doubted(_DOUBT)
    result = exact._with_likely_measures(doubted, _VIEWS, Limits())
    assert result.shape is other.shape
    assert (result.status, result.reasons) == (Status.APPROXIMATE, (_DOUBT,))


def test_one_that_agrees_less_or_is_unsound_is_not_taken(likely) -> None:  # noqa: ANN001
    found = _solved()
    failed = ExactResult(Status.FAILED, None, None, (), (("no-solid-fits", ""),), {})
    for other in (_solved(0.9), _solved(sound=False), failed):
        likely(other)
        assert exact._with_likely_measures(found, _VIEWS, Limits()) is found


def test_certain_measures_stay(likely) -> None:  # noqa: ANN001
    found = _solved(bound=0.001)
    likely(_solved())
    assert exact._with_likely_measures(found, _VIEWS, Limits()) is found
    doubted = _solved()
    likely(_solved(), moved=0.0)
    assert exact._with_likely_measures(doubted, _VIEWS, Limits()) is doubted
