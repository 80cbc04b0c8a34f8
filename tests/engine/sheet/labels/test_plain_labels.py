"""Without the network: sizes, widths and ends tell what they can, and the run says so."""

import json
from pathlib import Path

import numpy as np
import pytest

from gaussiancad_core.cli import main
from gaussiancad_core.messages import Message
from gaussiancad_core.recognition import picture_views
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.plain_labels import plain_labels


def test_letters_in_a_row_are_writing_and_lines_are_not(sketch) -> None:  # noqa: ANN001
    drawn = sketch(300, 200).lines((20, 20), (280, 20), (280, 120), (20, 120), (20, 20))
    for x in (60.0, 76.0, 92.0):
        drawn.lines((x, 150), (x + 9, 150), (x + 9, 168), (x, 168), (x, 150))
    drawn.broken((40, 70), (260, 70), (14, 8), 3.0)
    best = plain_labels(clean_sheet(drawn.grey)).best()
    assert best[150, 64] == InkClass.TEXT
    assert best[20, 150] == InkClass.VISIBLE
    assert best[70, 46] == InkClass.HIDDEN


def test_a_sheet_of_one_pen_is_read_in_doubt_and_the_missing_network_is_told(
    plain_picture: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(picture_views, "labels_problem", lambda: Message("the weights are missing"))
    words = ["reconstruct", str(plain_picture), "--output", str(tmp_path)]
    assert main([*words, "--result", "solid", "--length", "x=80"]) == 0
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert "labels-missing" in [item["code"] for item in report["warnings"]]
    assert "labels-doubtful" in [item["code"] for item in report["reasons"]]
    assert report["status"] == "approximate"
    assert set(report["views"]) == {"front", "top", "right"}
    assert np.isfinite(report["solid"]["volume_mm3"])
