"""One report over all sheets of a batch."""

import csv
import io
import json
from collections.abc import Sequence
from dataclasses import asdict, astuple, dataclass, fields
from pathlib import Path

from freecad.gaussiancad.staging import staging

SCHEMA = 2

_FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""What formulas begin with."""


@dataclass(frozen=True)
class SheetRow:
    """What became of a sheet.

    Attributes:
        name: of its results.
        sheet: its path.
        folder: of the engine's files.
        status: verified, approximate or failed; it speaks of the shape.
        measures_mm: bound that 95 % of the faces' places keep; empty where it is not known.
        exit_code: of the engine; -1 if it was killed.
        code: kebab-case code of the error, or empty.
        message: a sentence about the error, or empty.
        seconds: of the whole conversion.
    """

    name: str
    sheet: str
    folder: str
    status: str
    measures_mm: str
    exit_code: int
    code: str
    message: str
    seconds: float


def write_report(rows: Sequence[SheetRow], folder: Path) -> None:
    """Write ``report.csv`` and ``report.json``; each appears whole or not at all."""
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow([field.name for field in fields(SheetRow)])
    writer.writerows([_cell(value) for value in astuple(row)] for row in rows)
    _write_whole(folder / "report.csv", text.getvalue())
    values = {"schema": SCHEMA, "sheets": [asdict(row) for row in rows]}
    _write_whole(folder / "report.json", json.dumps(values, indent=2, ensure_ascii=False) + "\n")


def _cell(value: object) -> object:
    """A cell that no spreadsheet takes for a formula."""
    return f"'{value}" if isinstance(value, str) and value.startswith(_FORMULA) else value


def _write_whole(path: Path, text: str) -> None:
    # What is no text, as in a name of bytes, is written as JSON and Python write it.
    with staging(path.parent) as folder:
        staged = folder / path.name
        staged.write_bytes(text.encode("utf-8", "backslashreplace"))
        staged.replace(path)
