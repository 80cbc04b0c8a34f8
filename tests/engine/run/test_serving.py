"""An engine that stays: requests and answers."""

import json
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from gaussiancad_core.processes.events import Silence
from gaussiancad_core.readings.correction_operations import CORRECTIONS_SCHEMA
from gaussiancad_core.recognition import load_sheet
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.run import serving
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet


class _Engine:
    """A process that serves."""

    def __init__(self, sheet: Path) -> None:
        self.sheet = sheet
        self.events: list[dict[str, Any]] = []
        self._number = 0
        self.process = subprocess.Popen(
            [sys.executable, "-m", "gaussiancad_core", "serve"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def send(self, line: str) -> None:
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def answer(self) -> dict[str, Any]:
        for line in self.process.stdout:
            event = json.loads(line)
            self.events.append(event)
            if event["event"] == "answer":
                return event
        raise AssertionError("the engine went away")

    def ask(self, do: str, **fields: object) -> dict[str, Any]:
        self._number += 1
        self.send(json.dumps({"id": self._number, "do": do, "sheet": str(self.sheet), **fields}))
        found = self.answer()
        assert found["id"] == self._number
        return found


@pytest.fixture
def engine(plain_picture: Path, tmp_path: Path) -> Iterator[_Engine]:
    sheet = Path(shutil.copy(plain_picture, tmp_path))
    this_engine = _Engine(sheet)
    yield this_engine
    this_engine.process.kill()
    this_engine.process.wait()


def _corrections(path: Path, reading: dict[str, Any], *operations: dict[str, Any]) -> str:
    entry = {
        "schema": CORRECTIONS_SCHEMA,
        "sheet_sha256": reading["sheet"]["sha256"],
        "ops": list(operations),
    }
    path.write_text(json.dumps(entry), encoding="utf-8")
    return str(path)


def test_a_sheet_is_shown_read_corrected_and_solved(engine: _Engine, tmp_path: Path) -> None:
    out = str(tmp_path / "out")
    shown = engine.ask("render", output=out, most=200)
    assert Path(shown["picture"]).read_bytes().startswith(b"\x89PNG")
    assert shown["size"] == [520, 480]
    read = engine.ask("read", output=out)
    assert read["refused"] == 0
    reading = json.loads(Path(read["reading"]).read_text(encoding="utf-8"))
    front = next(item for item in reading["views"] if item["role"] == "front")
    line = next(item for item in reading["strokes"] if item["view"] == "front" and "line" in item)
    (x0, y0), (x1, y1) = line["line"]
    middle = [(x0 + x1) / 2, (y0 + y1) / 2 + 1]
    traced = engine.ask("trace", at=middle, box=front["box"])["shape"]
    ends = sorted(map(tuple, traced["line"]))
    assert ends == [pytest.approx(item, abs=0.5) for item in sorted([(x0, y0), (x1, y1)])]
    assert engine.ask("trace", at=[5, 5], box=front["box"])["shape"] is None

    again = {"op": "view", "id": "mine", "role": "front", "box": front["box"]}
    boxed = _corrections(
        tmp_path / "box.json", reading, {"op": "view", "id": "front", "role": "ignore"}, again
    )
    reread = engine.ask("reread", corrections=boxed, output=str(tmp_path / "boxed"))
    corrected = json.loads(Path(reread["reading"]).read_text(encoding="utf-8"))
    assert corrected["corrected"] == 2
    assert {item["id"] for item in corrected["views"] if item["role"] == "front"} == {"mine"}

    stated = _corrections(
        tmp_path / "told.json",
        reading,
        {"op": "scale", "points": [[0, 0], [100, 0]], "length_mm": 50.0},
    )
    solved = engine.ask("solve", reading=read["reading"], corrections=stated, output=out + "/part")
    assert solved["status"] == "verified"
    report = json.loads(Path(solved["report"]).read_text(encoding="utf-8"))
    assert report["scale_mm_per_pixel"] == pytest.approx(0.5)
    assert "corrected" in {item["code"] for item in report["warnings"]}
    assert {event["id"] for event in engine.events if event["event"] == "stage"} >= {2, 6}
    engine.process.stdin.close()
    assert engine.process.wait(60) == 0


def test_what_cannot_be_is_answered_and_the_engine_stays(engine: _Engine, tmp_path: Path) -> None:
    engine.send("no json")
    assert engine.answer()["error"]["code"] == "unknown-request"
    engine.process.stdin.flush()
    engine.process.stdin.buffer.write(b'{"id": 1, "do": "\xff\xfe\x00"}\n')
    engine.process.stdin.flush()
    assert engine.answer()["error"]["code"] == "unknown-request"
    assert engine.ask("dance")["error"]["code"] == "unknown-request"
    engine.sheet = tmp_path / "gone.png"
    assert engine.ask("read", output=str(tmp_path))["error"]["code"] == "file-missing"
    engine.sheet = Path(shutil.copy(tmp_path / "block.png", tmp_path / "here.png"))
    damaged = tmp_path / "damaged.json"
    damaged.write_text("[]", encoding="utf-8")
    found = engine.ask("reread", corrections=str(damaged), output=str(tmp_path))
    assert found["error"]["code"] == "corrections-not-read"
    assert "reading" in engine.ask("read", output=str(tmp_path / "out"))


def test_a_request_that_goes_on_ends_with_its_window(engine: _Engine, tmp_path: Path) -> None:
    request = {"id": 1, "do": "solve", "sheet": str(engine.sheet), "output": str(tmp_path / "out")}
    engine.send(json.dumps(request))
    for line in engine.process.stdout:
        if json.loads(line).get("event") == "stage":
            break
    engine.process.stdin.close()
    assert engine.process.wait(60) == 130


def test_sheets_stay_open_side_by_side(
    plain_picture: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []

    def open_sheet(job: Job, notes: RunNotes) -> OpenedSheet:
        opened.append(job.sheet.stem)
        return load_sheet.open_sheet(job, notes)

    monkeypatch.setattr(serving, "open_sheet", open_sheet)
    handler = serving.RequestHandler()

    def render(name: str) -> None:
        sheet = tmp_path / f"{name}.png"
        if not sheet.exists():
            shutil.copy(plain_picture, sheet)
        request = serving.Request(id=1, do="render", sheet=str(sheet), output=str(tmp_path))
        handler.answer(request, Silence())

    for name in "abab":
        render(name)
    assert opened == ["a", "b"]
    for name in "cde":
        render(name)
    render("b")
    assert opened == ["a", "b", "c", "d", "e"], "the one that was asked for longest ago was closed"
    render("a")
    assert opened[-1] == "a"
