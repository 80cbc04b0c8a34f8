"""From the lines of views to the part, the reader left out: how often is it the true one?

    OPENBLAS_NUM_THREADS=1 .venv/bin/python benchmarks/from_lines.py --cases DIR --data DIR
        [--only TEXT ...] [--json FILE]

The sheets are those of benchmarks/line_cases.py.  Of each the sketch is made from what was read,
under both projections where both may be, and compared with the part at one size, in the best of 24
orientations.  ``exact`` counts those with an IoU of .99 at least.  The command of the engine tells
OpenBLAS to use one thread; without that its idle threads count as much as the work itself.
"""

import argparse
import json
import sys
import time
from dataclasses import replace
from pathlib import Path
from statistics import mean, median

import numpy as np
from exact_measures import closeness, fine_mesh, registered
from line_cases import LineCase, kept_cases

from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.kernel.brep import bounding_box, read_solid, soundness
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.sketch.sketching import sketch

_SAME_IOU = 0.99


def sketched(case: LineCase) -> dict[str, object]:
    """What became of a sheet."""
    row: dict[str, object] = {"name": case.name, "refused": case.refused}
    if case.own is None:
        return row
    began = time.process_time()
    sketches = [
        sketch(replace(own.views, told=own.numbers), own.grid)
        for own in (case.own, case.other)
        if own is not None
    ]
    known = [own for own in sketches if own is not None]
    found = min(known, key=lambda own: own.energy, default=None)
    row["seconds"] = time.process_time() - began
    if found is None or found.shape is None:
        return {**row, "refused": "no sketch" if found is None else "no body"}
    plan = found.choice.plan
    facts = soundness(found.shape)
    row |= {
        "axis": plan.axis.name,
        "regions": len(plan.regions.polygons),
        "levels": [round(own, 3) for own in plan.levels],
        "energy": round(found.energy / plan.grid, 2),
        "other": found is not sketches[0],
        "proven": found.choice.is_proven,
        "valid": facts.valid and facts.closed,
        "solids": facts.solids,
    }
    try:
        truth = read_solid(case.truth)
        extents = np.ptp(bounding_box(found.shape), axis=0)
        placed, _ = registered(fine_mesh(found.shape), truth, tuple(map(float, extents)))
        row["iou"] = closeness(found.shape, placed).iou
    except (GaussianCadError, RuntimeError) as error:
        row["refused"] = f"not compared: {error}"[:80]
    return row


def main() -> None:
    """Sketch the sheets; print what came of them."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--cases", type=Path, required=True)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--only", nargs="*", default=[], help="parts of paths")
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    silence_opencascade()
    rows = []
    for case in kept_cases(options.cases, options.data, tuple(options.only)):
        rows.append(sketched(case))
        print(json.dumps(rows[-1]), file=sys.stderr, flush=True)
    known = [float(row["iou"]) for row in rows if "iou" in row]
    exact = sum(iou >= _SAME_IOU for iou in known)
    seconds = [float(row["seconds"]) for row in rows if "seconds" in row]
    print(
        f"{len(rows)} sheets, {len(seconds)} read, {len(known)} bodies, {exact} exact, "
        f"mean IoU {sum(known) / max(1, len(rows)):.3f} of all, "
        f"{mean(known) if known else 0.0:.3f} of bodies; "
        f"{median(seconds) if seconds else 0.0:.2f} s in the median"
    )
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    main()
