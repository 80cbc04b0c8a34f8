"""Does a solid agree with a drawing: by reasons, never by a share of lines.

A wrong hole costs a hundredth of a sheet's lines, and so does what an ordinary reading loses.  So
no limit on a share tells them apart.  A reason does: an extent that is another one; a whole drawn
circle that the solid has not; a visible edge of the solid where the sheet has neither line nor
ink; a hatched area that is no cut; a hole that is not as its note says; a single change of the
solid with which it explains the sheet better.  Without a reason a sheet that is mostly explained
agrees, and of one that is not nobody can tell.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from gaussiancad_core.geometry.points import Box
from gaussiancad_core.judging.difference_kinds import Kind
from gaussiancad_core.judging.difference_places import Difference
from gaussiancad_core.judging.laying import Laid
from gaussiancad_core.judging.misfits import Judge, lost_lines
from gaussiancad_core.judging.model_edits import Edit, as_message
from gaussiancad_core.judging.note_tally import Tally
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Axis
from gaussiancad_protocol.codes import Code


class Verdict(Enum):
    """Whether a solid agrees with a drawing."""

    AGREES = "agrees"
    DIFFERS = "differs"
    CANNOT_TELL = "cannot-tell"


_EXTENT, _EXTENT_TOLERANCES = 0.01, 3.0
"""How far an extent may be off: share of it, and tolerances of strokes, whichever is more."""

_LOST = 0.7
"""Share of a drawn circle that is lost where the solid has none there."""

_SURE = 0.9
"""Odds of a circle from which it counts."""

_SMALLEST = 0.01
"""Share of the longest extent that a circle is long at least to count."""

_OFF_INK = 0.004
"""Share of the sheet's lines that edges without line and ink make at least to count."""

_BARE = 0.5
"""Share of an edge that lies on ink at most where the sheet does not draw it."""

_HATCHING = 0.08
"""The same of a section's lines for areas that are hatched and not cut, or cut and not hatched."""

_QUIET = 0.1
"""Share of the lines that may stay unexplained where a solid agrees: readings lose as much."""


_POOR = 0.25
"""Share of the lines that stays unexplained from which no place tells anything: the views were read
wrongly, or are another part's."""

_TELLING = 0.15
"""Share of what is unexplained that a single change has to explain at least."""


@dataclass(frozen=True)
class Reason:
    """Why a solid differs from a drawing, or why nobody can tell.

    Attributes:
        code: kebab-case.
        message: a sentence.
    """

    code: str
    message: str


@dataclass(frozen=True, eq=False)
class Judgement:
    """Whether a solid agrees with a drawing.

    Attributes:
        verdict: the answer.
        reasons: of it, the strongest first; none where it agrees.
    """

    verdict: Verdict
    reasons: tuple[Reason, ...] = ()


def judged(
    laid: Laid,
    judge: Judge,
    differing: Sequence[Difference],
    edits: Sequence[Edit],
    notes: Sequence[Tally],
) -> Judgement:
    """Whether a solid agrees with a drawing.

    Args:
        laid: the solid on the sheet.
        judge: of the sheet.
        differing: the places at which they differ, with what ink is there.
        edits: single changes of the solid that explain the sheet better.
        notes: of the sheet, against the solid.
    """
    reasons = [*_extents(laid, judge)]
    if laid.misfit.share < _POOR:
        reasons += (*_circles(laid, judge), *_bare_edges(laid, differing), *_hatching(laid))
    reasons += _better(laid, edits)
    notes_broken = [broken(note) for note in notes if not note.agrees]
    # A count alone may speak of holes of which no circle was read.
    otherwise = laid.misfit.share < _POOR and any(note.count_otherwise for note in notes)
    if reasons or otherwise:
        return Judgement(Verdict.DIFFERS, (*reasons, *notes_broken))
    if laid.misfit.share >= _QUIET:
        notes_broken.insert(0, _unexplained(laid))
    return Judgement(Verdict.CANNOT_TELL if notes_broken else Verdict.AGREES, tuple(notes_broken))


NOT_LAID = Judgement(
    Verdict.CANNOT_TELL,
    (
        Reason(
            Code.EXTENTS_DIFFER,
            "the solid's extents fit the views in no position: it is another part, or the views "
            "were read wrongly",
        ),
    ),
)
"""Of a solid whose extents are not the sheet's, however it is turned."""


