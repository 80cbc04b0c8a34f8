"""What a benchmark finds: figures with names and units."""

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Figure:
    """A number that a benchmark states.

    Attributes:
        name: what it is of.
        value: the number, or a text such as ``3 of 6``.
        unit: of the number; empty where it is a count or a share.
    """

    name: str
    value: float | str
    unit: str = ""

    def __str__(self) -> str:
        value = self.value if isinstance(self.value, str) else f"{self.value:.6g}"
        return f"{self.name}: {value}{f' {self.unit}' if self.unit else ''}"


@dataclass(frozen=True)
class Outcome:
    """What a run found.

    Attributes:
        figures: the headline first.
        wrong: whether something is that must not be: the command ends with 1.
        head: columns of the table that is recorded; empty without one.
        rows: of that table.
    """

    figures: tuple[Figure, ...] = ()
    wrong: bool = False
    head: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()


def share(name: str, found: int, total: int) -> Figure:
    """A count of a count."""
    return Figure(name, f"{found} of {total}")


def as_cells(rows: Sequence[Sequence[object]]) -> tuple[tuple[str, ...], ...]:
    """Rows of a table as they are recorded."""
    return tuple(tuple(map(str, row)) for row in rows)


def as_table(head: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """Lines of text with the first column on the left and all others on the right."""
    cells = [[str(cell) for cell in row] for row in (head, *rows)]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return "\n".join(
        "  ".join([row[0].ljust(widths[0]), *map(str.rjust, row[1:], widths[1:])]).rstrip()
        for row in cells
    )
