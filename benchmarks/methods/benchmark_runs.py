"""One part, one sheet, one way to make models of it: draw, make, measure, in a child process."""

import base64
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache
from pathlib import Path

import cv2
import numpy as np
from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.exact_measures import EXACT_IOU, closeness, registered
from benchmarks.methods.exact_peers import Peer, peer_mesh
from benchmarks.run.workers import FIRST, SOLVE, Row
from benchmarks.sheets.benchmark_parts import Part, SheetKind, make_sheet
from benchmarks.sheets.exact_inputs import read_input
from gaussiancad_core.comparison.comparing import compare_models
from gaussiancad_core.comparison.comparison_options import CompareOptions, Protocol
from gaussiancad_core.comparison.comparison_report import comparison_dict
from gaussiancad_core.comparison.deviation import Deviation
from gaussiancad_core.comparison.model_files import Model, read_model
from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.kernel.brep_files import read_solid, write_step
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.pictures.preview import PreviewSize, render_preview
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from gaussiancad_core.report.job import Job
from gaussiancad_core.run.pipeline import reconstruct
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_protocol.modes import Device, Preset, Recipe, ResultKind, Status

SCRATCH = "scratch"
"""Folder for what a task needs while it runs; what an ended process left there may be removed."""

_PREPARING_S = 200.0
_MEASURING_S = 200.0

_PICTURE_PX = 420
_PICTURE_QUALITY = 82


class Method(Enum):
    """What is made of a sheet."""

    PAPER = "paper recipe"
    SURFACE = "default surface"
    SOLID = "exact solid"
    HULL = "plain hull"
    SWEEP = "sweep-and-cut"


class Run(Enum):
    """Methods that share their work."""

    ENGINE = (Method.SOLID, Method.SURFACE)
    PAPER = (Method.PAPER,)
    OUTLINES = (Method.HULL, Method.SWEEP)


_NO_MODEL: Row = {"status": Status.FAILED.value, "failure": "no-model"}
"""What is told where a method ends well and has nothing to show."""

_PEERS = {Method.HULL: Peer.HULL, Method.SWEEP: Peer.SWEEP_AND_CUT}


@dataclass(frozen=True)
class Effort:
    """How much is done for each part.

    Attributes:
        limit: s to make the models of one run, of the processor on a busy machine.
        points: surface points a side.
        preset: of the default surface.
        seed: of training and samples.
    """

    limit: float = 120.0
    points: int = 1_024
    preset: Preset = Preset.STANDARD
    seed: int = 0


@dataclass(frozen=True)
class RunTask:
    """What a process gets.

    Attributes:
        part, kind, run: what is made of which sheet.
        effort: how much is done.
        folder: keeps drawn lines.
        pictures: whether the models are shown.
    """

    part: Part
    kind: SheetKind
    run: Run
    effort: Effort
    folder: Path
    pictures: bool = False

    @property
    def known(self) -> Row:
        """What its row begins with."""
        case = self.part.case
        return {
            "group": case.group,
            "part": case.name,
            "input": self.kind.value,
            "run": self.run.name.lower(),
            "projection": self.part.projection.value,
            "digest": self.part.digest,
            "models": {method.value: {} for method in self.run.value},
        }

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: _PREPARING_S, SOLVE: self.effort.limit, "measure": _MEASURING_S}


@dataclass(frozen=True, eq=False)
class Made:
    """A model and what is said of it.

    Attributes:
        model: what is measured; None if there is none.
        facts: its status, the reasons, seconds.
        shape: the exact solid behind it.
    """

    model: Model | None
    facts: Row
    shape: TopoDS_Shape | None = None


def run_task(task: RunTask) -> Iterator[Row]:
    """What becomes known of a task, bit by bit."""
    silence_opencascade()
    truth = _truth(task.part)
    scratch = task.folder / SCRATCH
    scratch.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=scratch) as name:
        folder = Path(name)
        sheet = make_sheet(task.part, truth.shape, task.kind, folder, task.folder)
        stated = ReadingOptions(projection=task.part.projection, lengths=(truth.length,))
        yield {"stage": SOLVE}
        made = {}
        models: Row = {method.value: {} for method in task.run.value}
        for method, item in _made(task, sheet, stated, folder):
            made[method] = item
            models[method.value] = item.facts
        yield {"models": models, "stage": "measure"}
        for method, entry in made.items():
            if entry.model is not None:
                models[method.value] = {**entry.facts, **_measured(entry, truth, task)}
                yield {"models": models, "stage": "measure"}


@dataclass(frozen=True, eq=False)
class Truth:
    """What results are measured against.

    Attributes:
        shape: the solid as the sheet has it.
        model: the same for comparisons.
        length: its longest extent in mm and the sheet's axis of it.
    """

    shape: TopoDS_Shape
    model: Model
    length: tuple[Axis, float]


