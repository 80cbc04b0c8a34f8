"""A solid against a sheet under each reading of its views: the pose, the verdict, and why."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.difference_places import Difference, differences
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.faceted_solids import FacetedSolid
from gaussiancad_core.judging.laying import Laid, lay
from gaussiancad_core.judging.misfits import Judge
from gaussiancad_core.judging.model_edits import Edit, tried_edits
from gaussiancad_core.judging.note_tally import Tally, tally
from gaussiancad_core.judging.sheet_ink import SheetInk
from gaussiancad_core.judging.verdicts import NOT_LAID, Judgement, judged
from gaussiancad_core.model.axes import Projection

_MIRROR = np.diag([-1.0, 1.0, 1.0])


@dataclass(frozen=True, eq=False)
class SheetEvidence:
    """What a sheet says of its part under one projection.

    Attributes:
        views: their lines, with what notes and numbers say.
        ink: of the sheet, and where the views lie on it.
        projection: first or third angle.
    """

    views: DrawnViews
    ink: SheetInk
    projection: Projection


@dataclass(frozen=True, eq=False)
class SheetJudgement:
    """A solid against a sheet.

    Attributes:
        judgement: the verdict, and why.
        evidence: of the sheet, under the projection under which the solid fits best; None where
            it fits under none.
        laid: the solid on the sheet; None where its extents fit in no pose.
        differences: places at which both differ, the worst first.
        edits: single changes of the solid that explain the sheet better, the best first.
        silent: features of the solid that may be left out, or moved, and no line tells.
        tally: notes against the solid.
    """

    judgement: Judgement
    evidence: SheetEvidence | None = None
    laid: Laid | None = None
    differences: tuple[Difference, ...] = ()
    edits: tuple[Edit, ...] = ()
    silent: tuple[Edit, ...] = ()
    tally: tuple[Tally, ...] = ()


def judge_solid(solid: FacetedSolid, readings: Sequence[SheetEvidence]) -> SheetJudgement:
    """A solid against a sheet.

    Args:
        solid: mm, in any position.
        readings: of the sheet, one or two, the likelier first.
    """
    tried = []
    for evidence in readings:
        judge = Judge(drawn_sheet(evidence.views))
        laid = lay(solid, judge)
        if laid is not None:
            tried.append((laid, judge, evidence))
    if not tried:
        return SheetJudgement(NOT_LAID)
    laid, judge, evidence = min(tried, key=lambda each: each[0].misfit.cost)
    differing = differences(laid.misfit, evidence.ink)
    edits = tried_edits(laid, judge, evidence.ink, solid.mapped(_MIRROR, np.zeros(3)))
    kept = tally(laid.solid, evidence.views.holes)
    judgement = judged(laid, judge, differing, edits.better)
    return SheetJudgement(judgement, evidence, laid, differing, edits.better, edits.silent, kept)
