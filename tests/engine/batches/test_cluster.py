"""Batches on a Dask cluster: a scheduler and two workers, as processes of this machine."""

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import psutil
import pytest
from engine.batches.batch_runs import OPTIONS, command, rows

from gaussiancad_core.cli import main
from gaussiancad_core.errors import UsageError
from gaussiancad_core.processes.supervisor import ProcessLimits

pytest.importorskip("distributed")

from gaussiancad_core.batches import cluster

_LIMITS = ProcessLimits(1 << 30, 10.0)
_PATIENCE = 60.0


def _run(*arguments: "str | Path") -> "subprocess.CompletedProcess[str]":
    return subprocess.run(
        command(*arguments), capture_output=True, encoding="utf-8", check=False, timeout=150
    )


@dataclass
class _Dask:
    """A scheduler and its workers."""

    address: str
    workers: list["subprocess.Popen[bytes]"]


def _start(module: str, *arguments: str, log: Path) -> "subprocess.Popen[bytes]":
    return subprocess.Popen(
        [sys.executable, "-m", f"distributed.cli.{module}", *arguments],
        stdout=log.open("wb"),
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )


@pytest.fixture(scope="module")
def dask(tmp_path_factory: pytest.TempPathFactory) -> Iterator[_Dask]:
    """A cluster of two workers, with a thread each; whatever is left of it is killed."""
    folder = tmp_path_factory.mktemp("dask")
    file = folder / "scheduler.json"
    usual = ("--no-dashboard", "--scheduler-file", str(file))
    started = [
        _start(
            "dask_scheduler", "--host", "127.0.0.1", "--port", "0", *usual, log=folder / "scheduler"
        )
    ]
    try:
        started += [
            _start(
                "dask_worker",
                "--nthreads",
                "1",
                "--no-nanny",
                "--local-directory",
                str(folder / f"worker{number}"),
                *usual,
                log=folder / f"log{number}",
            )
            for number in range(2)
        ]
        until = time.monotonic() + _PATIENCE
        while not file.is_file() or not file.read_text():
            assert time.monotonic() < until and started[0].poll() is None
            time.sleep(0.1)
        address = json.loads(file.read_text())["address"]
        from distributed import Client

        with Client(address, timeout=_PATIENCE, set_as_default=False) as client:
            client.wait_for_workers(2, timeout=_PATIENCE)
        yield _Dask(address, started[1:])
    finally:
        for process in started:
            with suppress(OSError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()


@pytest.fixture
def sheets(tmp_path: Path, plain_sheet: Path) -> Path:
    """A sheet that becomes a solid, and one that is none."""
    folder = tmp_path / "sheets"
    folder.mkdir()
    shutil.copy(plain_sheet, folder / "one.dxf")
    (folder / "text.png").write_text("no picture")
    return folder


def test_the_results_are_those_of_one_machine(dask: _Dask, sheets: Path, tmp_path: Path) -> None:
    here, there = tmp_path / "here", tmp_path / "there"
    assert main(["reconstruct", str(sheets / "one.dxf"), "--output", str(here), *OPTIONS]) == 0
    ran = _run(sheets, "--output", there, *OPTIONS, "--scheduler", dask.address)
    assert (ran.returncode, ran.stderr) == (1, "")
    assert (there / "one" / "solid.step").read_bytes() == (here / "solid.step").read_bytes()
    assert {name: (row["status"], row["code"]) for name, row in rows(there).items()} == {
        "one": ("verified", ""),
        "text": ("failed", "not-an-image"),
    }
    assert not list(there.glob(".gaussiancad-probe-*"))


def test_a_batch_that_is_stopped_leaves_nothing_running(
    dask: _Dask, sheets: Path, tmp_path: Path
) -> None:
    output = tmp_path / "out"
    batch = subprocess.Popen(
        command(sheets, "--output", output, *OPTIONS, "--scheduler", dask.address),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    _children_of(dask)
    batch.send_signal(signal.SIGTERM)
    batch.communicate(timeout=_PATIENCE)
    assert len(rows(output)) == 2
    until = time.monotonic() + _PATIENCE
    while any(psutil.Process(worker.pid).children() for worker in dask.workers):
        assert time.monotonic() < until
        time.sleep(0.1)


def test_a_worker_that_is_lost_costs_no_sheet(dask: _Dask, sheets: Path, tmp_path: Path) -> None:
    """The last one here: the cluster has one worker less afterwards."""
    output = tmp_path / "out"
    batch = subprocess.Popen(
        command(sheets, "--output", output, *OPTIONS, "--scheduler", dask.address),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    victim, child = _children_of(dask)
    victim.kill()
    batch.communicate(timeout=120)
    assert sorted(row["exit_code"] for row in rows(output).values()) == ["0", "3"]
    assert not psutil.pid_exists(child)


def _children_of(dask: _Dask) -> tuple["subprocess.Popen[bytes]", int]:
    """A worker that has begun a sheet, and the process that works on it."""
    until = time.monotonic() + _PATIENCE
    while time.monotonic() < until:
        for worker in dask.workers:
            if worker.poll() is None:
                children = psutil.Process(worker.pid).children()
                if children:
                    return worker, children[0].pid
        time.sleep(0.02)
    raise AssertionError("no sheet was begun")


def test_where_nobody_answers_it_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "_PATIENCE_S", 0.5)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
    with pytest.raises(UsageError) as caught:
        cluster.Cluster(address, _LIMITS, tmp_path)
    assert caught.value.code == "scheduler-unreachable"


def test_workers_that_do_not_see_the_folder_are_named(
    dask: _Dask, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Each process has a folder of its own of this name.
    monkeypatch.chdir(tmp_path)
    with pytest.raises(UsageError) as caught:
        cluster.Cluster(dask.address, _LIMITS, Path("/proc/self/cwd"))
    assert caught.value.code == "folder-not-shared"
    assert not list(tmp_path.iterdir())
