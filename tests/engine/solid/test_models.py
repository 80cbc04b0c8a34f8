"""The models of a drawing: which one explains the most."""

from collections.abc import Callable

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.modes import Status
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.labelling import Labelling, Search
from gaussiancad_core.reasoning.part import model_part
from gaussiancad_core.solid import models
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_core.solid.models import Clock, Limits, labelled


def test_arcs_that_follow_a_curve_are_taken_for_it(
    pin_as_read: DrawnViews,
    sample_solid: Callable[[str], TopoDS_Shape],
    iou: Callable[[TopoDS_Shape, TopoDS_Shape], float],
) -> None:
    result = exact_solid(pin_as_read)
    assert (result.status, result.reasons) == (Status.VERIFIED, ())
    assert iou(result.shape, sample_solid("cross-bored-pin")) > 0.9999


def test_another_model_is_taken_only_where_it_gives_up_clearly_less(
    pin_as_read: DrawnViews, monkeypatch: pytest.MonkeyPatch
) -> None:
    part = model_part(pin_as_read)

    def chosen() -> bool:
        """Whether the model with curves is."""
        clock = Clock()
        clock.lap("model")
        return labelled(part, pin_as_read, Limits(), clock)[0].part is not part

    assert chosen()
    # Where the curve leads to labels for all lines nothing is compared.
    monkeypatch.setattr(Search, "fulfilled", lambda *_: Labelling(None, (), True))
    assert chosen()
    monkeypatch.setattr(models, "_LITTLE", 1e9)
    assert not chosen()
    assert models._cost(Labelling(None, (), False)) == float("inf")
