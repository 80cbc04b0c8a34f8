"""What the proof of verified counts, and its changes of drawings."""

from random import Random

import numpy as np
import pytest

from benchmarks.ask.measures import is_right
from benchmarks.ask.measures import table as measures_table
from benchmarks.ask.verified import has_changed, is_false, table
from benchmarks.run.workers import Row
from benchmarks.verified.verified_changes import permuted, split
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

_RIGHT: Row = {
    "policy": "all", "status": "verified", "reasons": [], "why": "", "within": 11, "faces": 12,
}  # fmt: skip
_FALSE = {**_RIGHT, "policy": "some", "why": "off by 3 mm, bound 0.01 mm", "within": 6}
_DOUBTED: Row = {"policy": "all", "status": "approximate", "reasons": ["assumed"]}
_CHANGED = {**_RIGHT, "policy": "split", "changed": "volume 5.0 became 4.0"}
_CELLS: Row = {"policy": "all", "free": 4, "fits": 2, "claimed": 1, "why": "2 labels fulfil"}


def test_what_is_false_and_what_has_changed() -> None:
    cases = (_RIGHT, _FALSE, _DOUBTED, _CHANGED, _CELLS)
    assert [is_false(case) for case in cases] == [False, True, False, False, False]
    assert [has_changed(case) for case in cases] == [False, False, False, True, True]


def test_table_counts_by_source_and_policy_and_names_what_is_wrong() -> None:
    rows = [
        {"source": "twins", "seed": 0, "cases": [_RIGHT, _FALSE, _DOUBTED]},
        {"source": "changes", "seed": 7, "cases": [_CHANGED]},
        {"source": "cells", "seed": 1, "cases": [_CELLS]},
        {"source": "grids", "seed": 2, "failure": "prepare-crashed"},
    ]
    lines = [line.split() for line in table(rows).splitlines()]
    assert ["twins", "3", "2", "1", "0", "1", "0", "70.8", "%"] in lines
    assert ["all", "5", "3", "1", "0", "1", "2", "77.8", "%"] in lines
    text = table(rows)
    assert "FALSE twins 0 case 1 (some): off by 3 mm" in text
    assert "CHANGED changes 7 case 0 (split): volume 5.0 became 4.0" in text
    assert "CHANGED cells 1 case 0 (all): 2 labels fulfil" in text
    assert "grids 2: prepare-crashed" in text


def test_changes_keep_all_ink() -> None:
    strokes = (
        Segment((0.0, 0.0), (10.0, 0.0), Linetype.VISIBLE),
        Segment((0.0, 0.0), (0.0, 7.0), Linetype.HIDDEN),
        Arc((5.0, 5.0), 2.0, 5.0, 4.0, Linetype.VISIBLE),
    )
    for change in (permuted, split):
        changed = change({Role.FRONT: strokes}, Random(1))[Role.FRONT]
        for kind in Linetype:
            this_strokes = [stroke for stroke in changed if stroke.linetype is kind]
            before = [stroke for stroke in strokes if stroke.linetype is kind]
            assert sum(s.length for s in this_strokes) == pytest.approx(
                sum(s.length for s in before)
            )
            points = np.concatenate([stroke.sample(0.01) for stroke in this_strokes])
            for place in np.concatenate([stroke.sample(0.5) for stroke in before]):
                assert np.hypot(*(points - place).T).min() < 0.01
    assert len(split({Role.FRONT: strokes}, Random(1))[Role.FRONT]) == 6


def test_measures_are_counted_for_the_right_shapes_alone() -> None:
    row: Row = {
        "group": "twins", "input": "scan", "px_mm": 0.1, "valid": True, "faces": 4,
        "true_faces": 4, "displaced": [0.0, 0.0, 0.004, 0.006] * 2, "farthest": 0.01,
        "uncertainty_mm": 0.005, "measures_source": "drawing",
    }  # fmt: skip
    assert is_right(row)
    other = [{**row, "faces": 5}, {**row, "farthest": 0.3}, {**row, "valid": False}]
    assert not any(map(is_right, other))
    lines = [line.split() for line in measures_table([row, *other]).splitlines()]
    stated = ["4", "1", "8", "0.060", "0.050", "75.0", "%", "75", "%", "1.20"]
    assert ["twins", "scan", *stated] in lines
    assert ["all", "by", "drawing", *stated] in lines
