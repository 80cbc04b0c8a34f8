"""A line of which the labels network is not sure: written, explained, never verified, corrected."""

import hashlib
import json
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.cli import main
from gaussiancad_core.recognition import picture_views
from gaussiancad_core.sheet.labels import labelled_ink
from gaussiancad_core.sheet.labels.class_shares import ClassShares
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.labels_network import InkLabels, ink_labels

SHEET = Path(__file__).parents[3] / "resources" / "samples" / "wedge-block.png"

_EDGE = 671.4, 300.0
"""A place on the edge where the slope begins, in the top view, px."""

_CLEAR = np.s_[88:470, 660:684]
"""Around that edge, without its ends."""

_WHOLE = np.s_[80:478, 660:684]
"""The same with its ends: they would say what the rest of it is."""


def doubting(
    margin: float, where: tuple[slice, slice] = _CLEAR
) -> Callable[[npt.NDArray[np.uint8]], InkLabels]:
    """The network, with log-odds of visible against dimension of its own for one edge."""

    def labelled(grey: npt.NDArray[np.uint8]) -> InkLabels:
        log_p = ink_labels(grey).log_p.copy()
        log_p[:, *where] = -12.0
        log_p[InkClass.VISIBLE, *where] = -0.7
        log_p[InkClass.DIMENSION, *where] = -0.7 - margin
        return InkLabels(log_p)

    return labelled


def values(path: Path) -> dict[str, Any]:
    return json.loads(path.read_text("utf-8"))


def made(sheet: Path, output: Path, *options: str | Path) -> dict[str, Any]:
    words = ["reconstruct", sheet, "--output", output, "--result", "solid", "--length", "x=90"]
    assert main([str(word) for word in (*words, *options)]) == 0
    return values(output / "report.json")


def edge_of(reading: dict[str, Any]) -> dict[str, Any]:
    """The stroke at the doubtful edge."""
    (found,) = (
        item
        for item in reading["strokes"]
        if "line" in item and all(abs(x - _EDGE[0]) < 3.0 for x, _ in item["line"])
    )
    return found


def codes(report: dict[str, Any]) -> list[str]:
    return [item["code"] for item in report["reasons"]]


@pytest.fixture(scope="module", autouse=True)
def _shares_of_classes_tell_nothing() -> Iterator[None]:
    """Else a sheet without dimensions would settle whether an edge is one."""
    plain = ClassShares(np.zeros(len(InkClass)))
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(labelled_ink, "learnt_shares", lambda labelled, width: plain)
        yield


@pytest.fixture(scope="module")
def read(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a run over a sheet with a doubtful edge; the sheet is beside it."""
    folder = tmp_path_factory.mktemp("doubtful")
    shutil.copy(SHEET, folder / "wedge.png")
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(picture_views, "ink_labels", doubting(0.2))
        made(folder / "wedge.png", folder / "run")
    return folder


def test_it_is_written_with_its_confidence_and_what_it_would_be(read: Path) -> None:
    reading = values(read / "run" / "reading.json")
    edge = edge_of(reading)
    assert (edge["view"], edge["kind"], edge["source"]) == ("top", "visible", "raster")
    assert 0.5 < edge["confidence"] < 0.62
    assert (edge["why"]["by"], edge["why"]["otherwise"]) == ("network", "dimension")
    assert 0.0 < edge["why"]["margin"] < 0.5
    # It is the only one: all others are known.
    assert min(item.get("confidence", 1.0) for item in reading["strokes"] if item != edge) > 0.9
    (problem,) = (item for item in reading["problems"] if item["code"] == "labels-doubtful")
    assert problem["args"]["count"] == 1 and "kind" in problem["offers"]


def test_the_solid_is_whole_and_yet_not_verified(read: Path) -> None:
    report = values(read / "run" / "report.json")
    assert report["solid"]["valid"] and report["solid"]["closed"]
    assert report["status"] == "approximate"
    assert codes(report) == ["labels-doubtful"]


def test_explain_says_why_and_what_it_would_be(
    read: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    at = "{},{}".format(*_EDGE)
    assert main(["explain", str(read / "run"), "--at", at]) == 0
    said = capsys.readouterr().out
    for words in ("A visible line", "% sure", "labels network", "it is a dimension line"):
        assert words in said


def test_the_doubt_goes_with_the_reading(read: Path, tmp_path: Path) -> None:
    taken = made(read / "wedge.png", tmp_path / "taken", "--reading", read / "run" / "reading.json")
    direct = values(read / "run" / "report.json")
    assert taken["status"] == "approximate"
    assert taken["reasons"] == direct["reasons"]
    again = edge_of(values(tmp_path / "taken" / "reading.json"))
    assert again == edge_of(values(read / "run" / "reading.json"))


def is_visible(edge: dict[str, Any]) -> dict[str, Any]:
    """The correction that says so."""
    target = {"id": edge["id"], "line": edge["line"]}
    return {"op": "kind", "target": target, "to": "visible"}


def corrected(read: Path, folder: Path, operation: dict[str, Any]) -> dict[str, Any]:
    """The report of a run in a folder over a reading and one correction of it."""
    stated = {
        "schema": "gaussiancad-corrections/1",
        "sheet_sha256": hashlib.sha256(SHEET.read_bytes()).hexdigest(),
        "ops": [operation],
    }
    path = folder / "corrections.json"
    path.write_text(json.dumps(stated), encoding="utf-8")
    return made(SHEET, folder / "out", "--reading", read, "--corrections", path)


def test_a_person_settles_it(read: Path, tmp_path: Path) -> None:
    reading = read / "run" / "reading.json"
    report = corrected(reading, tmp_path, is_visible(edge_of(values(reading))))
    assert report["status"] == "verified"
    said = edge_of(values(tmp_path / "out" / "reading.json"))
    assert said["source"] == "given"
    assert said["confidence"] == 1.0 and "why" not in said


def test_a_correction_elsewhere_leaves_it(read: Path, tmp_path: Path) -> None:
    report = corrected(read / "run" / "reading.json", tmp_path, {"op": "unit", "value": "mm"})
    assert report["status"] == "approximate"
    assert codes(report) == ["labels-doubtful"]


def test_an_annotation_may_be_an_edge_and_a_person_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(picture_views, "ink_labels", doubting(-0.2, _WHOLE))
    assert main(["read", str(SHEET), "--output", str(tmp_path)]) == 0
    reading = values(tmp_path / "reading.json")
    edge = edge_of(reading)
    assert (edge["view"], edge["kind"]) == (None, "dimension")
    assert 0.5 < edge["confidence"] < 0.62
    assert edge["why"]["otherwise"] == "visible"
    assert "labels-doubtful" in [item["code"] for item in reading["problems"]]
    report = corrected(tmp_path / "reading.json", tmp_path, is_visible(edge))
    assert report["status"] == "verified"
    assert edge_of(values(tmp_path / "out" / "reading.json"))["view"] == "top"
