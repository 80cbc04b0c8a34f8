"""Child processes for work that may hang or die: each stage of a task has its seconds."""

import signal
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import suppress
from multiprocessing import get_context
from multiprocessing.connection import Connection
from queue import SimpleQueue
from typing import Any, Protocol, TypeVar

import psutil

from gaussiancad_core.errors import GaussianCadError

Row = dict[str, Any]

Work = Callable[[Any], Iterator[Row]]
"""What becomes known of a task, bit by bit; a bit's ``stage`` tells the stage that comes next.
A child imports it by its name."""

SOLVE = "solve"
"""The stage whose seconds are measured."""

FIRST = "prepare"
"""The stage that a task begins with."""

_LOOKS_EVERY = 0.5
"""s between looks at what a child has spent."""

_PATIENCE = 4.0
"""By so much the clock may run ahead of the processor's seconds."""


class Limited(Protocol):
    """A task whose stages have limits."""

    @property
    def known(self) -> Row:
        """What is known of it beforehand: its row begins with that."""

    @property
    def allowed(self) -> Mapping[str, float]:
        """Seconds for each stage: of the clock, or of the processor where those are fewer."""


Task = TypeVar("Task", bound=Limited)


def serve(connection: Connection, work: Work) -> None:
    """Work on tasks until there is none, or nobody who asks: the child's main function."""
    # Who presses Ctrl-C stops the parent, which ends its children.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        while (task := connection.recv()) is not None:
            for bit in _told(work, task):
                connection.send(bit)
            connection.send(None)
    except (EOFError, ConnectionError):
        return


def _told(work: Work, task: Limited) -> Iterator[Row]:
    """What becomes known of a task, and what ended it."""
    try:
        yield from work(task)
    except GaussianCadError as error:
        yield {"failure": error.code, "message": error.message}
    except Exception as error:
        # Any defect is a row of the table, not the end of the run.
        yield {"failure": f"error-{type(error).__name__}", "message": str(error)}


class _Watch:
    """Seconds that a process and its children spend from now on.

    Those of the processor count where they are fewer than those of the clock, so that others on a
    busy machine do not end what would be done in time; but what only waits ends, too.
    """

    def __init__(self, pid: int) -> None:
        self._process = psutil.Process(pid)
        self._clock, self._before = time.monotonic(), self._worked()

    def spent(self) -> float:
        """Seconds since it began."""
        clock = time.monotonic() - self._clock
        worked = self._worked() - self._before
        return max(min(clock, worked), clock / _PATIENCE)

    def _worked(self) -> float:
        """Seconds of all processors."""
        try:
            family = self._process.children(recursive=True)
            cpu_times = self._process.cpu_times()
        except psutil.Error:
            # It is gone, which its pipe tells: the clock counts.
            return float("inf")
        # Of children that ended their parent knows.
        total = (
            cpu_times.user + cpu_times.system + cpu_times.children_user + cpu_times.children_system
        )
        for each in family:
            with suppress(psutil.Error):
                times = each.cpu_times()
                total += times.user + times.system
        return total


class Worker:
    """A child process that works on tasks one after the other; a new one when it hangs or dies."""

    def __init__(self, work: Work) -> None:
        self._work = work
        self._context = get_context("spawn")
        self._process: Any = None
        self._connection: Any = None

    def run(self, task: Limited) -> Row:
        """The row of a task; ``failure`` tells what ended it."""
        if self._process is None:
            self._start()
        row: Row = {**task.known, "stage": FIRST}
        self._connection.send(task)
        watch = _Watch(self._process.pid)
        while True:
            try:
                if not self._comes(watch, task.allowed[row["stage"]]):
                    # Time that was spent counts, or the slowest parts would make others look fast.
                    spent = {"seconds": task.allowed[SOLVE]} if row["stage"] == SOLVE else {}
                    return self._ended({**row, **spent}, f"{row['stage']}-over-time")
                bit = self._connection.recv()
            except (EOFError, ConnectionError):
                return self._ended(row, f"{row['stage']}-crashed")
            if bit is None:
                return row
            row.update(bit)
            if "stage" in bit:
                watch = _Watch(self._process.pid)

    def _comes(self, watch: "_Watch", allowed: float) -> bool:
        """Wait for word of the child; False once it has spent the seconds that it is allowed."""
        while (left := allowed - watch.spent()) > 0.0:
            if self._connection.poll(min(left, _LOOKS_EVERY)):
                return True
        return self._connection.poll(0.0)

    def close(self) -> None:
        """End the child."""
        if self._process is not None:
            self._process.kill()
            self._process.join()
            self._process = None

    def _start(self) -> None:
        self._connection, other = self._context.Pipe()
        self._process = self._context.Process(target=serve, args=(other, self._work), daemon=True)
        self._process.start()
        other.close()

    def _ended(self, row: Row, failure: str) -> Row:
        self.close()
        return {**row, "failure": failure}


def run_all(tasks: Sequence[Task], work: Work, workers: int) -> Iterator[tuple[Task, Row]]:
    """Tasks and their rows as they come, from as many child processes as there are workers."""
    free: SimpleQueue[Worker] = SimpleQueue()
    everyone = [Worker(work) for _ in range(workers)]
    for worker in everyone:
        free.put(worker)

    def run(task: Task) -> tuple[Task, Row]:
        worker = free.get()
        try:
            return task, worker.run(task)
        finally:
            free.put(worker)

    pool = ThreadPoolExecutor(workers)
    try:
        for future in as_completed([pool.submit(run, task) for task in tasks]):
            yield future.result()
    finally:
        # After an interruption nobody waits for what has not begun.
        pool.shutdown(wait=False, cancel_futures=True)
        for worker in everyone:
            worker.close()
