"""The exact solid of a drawing: reason, build, draw again, look for others."""

import gc
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from math import inf

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.axes import mutually_orthogonal
from gaussiancad_core.drawing.brep import soundness
from gaussiancad_core.errors import LimitError
from gaussiancad_core.modes import Status
from gaussiancad_core.reasoning.columns import Cell
from gaussiancad_core.reasoning.conflict_lines import Conflict
from gaussiancad_core.reasoning.conflicts import find_conflict
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.labelling import (
    Effort,
    Labelling,
    Labels,
    Search,
)
from gaussiancad_core.reasoning.open_outlines import with_closed_outlines
from gaussiancad_core.reasoning.part import NEAR, PartModel, model_part, with_lone_bodies
from gaussiancad_core.reasoning.rough_arcs import ROUGHLY, without_rough_arcs
from gaussiancad_core.reasoning.solvers import Deadline
from gaussiancad_core.reasoning.unsaid import with_unsaid
from gaussiancad_core.solid.build import BuiltSolid, build_solid
from gaussiancad_core.solid.labelled import LabelledSpace
from gaussiancad_core.solid.same import same_solid
from gaussiancad_core.solid.verify import Verification, verify

_COUNTING = 0.15
"""Units of thickness from which a cell makes a different solid."""


_PATIENT = 0.25
"""Share of the time after which it is not asked any more which lines contradict each other."""

_HARD, _OTHERWISE, _RELAXED, _OTHERS = 0.4, 0.55, 0.8, 0.9
"""Shares of the time at which a step's solvers end: labels for all lines, for all with more
surfaces, for most lines, others.  Machines that are not busy have done with them long before."""

_UNLIKELY = 0.02
"""Share of the search for others that is left where neither lines nor labels agree: they may,
but are found at once or not at all."""

_NONE = "no-solid-fits", "no solid has these lines: they contradict each other"
_UNBUILT = (
    "no-valid-solid",
    "the cells that fit the lines best bound no closed solid: lines are missing or wrong",
)
_UNFINISHED = "search-unfinished", "the search for solids with these lines was not completed"


@dataclass(frozen=True)
class Limits:
    """How far the search goes.

    Attributes:
        effort: of the labelling, deterministic.
        alternatives: solids looked at beside the first.
        relaxed: whether lines may be given up where all together fit no solid.
        seconds: after which no further alternative is begun, and by which solvers have ended.
        conflict: deterministic time for telling which lines contradict each other, where no solid
            has all of them, lines may be given up, and a quarter of ``seconds`` is not over.
    """

    effort: Effort = field(default_factory=Effort)
    alternatives: int = 8
    relaxed: bool = True
    seconds: float = 60.0
    conflict: float = 2.0


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
    with _uncollected():
        return _found(views, limits or Limits())


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
    clock = _Clock()
    try:
        part = model_part(views, deadline=clock.deadline(_OTHERS * limits.seconds))
    except LimitError as error:
        reason = error.code, error.message
        return ExactResult(Status.FAILED, None, None, (), (reason,), clock.seconds)
    clock.lap("model")
    work, labelling = _labelled(part, views, limits, clock)
    clock.lap("label")
    result = _searched(work, labelling, limits)
    explained = result.verification is not None and result.verification.explains
    if explained or not limits.relaxed or clock.total > _PATIENT * limits.seconds:
        return result
    conflict = find_conflict(part, views, limits.conflict)
    clock.lap("conflict")
    return replace(result, conflict=conflict)


def _labelled(
    part: PartModel, views: DrawnViews, limits: Limits, clock: "_Clock"
) -> tuple["_Work", Labelling]:
    """Labels of the part, or of the part with more surfaces where all lines are explained then."""
    work = _Work(part, views, Search(part.rules, limits.effort), clock)
    found = work.search.fulfilled(clock.deadline(_HARD * limits.seconds))
    if found.labels is not None:
        return work, found
    lines = views
    deadline = clock.deadline(_OTHERWISE * limits.seconds)
    closed = with_closed_outlines(views) if found.complete else None
    if closed is not None and (model := _modelled(closed, deadline)) is not None:
        # Where the outside runs into the part nearly all lines contradict each other.
        lines, search = closed, Search(model.rules, limits.effort)
        work = replace(work, part=model, search=search)
        found = search.fulfilled(clock.deadline(_HARD * limits.seconds))
        if found.labels is not None:
            return work, found
    # Another model takes as long as the first: time has to remain for the least contradiction.
    others = _otherwise(work, lines, found.complete, deadline)
    while clock.total + clock.seconds["model"] < _OTHERWISE * limits.seconds:
        if (other := next(others, None)) is None:
            break
        other_search = Search(other.rules, limits.effort)
        more = other_search.fulfilled(deadline)
        if more.labels is not None:
            return replace(work, part=other, search=other_search), more
    if limits.relaxed:
        found = work.search.least(clock.deadline(_RELAXED * limits.seconds))
    return work, found


