"""What the report says of solids and of lines that contradict each other."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.judging.difference_places import Difference
from gaussiancad_core.judging.faceted_solids import FacetedSolid
from gaussiancad_core.judging.note_tally import kept_notes
from gaussiancad_core.kernel.brep import soundness
from gaussiancad_core.labelling.conflict_lines import Conflict
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.section_planes import SectionRole
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.pictures.overlay import view_to_sheet
from gaussiancad_core.report.assumed_holes import assumed_holes
from gaussiancad_core.report.report_entries import (
    AlternativeReport,
    Assumption,
    ConflictReport,
    Disagreement,
    MeasuresReport,
    NoteReport,
)
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.report.section_report import assumed_planes, with_agreement
from gaussiancad_core.run.exact_stage import ExactModel
from gaussiancad_core.run.run_models import alternative_file
from gaussiancad_core.run.solid_judgement import ADDED, counted_differences
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.solid.contradiction import conflict_reason
from gaussiancad_core.solid.measure_bounds import Measures
from gaussiancad_core.solid.reasons import ASSUMED
from gaussiancad_core.solid.search_trace import Attempt
from gaussiancad_core.writing.callouts import NoteKind
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import Status

_FINE = 1e-4
"""Share of the longest extent within which two extents are one."""

_INSIDE = "bores, pockets or cavities that would show in hidden lines only"
"""What else there may be where a solid rests on hidden lines that no view has."""


def with_solid_facts(report: Report, model: ExactModel, turn: Turn) -> Report:
    """The report with what was tried for a model, how well it is known, and what else there is."""
    result, sheet = model.result, _Sheet(model.reading, turn)
    verification, judged = result.verification, model.judged
    report = replace(
        report,
        alternatives=_alternatives(model),
        measures=_measures(result.measures)
        if result.measures and report.has_measure_bound
        else None,
        assumptions=(
            *(
                Assumption(Code.NOTHING_HIDDEN, message, None, _INSIDE)
                for code, message in result.reasons
                if code == ASSUMED
            ),
            *_of_sheet(report, model, turn),
        ),
        sections=(
            with_agreement(report.sections, model.reading, verification)
            if verification is not None
            else report.sections
        ),
        disagreements=tuple(
            _disagreement(each, sheet)
            for each in (counted_differences(judged) if judged is not None else ())
        ),
        trace=tuple(_attempt(attempt, sheet) for attempt in result.trace),
    )
    if judged is not None and judged.laid is not None:
        report = replace(report, notes=_compared_notes(report, model, judged.laid.solid, turn))
    conflict = result.conflict
    if conflict is None:
        return report
    lines = _conflict_lines(conflict, sheet)
    return replace(report, conflict=lines).doubted(*conflict_reason(conflict))


def _compared_notes(
    report: Report, model: ExactModel, solid: FacetedSolid, turn: Turn
) -> tuple[NoteReport, ...]:
    """The notes, those as used that speak of what the solid has as they say."""
    kept = {turn.box_to_stored(box) for box in kept_notes(solid, model.reading.holes)}
    unseen = model.reading.registered.unseen
    return tuple(
        replace(
            note,
            used=note.at in kept
            if note.kind != NoteKind.THICKNESS.value
            else note.value_mm is not None and _is_as_thick(note.value_mm, unseen, solid),
        )
        for note in report.notes
    )


def _is_as_thick(value: float, unseen: Unseen | None, solid: FacetedSolid) -> bool:
    """Whether a solid is as thick along the axis that no view shows as a note says, mm."""
    if unseen is None or unseen.thickness is None:
        return False
    extent = solid.extent
    return bool(abs(extent[unseen.axis.value] - value) <= _FINE * extent.max())


class _Sheet:
    """Where points of the views lie on the sheet as stored.

    Args:
        reading: the views.
        turn: of the upright sheet.
    """

    def __init__(self, reading: ProjectedReading, turn: Turn) -> None:
        self._views = reading.registered.views
        self._beside = reading.adjacent_sections
        self._turn = turn

    def points(self, role: Role | SectionRole, points: np.ndarray) -> np.ndarray:
        """(n, 2) px of points (n, 2) mm of a view."""
        if isinstance(role, SectionRole):
            found = self._beside[role].place.to_sheet(points)
        else:
            found = view_to_sheet(self._views[role], self._views.size, points)
        return self._turn.to_stored(found)

    def place(self, role: Role, place: Point) -> tuple[float, float]:
        """The px of a point in mm of a view."""
        ((x, y),) = self.points(role, np.array([place])).tolist()
        return round(x, 1), round(y, 1)


def _disagreement(each: Difference, sheet: _Sheet) -> Disagreement:
    role = each.view.role
    first, last = each.ends
    line = (sheet.place(role, first), sheet.place(role, last)) if each.is_straight else None
    middle = each.pieces.mean(axis=1)[len(each.pieces) // 2]
    at = sheet.place(role, (float(middle[0]), float(middle[1])))
    kind = Linetype.HIDDEN if each.is_hidden else Linetype.VISIBLE
    return Disagreement(role.value, at, each.mm, each.kind not in ADDED, kind.value, line)


def _of_sheet(report: Report, model: ExactModel, turn: Turn) -> Iterator[Assumption]:
    """What was assumed of sections, holes and views that are not drawn: nothing of that decided
    anything where a solid is verified."""
    if model.result.status is Status.VERIFIED:
        return
    yield from assumed_planes(report.sections)
    yield from _second_view(report)
    if model.result.shape is not None:
        yield from assumed_holes(model.reading, model.result.shape, turn)


def _second_view(report: Report) -> Iterator[Assumption]:
    """That a second view would have shown what was taken for it."""
    yield from (
        Assumption(Code.SECOND_VIEW, reason.message, None, "another part with the same view")
        for reason in report.reasons
        if reason.code == Code.SECOND_VIEW_ASSUMED
    )


def _measures(measures: Measures) -> MeasuresReport:
    # Four digits say more than anybody can measure.
    along = {
        axis.name.lower(): float(f"{bound:.4g}")
        for axis, bound in zip(Axis, measures.by_axis, strict=True)
    }
    return MeasuresReport(float(f"{measures.uncertainty:.4g}"), measures.source.value, along)


def _attempt(attempt: Attempt, sheet: _Sheet) -> dict[str, Any]:
    """An attempt as JSON values."""
    return {
        "model": attempt.model.value,
        "outcome": attempt.outcome.value,
        "taken": attempt.taken,
        "rules": attempt.rules,
        "cells": attempt.cells,
        "work": round(attempt.work, 3),
        "given_up_mm": round(attempt.cost, 2),
        "given_up": [
            {
                "view": each.role.value,
                "at": list(sheet.place(each.role, each.place)),
                "length_mm": round(each.length, 2),
                "drawn": _name(each.drawn),
            }
            for each in attempt.given_up
        ],
        "faces": attempt.faces,
        "agreement": round(attempt.share, 4),
        "disagreements": attempt.flaws,
        "others": attempt.others,
        "open_at_mm": [[round(value, 2) for value in place] for place in attempt.open_at],
    }


def _alternatives(model: ExactModel) -> tuple[AlternativeReport, ...]:
    result, this_projection = model.result, model.reading.projection
    count = len(result.alternatives)
    reports = []
    for place, (shape, share) in enumerate(
        zip(result.alternatives, result.agreements, strict=True)
    ):
        facts = soundness(shape)
        projection = this_projection.other if place >= count - result.contrary else this_projection
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


def _conflict_lines(conflict: Conflict, sheet: _Sheet) -> tuple[ConflictReport, ...]:
    """Lines that contradict each other, with their boxes on the sheet as stored."""
    reports = []
    for line in conflict.lines:
        points = sheet.points(line.role, line.points)
        (x0, y0), (x1, y1) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
        drawn, fitting = _name(line.drawn), _name(line.fitting)
        reports.append(
            ConflictReport(line.role.value, drawn, line.suspect, fitting, (x0, y0, x1, y1))
        )
    return tuple(reports)


def _name(linetype: Linetype | None) -> str | None:
    return None if linetype is None else linetype.value
