"""What ``benchmark`` knows of each method on each sheet, and tables of text."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from benchmarks.methods.benchmark_runs import Method
from benchmarks.run.workers import Row
from gaussiancad_protocol.modes import Status

NONE = "–"


@dataclass(frozen=True)
class Table:
    """A table of text.

    Attributes:
        title: above it.
        note: what its columns are.
        head: their names.
        rows: as many cells each.
    """

    title: str
    note: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def as_text(self) -> str:
        """For a terminal."""
        lines = [self.head, *self.rows]
        widths = [max(len(line[k]) for line in lines) for k in range(len(self.head))]
        text = ["  ".join(f"{c:<{w}}" for c, w in zip(line, widths, strict=True)) for line in lines]
        return "\n".join([self.title, *(line.rstrip() for line in text)])


@dataclass(frozen=True)
class Record:
    """What one method made of one sheet.

    Attributes:
        part, input: whose and which sheet.
        method: which.
        entry: status, failure, seconds, and the comparison if there is a model.
    """

    part: str
    input: str
    method: Method
    entry: Row

    @property
    def status(self) -> str:
        """``failed`` where there is no model, whatever ended it."""
        given = self.entry.get("status", Status.FAILED.value)
        return given if self.entry.get("comparison") else Status.FAILED.value

    @property
    def falsely_verified(self) -> bool:
        """Whether it is called verified and is not the truth, or could not be measured."""
        verified = self.entry.get("status") == Status.VERIFIED.value
        return verified and not self.entry.get("exact")

    @property
    def failure(self) -> str:
        """The code of what ended it, or nothing."""
        return self.entry.get("failure", "")

    def figure(self, *path: str) -> float | None:
        """A number of the comparison, by its keys."""
        found = self.entry.get("comparison")
        for key in path:
            if found is None:
                return None
            found = found[key]
        return found


def records_of(rows: Iterable[Row]) -> list[Record]:
    """The records of tasks; a task that was ended is one that all of its methods share."""
    found = []
    for row in rows:
        shared = {key: row[key] for key in ("failure", "message", "seconds") if key in row}
        for name, entry in row["models"].items():
            # A model that was made is not one that could not be, but it was not measured.
            found.append(Record(row["part"], row["input"], Method(name), {**shared, **entry}))
    return found


def medians(
    records: Sequence[Record], sheets: Sequence[str], method: Method, *path: str
) -> list[float]:
    """One number a kind of sheet, nan where there is none: a line of a chart."""
    found = []
    for sheet in sheets:
        rs = [r for r in records if r.input == sheet and r.method is method]
        value = median(record.figure(*path) for record in rs)
        found.append(float("nan") if value is None else value)
    return found


def median(values: Iterable[float | None]) -> float | None:
    """The median of those that are known."""
    known = [value for value in values if value is not None]
    return float(np.median(known)) if known else None


def cell(value: float | None, digits: int = 4) -> str:
    """A number as text."""
    return NONE if value is None else f"{value:.{digits}f}"
