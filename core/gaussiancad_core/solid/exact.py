"""The exact solid of a drawing: reason, build, draw again, look for others."""

from dataclasses import dataclass, replace
from math import inf

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.carriers import find_carriers
from gaussiancad_core.errors import LimitError
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.misfits import solid_misfit
from gaussiancad_core.kernel.brep import area, soundness, volume
from gaussiancad_core.labelling.cell_labelling import Labelling
from gaussiancad_core.labelling.conflict_lines import Conflict
from gaussiancad_core.labelling.counted_work import Deadline, Meter
from gaussiancad_core.labelling.minimal_conflicts import find_conflict
from gaussiancad_core.labelling.part_model import model_part
from gaussiancad_core.processes.garbage import uncollected
from gaussiancad_core.solid.candidates import Candidate, Found, candidates_of
from gaussiancad_core.solid.limits import Limits, Modelled, Work
from gaussiancad_core.solid.measure_bounds import Measures, measures_of
from gaussiancad_core.solid.reasons import (
    GUARDED,
    NONE,
    UNBUILT,
    UNFINISHED,
    reasons_of,
    undrawn_in,
)
from gaussiancad_core.solid.relaxed_models import first_work, labelled
from gaussiancad_core.solid.search_trace import (
    Attempt,
    Journal,
    ModelKind,
    Outcome,
    cells_of,
    given_up_places,
)
from gaussiancad_core.solid.undrawn_variants import (
    other_with_undrawn_lines,
    views_that_may_lack_lines,
)
from gaussiancad_core.solid.verify import Verification
from gaussiancad_protocol.modes import Status

_FIRST, _OTHERS = 0.6, 0.9
"""Shares of the work at which building, and the search for others, end: of the first model's labels
and of others'."""

_QUICK = 0.25
"""Share of the work that a search took at most for another one, with likely measures."""

_LESS = 0.002
"""Share of the lines that a solid may show less then."""

_IN_DOUBT = 2e-3
"""Share of the volume that the bound of the faces' places makes of their area from which likely
measures are asked for."""


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
        complete: whether all solids that there may be were looked at.
        measures: how well the places of the solid's faces are known; None without a solid.
        trace: what was tried, in order.
        unusual: how unusual the solid is, in surfaces; None where all lines are drawn.
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
    complete: bool = False
    measures: Measures | None = None
    trace: tuple[Attempt, ...] = ()
    unusual: float | None = None

    @property
    def checked(self) -> Verification:
        """The verification of a result that has a solid.

        Raises:
            ValueError: it has none.
        """
        if self.verification is None:
            raise ValueError("there is no solid")
        return self.verification

    @property
    def explains(self) -> bool:
        """Whether there is a sound solid whose lines are those of the views."""
        return self.verification is not None and self.verification.explains

    @property
    def is_settled(self) -> bool:
        """Whether it is certain that no solid has all lines."""
        return self.complete and not self.explains

    def doubted(self, reason: tuple[str, str]) -> "ExactResult":
        """The same with a reason why it is not certain."""
        if self.status is Status.FAILED or reason in self.reasons:
            return self
        return replace(self, status=Status.APPROXIMATE, reasons=(*self.reasons, reason))


def exact_solid(views: DrawnViews, limits: Limits | None = None) -> ExactResult:
    """The solid whose lines are those of the views.

    Args:
        views: two to six.
        limits: of the search.
    """
    return exact_solid_and_model(views, limits)[0]


def exact_solid_and_model(
    views: DrawnViews, limits: Limits | None = None, model: Modelled | None = None
) -> tuple[ExactResult, Modelled | None]:
    """The solid whose lines are those of the views, and the model of the drawing as it is, for
    another search with other limits; None where it is too complex.

    Args:
        views: two to six.
        limits: of the search.
        model: of the drawing as it is, where an earlier search made it.
    """
    limits = limits or Limits()
    # Columns, rules and clauses are made by the million: looking at them took a third of the time.
    with uncollected():
        meter = Meter(limits.guard)
        result, model = _found(views, limits, meter, model)
        if meter.spent <= _QUICK * limits.work:
            result = _with_likely_measures(result, views, limits)
        return result.doubted(GUARDED) if meter.is_overrun else result, model


def _found(
    views: DrawnViews, limits: Limits, meter: Meter, model: Modelled | None = None
) -> tuple[ExactResult, Modelled | None]:
    journal = Journal()
    try:
        model = model or _modelled(views, limits, meter)
    except LimitError as error:
        attempt = Attempt(ModelKind.AS_DRAWN, Outcome.TOO_LARGE, work=meter.spent)
        return _failed((error.code, error.message), meter, (attempt,)), None
    meter.lap("model")
    result: ExactResult | None = None
    best, worth = -1, (False, False, False, -inf)
    first = first_work(model, views, limits, meter, journal)
    for work, labelling in labelled(first, limits):
        meter.lap("label")
        if labelling.labels is None:
            if limits.relaxed:
                work.failed(labelling)
            result = result or _failed(NONE if labelling.complete else UNFINISHED, meter)
            result = replace(result, complete=result.complete or labelling.complete)
            continue
        # Other models may be the better ones: work has to remain for them.
        share = _OTHERS if result is not None else _FIRST
        found = _searched(work, labelling, limits, meter.until(share * limits.work))
        found_worth = _worth(found, views)
        if result is None or found_worth > worth:
            result, best, worth = found, len(journal.attempts) - 1, found_worth
        if _is_neat(found):
            break
    meter.lap("label")
    if result is None:
        raise RuntimeError("no labels were looked for")
    result = replace(result, trace=journal.finished(best), seconds=meter.seconds)
    if result.explains or not limits.relaxed or meter.spent > _QUICK * limits.work:
        return result, model
    conflict = find_conflict(model.part, views, limits.conflict)
    meter.lap("conflict")
    return replace(result, conflict=conflict), model


