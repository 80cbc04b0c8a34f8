"""The engine's command in a process of its own, with a limit of seconds."""

import json
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from benchmarks.run.workers import Row

JUST_ENDED_S = 30.0
"""Seconds beyond a command's limit that the child which waits for it may take."""


@dataclass(frozen=True)
class Ended:
    """How a command ended.

    Attributes:
        exit_code: of the process; None where it was ended at its limit.
        error: the code of its error, or the last line where that has none; empty if all went well.
        seconds: by the clock.
    """

    exit_code: int | None
    error: str
    seconds: float

    @property
    def row(self) -> Row:
        """For a row of a table."""
        if self.exit_code is None:
            return {"exit_code": None, "seconds": self.seconds}
        return {"exit_code": self.exit_code, "error": self.error, "seconds": self.seconds}


def command(*arguments: object, limit_s: float | None = None) -> Ended:
    """Run ``gaussiancad`` with some arguments."""
    began = time.monotonic()
    try:
        done = subprocess.run(
            [sys.executable, "-m", "gaussiancad_core", *map(str, arguments)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            timeout=limit_s,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return Ended(None, "", limit_s or 0.0)
    seconds = time.monotonic() - began
    lines = done.stderr.decode("utf-8", "replace").strip().splitlines()
    last = lines[-1] if done.returncode and lines else ""
    error = last.rsplit("[", 1)[-1].rstrip("]") if last.endswith("]") else last
    return Ended(done.returncode, error, seconds)


def command_for_solid(
    sheet: Path, output: Path, *options: str, limit_s: float | None = None
) -> Ended:
    """Reconstruct the solid of a sheet by the command, which leaves in the folder what it had made
    when its time was up."""
    given = ("--output", output, "--result", "solid", *options)
    return command("reconstruct", sheet, *given, limit_s=limit_s)


def read_json(path: Path) -> Row:
    """The content of a file; nothing where there is none."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
