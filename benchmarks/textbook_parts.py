"""How parts of textbooks come out, which are modelled and drawn outside the engine's generators.

Nearly forty families of parts, such as a bearing block, a crank, a V-block, each with measures by
lot: round ones, or hundredths of a millimetre with ``--odd``.  OpenCASCADE removes the hidden
lines.  The sheet is a DXF file, or a picture as other programs draw it, without or with dimensions,
or a scan or photocopy of such a sheet, in first or third angle, of which the engine is told nothing
but the longest extent.

    .venv/bin/python benchmarks/textbook_parts.py [--families NAME ...] [--seeds N ...] [--odd]
        [--sheets dxf picture dimensioned scan photocopy] [--told] [--limit S] [--workers N]
        [--json FILE] [--resume] [--keep DIR]

A solid is ``exact`` if it is valid and its volume IoU with the truth is .999 at least; ``false``
ones are called verified and are not.  The last lines tell whose projection was mistaken.
"""

import argparse
import os
from collections.abc import Iterator, Sequence
from itertools import product
from pathlib import Path

from exact_tables import tables
from resumable import resumed, tell
from textbook_work import FAMILIES, SheetKind, Task, worked
from workers import Row


def main() -> None:
    """Make, draw and reconstruct what is asked for; print the tables."""
    options = _parser().parse_args()
    # Many small problems side by side: threads of one would only slow down the others.
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    tasks = list(_tasks(options))
    rows = []
    for row in resumed(tasks, worked, options.workers, options.json, options.resume):
        rows.append(row)
        tell(row, len(rows), len(tasks))
    places = {(task.name, task.kind.value): index for index, task in enumerate(tasks)}
    rows.sort(key=lambda row: places[row["name"], row["input"]])
    print(tables(rows))
    print("\n".join(_mistaken(rows)))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    kinds = [kind.value for kind in SheetKind]
    parser.add_argument("--families", nargs="*", default=list(FAMILIES), choices=list(FAMILIES))
    parser.add_argument("--seeds", nargs="*", type=int, default=[0], metavar="N")
    parser.add_argument("--odd", action="store_true", help="measures are no round numbers")
    parser.add_argument("--sheets", nargs="*", default=kinds, choices=kinds, metavar="KIND")
    parser.add_argument("--told", action="store_true", help="tell first or third angle")
    parser.add_argument("--limit", type=float, default=120.0, help="seconds for each sheet")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--json", type=Path, help="file of a JSON object a line, one a sheet")
    parser.add_argument("--resume", action="store_true", help="only what the JSON file lacks")
    parser.add_argument("--keep", type=Path, metavar="DIR", help="for sheets and results")
    return parser


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


if __name__ == "__main__":
    main()
