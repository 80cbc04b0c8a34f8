"""All labels of a part's cells, enumerated."""

import itertools

import numpy as np
import pytest

from benchmarks.sheets.sheet_policies import POLICIES, readings
from benchmarks.verified.verified_cells import Labels, compared
from benchmarks.verified.verified_sources import Page
from gaussiancad_core.evidence.projected_reading import drawn_views
from gaussiancad_core.labelling.part_model import PartModel, model_part
from gaussiancad_core.labelling.visibility_rules import holds
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.samples.modelling import box, cut, cylinder


def _model() -> PartModel:
    bore = cylinder(Axis.Z, (20, 20), 8.0, 10.0, 40)
    page = Page(cut(box((0, 0, 0), (50, 40, 30)), bore, box((30, -1, 10), (51, 41, 31))))
    reading, _ = readings(page.drawn(POLICIES[0]), page.size, POLICIES[0])
    return model_part(drawn_views(reading.registered, ()))


def test_labels_are_those_that_a_plain_search_finds() -> None:
    part = _model()
    space = Labels(part.rules)
    assert len(space.cells) <= 12
    plain = [
        dict(zip(space.cells, values, strict=True))
        for values in itertools.product((False, True), repeat=len(space.cells))
    ]
    fits = [labels for labels in plain if all(holds(rule, labels) for rule in part.rules)]
    left = space.fulfilling(part.rules)
    assert len(left) == len(fits) == 1
    assert space.agree(part.rules, left, np.random.default_rng(0))


def test_rules_that_are_left_out_leave_more_labels_than_are_claimed() -> None:
    part = _model()
    row = compared(part, np.random.default_rng(0))
    assert row["why"] == "" and row["fits"] == row["claimed"] == 1
    few = [rule for rule in part.rules if rule.linetype is None]
    assert len(Labels(few).fulfilling(few)) == pytest.approx(1 << Labels(few).free)
    assert len(Labels(few).fulfilling(few)) > 1
