"""What the tests of batches share: the command, and the rows of its report."""

import csv
import sys
from pathlib import Path

OPTIONS = ("--result", "solid", "--length", "x=80")


def command(*arguments: "str | Path") -> list[str]:
    """The command line of a batch."""
    return [sys.executable, "-m", "gaussiancad_core", "batch", *map(str, arguments)]


def rows(output: Path) -> dict[str, dict[str, str]]:
    """The report of an output folder, by the sheets' names."""
    with open(output / "report.csv", encoding="utf-8", newline="") as file:
        return {row["name"]: row for row in csv.DictReader(file)}
