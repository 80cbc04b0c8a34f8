"""How far the ends of lines may be off: sheets with lines too long or too short, solved exactly.

Parts of six classes are drawn on clean sheets of 1920 px, the ends of all their lines moved along
them by up to so many px (as in the paper's robustness test), read from the picture and solved.

    .venv/bin/python benchmarks/loose_ends.py [--parts N] [--seed N] [--workers N]

A row for each strength: sheets that were read, solids that are exact (valid, volume IoU .999 at
least), that are called verified, and false ones: called verified, yet not exact.
"""

import argparse
import os
import tempfile
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from benchmark_parts import Part, SheetKind, make_sheet
from exact_cases import Case, classed_cases
from exact_inputs import read_input
from exact_measures import closeness

from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.modes import Status
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.samples.classed import PartClass

_STRENGTHS = (
    SheetKind.CLEAN,
    SheetKind.ENDS_1,
    SheetKind.ENDS_2,
    SheetKind.ENDS_3,
    SheetKind.ENDS_5,
    SheetKind.ENDS_8,
)


@dataclass(frozen=True)
class Outcome:
    """What became of a sheet."""

    kind: SheetKind
    name: str
    read: bool
    exact: bool = False
    verified: bool = False


def main() -> None:
    """Solve all sheets; print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--parts", type=int, default=3, help="of each class")
    parser.add_argument("--seed", type=int, default=0, help="of the first part of each class")
    parser.add_argument("--workers", type=int, default=1)
    options = parser.parse_args()
    # Many small problems side by side: threads of one would only slow down the others.
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    cases = list(classed_cases(list(PartClass), options.parts, options.seed, 0))
    tasks = [(case, kind) for kind in _STRENGTHS for case in cases]
    with ProcessPoolExecutor(options.workers) as pool:
        outcomes = list(pool.map(_solved, tasks))
    print("\n".join(_table(outcomes)))


def _solved(task: tuple[Case, SheetKind]) -> Outcome:
    case, kind = task
    silence_opencascade()
    truth = case.truth()
    extents = np.ptp(np.array(bounding_box(truth)), axis=0)
    longest = int(np.argmax(extents))
    with tempfile.TemporaryDirectory() as folder:
        path = make_sheet(Part(case), truth, kind, Path(folder), Path("build"))
        try:
            given = read_input(path, (Axis(longest), float(extents[longest])))
        except GaussianCadError:
            return Outcome(kind, case.name, read=False)
    result = given.solved()
    exact = result.shape is not None and closeness(result.shape, truth).exact
    return Outcome(kind, case.name, True, exact, result.status is Status.VERIFIED)


def _table(outcomes: list[Outcome]) -> Iterator[str]:
    yield f"{'sheet':12}{'sheets':>8}{'read':>6}{'exact':>7}{'verified':>10}{'false':>7}"
    for kind in _STRENGTHS:
        own = [outcome for outcome in outcomes if outcome.kind is kind]
        false = [outcome.name for outcome in own if outcome.verified and not outcome.exact]
        counts = (
            f"{len(own):8}{sum(o.read for o in own):6}{sum(o.exact for o in own):7}"
            f"{sum(o.verified for o in own):10}{len(false):7}"
        )
        yield f"{kind.value:12}{counts} {' '.join(false)}".rstrip()


if __name__ == "__main__":
    main()
