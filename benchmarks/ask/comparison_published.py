"""How near are our solids to the truth under the protocols in which others publish?

Each sample is drawn on a clean sheet of 1920 x 1080 px, reconstructed with ``--result solid`` and
nothing told but its longest extent, and compared with its own solid.  Medians and means are over
the parts that came out as a solid; the others are counted as invalid.  ``truth`` compares every
part with itself: the floors.
"""

import argparse
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np

import gaussiancad
from benchmarks.run.engine import part_of
from benchmarks.run.outcome import Figure, Outcome, share
from gaussiancad_core.comparison.compare_command import compare_files
from gaussiancad_core.comparison.comparison_options import CompareOptions, Protocol
from gaussiancad_core.comparison.comparison_report import Comparison
from gaussiancad_core.comparison.deepcad import summarise_deepcad
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.kernel.brep_files import read_solid, write_step
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.samples import SAMPLES

MINUTES = 15


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--samples", nargs="+", metavar="NAME")
    parser.add_argument("--truth", action="store_true", help="every part against itself")


def run(options: argparse.Namespace) -> Outcome:
    """Print a line a part, then means and medians."""
    silence_opencascade()
    parts = [part for part in SAMPLES if not options.samples or part.name in options.samples]
    found: list[Comparison | None] = []
    print(f"{'':<20}{'CD':>8}{'HD':>8}{'EMD':>8}{'p2s':>9}{'CDx1000':>9}{'IoU':>9}{'agree':>8}")
    with tempfile.TemporaryDirectory() as name:
        for part in parts:
            truth = Path(name) / f"{part.name}.step"
            write_step(part.build(), truth)
            result = truth if options.truth else reconstructed(truth, Path(name) / part.name)
            asked = CompareOptions(protocols=tuple(Protocol))
            found.append(compare_files(result, truth, options=asked) if result else None)
            print(f"{part.name:<20}{_line(found[-1])}", flush=True)
    return Outcome(_sum_up(found))


def reconstructed(truth: Path, folder: Path) -> Path | None:
    """The solid that the engine makes from a sheet of the truth, or None."""
    low, high = bounding_box(read_solid(truth))
    axis = int(np.argmax(high - low))
    sheet = truth.with_suffix(".png")
    gaussiancad.draw(truth, sheet)
    part_of(sheet, folder, length={"xyz"[axis]: float((high - low)[axis])})
    solid = folder / "solid.step"
    return solid if solid.is_file() else None


def _values(each: Comparison) -> tuple[float, ...]:
    return (
        each.distances.chamfer,
        each.distances.hausdorff,
        each.distances.emd,
        each.point_to_surface,
        each.deepcad.chamfer_x1000,
        each.deepcad.volume_iou.value or 0.0,
        each.engineering.agreement,
    )


def _line(each: Comparison | None) -> str:
    return "  no solid" if each is None else _cells(_values(each))


def _cells(values: Sequence[float]) -> str:
    cd, hd, emd, p2s, squared, iou, agreement = values
    return f"{cd:8.4f}{hd:8.4f}{emd:8.4f}{p2s:9.5f}{squared:9.4f}{iou:9.5f}{agreement:8.4f}"


def _sum_up(found: Sequence[Comparison | None]) -> tuple[Figure, ...]:
    """Print means and medians."""
    table = np.array([_values(each) for each in found if each is not None])
    if len(table):
        print(f"{'mean':<20}{_cells(table.mean(axis=0))}")
        print(f"{'median':<20}{_cells(np.median(table, axis=0))}")
    summary = summarise_deepcad([None if each is None else each.deepcad for each in found])
    print(f"deepcad: {summary}")
    if not len(table):
        return (share("solids", 0, len(found)),)
    chamfer, *_, agreement = np.median(table, axis=0)
    return (
        share("solids", len(table), len(found)),
        Figure("median Chamfer distance", round(float(chamfer), 4), "units of a box of 5"),
        Figure("median agreement", round(float(agreement), 4)),
    )
