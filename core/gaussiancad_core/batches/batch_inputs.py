"""The sheets of a batch: files, folders, patterns, and tables with options for each sheet."""

import csv
import glob
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from gaussiancad_core.errors import LimitError, UsageError
from gaussiancad_core.report.job import Job, corrections_file_of
from gaussiancad_core.storage.plain_files import check_plain
from gaussiancad_protocol.codes import Code

SUFFIXES = frozenset(
    (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".webp", ".pdf", ".svg", ".svgz", ".dxf")
)
"""Of files that are taken from folders; those that are named are taken whatever their name."""

_SHEET = "sheet"
"""The column of a table that has the paths."""

_MOST_ROWS = 50_000
"""Lines of a table: that many sheets take days."""

JobOf = Callable[[Sequence[str]], Job]
"""A job by options of the command line, beside those that all sheets have.

Raises UsageError: an option is unknown or has a wrong value.
"""


@dataclass(frozen=True)
class BatchSheet:
    """A sheet, and what is asked of it.

    Attributes:
        path: of the file.
        job: with the sheet; its output is the folder of the whole batch.
    """

    path: Path
    job: Job


def collect_sheets(named: Iterable[str], job: Job, job_of: JobOf) -> list[BatchSheet]:
    """All sheets that were named, each once, in their order, with the corrections beside them.

    Args:
        named: files; folders, whose drawings are taken, those of folders in them as well; patterns
            such as ``scans/*.png``; tables, ``.csv`` with a column ``sheet`` (paths from where the
            table lies) and columns that are called as options: ``length``, ``page`` ...
        job: what is asked of all sheets.
        job_of: what is asked where a table has options of its own.

    Raises:
        UsageError: ``no-sheets``, ``table-unreadable``.
        LimitError: ``too-many-elements``: a table has more lines than are taken.
    """
    found: dict[str, BatchSheet] = {}
    for name in named:
        for sheet in _sheets(name, job, job_of):
            this_job = replace(
                sheet.job, corrections=corrections_file_of(sheet.path, sheet.job.page)
            )
            found.setdefault(os.path.abspath(sheet.path), replace(sheet, job=this_job))
    if not found:
        raise UsageError(Code.NO_SHEETS, "no drawing was found: name files, folders, or a table")
    return list(found.values())


def _sheets(name: str, job: Job, job_of: JobOf) -> Iterator[BatchSheet]:
    path = Path(name)
    if path.is_dir():
        paths = _in_folder(path, job.output)
    elif path.suffix.lower() == ".csv":
        yield from _in_table(path, job_of)
        return
    elif not path.exists() and glob.has_magic(name):
        paths = [Path(this_path) for this_path in sorted(glob.glob(name, recursive=True))]
    else:
        paths = [path]
    for item in paths:
        yield BatchSheet(item, replace(job, sheet=item))


def _in_folder(folder: Path, output: Path) -> list[Path]:
    """Drawings in a folder and below; not hidden ones, nor what batches wrote."""
    written = output.resolve()
    found: list[Path] = []
    for root, folders, files in os.walk(folder):
        kept = (this_folder for this_folder in folders if not this_folder.startswith("."))
        folders[:] = sorted(text for text in kept if (Path(root) / text).resolve() != written)
        found += [
            Path(root) / file
            for file in sorted(files)
            if not file.startswith(".") and Path(file).suffix.lower() in SUFFIXES
        ]
    return found


def _in_table(table: Path, job_of: JobOf) -> Iterator[BatchSheet]:
    try:
        check_plain(table)
        with table.open(encoding="utf-8-sig", newline="") as file:
            rows = list(csv.DictReader(file, strict=True))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise UsageError(
            Code.TABLE_UNREADABLE, f"{table} cannot be read as a CSV table: {error}"
        ) from error
    if len(rows) > _MOST_ROWS:
        raise LimitError(
            Code.TOO_MANY_ELEMENTS,
            "{path} has {count:,} lines, at most {most:,} are taken: make several tables of it",
            case="table",
            path=table,
            count=len(rows),
            most=_MOST_ROWS,
        )
    # Most lines ask for what others do.
    job_with = lru_cache(maxsize=None)(job_of)
    for number, row in enumerate(rows, start=2):
        place = f"{table}, line {number}"
        if None in row or not row.get(_SHEET):
            raise UsageError(
                Code.TABLE_UNREADABLE,
                f"{place}: each line needs a path in the column '{_SHEET}', and no more cells than "
                "the first line has",
            )
        options: list[str] = []
        for column, value in row.items():
            if column != _SHEET and value:
                options += [f"--{column.replace('_', '-')}={value}"]
        path = table.parent / row[_SHEET]
        try:
            yield BatchSheet(path, replace(job_with(tuple(options)), sheet=path))
        except UsageError as error:
            raise UsageError(error.code, f"{place}: {error.message}") from error
