"""Does a model agree with its drawing: what ``gaussiancad check`` does.

read -> views -> lines -> masks -> judge -> write.
"""

from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from gaussiancad_core.comparison.model_files import format_of, read_model
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.judging.faceted_solids import FacetedSolid, faceted_mesh, faceted_shape
from gaussiancad_core.judging.sheet_ink import SheetInk, distance_to_ink, placements_of
from gaussiancad_core.judging.sheet_judgement import SheetEvidence, SheetJudgement, judge_solid
from gaussiancad_core.judging.verdicts import Judgement, Reason, Verdict
from gaussiancad_core.kernel.brep import soundness
from gaussiancad_core.kernel.brep_files import read_shape, readable
from gaussiancad_core.messages import Message
from gaussiancad_core.pictures.check_picture import check_picture
from gaussiancad_core.processes.events import Listener, Progress
from gaussiancad_core.processes.garbage import uncollected
from gaussiancad_core.recognition.load_sheet import open_sheet
from gaussiancad_core.recognition.page_choice import naming_pages
from gaussiancad_core.recognition.views_and_lines import with_unseen
from gaussiancad_core.report.check_report import check_json, check_values
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.run.read_run import sheet_lines
from gaussiancad_core.run.registering_stage import SheetFindings, registered_lines
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.storage.outputs import CHECK_FILES, OutputFolder, os_error
from gaussiancad_core.writing.sheet_scale import ScaleSource
from gaussiancad_protocol.codes import Code

STAGES = ("read", "views", "lines", "masks", "judge", "write")

_SAME_SCALE = 0.01
"""Share within which a solid has the size that the sheet's numbers say."""


@dataclass(frozen=True, eq=False)
class SheetCheck:
    """A model against a sheet.

    Attributes:
        verdict: whether they agree.
        values: the content of ``check.json``.
    """

    verdict: Verdict
    values: dict[str, Any]


@dataclass(frozen=True, eq=False)
class CheckedModel:
    """A model of a file.

    Attributes:
        solid: as lines of sight meet it.
        doubt: why it encloses nothing for certain; None where it is whole.
    """

    solid: FacetedSolid
    doubt: Reason | None = None


@dataclass(frozen=True, eq=False)
class ReadSheet:
    """A sheet that models are checked against.

    Attributes:
        sheet: as stored and upright.
        readings: of its views, the likelier first; none where no part follows from it.
        refused: why there are none.
        is_shaded: whether a view of a file is a picture.
        report: what was told of the sheet.
    """

    sheet: OpenedSheet
    readings: tuple[SheetEvidence, ...]
    refused: Reason | None
    is_shaded: bool
    report: Report


def check_to_folder(job: Job, model: Path, listener: Listener) -> SheetCheck:
    """Check a model against a sheet, and write ``check.json`` and ``check.png`` into the job's
    folder.

    Raises:
        UnreadableError: the sheet cannot be read as a drawing, or the file as a model.
        UsageError: the folder cannot be written.
        LimitError: a limit was reached, or the disk is full.
    """
    notes = RunNotes(Report("", job.settings()), Progress(listener, len(STAGES)))
    with uncollected():
        checked = checked_model(model)
        read = read_for_check(job, notes)
        with notes.stage("judge"):
            found = checked_on(read, checked)
        values = check_values(
            found,
            read.sheet.turn.to_stored,
            read.report.scale_source,
            [asdict(each) for each in read.report.unused],
        )
    data, picture = CHECK_FILES
    folder = OutputFolder(job.output, CHECK_FILES, data)
    try:
        with notes.stage("write"):
            image = check_picture(values, read.sheet.picture)
            (folder.staging / picture).write_bytes(image)
            (folder.staging / data).write_bytes(check_json(values))
            folder.commit()
    except OSError as error:
        raise os_error(job.output, error) from error
    finally:
        folder.discard()
    return SheetCheck(found.judgement.verdict, values)


