"""The labels network as it is shipped."""

import json
from importlib.resources import files
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.sheet.labels import labels_network
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.labels_network import ink_labels, labels_problem, part_odds


def dimensioned() -> npt.NDArray[np.uint8]:
    """A rectangle in a wide pen with a dimension below it in a thin one."""
    grey = np.full((512, 640), 255, np.uint8)
    cv2.rectangle(grey, (150, 100), (450, 300), 0, 3)
    for x in (150, 450):
        cv2.line(grey, (x, 306), (x, 372), 0, 1, cv2.LINE_AA)
    cv2.arrowedLine(grey, (300, 360), (152, 360), 0, 1, cv2.LINE_AA, tipLength=0.08)
    cv2.arrowedLine(grey, (300, 360), (448, 360), 0, 1, cv2.LINE_AA, tipLength=0.08)
    cv2.putText(grey, "120", (275, 352), cv2.FONT_HERSHEY_SIMPLEX, 0.7, 0, 1, cv2.LINE_AA)
    return grey


def test_edges_are_told_from_a_dimension_and_its_number() -> None:
    labels = ink_labels(dimensioned())
    edges = np.array([[150.0, y] for y in range(120, 280)])
    line = np.array([[x, 360.0] for x in range(180, 270)])
    assert part_odds(labels.at(edges)).min() > 2.0
    assert part_odds(labels.at(line)).max() < -2.0
    written = dimensioned()[330:354, 270:330] < 100
    best = labels.best()[330:354, 270:330][written]
    assert (best == InkClass.TEXT).mean() > 0.9


def test_the_answer_is_the_same_every_time_and_adds_up() -> None:
    one, other = ink_labels(dimensioned()), ink_labels(dimensioned())
    assert np.array_equal(one.log_p, other.log_p)
    total = np.exp(one.log_p.astype(np.float64)).sum(axis=0)
    assert np.abs(total - 1.0).max() < 0.01


def test_tiles_say_what_the_whole_says(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = ink_labels(dimensioned())
    monkeypatch.setattr(labels_network, "_TILE", 320)
    parted = ink_labels(dimensioned())
    ink = dimensioned() < 100
    same = whole.best()[ink] == parted.best()[ink]
    assert same.mean() > 0.97


def test_blank_paper_is_paper_wherever_it_is() -> None:
    labels = ink_labels(np.full((70, 90), 255, np.uint8))
    assert labels.log_p.shape == (len(InkClass), 70, 90)
    assert (labels.log_p[InkClass.PAPER] == 0.0).all()


def test_points_outside_have_the_border() -> None:
    labels = ink_labels(dimensioned())
    outside, border = np.array([[-5.0, 900.0]]), np.array([[0.0, 511.0]])
    assert np.array_equal(labels.at(outside), labels.at(border))


def test_the_weights_are_whole_and_have_a_card() -> None:
    assert labels_problem() is None
    folder = files("gaussiancad_core.sheet.labels")
    card = json.loads(folder.joinpath("labels.json").read_text(encoding="utf-8"))
    digest = folder.joinpath("labels.onnx.sha256").read_text(encoding="ascii").strip()
    assert card["sha256"] == digest


@pytest.mark.parametrize("name", ["absent.onnx", "labels.onnx.sha256"])
def test_missing_and_damaged_weights_are_told(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setattr(labels_network, "_WEIGHTS", name)
    labels_problem.cache_clear()
    try:
        assert labels_problem() is not None
    finally:
        monkeypatch.undo()
        labels_problem.cache_clear()


@pytest.mark.parametrize(
    ("card", "factor"),
    [
        ({}, 1.0),
        ({"calibration": None}, 1.0),
        ({"calibration": {"temperature": 0.6}}, 0.6),
        ({"temperature": 0.4}, 0.4),
        (None, 1.0),
    ],
)
def test_the_card_may_say_how_far_log_odds_are_to_be_trusted(
    card: dict | None, factor: float, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if card is not None:
        (tmp_path / "labels.json").write_text(json.dumps(card), encoding="utf-8")
    monkeypatch.setattr(labels_network, "files", lambda _: tmp_path)
    labels_network.log_odds_factor.cache_clear()
    try:
        assert labels_network.log_odds_factor() == factor
    finally:
        labels_network.log_odds_factor.cache_clear()
