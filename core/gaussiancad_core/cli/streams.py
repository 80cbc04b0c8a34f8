"""What the command prints on: streams that are closed, full, or that nobody reads any more."""

import os
import sys
from contextlib import suppress
from typing import TextIO

_STREAMS = (("stdin", "r"), ("stdout", "w"), ("stderr", "w"))
"""By their numbers."""


def keep_streams() -> None:
    """Open the null device in place of standard streams that are closed: the next file that is
    opened would take their number, and what is printed would land in it."""
    for number, (name, mode) in enumerate(_STREAMS):
        try:
            os.fstat(number)
        except OSError:
            null = os.open(os.devnull, os.O_RDWR)
            if null != number:
                os.dup2(null, number)
                os.close(null)
            # Of children, too.
            os.set_inheritable(number, True)
        if getattr(sys, name) is None:
            stream = open(number, mode, encoding="utf-8", errors="replace", closefd=False)  # noqa: SIM115
            setattr(sys, name, stream)


def say(line: str) -> None:
    """Print a line on stderr; where that cannot be written to, the exit code has to do."""
    with suppress(ValueError):
        try:
            print(line, file=sys.stderr, flush=True)
        except OSError:
            drop(sys.stderr)


def drop(stream: TextIO) -> None:
    """Let what is left to be printed go nowhere: at its end Python prints it."""
    with open(os.devnull, "wb") as nowhere, suppress(ValueError):
        os.dup2(nowhere.fileno(), stream.fileno())
