"""The exact solid of a drawing: reason, build, draw again, look for others."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from math import inf

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.axes import mutually_orthogonal
from gaussiancad_core.drawing.brep import soundness
from gaussiancad_core.drawing.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.errors import LimitError
from gaussiancad_core.modes import Status
from gaussiancad_core.reasoning.columns import Cell
from gaussiancad_core.reasoning.conflict_lines import Conflict
from gaussiancad_core.reasoning.conflicts import find_conflict
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.labelling import (
    Labelling,
    Labels,
)
from gaussiancad_core.reasoning.part import (
    PartModel,
    model_part,
)
from gaussiancad_core.reasoning.solvers import Deadline
from gaussiancad_core.reasoning.supports import find_supports
from gaussiancad_core.reasoning.unsaid import with_unsaid
from gaussiancad_core.solid.build import BuiltSolid, build_solid
from gaussiancad_core.solid.certainty import certainties
from gaussiancad_core.solid.labelled import LabelledSpace
from gaussiancad_core.solid.models import Clock, Limits, Work, labelled
from gaussiancad_core.solid.same import same_solid
from gaussiancad_core.solid.verify import Verification, verify

_COUNTING = 0.15
"""Units of thickness from which a cell makes a different solid."""


_PATIENT = 0.25
"""Share of the time after which it is not asked any more which lines contradict each other."""

_FIRST, _OTHERS = 0.6, 0.9
"""Shares of the time at which building, and the search for others, end: of the first model's labels
and of others'."""

_UNLIKELY = 0.02
"""Share of the search for others that is left where neither lines nor labels agree: they may,
but are found at once or not at all."""

_WHOLE = 0.08
"""Share of the longest extent from which lines that are wrong, or lacking, count alike."""

_NONE = "no-solid-fits", "no solid has these lines: they contradict each other"
_UNBUILT = (
    "no-valid-solid",
    "the cells that fit the lines best bound no closed solid: lines are missing or wrong",
)
_RETOLD = (
    "linetypes-retold",
    "hidden lines no longer than a dash look like visible ones: some are taken for the other kind, "
    "as the other views have it",
)
_LOOSE = (
    "lines-inexact",
    "lines miss each other by more than they should: those that are close by were taken to meet, "
    "so that small steps may be missing",
)
_THIN = (
    "faces-thin",
    "long faces narrower than two pixels, which no view can show: they may be left between lines "
    "that belong together",
)
_UNFINISHED = "search-unfinished", "the search for solids with these lines was not completed"


_QUICK = 0.25
"""Share of the time that a search took at most for another one, with likely measures."""

_LESS = 0.002
"""Share of the lines that a solid may show less then."""


@dataclass(frozen=True)
class Candidate:
    """A solid that may be the part.

    Attributes:
        shape: mm, in the model's axes.
        verification: how its lines agree with the views.
    """

    shape: TopoDS_Shape
    verification: Verification


@dataclass(frozen=True)
class ExactResult:
    """What was found.

    Attributes:
        status: ``VERIFIED`` as the contract defines it, ``APPROXIMATE`` with reasons, ``FAILED``
            without a solid.
        shape: the solid in mm; None if there is none.
        verification: of the solid.
        alternatives: other solids that agree with the views as well.
        reasons: (code, sentence).
        seconds: of the steps.
        agreements: of the alternatives: share of all lines, both ways, that agree, 0 to 1.
        conflict: lines that contradict each other, where no solid has all lines.
        contrary: how many of the alternatives, the last ones, are under the other projection.
        relaxed: whether rules that the lines make had to be given up: the solid may show them all
            nevertheless, where coordinates that are meant to be one were read as two.
    """

    status: Status
    shape: TopoDS_Shape | None
    verification: Verification | None
    alternatives: tuple[TopoDS_Shape, ...]
    reasons: tuple[tuple[str, str], ...]
    seconds: dict[str, float]
    agreements: tuple[float, ...] = ()
    conflict: Conflict | None = None
    contrary: int = 0
    relaxed: bool = False


def exact_solid(views: DrawnViews, limits: Limits | None = None) -> ExactResult:
    """The solid whose lines are those of the views.

    Args:
        views: two to six.
        limits: of the search.
    """
    limits = limits or Limits()
    with _uncollected():
        return _with_likely_measures(_found(views, limits), views, limits)


@contextmanager
def _uncollected() -> Iterator[None]:
    """No garbage is looked for meanwhile.

    Columns, rules and clauses are made by the million, are all kept and have no cycles: looking at
    them again and again took a third of the time.
    """
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


