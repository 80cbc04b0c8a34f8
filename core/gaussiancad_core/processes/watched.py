"""A ``gaussiancad`` command in a process of its own, and what is left where that process dies.

The geometry kernel and other compiled libraries may end the process that they run in.  So a command
that uses them runs in a child, which writes the stage that it is in to a file without a name; who
started it lives on to tell what happened.  ``python -m gaussiancad_core.processes.watched FD
ARGUMENTS...`` is the child.  As a call of the kernel may never return, the system ends the child
where it looks for the solid for longer than any part takes.
"""

import math
import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from tempfile import TemporaryFile
from types import FrameType
from typing import Any

from gaussiancad_core.processes.events import ending_signals
from gaussiancad_core.processes.limited_child import limit_itself, limit_processor, processor_limit

_UNLIMITED = 1 << 50
"""Bytes of a file: what is written is bounded by the disk alone."""

_LONGEST_NAME = 64
"""Bytes of a stage's name."""

_OF_THE_KERNEL = "solid"
"""The stage whose seconds are limited."""

_MOST_SECONDS = 900.0
"""Of the processor, in that stage: six times what the largest parts take.  By seconds of the clock
the result would depend on what else the machine does."""


@dataclass(frozen=True)
class Watched:
    """How a command ended.

    Attributes:
        exit_code: of the process; negative where a signal ended it.
        stage: that it was in, empty before the first.
    """

    exit_code: int
    stage: str

    @property
    def signal(self) -> str:
        """Name of the signal that ended it; empty where none did."""
        if self.exit_code >= 0:
            return ""
        try:
            return signal.Signals(-self.exit_code).name
        except ValueError:
            return f"signal {-self.exit_code}"


def watch(arguments: Sequence[str]) -> Watched:
    """Run a command in a child to its end; it reads and prints what this process would.

    The signals that end this process are handed on: the child tells how far it came.

    Raises:
        OSError: nothing was started, as there is no room for the stage's name, or no process left.
    """
    python = [sys.executable, *(["-I"] if sys.flags.isolated else []), "-m", __name__]
    with TemporaryFile() as note:
        # The room is taken now: later there may be none.
        note.write(b" " * _LONGEST_NAME)
        note.flush()
        fileno = note.fileno()
        # The child hears none of them before it can tell how far it came: it lets them in itself.
        before = signal.pthread_sigmask(signal.SIG_BLOCK, ending_signals())
        try:
            child = subprocess.Popen([*python, str(fileno), *arguments], pass_fds=(fileno,))
            handlers = _handing_on(child)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
        code = _ended(child, handlers)
        return Watched(code, os.pread(fileno, _LONGEST_NAME, 0).decode("utf-8", "replace").strip())


_Handlers = dict[signal.Signals, Any]
"""What a signal did before."""


def _handing_on(child: "subprocess.Popen[bytes]") -> _Handlers:
    """Hand the signals that are to end this process on to a child."""

    def hand_on(number: int, _frame: FrameType | None) -> None:
        child.send_signal(number)

    # Ctrl-C reaches the child by itself, too: it takes the first.
    return {number: signal.signal(number, hand_on) for number in ending_signals()}


def _ended(child: "subprocess.Popen[bytes]", before: _Handlers) -> int:
    """The exit code of a child; then signals do what they did before."""
    try:
        return child.wait()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


class StageNotes:
    """A listener that writes the name of the stage to the start of a file, and lets the system end
    this process (SIGXCPU) where it looks for the solid for too long.

    Args:
        descriptor: of the file.
        most: s of the processor in which the solid is looked for.
    """

    def __init__(self, descriptor: int, most: float = _MOST_SECONDS) -> None:
        self._descriptor, self._most = descriptor, most
        self._usual = processor_limit()

    def send(self, event: str, **fields: Any) -> None:  # noqa: ANN401
        """Take one event."""
        if event == "stage":
            name = str(fields["name"]).encode()[:_LONGEST_NAME]
            os.pwrite(self._descriptor, name.ljust(_LONGEST_NAME), 0)
            more = self._most if fields["name"] == _OF_THE_KERNEL else math.inf
            limit_processor(min(time.process_time() + more, self._usual))


if __name__ == "__main__":
    # Until the command can tell how far it came, it ends at once, without a traceback.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    limit_itself(_UNLIMITED)
    # What this process starts needs no part of it.
    os.set_inheritable(int(sys.argv[1]), False)
    from gaussiancad_core.processes.command_entry import run_command

    sys.exit(run_command(sys.argv[2:], StageNotes(int(sys.argv[1]))))
