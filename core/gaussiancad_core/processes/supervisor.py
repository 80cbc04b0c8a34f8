"""Processes side by side, each with limits of memory and time; none outlives its supervisor.

What a process prints goes into files, so that none waits for a reader.
"""

import os
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import IO, Generic, TypeVar

import psutil

from gaussiancad_core.processes.process_start import Interpreters, Starter, hang_up, starter
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

_LOOKS_EVERY = 0.1
"""s between looks at the processes."""

_GRACE_S = 4.0
"""s in which a process that was asked to may end by itself."""

_MOST_TEXT = 1 << 16
"""Bytes of what a process said last that are kept."""

_UNASKED = "nobody waits for it any more [cancelled]"

Task = TypeVar("Task")


@dataclass(frozen=True)
class ProcessLimits:
    """What a process may take.

    Attributes:
        memory: bytes, with its children.
        seconds: of the clock.
        file: bytes of the largest file.
    """

    memory: int
    seconds: float
    file: int = 4 << 30


@dataclass(frozen=True)
class Ended:
    """How a process ended.

    Attributes:
        exit_code: as the command line has them; a process that was killed for a limit has 5, one
            that crashed 6.
        message: the last line that it said, or why it was ended; empty if all is well.
        seconds: of the clock.
        peak: bytes of memory at most, as far as was seen.
        output: what it printed on its standard output, where that was asked for.
    """

    exit_code: int
    message: str
    seconds: float
    peak: int
    output: bytes = b""


class _Child:
    """A process in a session of its own."""

    def __init__(
        self,
        starter: Starter,
        arguments: list[str],
        limits: ProcessLimits,
        *,
        keep_output: bool = False,
    ) -> None:
        self._limits = limits
        # Both are closed with the process, in end().
        self._said: IO[bytes] = tempfile.TemporaryFile()  # noqa: SIM115
        self._printed = tempfile.TemporaryFile() if keep_output else None  # noqa: SIM115
        self._process = starter.start(
            arguments, limits.file, self._printed or subprocess.DEVNULL, self._said
        )
        self._seen = _seen(self._process.pid)
        self._began = time.monotonic()
        self._peak = 0

    def look(self) -> Ended | None:
        """How it ended, if it did; it is ended where it takes too much."""
        code = self._process.poll()
        if code is not None:
            return self._ended_by_itself(code)
        self._peak = max(self._peak, self._memory())
        if self._peak > self._limits.memory:
            reason = f"it took more than {self._limits.memory / 2**30:.1f} GB of memory"
            return self._ended_for(Code.OUT_OF_MEMORY, f"{reason}: give it more with --memory")
        if self.seconds > self._limits.seconds:
            reason = f"it took more than {self._limits.seconds:g} s"
            return self._ended_for(Code.TAKES_TOO_LONG, f"{reason}: give it more with --seconds")
        return None

    @property
    def seconds(self) -> float:
        """s since it began."""
        return time.monotonic() - self._began

    def ask_to_end(self) -> None:
        """Let it end by itself, and clean up."""
        hang_up(self._process)

    def end(self, until: float) -> None:
        """End it and its children, by force if it still runs at that time (monotonic clock)."""
        with suppress(subprocess.TimeoutExpired):
            self._process.wait(max(until - time.monotonic(), 0.0))
        self._kill()
        for file in (self._said, self._printed):
            if file is not None:
                file.close()

    def _kill(self) -> None:
        if hasattr(os, "killpg"):
            with suppress(OSError):
                os.killpg(self._process.pid, signal.SIGKILL)
        else:
            self._process.kill()
        self._process.wait()
        hang_up(self._process)

    def _ended_for(self, code: str, message: str) -> Ended:
        self.ask_to_end()
        self.end(time.monotonic() + _GRACE_S)
        return Ended(int(ExitCode.LIMIT), f"{message} [{code}]", self.seconds, self._peak)

    def _ended_by_itself(self, code: int) -> Ended:
        message = "" if code == 0 else self._last_line()
        output = b""
        if self._printed is not None:
            self._printed.seek(0)
            output = self._printed.read()
        self.end(time.monotonic())
        if code < 0:
            message = f"its process was ended by {_name_of(-code)}"
            code = int(ExitCode.ENGINE)
        return Ended(code, message, self.seconds, self._peak, output)

    def _last_line(self) -> str:
        size = self._said.seek(0, os.SEEK_END)
        self._said.seek(max(size - _MOST_TEXT, 0))
        lines = self._said.read().decode("utf-8", "replace").strip().splitlines()
        return lines[-1] if lines else "no message"

    def _memory(self) -> int:
        total = 0
        if self._seen is None:
            return total
        with suppress(psutil.Error):
            for process in (self._seen, *self._seen.children(recursive=True)):
                with suppress(psutil.Error):
                    total += process.memory_info().rss
        return total


def run_limited(
    arguments: list[str], limits: ProcessLimits, asked_for: Callable[[], bool] = lambda: True
) -> Ended:
    """Run ``gaussiancad`` in a limited process to its end, with what it prints.

    Args:
        arguments: of the command.
        limits: of the process.
        asked_for: whether anybody still waits for it; else it is ended.
    """
    child = _Child(Interpreters(), arguments, limits, keep_output=True)
    try:
        while (ended := child.look()) is None:
            time.sleep(_LOOKS_EVERY)
            if not asked_for():
                child.ask_to_end()
                child.end(time.monotonic() + _GRACE_S)
                return Ended(int(ExitCode.CANCELLED), _UNASKED, child.seconds, 0)
    except BaseException:
        child.ask_to_end()
        child.end(time.monotonic())
        raise
    return ended


class Supervisor(Generic[Task]):
    """Runs tasks in processes, some at a time.

    Args:
        workers: processes at a time.
        limits: of each.
        modules: that each imports: where processes can be forked, they are imported once.
    """

    def __init__(self, workers: int, limits: ProcessLimits, modules: Sequence[str] = ()) -> None:
        self._workers, self._limits = workers, limits
        self._modules = tuple(modules)
        self._starter: Starter | None = None
        self._running: dict[int, tuple[Task, _Child]] = {}

    def run(self, tasks: Iterable[tuple[Task, list[str]]]) -> Iterator[tuple[Task, Ended]]:
        """Tasks as they end, however they do.

        Args:
            tasks: each with the arguments of its ``gaussiancad`` process; the next is taken when a
                worker is free.
        """
        waiting, number = iter(tasks), 0
        more = True
        while more or self._running:
            while more and len(self._running) < self._workers:
                task = next(waiting, None)
                if task is None:
                    more = False
                    break
                number += 1
                if self._starter is None:
                    self._starter = starter(self._modules)
                self._running[number] = task[0], _Child(self._starter, task[1], self._limits)
            for key, (item, child) in list(self._running.items()):
                if (ended := child.look()) is not None:
                    del self._running[key]
                    yield item, ended
            if self._running:
                time.sleep(_LOOKS_EVERY)

    def close(self) -> None:
        """End what still runs: asked first, forced after some seconds."""
        children = [child for _, child in self._running.values()]
        self._running.clear()
        for child in children:
            child.ask_to_end()
        until = time.monotonic() + _GRACE_S
        for child in children:
            child.end(until)
        if self._starter is not None:
            self._starter.close()
            self._starter = None


def _seen(pid: int) -> psutil.Process | None:
    """A process to be looked at; nothing if it has ended already."""
    try:
        return psutil.Process(pid)
    except psutil.Error:
        return None


def _name_of(number: int) -> str:
    with suppress(ValueError):
        return signal.Signals(number).name
    return f"signal {number}"