def _found(views: DrawnViews, limits: Limits) -> ExactResult:
    clock = Clock()
    try:
        part = model_part(views, deadline=clock.deadline(_OTHERS * limits.seconds))
    except LimitError as error:
        reason = error.code, error.message
        return ExactResult(Status.FAILED, None, None, (), (reason,), clock.seconds)
    clock.lap("model")
    result: ExactResult | None = None
    for work, labelling in labelled(part, views, limits, clock):
        clock.lap("label")
        # Other models may be the better ones: time has to remain for them.
        latest = clock.deadline((_OTHERS if result else _FIRST) * limits.seconds)
        found = _searched(work, labelling, limits, latest)
        if result is None or _worth(found, views) > _worth(result, views):
            result = found
        if _is_neat(found) or (work.fewest and labelling.complete and _is_sound(found)):
            break
    clock.lap("label")
    if _explains(result) or not limits.relaxed or clock.total > _PATIENT * limits.seconds:
        return result
    conflict = find_conflict(part, views, limits.conflict)
    clock.lap("conflict")
    return replace(result, conflict=conflict)


def _with_likely_measures(found: ExactResult, views: DrawnViews, limits: Limits) -> ExactResult:
    """The same solid with measures that most likely are round, where a picture leaves some open.

    They stay in doubt, and so does the solid: only its shape changes, and what is said of it.
    """
    own = found.verification
    if own is None or not own.sound or own.close:
        return found
    if sum(found.seconds.values()) > _QUICK * limits.seconds:
        return found
    likely = replace(views, likely=True)
    if not find_supports(likely).moved:
        return found
    other = _found(likely, replace(limits, seconds=_QUICK * limits.seconds))
    if not _is_as_good(other, found):
        return found
    # What else there may be was looked for among the first ones.
    reasons = other.reasons if other.reasons and not found.alternatives else found.reasons
    return replace(found, shape=other.shape, verification=other.verification, reasons=reasons)


def _is_as_good(other: ExactResult, found: ExactResult) -> bool:
    """Whether a solid is sound, shows the lines as well, and has no more faces."""
    new, old = other.verification, found.verification
    if new is None or old is None or not new.sound or new.share < old.share - _LESS:
        return False
    same_lines = len(new.flaws) <= len(old.flaws)
    return same_lines and soundness(other.shape).faces <= soundness(found.shape).faces


def _explains(result: ExactResult) -> bool:
    return result.verification is not None and result.verification.explains


def _is_neat(result: ExactResult) -> bool:
    return result.verification is not None and result.verification.neat


def _is_sound(result: ExactResult) -> bool:
    return result.verification is not None and result.verification.sound


def _worth(result: ExactResult, views: DrawnViews) -> tuple[bool, bool, bool, float]:
    """What solids of several models are ranked by: exact lines are right or wrong as a whole."""
    verification = result.verification
    if verification is None:
        return False, False, False, -inf
    told = verification.neat, verification.explains, verification.sound
    if views.apart is not None:
        return *told, verification.share
    most = _WHOLE * max(views.size)
    wrong = sum(min(flaw.length, most) for flaw in verification.flaws)
    return *told, -wrong


def _searched(work: Work, labelling: Labelling, limits: Limits, latest: Deadline) -> ExactResult:
    """The solid of labels, or of others that are as good."""
    clock, views = work.clock, work.views
    if labelling.labels is None:
        reason = _NONE if labelling.complete else _UNFINISHED
        return ExactResult(Status.FAILED, None, None, (), (reason,), clock.seconds)
    candidates, complete = _candidates(work, labelling, limits, latest)
    if not candidates:
        reason = _NONE if complete else _UNBUILT
        return ExactResult(Status.FAILED, None, None, (), (reason,), clock.seconds)
    agreeing = [c for c in candidates if c.verification.explains]
    best = agreeing[0] if agreeing else candidates[0]
    reasons = _reasons(best, agreeing, complete, views)
    if work.loose and best.verification.close:
        reasons.append(_LOOSE)
    others = sorted((c for c in agreeing if c is not best), key=_rank)
    return ExactResult(
        Status.APPROXIMATE if reasons else Status.VERIFIED,
        best.shape,
        best.verification,
        tuple(other.shape for other in others),
        tuple(reasons),
        clock.seconds,
        tuple(other.verification.share for other in others),
        relaxed=bool(labelling.given_up),
    )


def _rank(candidate: Candidate) -> tuple[float, int]:
    """Solids with more lines that agree come first, then those with fewer faces."""
    return -round(candidate.verification.share, 3), soundness(candidate.shape).faces


