"""What the report says of solids and of lines that contradict each other."""

from dataclasses import replace

from gaussiancad_core.drawing.brep import soundness
from gaussiancad_core.exact_stage import ExactModel
from gaussiancad_core.models import alternative_file
from gaussiancad_core.reasoning.conflict_lines import Conflict
from gaussiancad_core.report import AlternativeReport, ConflictReport, Report
from gaussiancad_core.sheet.deskew import Turn
from gaussiancad_core.sheet.reading import RegisteredSheet
from gaussiancad_core.solid.contradiction import conflict_reason
from gaussiancad_core.verification.overlay import view_to_sheet
from gaussiancad_core.views import Linetype


def with_solid_facts(report: Report, model: ExactModel, turn: Turn) -> Report:
    """The report with a model's other solids, and with lines that contradict each other."""
    report = replace(report, alternatives=_alternatives(model))
    conflict = model.result.conflict
    if conflict is None:
        return report
    lines = _conflict_lines(conflict, model.reading.registered, turn)
    return replace(report, conflict=lines).doubted(*conflict_reason(conflict))


def _alternatives(model: ExactModel) -> tuple[AlternativeReport, ...]:
    result, own = model.result, model.reading.projection
    count = len(result.alternatives)
    reports = []
    for place, (shape, share) in enumerate(
        zip(result.alternatives, result.agreements, strict=True)
    ):
        facts = soundness(shape)
        projection = own.other if place >= count - result.contrary else own
        reports.append(
            AlternativeReport(
                alternative_file(place + 1),
                projection.value,
                facts.faces,
                facts.volume_mm3,
                round(share, 4),
            )
        )
    return tuple(reports)


def _conflict_lines(
    conflict: Conflict, registered: RegisteredSheet, turn: Turn
) -> tuple[ConflictReport, ...]:
    """Lines that contradict each other, with their boxes on the sheet as stored."""
    reports = []
    for line in conflict.lines:
        view = registered.views[line.role]
        points = turn.to_stored(view_to_sheet(view, registered.views.size, line.points))
        (x0, y0), (x1, y1) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
        drawn, fitting = _name(line.drawn), _name(line.fitting)
        reports.append(
            ConflictReport(line.role.value, drawn, line.suspect, fitting, (x0, y0, x1, y1))
        )
    return tuple(reports)


def _name(linetype: Linetype | None) -> str | None:
    return None if linetype is None else linetype.value
