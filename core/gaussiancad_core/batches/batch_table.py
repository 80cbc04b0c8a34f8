"""``report.csv``: a row for each sheet of a batch."""

import csv
import io
from collections.abc import Sequence
from dataclasses import astuple, dataclass, fields

REPORT_FILE = "report.csv"

_FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""What formulas begin with."""


@dataclass(frozen=True)
class BatchRow:
    """What became of one sheet.

    Attributes:
        name: of its folder.
        sheet: its path.
        folder: of the results.
        status: as in its report, or ``failed``; it speaks of the shape.
        measures_mm: bound that 95 % of the faces' places keep; empty where it is not known.
        exit_code: of its process; 130 where the batch ended before the sheet did.
        code: kebab-case code of its error, or empty.
        message: of its error, or empty.
        seconds: of the run.
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


def table_bytes(rows: Sequence[BatchRow]) -> bytes:
    """The rows as CSV in UTF-8; what is no text in a name is written with backslashes."""
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow([field.name for field in fields(BatchRow)])
    writer.writerows([_cell(value) for value in astuple(row)] for row in rows)
    return text.getvalue().encode("utf-8", "backslashreplace")


def _cell(value: object) -> object:
    """A cell that no spreadsheet takes for a formula."""
    return f"'{value}" if isinstance(value, str) and value.startswith(_FORMULA) else value