def _candidates(
    work: Work, labelling: Labelling, limits: Limits, latest: Deadline
) -> tuple[list[Candidate], bool]:
    """Solids of the labels and of others, simplest first; whether all there are were looked at.

    Labels whose faces do not close, or bound something unsound, are not looked at: there may be a
    solid that could not be built.
    """
    thickness = work.part.space.thickness()
    counting: list[Cell] = [cell for cell, units in thickness.items() if units > _COUNTING]
    built = _build(work, labelling.labels, latest)
    first, settled = _candidate(work, built)
    candidates = [first] if first is not None else []
    explained = first is not None and first.verification.explains
    if not explained and (likelier := _likelier(work.part, labelling.labels)) is not None:
        second, looked_at = _candidate(work, _build(work, likelier, latest))
        settled &= looked_at
        explained = second is not None and second.verification.explains
        if second is not None and not (first and same_solid(second.shape, first.shape)):
            candidates.append(second)
    share = 1.0 if explained or not labelling.given_up else _UNLIKELY
    others = work.search.others(labelling, counting, limits.alternatives, share, latest)
    work.clock.lap("others")
    for labels in others.labels:
        if work.clock.total > limits.seconds:
            return candidates, False
        candidate, looked_at = _candidate(work, _build(work, labels, latest))
        settled &= looked_at
        if candidate and not any(same_solid(candidate.shape, c.shape) for c in candidates):
            candidates.append(candidate)
    if not candidates and built.largest is not None:
        # Where lines are missing or wrong, specks of material may lie beside the part.
        candidate, _ = _candidate(work, replace(built, shape=built.largest))
        return [candidate] if candidate else [], False
    return candidates, settled and others.complete and labelling.complete


def _likelier(part: PartModel, labels: Labels) -> Labels | None:
    """Labels under which the same rules hold and surfaces go on; None if they are the same."""
    settled = with_unsaid(part.space, part.rules, labels)
    likelier = with_unsaid(part.space, part.rules, labels, inf)
    return None if likelier == settled else likelier


def _build(work: Work, labels: Labels, deadline: Deadline) -> BuiltSolid:
    part = work.part
    labels = with_unsaid(part.space, part.rules, labels)
    built = build_solid(LabelledSpace(part.space, labels), part.supports.scale, deadline)
    work.clock.lap("build")
    return built


def _candidate(work: Work, built: BuiltSolid) -> tuple[Candidate | None, bool]:
    """What was built, drawn again; and whether it is certain what the labels bound."""
    if built.shape is None:
        return None, built.closed
    try:
        candidate = _verified(work, built.shape)
    except KERNEL_FAILURES:
        # What cannot be drawn again cannot be checked.
        return None, False
    return candidate, candidate.verification.sound


def _verified(work: Work, shape: TopoDS_Shape) -> Candidate:
    known, certain = certainties(work.part.supports, work.views, shape)
    # Rounded to the step of its design, a part is as large as meant however small it is drawn.
    views = replace(work.views, noise=0.0) if known else work.views
    candidate = Candidate(shape, verify(shape, views, certain))
    work.clock.lap("verify")
    return candidate


def _inexact(verification: Verification) -> str:
    spread, misfit = verification.spread, verification.misfit
    if not verification.off:
        share = 100.0 * verification.doubt
        where = f"so thin a part is drawn too small: its volume may be wrong by {share:.1g} %"
    elif misfit > spread:
        where = f"the views reach up to {misfit:.2g} mm beyond the solid, or less far"
    else:
        where = f"the views' lines lie up to {spread:.2g} mm beside the solid's"
    if verification.flaws or not verification.sound:
        return f"{where}: its measures are in doubt"
    return f"{where}: its faces are right, its measures may not be"


def _reasons(
    best: Candidate, agreeing: list[Candidate], complete: bool, views: DrawnViews
) -> list[tuple[str, str]]:
    reasons = []
    if not mutually_orthogonal(views.roles):
        reasons.append(
            ("two-views", "only two directions of view: what a third would show is not known")
        )
    if not best.verification.sound:
        reasons.append(("solid-unsound", "the solid is not one valid closed body"))
    if best.verification.flaws:
        worst = best.verification.flaws[0]
        what = "does not show" if worst.missing else "shows"
        others = len(best.verification.flaws) - 1
        more = f", and {others} more" if others else ""
        reasons.append(
            (
                "lines-unexplained",
                f"the solid {what} a line of {worst.length:.1f} mm that the {worst.role.value} "
                f"view has{'' if worst.missing else ' not'}, at ({worst.place[0]:.1f}, "
                f"{worst.place[1]:.1f}) mm{more}",
            )
        )
    if best.verification.retold:
        reasons.append(_RETOLD)
    if not best.verification.close:
        reasons.append(("lines-inexact", _inexact(best.verification)))
    if best.verification.thin:
        reasons.append(_THIN)
    if len(agreeing) > 1:
        reasons.append(
            ("ambiguous", f"{len(agreeing)} different solids have these lines: see alternatives/")
        )
    if not complete:
        reasons.append(_UNFINISHED)
    return reasons