def _extents(laid: Laid, judge: Judge) -> Iterator[Reason]:
    sheet = judge.sheet
    if laid.least >= _POOR:
        # Neither the solid nor a stretched one is what was read.
        return
    least = np.maximum(_EXTENT, _EXTENT_TOLERANCES * sheet.tolerance / sheet.size)
    for axis in Axis:
        deviation = float(laid.pose.deviation[axis.value])
        if abs(deviation) > least[axis.value]:
            stated = float(sheet.size[axis.value])
            yield Reason(
                Code.EXTENTS_DIFFER,
                Message(
                    "the views are {stated_mm:.4g} mm along {axis}, the solid is "
                    "{measured_mm:.4g} mm",
                    case="axis",
                    axis=axis.name.lower(),
                    stated_mm=stated,
                    measured_mm=stated * (1.0 + deviation),
                ),
            )


def _circles(laid: Laid, judge: Judge) -> Iterator[Reason]:
    least = _SMALLEST * judge.sheet.longest
    for view, number in lost_lines(laid.misfit, _LOST):
        line = view.lines[number]
        is_sure = line.odds >= _SURE and line.is_visible
        if line.is_circle and is_sure and line.length > least:
            right, up = line.points.mean(axis=0).tolist()
            yield Reason(
                Code.CIRCLE_MISSING,
                Message(
                    "the {view} view has a circle of {diameter_mm:.4g} mm at ({right:.4g}, "
                    "{up:.4g}) mm that the solid does not show",
                    view=view.role,
                    diameter_mm=line.length / np.pi,
                    right=right,
                    up=up,
                ),
            )


def _bare_edges(laid: Laid, differing: Sequence[Difference]) -> Iterator[Reason]:
    bare = [
        difference
        for difference in differing
        if difference.kind is Kind.EXTRA
        and difference.on_ink is not None
        and difference.on_ink < _BARE
    ]
    total = sum(difference.mm for difference in bare)
    if total <= _OFF_INK * laid.misfit.drawn:
        return
    worst = max(bare, key=lambda difference: difference.mm)
    (right, up), _ = worst.ends
    yield Reason(
        Code.EDGE_NOT_DRAWN,
        Message(
            "the solid shows an edge of {length_mm:.4g} mm in the {view} view, at ({right:.4g}, "
            "{up:.4g}) mm, where the sheet has neither a line nor ink; {total_mm:.4g} mm of such "
            "edges in all",
            view=worst.view.role,
            length_mm=worst.mm,
            right=right,
            up=up,
            total_mm=total,
        ),
    )


def _hatching(laid: Laid) -> Iterator[Reason]:
    for view in laid.misfit.views:
        wrong = float(view.mm[view.of(Kind.HATCHING)].sum())
        if wrong > _HATCHING * view.view.length:
            yield Reason(
                Code.SECTION_DIFFERS,
                Message(
                    "the section in the {view} view is hatched where the solid is not cut, or the "
                    "other way round",
                    view=view.view.role,
                ),
            )


def broken(note: Tally, boxes: Iterable[Box] = ()) -> Reason:
    """That a solid does not keep a note.

    Args:
        note: against the solid.
        boxes: where it is on the sheet, px.
    """
    return Reason(
        Code.NOTE_NOT_KEPT,
        Message(
            'the note "{text}" speaks of {stated} hole(s), the solid has {found} like that',
            boxes=boxes,
            text=note.text,
            stated=note.count_stated,
            found=note.count_found,
        ),
    )


def _better(laid: Laid, edits: Sequence[Edit]) -> Iterator[Reason]:
    """The best change, where the sheet is mostly explained with it."""
    misfit = laid.misfit
    least = _TELLING * misfit.cost
    if edits and edits[0].mm >= least and misfit.cost - edits[0].mm < _QUIET * misfit.drawn:
        yield Reason(Code.EXPLAINED_BETTER, as_message(edits[0]))


def _unexplained(laid: Laid) -> Reason:
    return Reason(
        Code.LINES_UNEXPLAINED,
        Message(
            "{percent} % of the lines that were read disagree with the solid, and nothing tells "
            "whether it or the reading is wrong",
            case="check",
            percent=round(100 * laid.misfit.share),
        ),
    )
