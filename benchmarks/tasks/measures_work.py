"""One sheet of ``measures``: draw, read, solve, and measure each face's displacement."""

import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import Enum
from pathlib import Path
from zlib import crc32

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.displacements import Displacement, Displacements, displacements
from benchmarks.judge.exact_measures import closeness
from benchmarks.parts.exact_cases import Case
from benchmarks.parts.twin_parts import twins
from benchmarks.run.workers import FIRST, SOLVE, Row
from benchmarks.sheets.exact_inputs import Input, InputKind, make_input
from benchmarks.tasks.textbook_work import FAMILIES
from gaussiancad_core.coordinates.carriers import find_carriers
from gaussiancad_core.coordinates.design_step import NominalStep
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.samples.classed import PartClass, classed_part
from gaussiancad_core.sheet.image.pixel_grids import rounding_step, seen_rounding
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_core.solid.exact import ExactResult

_SMALL = 3
"""Levels of the classes of parts that are small."""

_PREPARING_S = 400.0
_MEASURING_S = 120.0


class Group(Enum):
    """What parts there are."""

    TWINS = "twins"
    TEXTBOOK = "textbook"
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
        if self.group is Group.TEXTBOOK:
            return FAMILIES[self.family].part(self.seed, True)
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
    yield {"true_faces": len(faces_of(truth)), "source": drawing.source, **read(drawing)}
    yield {"stage": SOLVE}
    result = drawing.solved()
    yield {**stated(result, drawing.views), "stage": "measure"}
    if result.shape is None:
        return
    close = closeness(result.shape, truth)
    yield {"valid": close.valid, "iou": close.iou, "faces": close.faces}
    yield offset(displacements(result.shape, truth))


def read(drawing: Input) -> Row:
    """What is known of the measures before anything is solved; lengths in px."""
    views, registered = drawing.views, drawing.registered
    px = registered.mm_per_pixel
    row: Row = {"px_mm": px, "noise": views.noise / px}
    for axis, residual in registered.extents.residuals.items():
        row[f"residual_{axis.name.lower()}"] = [
            residual.median,
            residual.largest,
            residual.coordinates,
        ]
    row |= _rounding(registered)
    row["told_axis"] = views.known.name.lower() if views.known is not None else ""
    row["numbers"] = len(views.dimensions.lengths) if views.dimensions is not None else 0
    row["digit"] = views.dimensions.digit if views.dimensions is not None else 0.0
    for name, item in (("", views), ("likely_", replace(views, likely=True))):
        carriers = find_carriers(item)
        pixel = px * carriers.scale
        places = carriers.places
        row |= {
            f"{name}nominal": carriers.nominal,
            **{f"{name}{key}": value for key, value in _step(carriers.step, carriers.scale, pixel)},
            f"{name}odd": carriers.odd,
            f"{name}moved": carriers.moved / pixel,
            f"{name}unread": carriers.unread,
            f"{name}places": sum(map(len, places.values.values())) if places is not None else 0,
            f"{name}beside": places.offset / pixel if places is not None else 0.0,
        }
    return row


def _rounding(registered: RegisteredSheet) -> Row:
    """Whether lines lie on a grid of the program that drew them, and its step in px."""
    strokes = [view.strokes for view in registered.drawn]
    kinds = {well: seen_rounding(strokes, well_read=well) for well in (False, True)}
    return {
        "rounding": [kinds[False].value, kinds[True].value],
        "rounding_step": [rounding_step(strokes, well_read=well) for well in (False, True)],
    }


def _step(step: NominalStep | None, scale: float, pixel: float) -> Iterator[tuple[str, float]]:
    yield "step_mm", step.length / scale if step is not None else 0.0
    yield "step_moved", step.moved / pixel if step is not None else 0.0
    yield "step_reach", step.reach / pixel if step is not None else 0.0


def stated(result: ExactResult, views: DrawnViews) -> Row:
    """What is said of a result; lengths in px."""
    row: Row = {
        "status": result.status.value,
        "reasons": [code for code, _ in result.reasons],
        "seconds": sum(result.seconds.values()),
    }
    verification = result.verification
    if verification is not None:
        px = views.tolerance
        row |= {
            "spread": verification.spread / px,
            "misfit": verification.misfit / px,
            "apart": bool(verification.apart),
            "explains": verification.explains,
            "neat": verification.neat,
            "flaws": len(verification.flaws),
        }
    measures = result.measures
    if measures is not None:
        row |= {
            "uncertainty_mm": measures.uncertainty,
            "measures_source": measures.source.value,
            "by_axis_mm": list(measures.by_axis),
        }
    return row


def offset(found: Displacements) -> Row:
    """Each face's displacement in mm, those of the solid and those of the truth."""
    medians = np.sort(found.medians)
    return {
        "displaced": medians.tolist(),
        "farthest": found.farthest,
        "own": [_face(face) for face in found.moved],
        "other": [_face(face) for face in found.other],
    }


def _face(face: Displacement) -> list[object]:
    return [
        face.kind,
        face.axis,
        round(face.place, 6),
        round(face.area, 4),
        face.median,
        face.largest,
        face.shift,
    ]
