"""What a run tells while it goes on: JSON lines on stdout, and how it is stopped.

The protocol (version 1) is one JSON object a line with the key ``event``: ``hello``, ``stage``,
``progress``, ``preview``, ``warning``, ``sheet``, ``result``, ``error``.  Logs go to stderr.
Libraries print to file descriptor 1 (OpenCASCADE's STEP writer does), so
:func:`open_event_stream` keeps a duplicate of it for the events and points 1 at stderr.
"""

import json
import os
import signal
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, Protocol, TextIO

from gaussiancad_core.errors import CancelledError
from gaussiancad_protocol.codes import Code


class Listener(Protocol):
    """Where the events of a run go."""

    def send(self, event: str, **fields: Any) -> None:  # noqa: ANN401
        """Take one event; ``fields`` are JSON values."""


class Silence:
    """A listener that hears nothing."""

    def send(self, event: str, **fields: Any) -> None:  # noqa: ANN401
        """Drop the event."""


@dataclass(frozen=True)
class Both:
    """Two listeners that hear the same."""

    one: Listener
    other: Listener

    def send(self, event: str, **fields: Any) -> None:  # noqa: ANN401
        """Hand the event on."""
        self.one.send(event, **fields)
        self.other.send(event, **fields)


@dataclass(frozen=True)
class JsonLines:
    """A listener that writes JSON lines.

    Attributes:
        stream: text stream in UTF-8.
    """

    stream: TextIO

    def send(self, event: str, **fields: Any) -> None:  # noqa: ANN401
        """Write one event and flush it; a reader that has gone away is no error of the run."""
        try:
            self.stream.write(json.dumps({"event": event, **fields}, ensure_ascii=False) + "\n")
            self.stream.flush()
        except (BrokenPipeError, ValueError):
            return


@dataclass
class Progress:
    """The running stage's way to say how far it is; it also times the stages.

    Attributes:
        listener: where the events go.
        total: number of stages.
        seconds: duration of each finished stage, in order.
    """

    listener: Listener
    total: int
    seconds: dict[str, float] = field(default_factory=dict)
    _name: str = ""
    _started: float = 0.0
    _last_sent: float = 0.0

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Announce a stage, and note its duration when it ends well."""
        self._name, self._started, self._last_sent = name, time.monotonic(), 0.0
        self.listener.send("stage", name=name, index=len(self.seconds) + 1, of=self.total)
        yield
        self.seconds[name] = round(time.monotonic() - self._started, 3)
        self.listener.send("progress", stage=name, fraction=1.0, eta_s=0.0)

    @property
    def current(self) -> str:
        """Name of the stage that runs, or ran last."""
        return self._name

    def __call__(self, fraction: float, loss: float | None = None) -> None:
        """Tell the fraction of the running stage that is done; at most ten times a second."""
        now = time.monotonic()
        if now - self._last_sent < 0.1:
            return
        self._last_sent = now
        elapsed = now - self._started
        fields: dict[str, Any] = {"stage": self._name, "fraction": round(fraction, 4)}
        if loss is not None:
            fields["loss"] = round(float(loss), 6)
        if fraction > 0:
            fields["eta_s"] = round(elapsed * (1.0 - fraction) / fraction, 1)
        self.listener.send("progress", **fields)


def open_event_stream() -> JsonLines:
    """Take stdout for events; everything else that is printed goes to stderr from now on."""
    sys.stdout.flush()
    dup = os.dup(1)
    os.dup2(2, 1)
    sys.stdout = sys.stderr
    # What is no text in a name becomes an escape that JSON readers turn back.
    lines = os.fdopen(dup, "w", encoding="utf-8", errors="backslashreplace", newline="\n")
    return JsonLines(lines)


_AGAIN_S = 5.0
"""s after which a run that is to stop and did not is stopped again."""


def ending_signals() -> tuple[signal.Signals, ...]:
    """Signals that ask this process to end, be it that its terminal is closed: unless whoever
    started it wants it to outlive that."""
    closed = getattr(signal, "SIGHUP", None)
    if closed is None or signal.getsignal(closed) is signal.SIG_IGN:
        return signal.SIGINT, signal.SIGTERM
    return signal.SIGINT, signal.SIGTERM, closed


class Cancellation:
    """Lets signals that end raise :class:`CancelledError` in the main thread.

    What is raised within a callback of a library is lost there, so that it is raised again until
    it arrived.
    """

    def __init__(self) -> None:
        self._arrived = threading.Event()
        self._is_due = True
        self._because = ""
        self.raised: CancelledError | None = None
        """What was raised, if anything was."""
        for number in ending_signals():
            signal.signal(number, self._handle)

    def begin(self) -> None:
        """Let in the signals that whoever started this process held back until now."""
        if hasattr(signal, "pthread_sigmask"):
            signal.pthread_sigmask(signal.SIG_UNBLOCK, ending_signals())

    def stop(self, cause: str) -> None:
        """Stop the run from another thread; ``cause`` follows the word "cancelled"."""
        self._because = cause
        stop_main_thread()

    def end(self) -> None:
        """The run has ended, however it did: nothing is raised any more."""
        self._arrived.set()

    def _handle(self, number: int, _frame: object) -> None:
        if self._arrived.is_set() or not self._is_due:
            return
        self._is_due = False
        threading.Thread(target=self._insist, args=(number,), name="cancel", daemon=True).start()
        cause = self._because or f"by {signal.Signals(number).name}"
        self.raised = CancelledError(Code.CANCELLED, f"cancelled {cause}")
        raise self.raised

    def _insist(self, number: int) -> None:
        if not self._arrived.wait(_AGAIN_S):
            self._is_due = True
            _signal_main_thread(number)


def cancellation_behind(error: BaseException) -> CancelledError | None:
    """The cancellation that an error stands for, if it stands for one.

    A compiled function that was interrupted ends by a ``SystemError`` with the cause beneath.
    """
    found: BaseException | None = error
    while isinstance(found, SystemError):
        found = found.__cause__ or found.__context__
    return found if isinstance(found, CancelledError) else None


def _signal_main_thread(number: int) -> None:
    """Send a signal to the main thread, out of whatever it waits for where the system can."""
    thread = threading.main_thread().ident
    if thread is not None and hasattr(signal, "pthread_kill"):
        signal.pthread_kill(thread, number)
    else:
        signal.raise_signal(number)


def stop_main_thread() -> None:
    """Stop the run as SIGTERM does, from another thread."""
    _signal_main_thread(signal.SIGTERM)


def cancel_on_stdin(cancellation: Cancellation) -> None:
    """Stop the run when a line ``cancel`` comes on stdin, or stdin ends (the parent is gone)."""

    def watch() -> None:
        cause = "as standard input ended, which stops a run with --events"
        for line in sys.stdin:
            if line.strip() == "cancel":
                cause = "on standard input"
                break
        cancellation.stop(cause)

    threading.Thread(target=watch, name="stdin", daemon=True).start()
