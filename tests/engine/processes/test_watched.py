"""A command whose process dies is told, with the stage that it was in, and leaves a report."""

import json
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import psutil
import pytest

from gaussiancad_core.cli import main
from gaussiancad_core.processes.watched import watch

_PATIENCE_S = 60.0

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="processes die otherwise there")


@pytest.fixture(autouse=True)
def _hung_up() -> Iterator[None]:
    """Under nohup a process ignores SIGHUP, and those that it starts do, too."""
    before = signal.signal(signal.SIGHUP, signal.SIG_DFL)
    yield
    signal.signal(signal.SIGHUP, before)


def _engine_of(started: subprocess.Popen[bytes]) -> psutil.Process:
    """The process that does the work."""
    end = time.monotonic() + _PATIENCE_S
    while time.monotonic() < end:
        for child in psutil.Process(started.pid).children():
            if "gaussiancad_core.processes.watched" in child.cmdline():
                return child
        time.sleep(0.02)
    raise AssertionError("no engine was started")


def _started(sheet: Path, output: Path, *options: str, **streams: int) -> "subprocess.Popen[bytes]":
    command = [sys.executable, "-m", "gaussiancad_core", "reconstruct", str(sheet)]
    return subprocess.Popen([*command, "--output", str(output), *options], **streams)


@pytest.mark.parametrize(
    ("number", "code", "said"), [(signal.SIGSEGV, 6, "engine-died"), (signal.SIGKILL, 5, "killed")]
)
def test_a_process_that_dies_is_told_with_its_stage(
    plain_sheet: Path, tmp_path: Path, number: signal.Signals, code: int, said: str
) -> None:
    # The paper's recipe looks for no solid: there is one way only.
    surface = ["--result", "surface", "--recipe", "paper"]
    started = _started(
        plain_sheet, tmp_path, *surface, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    engine = _engine_of(started)
    # What was read is put in place as soon as it is known.
    while not (tmp_path / "reading.json").exists():
        time.sleep(0.05)
    engine.send_signal(number)
    _, errors = started.communicate(timeout=_PATIENCE_S)
    assert started.returncode == code
    assert errors.count(b"\n") == 1 and f"[{said}]".encode() in errors
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert report["status"] == "failed" and report["stage"]
    assert [item["code"] for item in report["reasons"]] == [said]
    # What was finished stays, nothing half is left, and the next run finds nothing foreign.
    assert {path.name for path in tmp_path.iterdir()} == {"reading.json", "report.json"}
    again = ["reconstruct", str(plain_sheet), "--output", str(tmp_path), "--result", "solid"]
    assert main(again) == 0


def _until_solid(started: "subprocess.Popen[bytes]") -> None:
    """Wait until the solid is looked for."""
    for line in started.stdout:
        event = json.loads(line)
        if event["event"] == "stage" and event["name"] == "solid":
            return
    raise AssertionError("the run ended before")


@pytest.mark.parametrize("deaths", [1, 2])
def test_a_way_in_which_a_library_ends_the_run_is_left_out(
    plain_sheet: Path, tmp_path: Path, deaths: int
) -> None:
    options = ("--result", "solid", "--events")
    # The end of stdin would end the run.
    streams = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    started = _started(plain_sheet, tmp_path, *options, **streams)
    for _ in range(deaths):
        _until_solid(started)
        _engine_of(started).send_signal(signal.SIGSEGV)
    if deaths == 1:
        _until_solid(started)
    started.stdout.read()
    code = started.wait(_PATIENCE_S)
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    if deaths == 1:
        assert (code, report["status"], report["solid"]["valid"]) == (0, "approximate", True)
        assert "solid-way-left-out" in [item["code"] for item in report["reasons"]]
    else:
        assert (code, report["status"], report["stage"]) == (6, "failed", "solid")
    assert not list(tmp_path.glob(".gaussiancad-*"))


_STAGES = """
import os, resource, sys, tempfile, time
from gaussiancad_core.processes.watched import StageNotes
resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
file = tempfile.TemporaryFile()
notes = StageNotes(file.fileno(), 1.0)
for name in sys.argv[1:]:
    notes.send("stage", name=name)
until = time.process_time() + 3.0
while time.process_time() < until:
    pass
"""
"""A run that hangs in the last of its stages."""


@pytest.mark.parametrize(
    ("stages", "code"), [(["read", "solid"], -signal.SIGXCPU), (["solid", "check"], 0)]
)
def test_the_search_for_the_solid_alone_has_seconds_of_the_processor(
    stages: list[str], code: int
) -> None:
    ended = subprocess.run([sys.executable, "-c", _STAGES, *stages], check=False)
    assert ended.returncode == code


def test_what_a_command_prints_and_its_exit_code_are_its_own(
    capfd: pytest.CaptureFixture[str],
) -> None:
    ended = watch(["compare", "missing.step", "missing.stl"])
    assert (ended.exit_code, ended.signal, ended.stage) == (3, "", "")
    assert "[file-missing]" in capfd.readouterr().err


@pytest.mark.parametrize(
    ("number", "later"), [("SIGINT", False), ("SIGTERM", True), ("SIGHUP", False)]
)
def test_a_signal_to_the_command_alone_cancels_it(
    plain_sheet: Path, tmp_path: Path, number: str, later: bool
) -> None:
    started = _started(plain_sheet, tmp_path, stderr=subprocess.PIPE)
    engine = _engine_of(started)
    while later and not any(tmp_path.iterdir()):
        time.sleep(0.05)
    started.send_signal(getattr(signal, number))
    _, stated = started.communicate(timeout=_PATIENCE_S)
    assert started.returncode == 130
    lines = stated.decode().splitlines()
    assert len(lines) == 1 and "[cancelled]" in lines[0]
    assert not engine.is_running()
