"""How often, how exactly and how fast do three views become the solid that was drawn?

Parts of six classes of surfaces, 8 to 120 faces, are drawn with their visible and hidden lines and
solved as exact lines and through sheets that are written to files and read again.

``exact`` is the share of parts that came out as one valid closed solid with a volume IoU of .999
at least, by OpenCASCADE's Booleans; a Boolean of meshes (manifold3d) has to agree.  ``close`` adds
those with as many faces as the truth and an IoU of .98: right but for their measures.  ``faces=``
is the share of the exact ones that have exactly as many faces as the truth.  ``false`` counts
solids that were called verified and are not exact, ``far`` those of them that are not even close;
``alt.`` parts whose truth was among the alternatives only; ``mirror`` solids that are the truth's
mirror image.  Every part is solved in a process that is ended at the time limit.  Sheets are in
third angle, and the reader is told so, and the longest extent.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path

from benchmarks.parts.exact_cases import classed_cases
from benchmarks.run.arguments import add_running
from benchmarks.run.outcome import Outcome
from benchmarks.run.rows import Running, rows_of
from benchmarks.sheets.exact_inputs import InputKind
from benchmarks.tasks.exact_tables import summary, tables
from benchmarks.tasks.exact_work import Task, counted, falsely_verified, in_words, worked
from sample_parts.classed import PartClass

MINUTES = 30

_USUAL = ("vectors", "clean", "foreign", "scan")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    kinds = [kind.value for kind in PartClass]
    inputs = [kind.value for kind in InputKind]
    parser.add_argument("--classes", nargs="*", default=kinds, choices=kinds, metavar="NAME")
    parser.add_argument("--parts", type=int, default=4, help="of each class")
    parser.add_argument("--seed", type=int, default=0, help="of the first part of each class")
    parser.add_argument("--inputs", nargs="*", default=_USUAL, choices=inputs, metavar="KIND")
    add_running(parser, limit_s=90.0)
    parser.add_argument("--cache", type=Path, default=Path("build"), help="keeps drawn lines")


def run(options: argparse.Namespace) -> Outcome:
    """Run what is asked for; print the tables."""
    rows = rows_of(list(_tasks(options)), worked, Running.of(options), in_words)
    print(tables(rows))
    return Outcome(counted(rows), any(map(falsely_verified, rows)), *summary(rows))


def _tasks(options: argparse.Namespace) -> Iterator[Task]:
    classes = [PartClass(name) for name in options.classes]
    cases = list(classed_cases(classes, options.parts, options.seed))
    for kind in map(InputKind, options.inputs):
        for case in cases:
            yield Task(case, kind, options.cache, options.limit)
