"""The command of the engine in a process of its own, with a limit of seconds."""

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
        stderr: what it wrote there.
        seconds: by the clock.
    """

    exit_code: int | None
    stderr: str
    seconds: float

    @property
    def error(self) -> str:
        """The code of its error, or the last line where that has none; empty if all went well."""
        lines = self.stderr.strip().splitlines()
        if not self.exit_code or not lines:
            return ""
        return lines[-1].rsplit("[", 1)[-1].rstrip("]") if lines[-1].endswith("]") else lines[-1]

    @property
    def row(self) -> Row:
        """For a row of a table."""
        if self.exit_code is None:
            return {"exit_code": None, "seconds": self.seconds}
        return {"exit_code": self.exit_code, "error": self.error, "seconds": self.seconds}


def engine(*arguments: object, limit_s: float | None = None) -> Ended:
    """Run ``gaussiancad`` with some arguments."""
    command = [sys.executable, "-m", "gaussiancad_core", *map(str, arguments)]
    began = time.monotonic()
    try:
        done = subprocess.run(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            timeout=limit_s,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return Ended(None, "", limit_s or 0.0)
    seconds = time.monotonic() - began
    return Ended(done.returncode, done.stderr.decode("utf-8", "replace"), seconds)


def solid_from(sheet: Path, output: Path, *more: object, limit_s: float | None = None) -> Ended:
    """Reconstruct the solid of a sheet into a folder."""
    options = ("--output", output, "--result", "solid", *more)
    return engine("reconstruct", sheet, *options, limit_s=limit_s)


def read_json(path: Path) -> Row:
    """The content of a file; nothing where there is none."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
