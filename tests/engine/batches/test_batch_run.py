"""Batches that are resumed, stopped, killed, and come too late."""

import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

import psutil
import pytest
from engine.batches.batch_runs import OPTIONS, command, rows

from gaussiancad_core.cli import main


def _run(*arguments: "str | Path") -> int:
    return main(["batch", *map(str, arguments)])


@pytest.fixture
def sheets(tmp_path: Path, plain_sheet: Path) -> Path:
    """A sheet that becomes a solid, one that is none, and one below in a folder."""
    folder = tmp_path / "sheets"
    (folder / "below").mkdir(parents=True)
    shutil.copy(plain_sheet, folder)
    (folder / "text.png").write_text("no picture")
    (folder / "below" / "text.png").write_text("no picture either")
    (folder / "notes.txt").write_text("no drawing")
    return folder


def _stamps(folder: Path) -> dict[str, int]:
    return {path.name: path.stat().st_mtime_ns for path in folder.iterdir()}


def test_what_is_done_and_whole_is_kept_and_all_else_is_done_again(
    sheets: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "out"
    assert _run(sheets, "--output", output, *OPTIONS, "--workers", "2") == 1
    assert capfd.readouterr().err == ""
    found = rows(output)
    assert sorted(row["exit_code"] for row in found.values()) == ["0", "3", "3"]
    assert found["block"]["status"] == "verified"
    page = (output / "index.html").read_text("utf-8")
    assert page.count("<tr class") == 3 and "block/preview.png" in page

    def again() -> None:
        assert _run(sheets, "--output", output, *OPTIONS, "--resume") == 1
        assert rows(output).keys() == found.keys()

    # A change of time alone says nothing: the content counts.
    os.utime(output / "block" / "report.json", (0, 0))
    before = _stamps(output / "block")
    again()
    assert _stamps(output / "block") == before
    # Nor does the manifest alone: the files tell what is whole.
    (output / "manifest.sqlite").write_bytes(b"no database at all" * 100)
    whole = (output / "block" / "solid.step").read_bytes()
    (output / "block" / "solid.step").write_bytes(b"")
    again()
    assert (output / "block" / "solid.step").read_bytes() == whole
    assert (output / "manifest.sqlite.damaged-1").read_bytes().startswith(b"no database")
    assert rows(output)["block"] | {"seconds": ""} == found["block"] | {"seconds": ""}


def _started(sheets: Path, output: Path) -> "subprocess.Popen[bytes]":
    """A batch whose first sheet is being worked on."""
    process = subprocess.Popen(
        command(sheets / "block.dxf", sheets / "text.png", "--output", output),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )
    deadline = time.monotonic() + 60
    while not list(output.glob("block/.gaussiancad-*")):
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
    found = rows(output)
    assert found["block"]["exit_code"] == "130" and "--resume" in found["block"]["message"]
    assert len(found) == 2


def test_nothing_outlives_a_batch_that_is_killed_and_the_next_one_goes_on(
    sheets: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "out"
    process = _started(sheets, output)
    family = psutil.Process(process.pid).children(recursive=True)
    assert family
    assert _run(sheets / "text.png", "--output", output) == 2
    assert "[batch-running]" in capfd.readouterr().err
    process.kill()
    process.wait()
    assert _survivors(family, 60.0) == []
    assert _run(sheets, "--output", output, *OPTIONS, "--resume") == 1
    assert rows(output)["block"]["status"] == "verified"
    assert not list(output.glob("block/.gaussiancad-*"))


@pytest.mark.parametrize(
    ("limit", "text"), [(("--seconds", "0.5"), "0.5 s"), (("--memory", "0.02"), "memory")]
)
def test_a_sheet_that_takes_too_much_is_ended_and_the_batch_is_not(
    limit: tuple[str, str], text: str, sheets: Path, tmp_path: Path
) -> None:
    assert _run(sheets / "block.dxf", "--output", tmp_path / "out", *limit) == 1
    (row,) = rows(tmp_path / "out").values()
    assert row["exit_code"] == "5" and row["status"] == "failed" and text in row["message"]
