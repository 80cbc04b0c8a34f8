"""Engines that stay beside the windows: all sheets that are open share them.

An engine answers one request after another.  Whoever asks it does so through a server of its own,
which knows nothing of the others.
"""

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


@dataclass(frozen=True, eq=False)
class _Asked:
    """A request that waits for its answer.

    Attributes:
        server: through which it was asked.
        number: that the answer carries.
        fields: of the request.
        done: called with the answer.
    """

    server: Server
    number: int
    fields: dict[str, object]
    done: Callable[[Answer], None]


class Engine(QtCore.QObject):
    """One process; it starts with the first request, and ends with the last server.

    Args:
        program: how it is started.
    """

    def __init__(self, program: Program) -> None:
        super().__init__()
        self._program = program
        self._process: QtCore.QProcess | None = None
        self._servers: list[Server] = []
        self._waiting: deque[_Asked] = deque()
        self._sent = False
        self._number = 0
        self._rest = b""
        self._complaints: deque[str] = deque(maxlen=_LAST_LINES)
        application = QtCore.QCoreApplication.instance()
        if application is not None:
            # Widgets go after this, and their processes under the feet of whoever hears them.
            application.aboutToQuit.connect(self._quit)

    def join(self, server: Server) -> None:
        """Stay while this server is there."""
        self._servers.append(server)

    def leave(self, server: Server) -> None:
        """Forget a server; after the last one the process ends."""
        if server in self._servers:
            self._servers.remove(server)
        self.forget(server)
        if not self._servers:
            self._end()

    def ask(
        self, server: Server, fields: dict[str, object], done: Callable[[Answer], None]
    ) -> None:
        """Take a request; :meth:`Server.ask` tells the rest."""
        self._number += 1
        self._waiting.append(_Asked(server, self._number, fields, done))
        self._send()

    def forget(self, server: Server) -> None:
        """Drop what a server asked; what the process does for it is broken off."""
        running = self._sent and bool(self._waiting) and self._waiting[0].server is server
        self._waiting = deque(item for item in self._waiting if item.server is not server)
        if running:
            self._end()
            self._send()

    def awaits(self, server: Server) -> bool:
        """Whether a server awaits an answer."""
        return any(item.server is server for item in self._waiting)

    def _send(self) -> None:
        """Send the first request, unless it was sent."""
        if self._sent or not self._waiting:
            return
        self._sent = True
        first = self._waiting[0]
        if self._process is None:
            self._begin()
        # A process that did not start has answered meanwhile.
        if self._process is not None and self._waiting and self._waiting[0] is first:
            line = json.dumps({"id": first.number, **first.fields}) + "\n"
            self._process.write(line.encode())

    def _quit(self) -> None:
        self._waiting.clear()
        self._end()

    def _end(self) -> None:
        """End the process at once."""
        process, self._process, self._rest, self._sent = self._process, None, b"", False
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
        # A lambda would keep this alive until its child, the process, is destroyed, and then
        # destroy it once more.
        process.finished.connect(self._ended)
        process.errorOccurred.connect(self._failed)
        self._process = process
        process.start(program, [*first, "serve"])

    def _hear(self) -> None:
        if self._process is None:
            # It was said before the process was ended, and is heard after.
            return
        *lines, self._rest = (self._rest + bytes(self._process.readAll())).split(b"\n")
        for line in lines:
            try:
                event = json.loads(line)
            except ValueError:
                continue
            if not self._waiting or not self._sent:
                continue
            first = self._waiting[0]
            if event.get("event") == "stage":
                first.server.stage.emit(str(event.get("name", "")))
            elif event.get("event") == "answer" and event.get("id") in (first.number, None):
                self._answered(event)

    def _answered(self, answer: Answer) -> None:
        """Hand the answer of the first request over, and send the next."""
        first = self._waiting.popleft()
        self._sent = False
        first.server.changed.emit()
        first.done(answer)
        self._send()

    def _note(self) -> None:
        if self._process is None:
            return
        text = bytes(self._process.readAllStandardError()).decode("utf-8", "replace")
        self._complaints.extend(item for item in text.splitlines() if item.strip())

    def _failed(self, error: QtCore.QProcess.ProcessError) -> None:
        # A process that ends badly is told by its end; one that never began has none.
        if error == QtCore.QProcess.ProcessError.FailedToStart and self._process is not None:
            stated = not_started(self._program.command[0], self._process.errorString()).message
            self._give_up(stated)

    def _ended(self, *_how: object) -> None:
        last = self._complaints[-1] if self._complaints else ""
        stated = translate("GaussianCAD", "The engine broke off: {reason}").format(reason=last)
        self._give_up(stated)

    def _give_up(self, message: str) -> None:
        """Tell whoever asked last; of the rest, what the same server asked falls away."""
        process, self._process, self._rest = self._process, None, b""
        if process is not None:
            process.deleteLater()
        if not self._waiting or not self._sent:
            return
        first = self._waiting[0]
        others = (item for item in self._waiting if item.server is not first.server)
        self._waiting = deque((first, *others))
        self._answered({"error": {"code": "engine-broke-off", "message": message}})


@dataclass(frozen=True, eq=False)
class Engines:
    """The engines that all sheets share.

    Attributes:
        program: how each is started.
        reader: keeps the ink of sheets, and reads.
        solver: makes parts; it is ended where what it makes is out of date.
        clerk: makes the pictures of pages.
    """

    program: Program
    reader: Engine
    solver: Engine
    clerk: Engine

    @classmethod
    def of(cls, program: Program) -> Engines:
        """New ones; none starts before it is asked."""
        return cls(program, Engine(program), Engine(program), Engine(program))


class Server(QtCore.QObject):
    """An engine as one sheet has it.

    Args:
        engine: that may serve others, too.
        parent: its owner.

    Signals:
        stage: name of the stage that a request has reached.
        changed: whether it is at work has changed.
    """

    stage = QtCore.Signal(str)
    changed = QtCore.Signal()

    def __init__(self, engine: Engine, parent: QtCore.QObject) -> None:
        super().__init__(parent)
        self._engine = engine
        engine.join(self)

    @property
    def busy(self) -> bool:
        """Whether an answer is awaited."""
        return self._engine.awaits(self)

    def ask(self, do: str, done: Callable[[Answer], None], **fields: object) -> None:
        """Send a request.

        Args:
            do: what is asked.
            done: called with the answer; with an error too, where the engine does not start or
                breaks off; not at all after :meth:`stop`.
            fields: of the request.
        """
        self._engine.ask(self, {"do": do, **fields}, done)
        self.changed.emit()

    def stop(self) -> None:
        """Break off everything that was asked."""
        self._engine.forget(self)
        self.changed.emit()

    def close(self) -> None:
        """Ask no more; the engine ends where nobody else asks it."""
        self._engine.leave(self)
