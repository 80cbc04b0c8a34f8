"""One report over all sheets of a batch."""

import csv
import io
import json
import os
from collections.abc import Sequence
from dataclasses import asdict, dataclass, fields
from pathlib import Path

SCHEMA = 2


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
    writer = csv.DictWriter(text, [field.name for field in fields(SheetRow)])
    writer.writeheader()
    writer.writerows(asdict(row) for row in rows)
    _write_whole(folder / "report.csv", text.getvalue())
    values = {"schema": SCHEMA, "sheets": [asdict(row) for row in rows]}
    _write_whole(folder / "report.json", json.dumps(values, indent=2, ensure_ascii=False) + "\n")


def _write_whole(path: Path, text: str) -> None:
    staged = path.with_name(f".{path.name}.{os.getpid()}")
    staged.write_text(text, encoding="utf-8", newline="")
    staged.replace(path)
