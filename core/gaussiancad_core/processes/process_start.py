"""How processes are started: each as an interpreter of its own, or forked from one that has
imported what they need."""

import json
import os
import select
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Sequence
from contextlib import suppress
from typing import IO, Protocol

_PATIENCE_S = 60.0
"""s in which a server has to have imported all."""

_WAITS_S = 0.02
"""s between looks at whether a process has ended."""

ONE_THREAD = {
    name: "1"
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
}
"""A sheet has one thread: the machine is full, and sums come out the same on any."""


class Process(Protocol):
    """What is known of a process, as :class:`subprocess.Popen` has it."""

    pid: int
    stdin: IO[bytes] | None
    returncode: int | None

    def poll(self) -> int | None:
        """Its exit code, negative for a signal; None while it runs."""

    def wait(self, timeout: float | None = None) -> int:
        """Its exit code; raises :class:`subprocess.TimeoutExpired`."""

    def kill(self) -> None:
        """End it at once."""


def hang_up(process: Process) -> None:
    """Close the standard input of a process, by which it ends; not where it is gone already."""
    if process.stdin is not None:
        with suppress(OSError):
            process.stdin.close()


class Starter(Protocol):
    """Starts processes."""

    def start(
        self, arguments: list[str], largest: int, output: IO[bytes] | int, errors: IO[bytes]
    ) -> Process:
        """A ``gaussiancad`` process in a session of its own.

        Args:
            arguments: of the command.
            largest: bytes of the largest file that it may write.
            output, errors: its standard output and error.
        """

    def close(self) -> None:
        """No more will be started."""


class Interpreters:
    """Starts an interpreter for each process."""

    def start(
        self, arguments: list[str], largest: int, output: IO[bytes] | int, errors: IO[bytes]
    ) -> Process:
        """See :class:`Starter`."""
        command = [*_python(), "gaussiancad_core.processes.limited_child", str(largest), *arguments]
        return subprocess.Popen(
            command,
            # Its end tells the child that nobody waits for it.
            stdin=subprocess.PIPE,
            stdout=output,
            stderr=errors,
            env={**os.environ, **ONE_THREAD},
            start_new_session=True,
        )

    def close(self) -> None:
        """Nothing is kept."""


def starter(modules: Sequence[str]) -> Starter:
    """What starts processes fastest here.

    Args:
        modules: that each of them imports.
    """
    if sys.platform == "linux" and modules:
        with suppress(OSError, ValueError):
            return ForkServer(modules)
    return Interpreters()


class ForkServer:
    """Starts processes that have imported some modules already.

    Raises:
        OSError: there is no server: it could not be started, or has threads.
    """

    def __init__(self, modules: Sequence[str]) -> None:
        self._channel, other = socket.socketpair()
        command = [*_python(), "gaussiancad_core.processes.fork_server", str(other.fileno())]
        with other:
            self._server = subprocess.Popen(
                [*command, *modules],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                pass_fds=[other.fileno()],
                env={**os.environ, **ONE_THREAD},
                start_new_session=True,
            )
        self._text = b""
        self._known: dict[int, ForkedProcess] = {}
        self._count = 0
        self._ready = False
        until = time.monotonic() + _PATIENCE_S
        while not self._ready and self._server.poll() is None and time.monotonic() < until:
            self.hear(0.2)
        if not self._ready:
            self.close()
            raise OSError("no process could be forked")

    def start(
        self, arguments: list[str], largest: int, output: IO[bytes] | int, errors: IO[bytes]
    ) -> Process:
        """See :class:`Starter`; an interpreter where the server is gone."""
        reading, writing = os.pipe()
        null = os.open(os.devnull, os.O_RDWR)
        self._count += 1
        head = {"number": self._count, "file": largest, "arguments": arguments}
        try:
            target = null if isinstance(output, int) else output.fileno()
            text = json.dumps(head).encode("ascii") + b"\n"
            sent = socket.send_fds(self._channel, [text], [reading, target, errors.fileno()])
            self._channel.sendall(text[sent:])
            process = ForkedProcess(self, os.fdopen(writing, "wb", buffering=0))
            self._known[self._count] = process
            until = time.monotonic() + _PATIENCE_S
            while not process.pid and self.is_alive and time.monotonic() < until:
                self.hear(0.2)
            if process.pid:
                return process
            if process.stdin is not None:
                process.stdin.close()
        except OSError:
            with suppress(OSError):
                os.close(writing)
        finally:
            os.close(reading)
            os.close(null)
        return Interpreters().start(arguments, largest, output, errors)

    @property
    def is_alive(self) -> bool:
        """Whether the server is there."""
        return self._server.poll() is None

    def hear(self, seconds: float) -> None:
        """Take in what the server says within that time."""
        try:
            ready, _, _ = select.select([self._channel], [], [], seconds)
            part = self._channel.recv(1 << 16) if ready else b""
        except (OSError, ValueError):
            return
        *lines, self._text = (self._text + part).split(b"\n")
        for line in lines:
            stated = json.loads(line)
            self._ready |= "ready" in stated
            process = self._known.get(stated.get("number", 0))
            if process is not None:
                process.pid = stated.get("pid", process.pid)
                if "code" in stated:
                    process.returncode = stated["code"]
                    del self._known[stated["number"]]

    def close(self) -> None:
        """End the server, and with it all of its processes that still run."""
        self._channel.close()
        self._server.kill()
        self._server.wait()


class ForkedProcess:
    """A process of a server; used as :class:`subprocess.Popen` is."""

    def __init__(self, server: ForkServer, stdin: IO[bytes]) -> None:
        self.pid = 0
        self.stdin: IO[bytes] | None = stdin
        self.returncode: int | None = None
        self._server = server

    def poll(self) -> int | None:
        """See :class:`Process`."""
        if self.returncode is None:
            self._server.hear(0.0)
        if self.returncode is None and (self._is_gone() or not self._server.is_alive):
            # It died with its server, or a signal broke off hearing what became of it.
            self._server.hear(0.1)
            if self.returncode is None:
                self.returncode = -signal.SIGKILL
        return self.returncode

    def _is_gone(self) -> bool:
        try:
            os.kill(self.pid, 0)
        except ProcessLookupError:
            return True
        except OSError:
            return False
        return False

    def wait(self, timeout: float | None = None) -> int:
        """See :class:`Process`."""
        until = time.monotonic() + timeout if timeout is not None else None
        while (code := self.poll()) is None:
            if timeout is not None and until is not None and time.monotonic() >= until:
                raise subprocess.TimeoutExpired("gaussiancad", timeout)
            time.sleep(_WAITS_S)
        return code

    def kill(self) -> None:
        """See :class:`Process`."""
        with suppress(OSError):
            os.kill(self.pid, signal.SIGKILL)


def _python() -> list[str]:
    """The interpreter, which imports from where this one does, up to the module."""
    return [sys.executable, *(["-I"] if sys.flags.isolated else []), "-m"]
