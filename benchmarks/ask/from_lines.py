"""How often do the lines of views alone, without the reader, become the true part?

The sheets are those of :mod:`benchmarks.sheets.line_cases`. Of each the sketch is made from what
was read, under both projections where both may be, and compared with the part at one size, in the
best of 24 orientations. ``exact`` counts those with an IoU of .99 at least. The command of the
engine tells OpenBLAS to use one thread; without that its idle threads count as much as the work
itself.
"""

import argparse
import json
import time
from dataclasses import replace
from pathlib import Path
from statistics import mean, median

from benchmarks.judge.exact_measures import closeness_at_one_size
from benchmarks.run.arguments import add_data, tell
from benchmarks.run.outcome import Figure, Outcome, share
from benchmarks.sheets.line_cases import LineCase, kept_cases
from benchmarks.sheets.published import SAME_IOU
from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.kernel.brep import soundness
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.sketch.sketching import sketch

MINUTES = 10


def sketched(case: LineCase) -> dict[str, object]:
    """What became of a sheet."""
    row: dict[str, object] = {"name": case.name, "refused": case.refused}
    if case.assumed is None:
        return row
    began = time.process_time()
    sketches = [
        sketch(replace(item.views, dimensions=item.numbers), item.grid)
        for item in (case.assumed, case.other)
        if item is not None
    ]
    known = [sketch for sketch in sketches if sketch is not None]
    found = min(known, key=lambda item: item.energy, default=None)
    row["seconds"] = time.process_time() - began
    if found is None or found.shape is None:
        return {**row, "refused": "no sketch" if found is None else "no body"}
    plan = found.choice.plan
    facts = soundness(found.shape)
    row |= {
        "axis": plan.axis.name,
        "regions": len(plan.regions.polygons),
        "levels": [round(level, 3) for level in plan.levels],
        "energy": round(found.energy / plan.grid, 2),
        "other": found is not sketches[0],
        "proven": found.choice.is_proven,
        "valid": facts.valid and facts.closed,
        "solids": facts.solids,
    }
    try:
        row["iou"] = closeness_at_one_size(found.shape, read_solid(case.truth))[0].iou
    except (GaussianCadError, RuntimeError) as error:
        row["refused"] = f"not compared: {error}"[:80]
    return row


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--cases", type=Path, required=True)
    add_data(parser)
    parser.add_argument("--json", type=Path)


def run(options: argparse.Namespace) -> Outcome:
    """Sketch the sheets; print what came of them."""
    silence_opencascade()
    rows = []
    for case in kept_cases(options.cases, options.data, tuple(options.only)):
        rows.append(sketched(case))
        tell(json.dumps(rows[-1]))
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1) + "\n")
    known = [float(row["iou"]) for row in rows if "iou" in row]
    seconds = [float(row["seconds"]) for row in rows if "seconds" in row]
    figures = (
        share("exact", sum(iou >= SAME_IOU for iou in known), len(rows)),
        share("read", len(seconds), len(rows)),
        share("bodies", len(known), len(rows)),
        Figure("mean IoU of all", round(sum(known) / max(1, len(rows)), 3)),
        Figure("mean IoU of bodies", round(mean(known), 3) if known else 0.0),
        Figure("median", round(median(seconds), 2) if seconds else 0.0, "s"),
    )
    return Outcome(figures)
