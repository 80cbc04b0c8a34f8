"""What a run left counts as finished only as it was left."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from gaussiancad_core.report.run_report import engine_facts
from gaussiancad_core.storage.resume_check import file_facts, finished_report

_SETTINGS = {"seed": 3}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "cameras").mkdir()
    for name in ("solid.step", "cameras/front.png"):
        (tmp_path / name).write_text(f"content of {name}")
    values = {
        "status": "verified",
        "settings": _SETTINGS,
        "engine": engine_facts(_SETTINGS, "abc"),
        "files": file_facts([tmp_path / "solid.step", tmp_path / "cameras"]),
    }
    (tmp_path / "report.json").write_text(json.dumps(values))
    return tmp_path


def _changed(key: str, value: object) -> Callable[[Path], None]:
    def change(folder: Path) -> None:
        path = folder / "report.json"
        path.write_text(json.dumps({**json.loads(path.read_text()), key: value}))

    return change


def test_an_untouched_folder_is_finished(folder: Path) -> None:
    report = finished_report(folder / "report.json", _SETTINGS, "abc")
    assert report is not None and set(report["files"]) == {"solid.step", "cameras/front.png"}
    assert finished_report(folder / "report.json", {"seed": 4}, "abc") is None
    assert finished_report(folder / "report.json", _SETTINGS, "abd") is None


@pytest.mark.parametrize(
    "spoil",
    [
        lambda folder: (folder / "solid.step").unlink(),
        lambda folder: (folder / "cameras" / "front.png").write_text(""),
        lambda folder: (folder / "solid.step").write_text("Content of solid.step"),
        lambda folder: (folder / "report.json").unlink(),
        lambda folder: (folder / "report.json").write_text("null"),
        lambda folder: (folder / "report.json").write_bytes(b"\xff{"),
        _changed("status", "failed"),
        _changed("engine", {"version": "0"}),
        _changed("files", None),
        _changed("files", {"solid.step": None}),
    ],
)
def test_what_is_missing_changed_or_of_another_engine_is_not(
    folder: Path, spoil: Callable[[Path], None]
) -> None:
    spoil(folder)
    assert finished_report(folder / "report.json", _SETTINGS, "abc") is None
