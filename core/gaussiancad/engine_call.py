"""A command of the engine, run in a process of its own to its end.

The geometry kernel may end the process that it runs in, and numerical libraries read their
environment when they are loaded.  So nothing of the engine is loaded here: the process that is
started sets up its own environment, and what it says comes back as events.
"""

import contextlib
import importlib.util
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import IO, Any

from gaussiancad_core.errors import (
    CancelledError,
    EngineError,
    GaussianCadError,
    LimitError,
    NoModelError,
    UnreadableError,
    UsageError,
)
from gaussiancad_core.messages import filled
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.event_lines import Event, EventKind, parse_event
from gaussiancad_protocol.exit_codes import ExitCode

PYTHON_VARIABLE = "GAUSSIANCAD_PYTHON"
"""Environment variable that names the engine's interpreter, as for the workbench."""

_CORE = Path(__file__).resolve().parents[1]
"""The folder of the engine's packages: that of this package, so that versions never differ."""

_KERNEL = "OCP"
"""A library that an engine's environment has, and other Pythons have not."""

_SECONDS_TO_STOP = 30.0
"""That a run has to end once it is told to: as the workbench waits before it ends a process."""

_LAST_BYTES = 1 << 16
"""Of what the process printed as errors that are looked at."""

_SECONDS_BETWEEN = 0.5
"""After which progress is called again where the run says nothing new."""

Progress = Callable[[str, float], None]
"""Called with the running stage and the fraction of it that is done, 0 to 1: at each event, and
twice a second between events, so that an exception in it stops a run that says nothing, too."""


@dataclass(frozen=True)
class Watch:
    """Over a run.

    Attributes:
        progress: called with how far the run is; an exception in it stops the run.
        limit_s: seconds after which the run is stopped.
    """

    progress: Progress | None = None
    limit_s: float | None = None

    def callback(self) -> Progress | None:
        """What is called as :data:`Progress`, from now on; None where nobody watches.

        It raises a LimitError, ``takes-too-long``, once the limit has passed.
        """
        if self.limit_s is None:
            return self.progress
        end = time.monotonic() + self.limit_s

        def called(stage: str, fraction: float) -> None:
            if time.monotonic() > end:
                raise LimitError(
                    Code.TAKES_TOO_LONG,
                    "it took more than {seconds} s, in the stage {stage}: give it more with "
                    "limit_s",
                    seconds=f"{self.limit_s:g}",
                    stage=stage,
                )
            if self.progress is not None:
                self.progress(stage, fraction)

        return called


_ERRORS: dict[int, type[GaussianCadError]] = {
    ExitCode.USAGE: UsageError,
    ExitCode.UNREADABLE: UnreadableError,
    ExitCode.NO_MODEL: NoModelError,
    ExitCode.LIMIT: LimitError,
    ExitCode.CANCELLED: CancelledError,
}


@dataclass(frozen=True)
class EndedCommand:
    """What a command ended with.

    Attributes:
        exit_code: of the process.
        printed: on standard output, by a command without events.
        errors: the last of what it printed on standard error.
        error_event: the event ``error``, where one was sent.
    """

    exit_code: int
    printed: str = ""
    errors: str = ""
    error_event: Mapping[str, Any] = field(default_factory=dict)

    def error(self) -> GaussianCadError:
        """The error that the command ended with."""
        code, message = self.error_event.get("code"), self.error_event.get("message")
        if not (isinstance(code, str) and isinstance(message, str)):
            code, message = self._last_line()
        args = self.error_event.get("args")
        known = filled(message, args if isinstance(args, Mapping) else {})
        return _ERRORS.get(self.exit_code, EngineError)(code, known)

    def _last_line(self) -> tuple[str, str]:
        """Code and message of the line by which a command tells its error."""
        last = next(iter(reversed(self.errors.strip().splitlines())), "")
        message, _, code = last.removeprefix("gaussiancad: ").rpartition(" [")
        if message and code.endswith("]"):
            return code[:-1], message
        return (
            Code.ENGINE_BROKEN,
            f"the engine ended with {self.exit_code} ({last or 'no message'})",
        )


def engine_python() -> str:
    """The interpreter that has the engine's libraries.

    Returns:
        That of ``GAUSSIANCAD_PYTHON`` if set, else this one if it has the libraries, else that of
        the environment ``.venv`` in a checkout.

    Raises:
        EngineError: ``engine-missing``.
    """
    named = os.environ.get(PYTHON_VARIABLE)
    if named:
        if not os.access(named, os.X_OK) or Path(named).is_dir():
            raise EngineError(
                Code.ENGINE_MISSING,
                "{variable} names {path}, which is no interpreter: correct or unset it",
                variable=PYTHON_VARIABLE,
                path=named,
            )
        return named
    if importlib.util.find_spec(_KERNEL) is not None and sys.executable:
        return sys.executable
    path = _CORE.parent / ".venv" / "bin" / "python"
    if path.is_file():
        return str(path)
    raise EngineError(
        Code.ENGINE_MISSING,
        "this Python ({python}) lacks the engine's libraries: pip install gaussiancad-core, or "
        "name an interpreter that has them in {variable}",
        python=sys.executable or "unknown",
        variable=PYTHON_VARIABLE,
    )


