"""Recordings of ``corrected``: the tutorial's sheets, corrected by gestures alone."""

import json
from pathlib import Path

import pytest

from benchmarks.ask.corrected import RECORDINGS, ROOT, measured

_TRUTH = ROOT / "resources" / "samples" / "l-bracket.step"


@pytest.mark.parametrize("name", ["tutorial/2-lines-missing.png", "tutorial/3-views-moved.png"])
def test_the_tutorials_sheets_become_the_exact_part(name: str) -> None:
    steps = json.loads(Path(RECORDINGS).read_text(encoding="utf-8"))[name]
    row = measured(name, ROOT / "docs" / name, _TRUTH, steps)
    assert row.status == "verified" and not row.is_false
    assert row.iou == pytest.approx(1.0, abs=1e-4)
    assert row.operations <= 4
