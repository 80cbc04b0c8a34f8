"""Processes that are forked from one that has imported all, and what becomes of them."""

import os
import signal
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import psutil
import pytest

from gaussiancad_core.processes.process_start import (
    ForkedProcess,
    ForkServer,
    Interpreters,
    Process,
    Starter,
    starter,
)
from gaussiancad_core.processes.supervisor import ProcessLimits, Supervisor

PREFERRED = ("gaussiancad_core.cli.explain",)
LIMITS = ProcessLimits(4 << 30, 120.0)

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="forks only there")


@pytest.fixture
def server() -> Iterator[ForkServer]:
    fork_server = ForkServer(PREFERRED)
    yield fork_server
    fork_server.close()


def _started(starter: Starter, *arguments: str) -> tuple[Process, "tempfile._TemporaryFileWrapper"]:
    errors = tempfile.TemporaryFile()  # noqa: SIM115
    return starter.start(list(arguments), 1 << 30, -3, errors), errors


def _said(errors: "tempfile._TemporaryFileWrapper") -> str:
    errors.seek(0)
    return errors.read().decode()


def _long(sheet: Path, folder: Path) -> list[str]:
    return ["reconstruct", "--events", str(sheet), "--output", str(folder), "--result", "surface"]


def test_a_forked_process_ends_as_an_interpreter_does(server: ForkServer, tmp_path: Path) -> None:
    for arguments in (["explain", str(tmp_path / "none")], ["explain"], ["--help"]):
        stated = []
        for item in (server, Interpreters()):
            process, errors = _started(item, *arguments)
            stated.append((process.wait(60.0), _said(errors)))
        assert stated[0] == stated[1]


def test_many_are_told_apart(server: ForkServer, tmp_path: Path) -> None:
    started = [_started(server, "explain", str(tmp_path / str(number))) for number in range(6)]
    assert all(isinstance(process, ForkedProcess) for process, _ in started)
    assert len({process.pid for process, _ in started}) == 6
    for number, (process, errors) in enumerate(started):
        assert process.wait(60.0) == 3
        assert str(tmp_path / str(number)) in _said(errors)


def test_a_process_that_is_killed_is_told_by_its_signal(
    server: ForkServer, plain_sheet: Path, tmp_path: Path
) -> None:
    process, _ = _started(server, *_long(plain_sheet, tmp_path / "out"))
    assert process.poll() is None
    process.kill()
    assert process.wait(10.0) == -signal.SIGKILL


def test_processes_die_with_their_server_and_others_are_started_without(
    server: ForkServer, plain_sheet: Path, tmp_path: Path
) -> None:
    process, _ = _started(server, *_long(plain_sheet, tmp_path / "out"))
    this_process = psutil.Process(process.pid)
    parent = this_process.parent()
    assert parent is not None
    parent.kill()
    assert process.wait(10.0) == -signal.SIGKILL
    until = time.monotonic() + 60.0
    while this_process.is_running() and this_process.status() != psutil.STATUS_ZOMBIE:
        assert time.monotonic() < until
        time.sleep(0.05)
    other, errors = _started(server, "explain", str(tmp_path / "none"))
    assert not isinstance(other, ForkedProcess)
    assert other.wait(60.0) == 3
    assert _said(errors).count("\n") == 1


def test_what_nobody_waits_for_is_cancelled(
    server: ForkServer, plain_sheet: Path, tmp_path: Path
) -> None:
    process, _ = _started(server, *_long(plain_sheet, tmp_path / "out"))
    process.stdin.close()
    assert process.wait(30.0) == 130


def test_modules_with_threads_are_not_forked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "threaded.py").write_text(
        "import threading, time\n"
        "threading.Thread(target=time.sleep, args=(600,), daemon=True).start()\n"
    )
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(tmp_path), *sys.path]))
    with pytest.raises(OSError, match="forked"):
        ForkServer(["threaded"])
    assert isinstance(starter(["threaded"]), Interpreters)
    assert isinstance(starter(()), Interpreters)


def test_the_modules_of_a_batch_have_no_threads() -> None:
    from gaussiancad_core.batches.batch_run import _MODULES

    this_starter = starter(_MODULES)
    assert isinstance(this_starter, ForkServer)
    this_starter.close()


def test_solids_are_the_same_to_the_byte(plain_sheet: Path, tmp_path: Path) -> None:
    """Of a forked process, and of an interpreter of its own."""
    solids = []
    for name, modules in (("forked", ("gaussiancad_core.run.pipeline",)), ("started", ())):
        output = tmp_path / name
        supervisor: Supervisor[str] = Supervisor(1, LIMITS, modules)
        arguments = ["reconstruct", str(plain_sheet), "--output", str(output), "--result", "solid"]
        ((_, ended),) = supervisor.run([(name, [*arguments, "--length", "x=80"])])
        supervisor.close()
        assert (ended.exit_code, ended.message) == (0, "")
        assert ended.peak > 0
        solids.append((output / "solid.step").read_bytes())
    assert solids[0] == solids[1]