def run_command(arguments: Sequence[str], watch: Watch = Watch()) -> EndedCommand:
    """Run a command of the engine that sends events, or one that prints.

    Args:
        arguments: of ``gaussiancad``; with ``--events`` its events are heard.
        watch: over the run.

    Raises:
        EngineError: no engine was found, or none can be started.
        LimitError: ``takes-too-long``.
        KeyboardInterrupt: by Ctrl-C, once the run has ended.
    """
    command = [engine_python(), "-P", "-u", "-m", "gaussiancad_core", *arguments]
    progress = watch.callback()
    with tempfile.TemporaryFile() as errors:
        try:
            process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=errors,
                env=_environment(),
                # Ctrl-C is handed on below, as a wish to stop.
                start_new_session=True,
            )
        except OSError as error:
            raise EngineError(
                Code.ENGINE_BROKEN,
                "the engine cannot be started ({reason}): run `gaussiancad doctor`",
                reason=error.strerror or error,
            ) from error
        printed, stated = _heard(process, progress, arguments[0], events="--events" in arguments)
        return EndedCommand(process.wait(), printed, _last_of(errors), stated)


def _environment() -> dict[str, str]:
    known = os.environ.get("PYTHONPATH")
    path = os.pathsep.join([str(_CORE), known] if known else [str(_CORE)])
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONHOME"}
    return {**kept, "PYTHONPATH": path}


def _heard(
    process: "subprocess.Popen[bytes]", progress: Progress | None, command: str, *, events: bool
) -> tuple[str, Mapping[str, Any]]:
    """What a process printed, or the error that it told, once it has ended."""
    assert process.stdin is not None and process.stdout is not None
    lines: SimpleQueue[bytes | None] = SimpleQueue()
    # It reads on after a wish to stop: a run must not wait for a reader of what it still prints.
    listener = threading.Thread(target=_listen, args=(process.stdout, lines), daemon=True)
    listener.start()
    printed: list[str] = []
    stated: Mapping[str, Any] = {}
    running = command, 0.0
    try:
        while (line := _next_line(lines, progress, running)) is not None:
            text = line.decode("utf-8", "replace")
            if not events:
                printed.append(text)
                continue
            event = parse_event(text)
            if event is None:
                continue
            if event.kind is EventKind.ERROR:
                stated = event.fields
            elif progress is not None and (found := _running(event)) is not None:
                running = found
                progress(*running)
        process.wait()
    except BaseException:
        _stop(process)
        raise
    finally:
        with contextlib.suppress(OSError):
            process.stdin.close()
        # A process that the run left behind may hold its end of the pipe open.
        listener.join(1.0)
        if not listener.is_alive():
            process.stdout.close()
    return "".join(printed), stated


def _next_line(
    lines: "SimpleQueue[bytes | None]", progress: Progress | None, running: tuple[str, float]
) -> bytes | None:
    """The next line that a process prints; None at its end."""
    while progress is not None:
        try:
            return lines.get(timeout=_SECONDS_BETWEEN)
        except Empty:
            progress(*running)
    return lines.get()


def _listen(stream: IO[bytes], lines: "SimpleQueue[bytes | None]") -> None:
    with contextlib.suppress(OSError, ValueError):
        for line in stream:
            lines.put(line)
    lines.put(None)


def _running(event: Event) -> tuple[str, float] | None:
    """The stage that an event speaks of, and the fraction of it that is done."""
    if event.kind is EventKind.STAGE:
        return event.text("name"), 0.0
    if event.kind is EventKind.PROGRESS:
        return event.text("stage"), event.number("fraction") or 0.0
    return None


def _stop(process: "subprocess.Popen[bytes]") -> None:
    """End a run: by its own wish to stop, or after a while by force."""
    assert process.stdin is not None
    with contextlib.suppress(OSError):
        process.stdin.write(b"cancel\n")
        process.stdin.close()
    process.terminate()
    try:
        process.wait(_SECONDS_TO_STOP)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _last_of(file: IO[bytes]) -> str:
    size = file.seek(0, os.SEEK_END)
    file.seek(max(size - _LAST_BYTES, 0))
    return file.read().decode("utf-8", "replace")
