"""How often, how exactly and how fast three views become the solid that was drawn.

Parts of six classes of surfaces, 8 to 120 faces, are drawn with their visible and hidden lines and
solved as exact lines, with noise, and through sheets that are written to files and read again.

    .venv/bin/python benchmarks/exact_solid.py [--classes NAME ...] [--parts N] [--large N]
        [--huge N] [--inputs KIND ...] [--workers N] [--json FILE] [--resume] [--plot FILE.svg]
    .venv/bin/python benchmarks/exact_solid.py --data DIR [--parts N] [--inputs KIND ...]

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
import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from exact_cases import Case, classed_cases, folder_cases
from exact_inputs import DRAWN_KINDS, FILE_KINDS, InputKind
from exact_peers import Peer
from exact_tables import tables, time_picture
from exact_work import Task, worked
from resumable import resumed, tell
from workers import Row

from gaussiancad_core.samples.classed import PartClass


def main() -> None:
    """Run what is asked for; print the tables."""
    options = _parser().parse_args()
    # Many small problems side by side: threads of one would only slow down the others.
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    tasks = list(_tasks(options))
    rows = []
    for row in resumed(tasks, worked, options.workers, options.json, options.resume):
        rows.append(row)
        tell(row, len(rows), len(tasks))
    print(tables(sorted(rows, key=lambda row: _order(row, tasks))))
    if options.plot is not None:
        options.plot.write_text(time_picture(rows), encoding="utf-8")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    kinds = [kind.value for kind in PartClass]
    inputs = [kind.value for kind in InputKind]
    parser.add_argument("--classes", nargs="*", default=kinds, choices=kinds, metavar="NAME")
    parser.add_argument("--parts", type=int, default=21, help="of each class, or of the folder")
    parser.add_argument("--large", type=int, default=0, help="parts of 121 to 150 planes beside")
    parser.add_argument("--huge", type=int, default=0, help="parts of 151 to 320 faces beside")
    parser.add_argument("--seed", type=int, default=0, help="of the first part of each class")
    parser.add_argument("--inputs", nargs="*", choices=inputs, metavar="KIND")
    parser.add_argument("--limit", type=float, default=90.0, help="seconds for each part")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--peers", nargs="*", default=[], choices=[peer.value for peer in Peer])
    parser.add_argument("--cache", type=Path, default=Path("build"), help="keeps drawn lines")
    parser.add_argument("--data", type=Path, help="folder of STEP files, or of STEP and DXF pairs")
    parser.add_argument("--json", type=Path, help="file of a JSON object a line, one a part")
    parser.add_argument("--resume", action="store_true", help="only what the JSON file lacks")
    parser.add_argument("--plot", type=Path, help="SVG of time against faces")
    return parser


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


def _order(row: Row, tasks: Sequence[Task]) -> int:
    places = {task.name: index for index, task in enumerate(tasks)}
    return places[row["group"], row["name"], row["input"]]


if __name__ == "__main__":
    main()
