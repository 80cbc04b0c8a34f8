"""How do parts of textbooks come out that the engine neither models nor draws?

Nearly forty families of parts, such as a bearing block, a crank, a V-block, each with measures by
lot: round ones, or hundredths of a millimetre with ``--odd``.  OpenCASCADE removes the hidden
lines.  The sheet is a DXF file, or a picture as other programs draw it, without or with dimensions,
or a scan or photocopy of such a sheet, in first or third angle, of which the engine is told nothing
but the longest extent.

A solid is ``exact`` if it is valid and its volume IoU with the truth is .999 at least; ``false``
ones are called verified and are not.  The last lines tell whose projection was mistaken.
"""

import argparse
from collections.abc import Iterator, Sequence
from itertools import product
from pathlib import Path

from benchmarks.run.arguments import add_running
from benchmarks.run.outcome import Outcome
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import Row
from benchmarks.tasks.exact_tables import tables
from benchmarks.tasks.exact_work import counted, in_words
from benchmarks.tasks.textbook_work import FAMILIES, SheetKind, Task, worked

MINUTES = 30


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    kinds = [kind.value for kind in SheetKind]
    parser.add_argument("--families", nargs="*", default=list(FAMILIES), choices=list(FAMILIES))
    parser.add_argument("--seeds", nargs="*", type=int, default=[0], metavar="N")
    parser.add_argument("--odd", action="store_true", help="measures are no round numbers")
    parser.add_argument("--sheets", nargs="*", default=kinds, choices=kinds, metavar="KIND")
    parser.add_argument("--told", action="store_true", help="tell first or third angle")
    add_running(parser, limit_s=120.0)
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for sheets and results")


def run(options: argparse.Namespace) -> Outcome:
    """Make, draw and reconstruct what is asked for; print the tables."""
    rows = rows_of(list(_tasks(options)), worked, Running.of(options), in_words)
    print(tables(rows))
    print("\n".join(_mistaken(rows)))
    return Outcome(counted(rows))


def _tasks(options: argparse.Namespace) -> Iterator[Task]:
    for kind, family, seed in product(options.sheets, options.families, options.seeds):
        yield Task(
            family, seed, options.odd, SheetKind(kind), options.told, options.limit, options.keep
        )


def _mistaken(rows: Sequence[Row]) -> Iterator[str]:
    """The parts whose sheet was read under the wrong projection, kind by kind."""
    for kind in dict.fromkeys(row["input"] for row in rows):
        names = [row["name"] for row in rows if row["input"] == kind and row.get("mistaken")]
        yield f"{kind}, wrong projection: {len(names)} {' '.join(names)}".rstrip()
