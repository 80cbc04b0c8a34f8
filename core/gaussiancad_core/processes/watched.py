"""A ``gaussiancad`` command in a process of its own, and what is left where that process dies.

The geometry kernel and other compiled libraries may end the process that they run in.  So a command
that uses them runs in a child, which writes the stages that it enters to a pipe; who started it
lives on to tell what happened.  ``python -m gaussiancad_core.processes.watched FD ARGUMENTS...``
is the child.
"""

import os
import signal
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from types import FrameType
from typing import Any

from gaussiancad_core.processes.child import limit_itself

_UNLIMITED = 1 << 50
"""Bytes of a file: what is written is bounded by the disk alone."""

_MOST_NOTES = 1 << 16
"""Bytes of stages' names that are looked at."""


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
    """
    told, telling = os.pipe()
    python = [sys.executable, *(["-I"] if sys.flags.isolated else []), "-m", __name__]
    child = subprocess.Popen([*python, str(telling), *arguments], pass_fds=(telling,))
    os.close(telling)

    def hand_on(number: int, _frame: FrameType | None) -> None:
        child.send_signal(number)

    before = {number: signal.signal(number, hand_on) for number in (signal.SIGTERM,)}
    # Ctrl-C reaches the child by itself.
    before[signal.SIGINT] = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        code = child.wait()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    with open(told, "rb") as notes:
        stages = notes.read(_MOST_NOTES).decode("utf-8", "replace").split()
    return Watched(code, stages[-1] if stages else "")


class StageNotes:
    """A listener that writes the names of stages to a pipe.

    Args:
        descriptor: of the pipe.
    """

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor

    def send(self, event: str, **fields: Any) -> None:  # noqa: ANN401
        """Take one event."""
        if event == "stage":
            os.write(self._descriptor, f"{fields['name']}\n".encode())


if __name__ == "__main__":
    limit_itself(_UNLIMITED)
    # What this process starts needs no part of it.
    os.set_inheritable(int(sys.argv[1]), False)
    from gaussiancad_core.cli import main

    sys.exit(main(sys.argv[2:], StageNotes(int(sys.argv[1]))))
