"""How often, how exactly and how fast do three views become the solid that was drawn?

Parts of six classes of surfaces, 8 to 120 faces, are drawn with their visible and hidden lines and
solved as exact lines, with noise, and through sheets that are written to files and read again.

``exact`` is the share of parts that came out as one valid closed solid with a volume IoU of .999
at least, by OpenCASCADE's Booleans; a Boolean of meshes (manifold3d) has to agree.  ``close`` adds
those with as many faces as the truth and an IoU of .98: right but for their measures.  ``faces=``
is the share of the exact ones that have exactly as many faces as the truth.  ``false`` counts
solids that were called verified and are not exact, ``far`` those of them that are not even close;
``alt.`` parts whose truth was among the alternatives only; ``mirror`` solids that are the truth's
mirror image.  Every part is solved in a process that is ended at the time limit.  Sheets are in
third angle, and the reader is told so, and the longest extent.

With ``--data`` the parts are the STEP files of a folder; where DXF files of the same names lie
beside them, these drawings (third angle) are solved instead and the STEP solids are scaled and
turned to fit.  How many parts have surfaces that no cells express is told by kind, and how the
others do.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path

from benchmarks.methods.exact_peers import Peer
from benchmarks.parts.exact_cases import Case, classed_cases, folder_cases
from benchmarks.run.arguments import add_running, existing_folder
from benchmarks.run.outcome import Outcome
from benchmarks.run.rows import Running, rows_of
from benchmarks.sheets.exact_inputs import DRAWN_KINDS, FILE_KINDS, InputKind
from benchmarks.tasks.exact_tables import tables, time_picture
from benchmarks.tasks.exact_work import Task, counted, in_words, worked
from gaussiancad_core.samples.classed import PartClass

MINUTES = 60


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    kinds = [kind.value for kind in PartClass]
    inputs = [kind.value for kind in InputKind]
    parser.add_argument("--classes", nargs="*", default=kinds, choices=kinds, metavar="NAME")
    parser.add_argument("--parts", type=int, default=21, help="of each class, or of the folder")
    parser.add_argument("--large", type=int, default=0, help="parts of 121 to 150 planes beside")
    parser.add_argument("--huge", type=int, default=0, help="parts of 151 to 320 faces beside")
    parser.add_argument("--seed", type=int, default=0, help="of the first part of each class")
    parser.add_argument("--inputs", nargs="*", choices=inputs, metavar="KIND")
    add_running(parser, limit_s=90.0)
    parser.add_argument("--peers", nargs="*", default=[], choices=[peer.value for peer in Peer])
    parser.add_argument("--cache", type=Path, default=Path("build"), help="keeps drawn lines")
    parser.add_argument("--data", type=existing_folder, help="STEP files, or pairs of STEP and DXF")
    parser.add_argument("--plot", type=Path, help="SVG of time against faces")


def run(options: argparse.Namespace) -> Outcome:
    """Run what is asked for; print the tables."""
    rows = rows_of(list(_tasks(options)), worked, Running.of(options), in_words)
    print(tables(rows))
    if options.plot is not None:
        options.plot.write_text(time_picture(rows), encoding="utf-8")
    return Outcome(counted(rows))


def _tasks(options: argparse.Namespace) -> Iterator[Task]:
    cases: list[Case]
    if options.data is not None:
        cases = list(folder_cases(options.data, options.parts))
        usual = FILE_KINDS if any(case.dxf for case in cases) else DRAWN_KINDS
    else:
        classes = [PartClass(name) for name in options.classes]
        more = options.large, options.huge
        cases = list(classed_cases(classes, options.parts, options.seed, *more))
        usual = DRAWN_KINDS
    kinds = [InputKind(name) for name in options.inputs or ()] or usual
    peers = tuple(Peer(name) for name in options.peers)
    for kind in kinds:
        for case in cases:
            yield Task(case, kind, options.cache, options.limit, peers)
