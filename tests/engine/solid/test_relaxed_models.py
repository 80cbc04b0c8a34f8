"""The models of a drawing: which one explains the most."""

from collections.abc import Callable

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.solid import relaxed_models
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_protocol.modes import Status


def test_arcs_that_follow_a_curve_are_taken_for_it(
    pin_as_read: DrawnViews,
    sample_solid: Callable[[str], TopoDS_Shape],
    iou: Callable[[TopoDS_Shape, TopoDS_Shape], float],
) -> None:
    result = exact_solid(pin_as_read)
    assert (result.status, result.reasons) == (Status.VERIFIED, ())
    assert iou(result.shape, sample_solid("cross-bored-pin")) > 0.9999


def _only_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leaves out models that fulfil all rules, which would be the only ones."""
    monkeypatch.setattr(relaxed_models, "wider_models", lambda *_: iter(()))


def test_curves_are_followed_where_little_is_given_up_and_nothing_fits(
    pin_as_read: DrawnViews, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An arc that reaches beyond the outline gives up hardly any line, and bounds no solid."""
    _only_given_up(monkeypatch)
    monkeypatch.setattr(relaxed_models, "_LITTLE", float("inf"))
    assert exact_solid(pin_as_read).status is Status.VERIFIED
