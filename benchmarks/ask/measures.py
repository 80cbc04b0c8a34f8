"""How well are the measures of solids known, and is that what is said of them?

Small parts whose measures are hundredths of a millimetre, and parts of the classes with round ones
are drawn as pictures, with and without dimensions, and as scans; each face of the solid that comes
out is put beside the part, and each of the part's faces beside the solid.

Counted are solids of the right shape: as many faces as the part, none of them farther than two
pixels from where it belongs.  ``within`` is the share of their faces, of all together, that lie
within ``uncertainty_mm``, and should be 95 % at least; ``least`` the share of the solid for which
it is the smallest.  ``bound`` is that uncertainty, in px, in the median; ``faces`` what 95 % of all
faces keep, ``needed`` the same as a share of their solid's bound: far below 1 where bounds are
needlessly wide.  Exit code 1 if less than 95 % of the faces of a row lie within their bounds.
"""

import argparse
from collections.abc import Iterable, Iterator

import numpy as np

from benchmarks.parts.twin_parts import FAMILIES as TWINS
from benchmarks.run.arguments import add_running
from benchmarks.run.outcome import Figure, Outcome, as_cells, as_table, share
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import Row
from benchmarks.sheets.exact_inputs import InputKind
from benchmarks.tasks.measures_work import Group, Task, worked
from sample_parts.classed import PartClass

MINUTES = 60

INPUTS = (
    InputKind.FOREIGN,
    InputKind.FOREIGN_DIMENSIONED,
    InputKind.CLEAN,
    InputKind.SCAN,
    InputKind.DIMENSIONED,
)

_RIGHT_PX = 2.0
"""px that a face is displaced by at most if it is the one that was drawn."""

_ASKED = 0.95

_FEWEST = 100
"""Faces from which a row can be wrong."""

_HEAD = ("", "", "sheets", "right", "faces", "95 % px", "bound px", "within", "least", "needed")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    groups, kinds = [item.value for item in Group], [item.value for item in INPUTS]
    parser.add_argument("--groups", nargs="*", default=groups, choices=groups, metavar="NAME")
    parser.add_argument("--inputs", nargs="*", default=kinds, choices=kinds, metavar="KIND")
    parser.add_argument("--parts", type=int, default=2, help="of each family or class")
    parser.add_argument("--seed", type=int, default=0, help="of the first part of each")
    add_running(parser, limit_s=60.0)


def run(options: argparse.Namespace) -> Outcome:
    """Run what is asked for; print the table."""
    rows = rows_of(list(_tasks(options)), worked, Running.of(options), in_words)
    cells = as_cells(list(by_group(rows)))
    print(as_table(_HEAD, cells))
    shares = _within(rows)
    within = 100.0 * float((shares <= 1.0).mean()) if len(shares) else 0.0
    figures = (
        Figure("faces within the stated bound", round(within, 1), "%"),
        share("solids of the right shape", sum(map(is_right, rows)), len(rows)),
    )
    is_wrong = any(_is_wrong(some) for _, some in _grouped(rows))
    return Outcome(figures, is_wrong, _HEAD, cells)


def _tasks(options: argparse.Namespace) -> Iterator[Task]:
    families = {
        Group.TWINS: tuple(TWINS),
        Group.CLASSED: tuple(item.value for item in PartClass),
    }
    for seed in range(options.seed, options.seed + options.parts):
        for group in map(Group, options.groups):
            for family in families[group]:
                for kind in options.inputs:
                    yield Task(group, family, seed, InputKind(kind), options.limit)


def is_right(row: Row) -> bool:
    """Whether a solid has the shape that was drawn, whatever its measures are."""
    if not row.get("displaced") or row["faces"] != row["true_faces"]:
        return False
    return bool(row["valid"]) and row["farthest"] <= _RIGHT_PX * row["px_mm"]


def by_group(rows: list[Row]) -> Iterator[tuple[object, ...]]:
    """The cells of :data:`_HEAD` for each group of rows."""
    for name, some in _grouped(rows):
        yield _line(name, some)


def _grouped(rows: list[Row]) -> Iterator[tuple[tuple[str, str], list[Row]]]:
    """Rows by group of parts and kind of sheet, then by kind of sheet, by where the measures are
    from, and all."""
    found: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        found.setdefault((row["group"], row["input"]), []).append(row)
    for row in rows:
        found.setdefault(("all", row["input"]), []).append(row)
    for row in rows:
        if "measures_source" in row:
            found.setdefault(("all", f"by {row['measures_source']}"), []).append(row)
    found["all", ""] = rows
    yield from found.items()


def _within(rows: Iterable[Row]) -> np.ndarray:
    """(n,) displacements of all faces of right solids as shares of their bounds."""
    stated_rows = [row for row in rows if is_right(row) and row.get("uncertainty_mm")]
    shares = [np.array(row["displaced"]) / row["uncertainty_mm"] for row in stated_rows]
    return np.concatenate([np.zeros(0), *shares])


def _is_wrong(rows: list[Row]) -> bool:
    shares = _within(rows)
    return len(shares) >= _FEWEST and float((shares <= 1.0).mean()) < _ASKED


def _line(name: tuple[str, str], rows: list[Row]) -> tuple[object, ...]:
    right = [row for row in rows if is_right(row)]
    faces = [np.array(row["displaced"]) / row["px_mm"] for row in right]
    shares = _within(rows)
    stated_rows = [row for row in right if row.get("uncertainty_mm")]
    each = [float((np.array(r["displaced"]) <= r["uncertainty_mm"]).mean()) for r in stated_rows]
    bounds = [row["uncertainty_mm"] / row["px_mm"] for row in stated_rows]
    count = sum(map(len, faces))
    return (
        *name,
        len(rows),
        len(right),
        count,
        f"{np.quantile(np.concatenate(faces), _ASKED):.3f}" if count else "",
        f"{np.median(bounds):.3f}" if stated_rows else "",
        f"{100.0 * (shares <= 1.0).mean():.1f} %" if stated_rows else "",
        f"{100.0 * min(each):.0f} %" if stated_rows else "",
        f"{np.quantile(shares, _ASKED):.2f}" if stated_rows else "",
    )


def in_words(row: Row) -> str:
    """A line about a sheet, for who waits."""
    what = row.get("failure") or ", ".join([row.get("status", ""), *row.get("reasons", ())])
    faces = np.array(row.get("displaced") or ()) / row.get("px_mm", 1.0)
    off = f", faces off by up to {np.quantile(faces, _ASKED):.3f} px" if len(faces) else ""
    name = f"{row['family']}-{row['seed']} {row['input']}"
    return f"{name}: {what}{off}"
