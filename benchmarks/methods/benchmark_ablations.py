"""The ablations of ``benchmark``: one setting of one of them in a child process.

The GaussianCAD paper's ablations are those of the median kernel, of the Hough transforms and of the
cameras' distance; the fourth, of its masks, compares them with those of SAM, which fails.  Here
masks are disturbed instead.
"""

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from enum import Enum

from benchmarks.ask.camera_distance import DISTANCES, errors_at, parallel_error, scene_of
from benchmarks.ask.make_ablation_picture import KERNELS, STYLE
from benchmarks.ask.sheet_reading import read_in_styles
from benchmarks.ask.splatting_noise import COLUMNS, measured
from benchmarks.run.workers import FIRST, SOLVE, Row
from benchmarks.sheets.disturbed_views import cases, solid_mesh
from benchmarks.sheets.styled_sheets import Job
from gaussiancad_core.samples import sample
from gaussiancad_core.sheet.reading_options import Finder, ReadingOptions
from gaussiancad_protocol.modes import Preset

_PREPARING_S = 120.0


class Ablation(Enum):
    """What is varied."""

    READING = "reading"
    DISTANCE = "distance"
    MASKS = "masks"


PARALLEL = "parallel"
"""The setting of the distance that has orthographic cameras."""

PARTS = {
    Ablation.READING: "three-axis-block",
    Ablation.DISTANCE: "three-axis-block",
    Ablation.MASKS: "l-bracket",
}
"""Sample parts: those of the benchmarks whose measures these are."""

READING_STYLES = ("clean", STYLE)


@dataclass(frozen=True)
class AblationTask:
    """What a process gets.

    Attributes:
        ablation: which.
        setting: what is varied, as text.
        limit: s of the clock.
        iterations: of the trainings at a distance.
        preset: of the trainings on disturbed masks.
    """

    ablation: Ablation
    setting: str
    limit: float
    iterations: int = 300
    preset: Preset = Preset.DRAFT

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {
            "ablation": self.ablation.value,
            "setting": self.setting,
            "part": PARTS[self.ablation],
            "iterations": self.iterations,
            "preset": self.preset.value,
        }

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: _PREPARING_S, SOLVE: self.limit, "done": _PREPARING_S}


def ablation_tasks(limit: float, *, quick: bool) -> Iterator[AblationTask]:
    """All settings of all ablations, or two of each."""
    few = slice(0, 2) if quick else slice(None)
    readings = [f"{finder.value} {kernel}" for finder in Finder for kernel in KERNELS]
    distances = [PARALLEL, *(f"{distance:g}" for distance in DISTANCES)]
    masks = [case.name for case in cases()]
    iterations = 10 if quick else AblationTask.iterations
    for ablation, settings in zip(Ablation, (readings, distances, masks), strict=True):
        for setting in settings[few]:
            yield AblationTask(ablation, setting, limit, iterations)


def run_ablation(task: AblationTask) -> Iterator[Row]:
    """The figures of one setting."""
    yield {"stage": SOLVE}
    figures = {
        Ablation.READING: _reading,
        Ablation.DISTANCE: _distance,
        Ablation.MASKS: _masks,
    }[task.ablation](task)
    yield {"figures": figures, "stage": "done"}


def _reading(task: AblationTask) -> Row:
    """Precision and recall of the lines of a clean sheet and of one with much noise."""
    finder, kernel = task.setting.split()
    reading = ReadingOptions(median_kernel=int(kernel), finder=Finder(finder))
    found = read_in_styles(Job(PARTS[task.ablation], 0, 0, READING_STYLES, None, 0.0, reading))
    rows = zip(("clean", "noisy"), found, strict=True)
    return {
        name: {
            "failure": item.failure,
            **{kind: _shares(getattr(item, kind)) for kind in ("visible", "hidden")},
        }
        for name, item in rows
    }


def _shares(matched: object) -> Row:
    return {**asdict(matched), "precision": matched.precision, "recall": matched.recall}


def _distance(task: AblationTask) -> Row:
    """Size and distance from the truth, as ``camera_distance`` has them."""
    scene = scene_of(PARTS[task.ablation], task.iterations)
    if task.setting == PARALLEL:
        return {"parallel": parallel_error(scene)}
    size, shape, lens = errors_at(scene, float(task.setting))
    return {"size": size, "shape": shape, "lens": lens}


def _masks(task: AblationTask) -> Row:
    """Distance from the truth and from the masks, as ``splatting_noise`` has them."""
    case = next(case for case in cases() if case.name == task.setting)
    row = measured(solid_mesh(sample(PARTS[task.ablation]).build()), case, task.preset)
    return {name: list(pair) for name, pair in zip(COLUMNS, row, strict=True)}
