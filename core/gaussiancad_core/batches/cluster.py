"""Sheets of a batch on several machines: a Dask cluster whose workers see the batch's folders.

On a worker a sheet is the same limited process as on one machine, so that limits and results are
the same.  What travels are the arguments of a command and how it ended, as plain values; the
coordinator alone writes the manifest and the report.
"""

import os
import time
import uuid
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from gaussiancad_core import __version__
from gaussiancad_core.errors import UsageError
from gaussiancad_core.processes.supervisor import Ended, ProcessLimits, run_limited
from gaussiancad_core.storage.extras import Extra, demand
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

if TYPE_CHECKING:
    from distributed import Client, Future

_PATIENCE_S = 10.0
"""s in which a scheduler and its workers have to answer."""

_LOOKS_EVERY_S = 0.5
"""s between looks at the cluster, and at whether a sheet is still asked for."""

_GRACE_S = 6.0
"""s in which sheets that are not asked for any more end."""

_LOSSES = 3
"""Workers that a sheet may be lost with; it is given up then."""

Task = TypeVar("Task")


class Cluster(Generic[Task]):
    """Runs tasks in limited processes on the workers of a Dask cluster.

    Args:
        address: of the scheduler, as ``tcp://host:8786``.
        limits: of each process.
        folder: of the batch, which every worker has to see under the same name.

    Raises:
        EngineError: ``extra-missing``, Dask is not installed.
        UsageError: ``scheduler-unreachable``,
            ``scheduler-without-workers``, ``scheduler-differs`` for another version of the engine,
            ``folder-not-shared``.
    """

    def __init__(self, address: str, limits: ProcessLimits, folder: Path) -> None:
        self._limits = asdict(limits)
        self._client = _connected(address)
        self._running: dict[Future, Task] = {}
        try:
            _check(self._client, address, folder)
        except BaseException:
            self._client.close(timeout=_PATIENCE_S)
            raise

    def run(self, tasks: Iterable[tuple[Task, list[str]]]) -> Iterator[tuple[Task, Ended]]:
        """Tasks as they end, however they do.

        Args:
            tasks: each with the arguments of its ``gaussiancad`` process; the next is taken when a
                worker is free.
        """
        waiting = iter(tasks)
        more = True
        while more or self._running:
            while more and len(self._running) < max(self._places(), 1):
                task = next(waiting, None)
                if task is None:
                    more = False
                    break
                future = self._client.submit(
                    work_on, task[1], self._limits, key=f"gaussiancad-{uuid.uuid4()}", pure=False
                )
                self._running[future] = task[0]
            done = [future for future in self._running if future.done()]
            for future in done:
                item = self._running.pop(future)
                yield item, _ended(future)
            if self._running and not done:
                time.sleep(_LOOKS_EVERY_S)

    def close(self) -> None:
        """End what still runs: sheets that nobody asks for end by themselves."""
        futures = list(self._running)
        self._running.clear()
        with suppress(Exception):
            self._client.cancel(futures, force=True)
        until = time.monotonic() + _GRACE_S
        with suppress(Exception):
            while time.monotonic() < until and any(self._client.processing().values()):
                time.sleep(_LOOKS_EVERY_S)
        self._client.close(timeout=_PATIENCE_S)

    def _places(self) -> int:
        """Sheets that all workers together work on at a time."""
        return sum(self._client.nthreads().values())


def work_on(arguments: list[str], limits: dict[str, Any]) -> dict[str, Any]:
    """What a worker does with a sheet.

    Args:
        arguments: of a ``gaussiancad`` command.
        limits: of its process, as the fields of :class:`ProcessLimits`.

    Returns:
        The fields of :class:`Ended` but for the output.
    """
    ended = run_limited(arguments, ProcessLimits(**limits), _asked_for())
    return {**asdict(ended), "output": ""}


def _asked_for() -> Any:  # noqa: ANN401
    """Tells whether the coordinator still asks for what this worker's thread works on."""
    from distributed import get_worker

    worker = get_worker()
    key = worker.get_current_task()

    def asked() -> bool:
        task = worker.state.tasks.get(key)
        return task is not None and task.state == "executing"

    return asked


def engine_here() -> tuple[str, list[str]]:
    """The version of the engine on a worker, and which of its packages have which."""
    from gaussiancad_core.storage.versions import ENGINE_PACKAGES, installed_versions

    found = installed_versions(ENGINE_PACKAGES)
    return __version__, sorted(f"{name} {version}" for name, version in found.items())


def reads(path: str) -> str:
    """What a worker reads in a file; empty where it sees none."""
    try:
        return Path(path).read_text(encoding="ascii")
    except (OSError, ValueError):
        return ""


def _connected(address: str) -> "Client":
    demand(Extra.CLUSTER, "--scheduler")
    import logging

    from distributed import Client

    # What it has to say, the batch says in one line.
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    try:
        return Client(address, timeout=_PATIENCE_S, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        reason = " ".join(str(error).split())[:200]
        raise UsageError(
            Code.SCHEDULER_UNREACHABLE,
            f"no Dask scheduler answers at {address} ({reason}): start one, or check the address",
        ) from error


def _check(client: "Client", address: str, folder: Path) -> None:
    """Whether all workers have this engine and see the folder."""
    this_engine_here = engine_here()
    others = client.run(engine_here)
    if not others:
        raise UsageError(
            Code.SCHEDULER_WITHOUT_WORKERS,
            f"the scheduler at {address} has no workers: start some, with this engine installed",
        )
    for worker, found in others.items():
        if (found[0], list(found[1])) != this_engine_here:
            raise UsageError(
                Code.SCHEDULER_DIFFERS,
                f"the worker at {worker} has another engine, or other packages for it: results "
                "would differ; install the same lock everywhere",
            )
    token = uuid.uuid4().hex
    probe = Path(os.path.abspath(folder)) / f".gaussiancad-probe-{token}"
    try:
        probe.write_text(token, encoding="ascii")
        seen = client.run(reads, str(probe))
    finally:
        probe.unlink(missing_ok=True)
    for worker, text in seen.items():
        if text != token:
            raise UsageError(
                Code.FOLDER_NOT_SHARED,
                f"the worker at {worker} does not see {probe.parent}: put sheets and output into a "
                "folder that all machines have under one name",
            )


def _ended(future: "Future") -> Ended:
    """How a task ended, also where its workers were lost."""
    if future.status == "finished":
        with suppress(Exception):
            found = future.result(timeout=_PATIENCE_S)
            return Ended(**{**found, "output": b""})
    return Ended(
        int(ExitCode.ENGINE),
        f"the machines that worked on it were lost {_LOSSES} times, or it was: look at their logs "
        f"[{Code.WORKER_LOST.value}]",
        0.0,
        0,
    )