@lru_cache(maxsize=1)
def _truth(part: Part) -> Truth:
    """The solid; that of a given sheet is turned as the sheet's outlines have it.

    Raises:
        GaussianCadError: the given sheet cannot be read.
    """
    shape = part.case.truth()
    low, high = bounding_box(shape)
    size = high - low
    if part.sheet is not None:
        drawing = read_input(part.sheet, None, projection=part.projection)
        # What the sheet is taken to measure in mm depends on what is told.
        size = np.array(drawing.views.size) / max(drawing.views.size) * size.max()
        stated = (Axis(int(np.argmax(size))), float(size.max()))
        drawing = read_input(part.sheet, stated, projection=part.projection)
        hull = peer_mesh(Peer.HULL, drawing.outlines, drawing.masks)
        shape, _ = registered(hull, shape, drawing.views.size)
    return Truth(shape, _as_model(shape), (Axis(int(np.argmax(size))), float(size.max())))


def _as_model(shape: TopoDS_Shape) -> Model:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "truth.step"
        write_step(shape, path)
        return read_model(path)


def _made(
    task: RunTask, sheet: Path, reading_options: ReadingOptions, folder: Path
) -> Iterator[tuple[Method, Made]]:
    if task.run is Run.OUTLINES:
        yield from _outline_models(task.run, sheet, reading_options)
        return
    recipe = Recipe.PAPER if task.run is Run.PAPER else Recipe.ORTHOGRAPHIC
    job = Job(
        sheet,
        folder / "result",
        reading_options,
        result=ResultKind.SURFACE if recipe is Recipe.PAPER else ResultKind.BOTH,
        recipe=recipe,
        preset=Preset.DRAFT if recipe is Recipe.PAPER else task.effort.preset,
        seed=task.effort.seed,
        device=Device.CPU,
    )
    try:
        report = reconstruct(job, Silence())
    except GaussianCadError as error:
        failed = {"status": Status.FAILED.value, "failure": error.code, "message": error.message}
        yield from ((method, Made(None, failed)) for method in task.run.value)
        return
    spent = report.seconds
    for method in task.run.value:
        solid = method is Method.SOLID
        path = job.output / ("solid.step" if solid else "surface.stl")
        left_out = ("hull", "gaussians", "surface") if solid else ()
        facts = {
            "status": report.status.value if solid else Status.APPROXIMATE.value,
            "seconds": sum(item for name, item in spent.items() if name not in left_out),
        }
        if not path.is_file():
            yield (
                method,
                Made(None, facts | _NO_MODEL),
            )
            continue
        yield method, Made(read_model(path), facts, read_solid(path) if solid else None)


def _outline_models(
    run: Run, sheet: Path, reading_options: ReadingOptions
) -> Iterator[tuple[Method, Made]]:
    """The hull and the swept outlines of the views, which nobody checks."""
    started = time.perf_counter()
    drawing = read_input(sheet, reading_options.lengths[0], projection=reading_options.projection)
    reading = time.perf_counter() - started
    for method in run.value:
        started = time.perf_counter()
        mesh = None
        if drawing.outlines is not None and drawing.masks is not None:
            mesh = peer_mesh(_PEERS[method], drawing.outlines, drawing.masks)
        facts: Row = {"seconds": reading + time.perf_counter() - started}
        if mesh is None:
            yield (
                method,
                Made(None, facts | _NO_MODEL),
            )
        else:
            yield method, Made(Model(mesh), {**facts, "status": Status.APPROXIMATE.value})


def _measured(made: Made, truth: Truth, task: RunTask) -> Row:
    """A model under all protocols."""
    asked = CompareOptions(
        points=task.effort.points, seed=task.effort.seed, protocols=tuple(Protocol)
    )
    comparison, deviation = compare_models(made.model, truth.model, asked)
    found = comparison_dict(comparison)
    # Histogram and worst points are most of it, and no table has them.
    del found["deviation"]
    row: Row = {"comparison": found, "range_mm": comparison.deviation.range_mm}
    if made.shape is not None:
        close = closeness(made.shape, truth.shape)
        row |= {"exact": close.exact, "faces": close.faces, "true_faces": close.true_faces}
    else:
        iou = comparison.engineering.volume_iou.value if comparison.engineering else None
        row["exact"] = made.model.closed and iou is not None and iou >= EXACT_IOU
    return row | ({"picture": _picture(deviation)} if task.pictures else {})


def _picture(deviation: Deviation) -> str:
    """A small JPEG of the coloured model, base64."""
    image = render_preview(deviation.mesh, deviation.colours, PreviewSize())
    scale = _PICTURE_PX / image.shape[1]
    small = cv2.resize(image, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
    options = [cv2.IMWRITE_JPEG_QUALITY, _PICTURE_QUALITY]
    _, content = cv2.imencode(".jpg", small[..., ::-1], options)
    return base64.b64encode(content.tobytes()).decode("ascii")
