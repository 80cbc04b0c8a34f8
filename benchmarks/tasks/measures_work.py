"""One sheet of ``measures``: draw, read, solve, and measure each face's displacement."""

import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from zlib import crc32

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.displacements import displacements
from benchmarks.judge.exact_measures import closeness
from benchmarks.parts.exact_cases import Case
from benchmarks.parts.twin_parts import twins
from benchmarks.run.workers import FIRST, SOLVE, Row
from benchmarks.sheets.exact_inputs import InputKind, make_input
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.solid.exact import ExactResult
from sample_parts.classed import PartClass, classed_part

_SMALL = 3
"""Levels of the classes of parts that are small."""

_PREPARING_S = 400.0
_MEASURING_S = 120.0


class Group(Enum):
    """What parts there are."""

    TWINS = "twins"
    CLASSED = "classed"


@dataclass(frozen=True)
class Task:
    """A sheet.

    Attributes:
        group: of parts.
        family: of the group.
        seed: of the part and of the sheet's look.
        kind: of the sheet.
        limit: s for the solver.
    """

    group: Group
    family: str
    seed: int
    kind: InputKind
    limit: float

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {
            "group": self.group.value,
            "family": self.family,
            "seed": self.seed,
            "input": self.kind.value,
        }

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: _PREPARING_S, SOLVE: self.limit, "measure": _MEASURING_S}

    def truth(self) -> TopoDS_Shape:
        """The part; but for those of classes its measures are hundredths of millimetres."""
        if self.group is Group.CLASSED:
            return classed_part(PartClass(self.family), self.seed, self.seed % _SMALL)
        variants = twins(self.family, self.seed, odd=True)
        return variants[self.seed % len(variants)]


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a sheet, bit by bit."""
    silence_opencascade()
    truth = task.truth()
    look = crc32(f"{task.family} {task.seed}".encode())
    case = Case(f"{task.group.value}-{task.seed}", task.family, look)
    with tempfile.TemporaryDirectory() as folder:
        # What is kept for classes is told by the engine's code, which these parts are not of.
        drawing = make_input(case, truth, task.kind, Path(folder))
    yield {"true_faces": len(faces_of(truth)), "px_mm": drawing.px_mm, "stage": SOLVE}
    result = drawing.solved()
    yield {**stated(result), "stage": "measure"}
    if result.shape is None:
        return
    close = closeness(result.shape, truth)
    found = displacements(result.shape, truth)
    yield {
        "valid": close.valid,
        "iou": close.iou,
        "faces": close.faces,
        "displaced": np.sort(found.medians).tolist(),
        "farthest": found.farthest,
    }


def stated(result: ExactResult) -> Row:
    """What is said of a result."""
    row: Row = {
        "status": result.status.value,
        "reasons": [code for code, _ in result.reasons],
        "seconds": sum(result.seconds.values()),
    }
    if result.measures is not None:
        row["uncertainty_mm"] = result.measures.uncertainty
        row["measures_source"] = result.measures.source.value
    return row
