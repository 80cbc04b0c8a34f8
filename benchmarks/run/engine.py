"""The engine in a process of its own, with a limit of seconds: from Python, and as a command."""

import json
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import gaussiancad
from benchmarks.run.workers import Row
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

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


def part_of(sheet: Path, output: Path, *, limit_s: float | None = None, **given: Any) -> Ended:  # noqa: ANN401
    """Reconstruct the solid of a sheet, as a user of Python does, into a folder.

    Args:
        sheet: its file.
        output: where the files of the run are saved, unless it ended with an error.
        limit_s: seconds.
        given: what is known of the sheet; see :func:`gaussiancad.reconstruct`.
    """
    began = time.monotonic()
    try:
        result = gaussiancad.reconstruct(sheet, result="solid", limit_s=limit_s, **given)
    except gaussiancad.LimitError as error:
        if error.code == Code.TAKES_TOO_LONG and limit_s is not None:
            return Ended(None, "", limit_s)
        return Ended(error.exit_code, error.code, time.monotonic() - began)
    except gaussiancad.Error as error:
        return Ended(error.exit_code, error.code, time.monotonic() - began)
    result.save(output)
    seconds = time.monotonic() - began
    if result.status != "failed":
        return Ended(ExitCode.DONE, "", seconds)
    return Ended(ExitCode.NO_MODEL, next((reason.code for reason in result.reasons), ""), seconds)


def command_for_solid(sheet: Path, output: Path, limit_s: float | None = None) -> Ended:
    """Reconstruct the solid of a sheet by the command, which leaves in the folder what it had made
    when its time was up."""
    options = ("--output", output, "--result", "solid")
    return command("reconstruct", sheet, *options, limit_s=limit_s)


def read_json(path: Path) -> Row:
    """The content of a file; nothing where there is none."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
