"""Batches that are resumed, stopped, killed, and come too late."""

import csv
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

SAMPLES = Path(__file__).parents[3] / "resources" / "samples"
OPTIONS = ("--result", "solid", "--length", "x=80")


def _command(*arguments: "str | Path") -> list[str]:
    return [sys.executable, "-m", "gaussiancad_core", "batch", *map(str, arguments)]


def _run(*arguments: "str | Path") -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        _command(*arguments), capture_output=True, encoding="utf-8", check=False, timeout=120
    )


def _rows(output: Path) -> dict[str, dict[str, str]]:
    with open(output / "report.csv", encoding="utf-8", newline="") as file:
        return {row["name"]: row for row in csv.DictReader(file)}


@pytest.fixture
def sheets(tmp_path: Path) -> Path:
    """A sheet that becomes a solid, one that is none, and one below in a folder."""
    folder = tmp_path / "sheets"
    (folder / "below").mkdir(parents=True)
    shutil.copy(SAMPLES / "l-bracket.png", folder)
    (folder / "text.png").write_text("no picture")
    (folder / "below" / "text.png").write_text("no picture either")
    (folder / "notes.txt").write_text("no drawing")
    return folder


def _stamps(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in folder.iterdir()}


def test_what_is_done_and_whole_is_kept_and_all_else_is_done_again(
    sheets: Path, tmp_path: Path
) -> None:
    output = tmp_path / "out"
    first = _run(sheets, "--output", output, *OPTIONS, "--workers", "2")
    assert first.returncode == 1 and first.stderr == ""
    rows = _rows(output)
    assert sorted(row["exit_code"] for row in rows.values()) == ["0", "3", "3"]
    assert rows["l-bracket"]["status"] == "verified"
    page = (output / "index.html").read_text("utf-8")
    assert page.count("<tr class") == 3 and "l-bracket/preview.png" in page
    before = _stamps(output / "l-bracket")

    def again() -> None:
        assert _run(sheets, "--output", output, *OPTIONS, "--resume").returncode == 1
        assert _rows(output).keys() == rows.keys()

    again()
    assert _stamps(output / "l-bracket") == before
    # A change of time alone says nothing: the content counts.
    os.utime(output / "l-bracket" / "solid.step", (0, 0))
    again()
    assert _rows(output)["l-bracket"]["status"] == "verified"
    whole = (output / "l-bracket" / "solid.step").read_bytes()
    (output / "l-bracket" / "solid.step").write_bytes(b"")
    again()
    assert (output / "l-bracket" / "solid.step").read_bytes() == whole
    (output / "manifest.sqlite").write_bytes(b"no database at all" * 100)
    again()
    assert (output / "manifest.sqlite.damaged-1").read_bytes().startswith(b"no database")
    assert _rows(output)["l-bracket"] | {"seconds": ""} == rows["l-bracket"] | {"seconds": ""}


def _started(sheets: Path, output: Path) -> "subprocess.Popen[bytes]":
    """A batch whose first sheet is being worked on."""
    process = subprocess.Popen(
        _command(sheets / "l-bracket.png", sheets / "text.png", "--output", output),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )
    deadline = time.monotonic() + 60
    while not list(output.glob("l-bracket/.gaussiancad-*")):
        assert process.poll() is None and time.monotonic() < deadline
        time.sleep(0.05)
    return process


def _survivors(family: list[psutil.Process], within: float) -> list[psutil.Process]:
    return psutil.wait_procs(family, timeout=within)[1]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_all_with_a_report_that_names_every_sheet(
    number: signal.Signals, sheets: Path, tmp_path: Path
) -> None:
    output = tmp_path / "out"
    process = _started(sheets, output)
    family = psutil.Process(process.pid).children(recursive=True)
    process.send_signal(number)
    assert process.wait(timeout=60) == 130
    assert _survivors(family, 60.0) == []
    assert process.stderr.read().count(b"\n") == 1
    rows = _rows(output)
    assert rows["l-bracket"]["exit_code"] == "130" and "--resume" in rows["l-bracket"]["message"]
    assert len(rows) == 2


def test_nothing_outlives_a_batch_that_is_killed_and_the_next_one_goes_on(
    sheets: Path, tmp_path: Path
) -> None:
    output = tmp_path / "out"
    process = _started(sheets, output)
    family = psutil.Process(process.pid).children(recursive=True)
    assert family
    refused = _run(sheets / "text.png", "--output", output)
    assert refused.returncode == 2 and "[batch-running]" in refused.stderr
    process.kill()
    process.wait()
    assert _survivors(family, 60.0) == []
    done = _run(sheets, "--output", output, *OPTIONS, "--resume")
    assert done.returncode == 1
    assert _rows(output)["l-bracket"]["status"] == "verified"
    assert not list(output.glob("l-bracket/.gaussiancad-*"))


@pytest.mark.parametrize(
    ("limit", "text"), [(("--seconds", "0.5"), "0.5 s"), (("--memory", "0.02"), "memory")]
)
def test_a_sheet_that_takes_too_much_is_ended_and_the_batch_is_not(
    limit: tuple[str, str], text: str, sheets: Path, tmp_path: Path
) -> None:
    done = _run(sheets / "l-bracket.png", "--output", tmp_path / "out", *limit)
    assert done.returncode == 1
    (row,) = _rows(tmp_path / "out").values()
    assert row["exit_code"] == "5" and row["status"] == "failed" and text in row["message"]
