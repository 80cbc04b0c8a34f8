"""A solid against a sheet under each reading of its views: the pose, the verdict, and why."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.difference_places import Difference, differences
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.faceted_solids import FacetedSolid
from gaussiancad_core.judging.laying import Laid, as_it_lies, lay
from gaussiancad_core.judging.misfits import Judge
from gaussiancad_core.judging.model_edits import Edit, TriedEdits, tried_edits
from gaussiancad_core.judging.note_tally import Tally, tally
from gaussiancad_core.judging.number_tally import NumberDifference, differing_numbers
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
        numbers: that the solid does not keep.
    """

    judgement: Judgement
    evidence: SheetEvidence | None = None
    laid: Laid | None = None
    differences: tuple[Difference, ...] = ()
    edits: tuple[Edit, ...] = ()
    silent: tuple[Edit, ...] = ()
    tally: tuple[Tally, ...] = ()
    numbers: tuple[NumberDifference, ...] = ()


def judge_solid(solid: FacetedSolid, readings: Sequence[SheetEvidence]) -> SheetJudgement:
    """A solid against a sheet.

    Args:
        solid: mm, in any position.
        readings: of the sheet, one or two, the likelier first.
    """
    judges = [Judge(drawn_sheet(evidence.views)) for evidence in readings]
    tried = [
        (laid, judge, evidence)
        for judge, evidence in zip(judges, readings, strict=True)
        if (laid := lay(solid, judge)) is not None
    ]
    if not tried:
        return SheetJudgement(NOT_LAID)
    laid, judge, evidence = min(tried, key=lambda each: each[0].least)
    # Under the other projection a part looks much like its mirror image under this one.
    mirrored = min(_mirrored_cost(solid, each) for each in judges)
    edits = tried_edits(laid, judge, evidence.ink, mirrored)
    return _judged(laid, judge, evidence, edits)


def judge_in_place(
    solid: FacetedSolid, evidence: SheetEvidence, *, tries_edits: bool
) -> SheetJudgement:
    """A solid against the sheet that it was made from.

    Args:
        solid: in mm of the sheet, on its axes.
        evidence: of the sheet, under the projection under which the solid was made.
        tries_edits: whether single changes of the solid are tried, which takes the longest.
    """
    judge = Judge(drawn_sheet(evidence.views))
    laid = as_it_lies(solid, judge)
    edits = tried_edits(laid, judge, evidence.ink, np.inf) if tries_edits else TriedEdits((), ())
    return _judged(laid, judge, evidence, edits)


def _judged(laid: Laid, judge: Judge, evidence: SheetEvidence, edits: TriedEdits) -> SheetJudgement:
    differing = differences(laid.misfit, evidence.ink)
    kept = tally(laid.solid, evidence.views.holes)
    numbers = differing_numbers(laid.solid, evidence.views.dimensions, evidence.views.roles)
    return SheetJudgement(
        judged(laid, judge, differing, edits.better, kept),
        evidence,
        laid,
        differing,
        edits.better,
        edits.silent,
        kept,
        numbers,
    )


def _mirrored_cost(solid: FacetedSolid, judge: Judge) -> float:
    """mm of line that the mirror image of a solid leaves unexplained, without its own edges."""
    laid = lay(solid.mapped(_MIRROR, np.zeros(3)), judge)
    if laid is None:
        return np.inf
    return judge.cost_of(judge.sighted(laid.solid), laid.solid.smooth)
