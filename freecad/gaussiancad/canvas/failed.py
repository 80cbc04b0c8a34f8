"""The sheets of a batch that need a person: those that failed, and those that are approximate."""

from __future__ import annotations

import csv
import json
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

_STATUSES = ("failed", "approximate")
"""Those that are listed, in their order."""


@dataclass(frozen=True)
class FailedSheet:
    """A row of a batch's report.

    Attributes:
        name: of its results.
        sheet: path of the drawing.
        page: of a file with pages.
        status: ``failed`` or ``approximate``.
        code, message, args: of the engine's first message about it; empty where there is none.
    """

    name: str
    sheet: Path
    page: int = 1
    status: str = _STATUSES[0]
    code: str = ""
    message: str = ""
    args: Mapping[str, object] = field(default_factory=dict)


def failed_sheets(report: Path) -> tuple[FailedSheet, ...]:
    """The sheets of a report that need a person; those that failed come first.

    Args:
        report: of a batch, ``report.json`` or ``report.csv``.

    Raises:
        OSError: it cannot be read.
        ValueError: it is no report of a batch.
    """
    found = [item for item in map(_sheet, _rows(report)) if item.status in _STATUSES]
    return tuple(sorted(found, key=lambda item: _STATUSES.index(item.status)))


def _rows(report: Path) -> list[Mapping[str, object]]:
    text = report.read_text(encoding="utf-8", errors="replace")
    known = {"name", "sheet", "status"}
    rows: object
    if report.suffix.lower() == ".json":
        try:
            found = json.loads(text)
        except ValueError:
            found = None
        rows = found.get("sheets") if isinstance(found, dict) else None
    else:
        table = csv.DictReader(text.splitlines())
        # A table without rows is a report only by the names of its columns.
        rows = list(table) if known <= set(table.fieldnames or ()) else None
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise ValueError(f"{report.name} is no report of a batch")
    if any(not known <= row.keys() for row in rows):
        raise ValueError(f"{report.name} is no report of a batch")
    return rows


def _sheet(row: Mapping[str, object]) -> FailedSheet:
    def text(name: str) -> str:
        found = str(row.get(name) or "")
        # Texts that a spreadsheet would compute are kept with a mark before them.
        return found[1:] if found[:1] == "'" and found[1:2] in "=+-@" else found

    failed_sheet = FailedSheet(
        text("name"),
        Path(text("sheet")),
        status=text("status"),
        code=text("code"),
        message=text("message"),
    )
    return _with_details(failed_sheet, Path(text("folder")))


def _with_details(row: FailedSheet, folder: Path) -> FailedSheet:
    """The row with what the sheet's own report says, where the run left one."""
    try:
        report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
        row = replace(row, page=int(report["settings"]["page"]))
        why = next(iter(report["reasons"]))
        args = why.get("args", {})
        return replace(row, code=why["code"], message=why["message"], args=dict(args))
    except (OSError, ValueError, TypeError, KeyError, StopIteration):
        return row
