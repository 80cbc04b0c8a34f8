"""An engine that stays beside a window, and answers its requests one after another."""

from __future__ import annotations

import json
import sys
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass

from freecad.gaussiancad.engine.verdict import not_started
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore

Answer = dict
"""What the engine answers: its fields, or ``error`` with a code and a message."""

_LAST_LINES = 5
"""Lines on standard error that are told of an engine that broke off."""


@dataclass(frozen=True)
class Program:
    """How the engine is started.

    Attributes:
        command: program and first arguments.
        environment: variables; None for those of this process.
    """

    command: tuple[str, ...] = (sys.executable, "-m", "gaussiancad_core")
    environment: dict[str, str] | None = None


class Server(QtCore.QObject):
    """One engine; it starts with the first request.

    Args:
        program: the engine.
        parent: its owner.

    Signals:
        stage: name of the stage that a request has reached.
        changed: whether it is at work has changed.
    """

    stage = QtCore.Signal(str)
    changed = QtCore.Signal()

    def __init__(self, program: Program, parent: QtCore.QObject) -> None:
        super().__init__(parent)
        self._program = program
        self._process: QtCore.QProcess | None = None
        self._waiting: deque[tuple[int, Callable[[Answer], None]]] = deque()
        self._number = 0
        self._rest = b""
        self._complaints: deque[str] = deque(maxlen=_LAST_LINES)
        application = QtCore.QCoreApplication.instance()
        if application is not None:
            # Widgets go after this, and their processes under the feet of whoever hears them.
            application.aboutToQuit.connect(self.stop)

    @property
    def busy(self) -> bool:
        """Whether an answer is awaited."""
        return bool(self._waiting)

    def ask(self, do: str, done: Callable[[Answer], None], **fields: object) -> None:
        """Send a request.

        Args:
            do: what is asked.
            done: called with the answer; with an error too, where the engine does not start or
                breaks off; not at all after :meth:`stop`.
            fields: of the request.
        """
        self._number += 1
        self._waiting.append((self._number, done))
        if self._process is None:
            self._begin()
        if self._process is not None:
            line = json.dumps({"id": self._number, "do": do, **fields}) + "\n"
            self._process.write(line.encode())
        self.changed.emit()

    def stop(self) -> None:
        """End the engine at once, and everything that it was asked."""
        self._waiting.clear()
        process, self._process, self._rest = self._process, None, b""
        if process is not None:
            for signal in (
                process.finished,
                process.errorOccurred,
                process.readyRead,
                process.readyReadStandardError,
            ):
                signal.disconnect()
            process.kill()
            process.waitForFinished(1000)
            process.deleteLater()
        self.changed.emit()

    def _begin(self) -> None:
        program, *first = self._program.command
        process = QtCore.QProcess(self)
        if self._program.environment is not None:
            variables = QtCore.QProcessEnvironment()
            for name, value in self._program.environment.items():
                variables.insert(name, value)
            process.setProcessEnvironment(variables)
        process.readyRead.connect(self._hear)
        process.readyReadStandardError.connect(self._note)
        process.finished.connect(lambda *_: self._ended())
        process.errorOccurred.connect(self._failed)
        self._process = process
        process.start(program, [*first, "serve"])

    def _hear(self) -> None:
        *lines, self._rest = (self._rest + bytes(self._process.readAll())).split(b"\n")
        for line in lines:
            try:
                event = json.loads(line)
            except ValueError:
                continue
            if event.get("event") == "stage":
                self.stage.emit(str(event.get("name", "")))
            elif event.get("event") == "answer" and self._waiting:
                self._answer(event)

    def _answer(self, event: dict) -> None:
        number, done = self._waiting[0]
        if event.get("id") in (number, None):
            self._waiting.popleft()
            self.changed.emit()
            done(event)

    def _note(self) -> None:
        text = bytes(self._process.readAllStandardError()).decode("utf-8", "replace")
        self._complaints.extend(own for own in text.splitlines() if own.strip())

    def _failed(self, error: QtCore.QProcess.ProcessError) -> None:
        # A process that ends badly is told by its end; one that never began has none.
        if error == QtCore.QProcess.ProcessError.FailedToStart and self._process is not None:
            told = not_started(self._program.command[0], self._process.errorString()).message
            self._give_up(told)

    def _ended(self) -> None:
        last = self._complaints[-1] if self._complaints else ""
        told = translate("GaussianCAD", "The engine broke off: {reason}").format(reason=last)
        self._give_up(told)

    def _give_up(self, message: str) -> None:
        process, self._process, self._rest = self._process, None, b""
        if process is not None:
            process.deleteLater()
        waiting = list(self._waiting)
        self._waiting.clear()
        self.changed.emit()
        for _, done in waiting[:1]:
            done({"error": {"code": "engine-broke-off", "message": message}})
