"""One run of the engine: started, watched and stopped without ever blocking the window.

In a window Qt's signals drive the run.  In ``freecadcmd``, where no event loop runs,
:meth:`EngineRun.wait` does.  Stopping escalates: a line ``cancel``, after a grace period a request
to terminate, after another one the end.  If FreeCAD itself dies, the engine sees the end of its
stdin and stops by itself.
"""

import os
import time
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from freecad.gaussiancad.engine.environment import clean_environment
from freecad.gaussiancad.engine.job import MODULE_ARGUMENTS
from freecad.gaussiancad.engine.locate import Engine
from freecad.gaussiancad.engine.protocol import Event, EventKind, LineBuffer, parse_event
from freecad.gaussiancad.engine.verdict import Ending, RunState, Verdict, judge, not_started
from freecad.gaussiancad.qt import QtCore

GRACE_SECONDS = 5.0
LOG_LINES = 400

_POLL_MS = 100


@dataclass(frozen=True)
class RunResult:
    """What is left of a run.

    Attributes:
        verdict: how it ended.
        exit_code: of the process; -1 if there was none or a signal ended it.
        output: what the engine printed on stdout besides events.
        log: the last lines of its stderr.
    """

    verdict: Verdict
    exit_code: int
    output: str
    log: str

    @property
    def state(self) -> RunState:
        """How it ended, in a word."""
        return self.verdict.state

    @property
    def code(self) -> str:
        """The engine's kebab-case code, or empty."""
        return self.verdict.code

    @property
    def message(self) -> str:
        """A sentence, empty if done; the engine's own is English."""
        return self.verdict.message

    @property
    def words(self) -> str:
        """The same for who uses the window, in their language."""
        return self.verdict.words


@dataclass(frozen=True)
class Watcher:
    """Who is told what happens.

    Attributes:
        on_event: every event.
        on_log: every other line, of stdout or stderr.
        on_finished: the end, once, whatever it was.
    """

    on_event: Callable[[Event], None] = lambda event: None
    on_log: Callable[[str], None] = lambda line: None
    on_finished: Callable[[RunResult], None] = lambda result: None


class EngineRun:
    """A run of the engine.

    Args:
        engine: whose interpreter is started.
        arguments: after ``-m gaussiancad_core``.
        watcher: who is told.
        grace: seconds between the steps of stopping.
    """

    def __init__(
        self,
        engine: Engine,
        arguments: Sequence[str],
        watcher: Watcher | None = None,
        grace: float = GRACE_SECONDS,
    ) -> None:
        self.result: RunResult | None = None
        self._engine = engine
        self._arguments = [*MODULE_ARGUMENTS, *arguments]
        self._speaks_events = "--events" in arguments
        self._watcher = watcher or Watcher()
        self._grace = grace
        self._stdout, self._stderr = LineBuffer(), LineBuffer()
        self._output: list[str] = []
        self._log: deque[str] = deque(maxlen=LOG_LINES)
        self._error: Event | None = None
        self._greeted = False
        self._cancelling = False
        self._deadline = 0.0
        self._next_step = self._terminate
        self._process = QtCore.QProcess()
        self._timer: QtCore.QTimer | None = None

    @property
    def running(self) -> bool:
        """Whether the process lives."""
        return self._process.state() != QtCore.QProcess.ProcessState.NotRunning

    @property
    def pid(self) -> int:
        """Number of the process, 0 if there is none."""
        return int(self._process.processId())

    def start(self) -> None:
        """Start the process; all that follows comes through the watcher."""
        environment = QtCore.QProcessEnvironment()
        for name, value in clean_environment(os.environ).items():
            environment.insert(name, value)
        process = self._process
        process.setProcessEnvironment(environment)
        process.readyReadStandardOutput.connect(self._read_output)
        process.readyReadStandardError.connect(self._read_log)
        process.errorOccurred.connect(self._on_process_error)
        process.finished.connect(self._on_process_finished)
        process.start(self._engine.python, self._arguments)

    def cancel(self) -> None:
        """Ask the engine to stop, and see to it that it does."""
        if self._cancelling or not self.running:
            return
        self._cancelling = True
        if self._speaks_events:
            self._process.write(b"cancel\n")
        else:
            self._terminate()
        self._deadline = time.monotonic() + self._grace
        if QtCore.QCoreApplication.instance() is not None:
            self._timer = QtCore.QTimer()
            self._timer.timeout.connect(self._escalate)
            self._timer.start(_POLL_MS)

    def flush(self) -> None:
        """Have the engine asked to stop at once, whenever FreeCAD comes back to the process."""
        if self.running:
            self._process.waitForBytesWritten(_POLL_MS)

    def advance(self, *, at_once: bool = False) -> None:
        """Run on for a moment without an event loop.

        Args:
            at_once: whether only what has come already is told.
        """
        self._process.waitForFinished(0 if at_once else _POLL_MS)
        self._escalate()

    def wait(self) -> RunResult:
        """Run to the end without an event loop; an interrupt from the keyboard cancels the run."""
        while self.result is None:
            try:
                self.advance()
            except KeyboardInterrupt:
                self.cancel()
        return self.result

    def _escalate(self) -> None:
        if self._cancelling and self.running and time.monotonic() >= self._deadline:
            self._deadline = time.monotonic() + self._grace
            self._next_step()

    def _terminate(self) -> None:
        self._next_step = self._process.kill
        self._process.terminate()

    def _read_output(self) -> None:
        for line in self._stdout.feed(bytes(self._process.readAllStandardOutput().data())):
            self._take_output(line)

    def _read_log(self) -> None:
        for line in self._stderr.feed(bytes(self._process.readAllStandardError().data())):
            self._take_log(line)

    def _take_output(self, line: str) -> None:
        event = parse_event(line) if self._speaks_events else None
        if event is None:
            self._output.append(line)
            self._watcher.on_log(line)
            return
        self._greeted = True
        if event.kind is EventKind.ERROR:
            self._error = event
        self._watcher.on_event(event)

    def _take_log(self, line: str) -> None:
        self._log.append(line)
        self._watcher.on_log(line)

    def _on_process_error(self, error: QtCore.QProcess.ProcessError) -> None:
        if error == QtCore.QProcess.ProcessError.FailedToStart:
            self._finish(not_started(self._engine.python, self._process.errorString()), -1)

    def _on_process_finished(self, *_status: object) -> None:
        self._read_output()
        self._read_log()
        for line in self._stdout.rest():
            self._take_output(line)
        for line in self._stderr.rest():
            self._take_log(line)
        crashed = self._process.exitStatus() == QtCore.QProcess.ExitStatus.CrashExit
        exit_code = -1 if crashed else self._process.exitCode()
        spoke = self._greeted or not self._speaks_events
        ending = Ending(
            self._engine.python, exit_code, self._cancelling, spoke, self._error, tuple(self._log)
        )
        self._finish(judge(ending), exit_code)

    def _finish(self, verdict: Verdict, exit_code: int) -> None:
        if self.result is not None:
            return
        if self._timer is not None:
            self._timer.stop()
        self.result = RunResult(verdict, exit_code, "\n".join(self._output), "\n".join(self._log))
        self._watcher.on_finished(self.result)
