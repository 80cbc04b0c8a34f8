"""Solids that labels bound: built, drawn again, and others that are as good."""

from dataclasses import dataclass, replace
from math import inf

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.cells.cell_complex import Cell
from gaussiancad_core.kernel.brep import edges_of
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.labelling.cell_labelling import Labelling
from gaussiancad_core.labelling.clauses import Labels
from gaussiancad_core.labelling.counted_work import Counted, Deadline
from gaussiancad_core.labelling.unconstrained_cells import with_unconstrained
from gaussiancad_core.model.axes import Vector
from gaussiancad_core.solid.boundary_building import BuiltSolid, build_solid
from gaussiancad_core.solid.labelled_cells import LabelledComplex
from gaussiancad_core.solid.limits import Limits, Work
from gaussiancad_core.solid.same import same_solid
from gaussiancad_core.solid.search_trace import Outcome
from gaussiancad_core.solid.verify import Verification, verify

_SLIM = 0.15
"""Units of thickness up to which cells most likely are what continues the surfaces around them."""

_UNLIKELY = 0.02
"""Share of the search for others that is left where neither lines nor labels agree: they may,
but are found at once or not at all."""

_ASSUMED = 2
"""Solids that are looked at beside the first where one rests on what is usual."""


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
class Found:
    """Solids of one model.

    Attributes:
        candidates: simplest first.
        complete: whether all there are were looked at.  Labels whose faces do not close, or bound
            something unsound, are not looked at: there may be a solid that could not be built.
        others: how many labels were built beside the first.
        outcome: of the first labels, where they bound no solid.
        open_at: mm, where their faces do not close.
    """

    candidates: list[Candidate]
    complete: bool
    others: int
    outcome: Outcome
    open_at: tuple[Vector, ...]


def candidates_of(work: Work, labelling: Labelling, limits: Limits, latest: Deadline) -> Found:
    """Solids of the labels and of others.

    Args:
        work: with the model whose labels they are.
        labelling: with labels.
        limits: of the search.
        latest: by which building, and the search for others, end.
    """
    given = labelling.labels
    if given is None:
        raise ValueError("there are no labels to build")
    counting = counting_cells(work)
    built = _build(work, given, latest, _SLIM)
    first, settled = _candidate(work, built)
    candidates = [first] if first is not None else []
    explained = first is not None and first.verification.explains
    likely = _continued(work, given, _SLIM)
    likelier = _continued(work, given, inf)
    if not explained and likelier != likely:
        second, looked_at = _candidate(work, _build(work, likelier, latest, _SLIM))
        settled &= looked_at
        explained = second is not None and second.verification.explains
        if second is not None and not (first and _are_one(work, second, first)):
            candidates.append(second)
    share = 1.0 if explained or not labelling.given_up else _UNLIKELY
    # What gives lines up, and shows it, has no rivals: the sketch is its measure.
    most = limits.alternatives if explained or not labelling.given_up else 0
    if work.part.usual is not None:
        # Views that leave hidden lines out never tell all: the likeliest others are told.
        most = min(most, _ASSUMED)
    others = work.search.others(labelling, counting, most, share, latest, likely=True)
    work.meter.lap("others")
    # What slim cells were likely to be is not what they have to be.
    plain = [given] if likely != _continued(work, given, work.slim) else []
    further = [*(plain if explained else ()), *others.labels]
    done = 0
    for labels in further:
        if work.meter.spent > limits.work or work.meter.is_overrun:
            break
        done += 1
        candidate, looked_at = candidate_of(work, labels, latest)
        settled &= looked_at
        if candidate and not any(_are_one(work, candidate, c) for c in candidates):
            candidates.append(candidate)
    complete = settled and others.complete and labelling.complete and done == len(further)
    if not candidates and built.largest is not None:
        # Where lines are missing or wrong, specks of material may lie beside the part.
        candidate, _ = _candidate(work, replace(built, shape=built.largest))
        candidates, complete = [candidate] if candidate else [], False
    outcome = Outcome.NOTHING if built.closed else Outcome.OPEN
    return Found(candidates, complete, done, outcome, built.open_at)


def counting_cells(work: Work) -> list[Cell]:
    """Cells that make a different solid: those thicker than how well places are known."""
    slim = work.slim
    return [cell for cell, units in work.part.space.thickness().items() if units > slim]


def candidate_of(work: Work, labels: Labels, latest: Deadline) -> tuple[Candidate | None, bool]:
    """What labels bound, drawn again; and whether that is certain."""
    return _candidate(work, _build(work, labels, latest, work.slim))


def _are_one(work: Work, one: Candidate, other: Candidate) -> bool:
    return same_solid(one.shape, other.shape, work.views.indistinct)


def _continued(work: Work, labels: Labels, thickest: float) -> Labels:
    """Labels for all cells; slim ones go on as what is around them, where as many rules hold."""
    return with_unconstrained(work.part.space, work.part.rules, labels, thickest)


def _build(work: Work, labels: Labels, deadline: Deadline, thickest: float) -> BuiltSolid:
    part = work.part
    space = LabelledComplex(part.space, _continued(work, labels, thickest))
    built = build_solid(space, part.carriers.scale, deadline)
    work.meter.lap("build")
    return built


def _candidate(work: Work, built: BuiltSolid) -> tuple[Candidate | None, bool]:
    """What was built, drawn again; and whether it is certain what the labels bound."""
    if built.shape is None:
        return None, built.closed
    try:
        work.meter.count(Counted.EDGE, len(edges_of(built.shape)))
        candidate = Candidate(built.shape, verify(built.shape, work.views))
    except KERNEL_FAILURES:
        # What cannot be drawn again cannot be checked.
        return None, False
    work.meter.lap("verify")
    return candidate, candidate.verification.sound
