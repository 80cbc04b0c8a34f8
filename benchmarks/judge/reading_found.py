"""What was read of a sheet, in px of the sheet as it is stored, and a picture of it."""

import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

import cv2

from benchmarks.judge.stroke_matching import Box
from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.evidence.projection_choice import both_readings
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.processes.events import Progress, Silence
from gaussiancad_core.recognition.views_and_lines import SheetLines, read_lines
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.run.pipeline import STAGES
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage, read_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import register_views
from gaussiancad_core.sketch.projection_by_sketch import weigh
from gaussiancad_protocol.modes import ResultKind


@dataclass(frozen=True)
class Found:
    """What was read.

    Attributes:
        boxes, strokes: of each view, as its own ink tells, in px of the sheet as stored.
        projection, alternatives: first or third angle.
        direct_views: how many views have the strokes of the file.
    """

    boxes: dict[Role, Box]
    strokes: dict[Role, tuple[DrawnStroke, ...]]
    projection: Projection
    alternatives: tuple[Projection, ...]
    direct_views: int = 0


def read(path: Path, reading: ReadingOptions) -> Found:
    """Read a sheet as ``gaussiancad reconstruct`` does, with nothing told of it.

    Args:
        path: of the sheet.
        reading: finder and filter.

    Raises:
        GaussianCadError: it cannot be read.
    """
    sheet, lines = lines_of(read_sheet(path), reading)
    return found_of(lines, sheet.turn, reading)


def picture_of(path: Path) -> SheetImage:
    """A sheet as it is read of its picture alone, which has the pixels of the file's reading."""
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / f"{path.stem}.png"
        cv2.imwrite(str(picture), read_sheet(path).grey)
        return read_sheet(picture)


def lines_of(image: SheetImage, reading: ReadingOptions) -> tuple[OpenedSheet, SheetLines]:
    """A sheet upright, and the engine's views and lines; nobody asks for the scale.

    Raises:
        GaussianCadError: it has no views that belong together.
    """
    sheet = OpenedSheet(image, reading.median_kernel)
    job = Job(
        image.path,
        image.path.parent,
        replace(reading, mm_per_pixel=1.0, lengths=()),
        result=ResultKind.SURFACE,
    )
    notes = RunNotes(Report(image.sha256, job.settings()), Progress(Silence(), len(STAGES)))
    return sheet, read_lines(job, sheet, notes)


def found_of(lines: SheetLines, turn: Turn, reading: ReadingOptions) -> Found:
    """What was read, brought together.

    Args:
        lines: views with their strokes, in px of the upright sheet.
        turn: of the upright sheet; its scale leads to px of the sheet as stored.
        reading: finder and filter.

    Raises:
        GaussianCadError: the views contradict each other.
    """
    layout, drawn = lines.layout, lines.drawn
    projection, alternatives = layout.projection, layout.alternatives
    if alternatives:
        both = zip(both_readings(drawn, reading), (projection, projection.other), strict=True)
        readings = [ProjectedReading(item, angle) for item, angle in both if item is not None]
        weighed = weigh(readings)
        chosen = readings[weighed.likelier]
        registered, projection = chosen.registered, chosen.projection
        is_certain = weighed.is_clear or len(readings) == 1
        alternatives = () if is_certain else (projection.other,)
    else:
        registered = register_views(drawn, reading)
    drawn = registered.drawn
    offset = turn.scale * turn.centre[0], turn.scale * turn.centre[1]
    to_stored = Similarity(turn.scale, turn.angle, origin=turn.centre, offset=offset)
    strokes = {
        view.role: tuple(stroke.mapped(to_stored) for stroke in view.strokes) for view in drawn
    }
    boxes = {view.role: view.stored_box(turn) for view in drawn}
    direct_views = sum(view.source is not StrokesSource.RASTER for view in drawn)
    return Found(boxes, strokes, projection, alternatives, direct_views)