def _modelled(views: DrawnViews, limits: Limits, meter: Meter) -> Modelled:
    part = model_part(views, deadline=meter.until(_OTHERS * limits.work))
    return Modelled(part, meter.spent)


def _failed(reason: tuple[str, str], meter: Meter, trace: tuple[Attempt, ...] = ()) -> ExactResult:
    return ExactResult(Status.FAILED, None, None, (), (reason,), meter.seconds, trace=trace)


def _with_likely_measures(found: ExactResult, views: DrawnViews, limits: Limits) -> ExactResult:
    """The same solid with measures that most likely are round, where a picture leaves some open.

    They stay in doubt: only the shape changes, and what is said of its lines.
    """
    verification = found.verification
    if not views.noise or verification is None or not verification.sound or not _is_in_doubt(found):
        return found
    likely = replace(views, likely=True)
    if not find_carriers(likely).moved:
        return found
    less = replace(limits, work=_QUICK * limits.work)
    other, _ = _found(likely, less, Meter(limits.guard))
    if not _is_as_good(other, found):
        return found
    # What else there may be was looked for among the first ones.
    reasons = other.reasons if other.reasons and not found.alternatives else found.reasons
    status = Status.APPROXIMATE if reasons else found.status
    attempts = (replace(each, model=ModelKind.LIKELY_MEASURES) for each in other.trace[-1:])
    return replace(
        found,
        status=status,
        shape=other.shape,
        verification=other.verification,
        reasons=reasons,
        trace=(*(replace(each, taken=False) for each in found.trace), *attempts),
    )


def _is_in_doubt(found: ExactResult) -> bool:
    """Whether the places of the faces are known too little for the size of the part."""
    if found.measures is None:
        raise ValueError("what was found has no measures")
    doubtful = found.measures.uncertainty * area(found.shape)
    return doubtful > _IN_DOUBT * abs(volume(found.shape))


def _is_as_good(other: ExactResult, found: ExactResult) -> bool:
    """Whether a solid is sound, shows the lines as well, and has no more faces."""
    new, old = other.verification, found.verification
    if new is None or old is None or not new.sound or new.share < old.share - _LESS:
        return False
    same_lines = len(new.flaws) <= len(old.flaws)
    return same_lines and soundness(other.shape).faces <= soundness(found.shape).faces


def _is_neat(result: ExactResult) -> bool:
    return result.verification is not None and result.verification.neat


def _worth(result: ExactResult, views: DrawnViews) -> tuple[bool, bool, bool, float]:
    """What solids of several models are ranked by."""
    verification = result.verification
    if verification is None:
        return False, False, False, -inf
    stated = verification.neat, verification.explains, verification.sound
    return *stated, -solid_misfit(result.shape, views).cost


def _searched(work: Work, labelling: Labelling, limits: Limits, latest: Deadline) -> ExactResult:
    """The solid of labels, or of others that are as good."""
    meter, views = work.meter, work.views
    found = candidates_of(work, labelling, limits, latest)
    candidates, complete = found.candidates, found.complete
    if not candidates:
        _note(work, labelling, found, None)
        failed = _failed(NONE if complete else UNBUILT, meter)
        return replace(failed, complete=complete)
    agreeing = [c for c in candidates if c.verification.explains]
    best = agreeing[0] if agreeing else candidates[0]
    _note(work, labelling, found, best)
    reasons = reasons_of(best.verification, len(agreeing), complete, views)
    if views.undrawn and len(views.undrawn) < len(views.roles):
        reasons.append(undrawn_in(views.undrawn))
    others = sorted((c for c in agreeing if c is not best), key=_rank)
    if not reasons:
        undrawn = other_with_undrawn_lines(work, best.shape, limits)
        meter.lap("undrawn")
        if undrawn is not None:
            reasons.append(undrawn_in(views_that_may_lack_lines(views)))
            others.append(undrawn)
    return ExactResult(
        Status.APPROXIMATE if reasons else Status.VERIFIED,
        best.shape,
        best.verification,
        tuple(other.shape for other in others),
        tuple(reasons),
        meter.seconds,
        tuple(other.verification.share for other in others),
        relaxed=bool(labelling.given_up),
        complete=complete,
        measures=measures_of(best.shape, work.part.carriers, views, best.verification),
        unusual=labelling.unusual,
    )


def _note(work: Work, labelling: Labelling, found: Found, best: Candidate | None) -> None:
    """Put what came of a model into the journal."""
    rules, scale = work.part.rules, work.part.carriers.scale
    attempt = Attempt(
        work.kind,
        found.outcome,
        len(rules),
        cells_of(rules),
        work.meter.spent,
        sum(rule.weight for rule in labelling.given_up) / scale,
        given_up_places(labelling.given_up, scale),
        others=found.others,
        open_at=found.open_at,
    )
    if best is not None:
        verification = best.verification
        outcome = Outcome.DEVIATES if verification.sound else Outcome.UNSOUND
        attempt = replace(
            attempt,
            outcome=Outcome.ALL_LINES if verification.explains else outcome,
            faces=soundness(best.shape).faces,
            share=verification.share,
            flaws=len(verification.flaws),
        )
    work.journal.add(attempt)


def _rank(candidate: Candidate) -> tuple[float, int]:
    """Solids with more lines that agree come first, then those with fewer faces."""
    return -round(candidate.verification.share, 3), soundness(candidate.shape).faces
