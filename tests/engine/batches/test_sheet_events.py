"""What a batch tells whoever started it."""

import csv
import json
import os
import shutil
import sqlite3
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import psutil
import pytest

from gaussiancad_core.batches.batch_table import BatchRow

OPTIONS = ("--result", "solid", "--length", "x=80", "--workers", "1")


def _command(*arguments: "str | Path") -> list[str]:
    return [sys.executable, "-m", "gaussiancad_core", "batch", "--events", *map(str, arguments)]


def _events(*arguments: "str | Path", code: int) -> list[dict[str, Any]]:
    # The end of stdin would stop the batch.
    reading, writing = os.pipe()
    try:
        ended = subprocess.run(
            _command(*arguments), stdin=reading, capture_output=True, check=False, timeout=120
        )
    finally:
        os.close(reading)
        os.close(writing)
    assert ended.returncode == code, ended.stderr
    return [json.loads(line) for line in ended.stdout.splitlines()]


@pytest.fixture
def sheets(tmp_path: Path, plain_sheet: Path) -> Path:
    """A sheet that becomes a solid, and one whose name is no text and whose content is none."""
    folder = tmp_path / "sheets"
    folder.mkdir()
    shutil.copy(plain_sheet, folder)
    Path(os.fsdecode(os.fsencode(folder) + b"/text\xe9.png")).write_bytes(b"no picture")
    return folder


def test_each_sheet_is_told_with_its_row_and_files_also_where_it_was_kept(
    sheets: Path, tmp_path: Path
) -> None:
    output = tmp_path / "out"
    hello, first, second, result = _events(sheets, "--output", output, *OPTIONS, code=1)
    assert hello["event"] == "hello" and hello["protocol"] == 1
    assert result == {
        "event": "result",
        "path": str(output / "report.csv"),
        "sheets": 2,
        "failed": 1,
    }
    assert {"solid.step", "report.json"} <= set(first["files"])
    assert first["files"] == sorted(
        path.relative_to(output / "block").as_posix()
        for path in (output / "block").rglob("*")
        if path.is_file()
    )
    assert first["folder"] == str(output / "block")
    assert second["files"] == [] and second["code"] == "not-an-image"
    assert second["message"].endswith("export the drawing as one of them")
    assert os.fsencode(second["sheet"]) == os.fsencode(sheets) + b"/text\xe9.png"
    with open(output / "report.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    for stated, row in zip((first, second), rows, strict=True):
        assert list(row) == list(BatchRow.__dataclass_fields__)
        for key in row.keys() - {"sheet"}:
            assert str(stated[key]) == row[key]
    given = [(e["event"], e["kept"], e["done"], e["count"]) for e in (first, second)]
    assert given == [("sheet", False, 1, 2), ("sheet", False, 2, 2)]
    _, *kept, _ = _events(sheets, "--output", output, *OPTIONS, "--resume", code=1)
    pace = {"rate": 0.0, "eta_s": None}
    assert kept == [first | {"kept": True} | pace, second | {"kept": True} | pace]
    assert first["rate"] > 0.0 and first["eta_s"] > 0.0 and second["eta_s"] == 0.0
    _forget_codes(output / "manifest.sqlite")
    _, *again, _ = _events(sheets, "--output", output, *OPTIONS, "--resume", code=1)
    # What was finished is known by its own report; what failed is done again.
    volatile = {"seconds": 0.0, **pace}
    assert [e | volatile for e in again] == [first | {"kept": True} | volatile, second | volatile]


def _forget_codes(manifest: Path) -> None:
    """Make the manifest one of a version that noted no codes."""
    base = sqlite3.connect(manifest)
    with base:
        base.execute("update sheet set done = json_remove(done, '$.code')")
    base.close()


@pytest.mark.parametrize("word", [b"cancel\n", b""])
def test_the_word_cancel_and_the_end_of_stdin_end_all_with_a_whole_report(
    word: bytes, sheets: Path, tmp_path: Path
) -> None:
    output = tmp_path / "out"
    process = subprocess.Popen(
        _command(sheets, "--output", output, *OPTIONS),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    deadline = time.monotonic() + 60
    while not list(output.glob("block/.gaussiancad-*")):
        assert process.poll() is None and time.monotonic() < deadline
        time.sleep(0.05)
    family = psutil.Process(process.pid).children(recursive=True)
    assert family
    printed, _ = process.communicate(word, timeout=60)
    assert process.returncode == 130
    assert psutil.wait_procs(family, timeout=60)[1] == []
    assert json.loads(printed.splitlines()[-1])["code"] == "cancelled"
    with open(output / "report.csv", encoding="utf-8", newline="") as file:
        stated = [(row["exit_code"], row["code"]) for row in csv.DictReader(file)]
    assert stated == [("130", "cancelled")] * 2
    base = sqlite3.connect(output / "manifest.sqlite")
    assert base.execute("pragma integrity_check").fetchall() == [("ok",)]
    base.close()