def _modelled(views: DrawnViews, deadline: Deadline, near: float = NEAR) -> PartModel | None:
    try:
        return model_part(views, near, deadline)
    except LimitError:
        return None


def _otherwise(
    work: "_Work", lines: DrawnViews, contradict: bool, deadline: Deadline
) -> Iterator[PartModel]:
    """The part with more surfaces, and, where its lines do ``contradict``, without rough arcs."""
    if (wider := _wider(work, deadline)) is not None:
        yield wider
    smooth = without_rough_arcs(lines) if contradict else None
    if smooth is not None and (model := _modelled(smooth, deadline, ROUGHLY)) is not None:
        yield model


def _wider(work: "_Work", deadline: Deadline) -> PartModel | None:
    def contradict(but: Sequence[int]) -> bool:
        return work.search.contradict(but, deadline)

    try:
        return with_lone_bodies(work.part, contradict, deadline)
    except LimitError:
        return None


def _searched(work: "_Work", labelling: Labelling, limits: Limits) -> ExactResult:
    """The solid of labels, or of others that are as good."""
    clock, views = work.clock, work.views
    if labelling.labels is None:
        reason = _NONE if labelling.complete else _UNFINISHED
        return ExactResult(Status.FAILED, None, None, (), (reason,), clock.seconds)
    candidates, complete = _candidates(work, labelling, limits)
    if not candidates:
        reason = _NONE if complete else _UNBUILT
        return ExactResult(Status.FAILED, None, None, (), (reason,), clock.seconds)
    agreeing = [c for c in candidates if c.verification.explains]
    best = agreeing[0] if agreeing else candidates[0]
    reasons = _reasons(best, agreeing, complete, views)
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


class _Clock:
    """Seconds of named steps."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self._start = self._last = time.perf_counter()

    def lap(self, name: str) -> None:
        now = time.perf_counter()
        self.seconds[name] = self.seconds.get(name, 0.0) + now - self._last
        self._last = now

    @property
    def total(self) -> float:
        return time.perf_counter() - self._start

    def deadline(self, seconds: float) -> Deadline:
        """So many seconds after the start."""
        return Deadline(self._start + seconds)


@dataclass(frozen=True)
class _Work:
    """What candidates are made from."""

    part: PartModel
    views: DrawnViews
    search: Search
    clock: _Clock


def _candidates(work: _Work, labelling: Labelling, limits: Limits) -> tuple[list[Candidate], bool]:
    """Solids of the labels and of others, simplest first; whether all there are were looked at.

    Labels whose faces do not close, or bound something unsound, are not looked at: there may be a
    solid that could not be built.
    """
    thickness = work.part.space.thickness()
    counting: list[Cell] = [cell for cell, units in thickness.items() if units > _COUNTING]
    latest = work.clock.deadline(_OTHERS * limits.seconds)
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
        return [_verified(work, built.largest)], False
    return candidates, settled and others.complete and labelling.complete


def _likelier(part: PartModel, labels: Labels) -> Labels | None:
    """Labels under which the same rules hold and surfaces go on; None if they are the same."""
    settled = with_unsaid(part.space, part.rules, labels)
    likelier = with_unsaid(part.space, part.rules, labels, inf)
    return None if likelier == settled else likelier


def _build(work: _Work, labels: Labels, deadline: Deadline) -> BuiltSolid:
    part = work.part
    labels = with_unsaid(part.space, part.rules, labels)
    built = build_solid(LabelledSpace(part.space, labels), part.supports.scale, deadline)
    work.clock.lap("build")
    return built


def _candidate(work: _Work, built: BuiltSolid) -> tuple[Candidate | None, bool]:
    """What was built, drawn again; and whether it is certain what the labels bound."""
    if built.shape is None:
        return None, built.closed
    candidate = _verified(work, built.shape)
    return candidate, candidate.verification.sound


def _verified(work: _Work, shape: TopoDS_Shape) -> Candidate:
    candidate = Candidate(shape, verify(shape, work.views))
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
    if not best.verification.close:
        reasons.append(("lines-inexact", _inexact(best.verification)))
    if len(agreeing) > 1:
        reasons.append(
            ("ambiguous", f"{len(agreeing)} different solids have these lines: see alternatives/")
        )
    if not complete:
        reasons.append(_UNFINISHED)
    return reasons
