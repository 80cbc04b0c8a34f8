"""A solid against a sheet under each reading of its views: the pose, the verdict, and why."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.judging.difference_places import Difference, differences
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.faceted_solids import FacetedSolid
from gaussiancad_core.judging.laying import Laid, lay
from gaussiancad_core.judging.misfits import Judge
from gaussiancad_core.judging.note_tally import Tally, tally
from gaussiancad_core.judging.sheet_ink import SheetInk
from gaussiancad_core.judging.verdicts import NOT_LAID, Judgement, judged
from gaussiancad_core.model.axes import Projection


@dataclass(frozen=True, eq=False)
class SheetJudgement:
    """A solid against a sheet.

    Attributes:
        judgement: the verdict, and why.
        projection: first or third angle, under which the solid fits best; None where it fits
            under none.
        laid: the solid on the sheet; None where its extents fit in no pose.
        differences: places at which both differ, the worst first.
        tally: notes against the solid.
        ink: of the sheet under that projection.
    """

    judgement: Judgement
    projection: Projection | None = None
    laid: Laid | None = None
    differences: tuple[Difference, ...] = ()
    tally: tuple[Tally, ...] = ()
    ink: SheetInk | None = None


def judge_solid(
    solid: FacetedSolid, readings: Sequence[tuple[ProjectedReading, SheetInk]]
) -> SheetJudgement:
    """A solid against a sheet.

    Args:
        solid: mm, in any position.
        readings: of the sheet, one or two, the likelier first, with its ink.
    """
    tried = []
    for reading, ink in readings:
        judge = Judge(drawn_sheet(reading.numbered))
        laid = lay(solid, judge)
        if laid is not None:
            tried.append((laid, judge, reading, ink))
    if not tried:
        return SheetJudgement(NOT_LAID)
    laid, judge, reading, ink = min(tried, key=lambda each: each[0].misfit.cost)
    differing = differences(laid.misfit, ink)
    kept = tally(laid.solid, reading.holes)
    judgement = judged(laid, judge, differing)
    return SheetJudgement(judgement, reading.projection, laid, differing, kept, ink)


def doubted(found: SheetJudgement, judgement: Judgement) -> SheetJudgement:
    """The same with another verdict."""
    return replace(found, judgement=judgement)