def checked_model(path: Path) -> CheckedModel:
    """A model of a file, as lines of sight meet it.

    Raises:
        UnreadableError: as of :func:`.read_model`.
    """
    if not format_of(path).is_exact:
        mesh = read_model(path).mesh
        return CheckedModel(faceted_mesh(mesh), None if mesh.watertight else _OPEN)
    with readable(path):
        shape = read_shape(path)
        facts = soundness(shape)
        is_whole = facts.valid and facts.closed and facts.solids
        return CheckedModel(faceted_shape(shape), None if is_whole else _OPEN)


_OPEN = Reason(
    Code.SOLID_UNSOUND,
    Message("the model is not closed, or damaged: what it is full of is not certain", case="model"),
)


def read_for_check(job: Job, notes: RunNotes) -> ReadSheet:
    """A sheet as models are checked against it.

    Raises:
        UnreadableError: it cannot be read as a drawing at all.
        LimitError: a limit was reached.
    """
    sheet = open_sheet(job, notes)
    try:
        lines = with_unseen(sheet_lines(job, sheet, notes), notes)
        findings = registered_lines(job, lines, sheet.turn, notes)
    except NoModelError as error:
        message = naming_pages(error, sheet.image).message
        return ReadSheet(sheet, (), Reason(error.code, message), False, notes.report)
    away = distance_to_ink(sheet.clean.ink)
    readings = [
        SheetEvidence(reading.numbered, SheetInk(away, placements_of(reading)), reading.projection)
        for reading in (findings.assumed, findings.other)
        if reading is not None
    ]
    shaded = _is_shaded(findings, sheet)
    return ReadSheet(sheet, tuple(readings), None, shaded, notes.report)


def checked_on(read: ReadSheet, model: CheckedModel) -> SheetJudgement:
    """Whether a model agrees with a sheet."""
    if read.refused is not None:
        return SheetJudgement(Judgement(Verdict.CANNOT_TELL, (read.refused,)))
    found = _sized(judge_solid(model.solid, read.readings), read.report)
    if model.doubt is not None and found.judgement.verdict is Verdict.AGREES:
        found = _doubted(found, model.doubt)
    if read.is_shaded and found.judgement.verdict is Verdict.DIFFERS:
        found = _doubted(found, _SHADED)
    return found


_SHADED = Reason(
    Code.SHADED_VIEWS,
    "the sheet shows shaded pictures in place of lines: they are not read surely enough to say "
    "that the model differs",
)

_PICTURED = 0.5
"""Share of a view's box that a picture of the file covers from which the view is that picture."""


def _is_shaded(findings: SheetFindings, sheet: OpenedSheet) -> bool:
    """Whether a view of a file is a picture."""
    drawing = sheet.image.vectors
    if drawing is None:
        return False
    return any(
        _covered(view.box, box) >= _PICTURED
        for view in findings.assumed.registered.drawn
        for box in drawing.pictures
    )


def _covered(box: Box, picture: Box) -> float:
    """Share of a box that another one covers."""
    width = min(box[2], picture[2]) - max(box[0], picture[0])
    height = min(box[3], picture[3]) - max(box[1], picture[1])
    area = (box[2] - box[0]) * (box[3] - box[1])
    return max(width, 0.0) * max(height, 0.0) / area if area > 0.0 else 0.0


def _doubted(found: SheetJudgement, reason: Reason) -> SheetJudgement:
    """The same, but nobody can tell."""
    reasons = (reason, *found.judgement.reasons)
    return replace(found, judgement=Judgement(Verdict.CANNOT_TELL, reasons))


def _sized(found: SheetJudgement, report: Report) -> SheetJudgement:
    """The same with a word on the size, where the sheet says how large the part is."""
    known = {ScaleSource.GIVEN.value, ScaleSource.DIMENSION.value}
    if found.laid is None or report.scale_source not in known:
        return found
    scale = found.laid.pose.scale
    if abs(scale - 1.0) <= _SAME_SCALE:
        return found
    reason = Reason(
        Code.SIZE_DIFFERS,
        Message(
            "the solid has {factor:.4g} times the size that the sheet's numbers say",
            factor=scale,
        ),
    )
    judgement = Judgement(Verdict.DIFFERS, (reason, *found.judgement.reasons))
    return replace(found, judgement=judgement)
