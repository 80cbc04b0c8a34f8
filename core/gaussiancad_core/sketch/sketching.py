"""A part sketched from the lines of its views: slabs of regions, along the cheapest axis."""

from contextlib import suppress
from dataclasses import dataclass, replace
from math import inf
from typing import Any

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.agreed_places import find_places
from gaussiancad_core.coordinates.carriers import PartCarriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.faceted_solids import faceted_shape
from gaussiancad_core.judging.misfits import Judge
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.labelling.part_model import MOST_STROKES
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.proposing.broken_corners import EdgeBreak
from gaussiancad_core.sketch.broken_edges import with_breaks
from gaussiancad_core.sketch.choosing import Choice, choose
from gaussiancad_core.sketch.slab_plan import plans_of
from gaussiancad_core.sketch.slab_solids import (
    Bore,
    Slab,
    body_of,
    cones_of,
    slabs_of,
    turned_down,
    with_holes,
)
from gaussiancad_core.sketch.turned_views import Slope

_EFFORT = 1.0
"""Units of the solver's work for all axes."""

_MOST = 0.6
"""Units of it for one of them."""


@dataclass(frozen=True, eq=False)
class Sketch:
    """A part as it was sketched.

    Attributes:
        choice: of regions and slabs.
        slabs: from the lowest, with sharp edges.
        breaks: of edges, as far as the kernel made them.
        slopes: of a turned part, that were turned down.
        bores: holes across the slabs as they were cut.
        shape: the part in mm; None where the kernel made none.
        carriers: of the views: where their lines may lie.
        at_least: mm that every part costs, along any axis.
        unexplained: mm of line that the judge finds the part not to explain; infinite without one.
    """

    choice: Choice
    slabs: tuple[Slab, ...]
    breaks: tuple[EdgeBreak, ...]
    slopes: tuple[Slope, ...]
    bores: tuple[Bore, ...]
    shape: TopoDS_Shape | None
    carriers: PartCarriers
    at_least: float
    unexplained: float

    @property
    def energy(self) -> float:
        """mm of line, and what counts as much, that it costs."""
        return self.choice.energy

    @property
    def axis(self) -> Axis:
        """Across the slabs."""
        return self.choice.plan.axis


def sketch(views: DrawnViews, grid: float) -> Sketch | None:
    """The part that explains the lines of views best, as slabs.

    Args:
        views: of the part, with what the sheet's numbers say.
        grid: mm of a step of the sheet's coordinates.

    Returns:
        None where no view tells an outline, none was chosen in time, or a view has more lines than
        anything follows from in time.
    """
    if max(map(len, views.strokes.values())) > MOST_STROKES:
        return None
    places = find_places(views, grid)
    best: Choice | None = None
    left, at_least = _EFFORT, inf
    # What is not made of slabs along an axis has many lines that nothing explains.
    for plan in sorted(plans_of(views, places), key=lambda this_plan: this_plan.alien):
        least = inf if best is None else best.energy
        if left <= 0.0 or plan.alien >= least:
            at_least = min(at_least, plan.alien)
            continue
        choice, bound, spent = choose(plan, least, min(_MOST, left))
        left -= spent
        at_least = min(at_least, bound)
        if choice is not None and (best is None or choice.energy < best.energy):
            best = choice
    if best is None:
        return None
    body = _built(best, Judge(drawn_sheet(views)))
    at_least = min(at_least, best.energy)
    return Sketch(
        best,
        body.slabs,
        body.breaks,
        body.slopes,
        body.bores,
        body.shape,
        places.carriers,
        at_least,
        body.cost,
    )


@dataclass(frozen=True, eq=False)
class _Body:
    """A choice as the kernel made it; what it cannot make is left out.

    Attributes:
        slabs, breaks, slopes, bores, shape: as of the sketch.
        cost: mm of line that it leaves unexplained; infinite where there is none.
    """

    slabs: tuple[Slab, ...]
    breaks: tuple[EdgeBreak, ...] = ()
    slopes: tuple[Slope, ...] = ()
    bores: tuple[Bore, ...] = ()
    shape: TopoDS_Shape | None = None
    cost: float = inf

    def with_step(self, shape: TopoDS_Shape, judge: Judge, **made: Any) -> "_Body":  # noqa: ANN401
        """The same after one more step, if the step explains something, or takes nothing away."""
        cost = _cost(shape, judge)
        return replace(self, shape=shape, cost=cost, **made) if cost <= self.cost else self


def _built(choice: Choice, judge: Judge) -> _Body:
    """The body of a choice: its slabs, and each later step that does not make it worse."""
    plan = choice.plan
    body = _Body(slabs_of(choice))
    if not body.slabs:
        return body
    with suppress(*KERNEL_FAILURES):
        shape = body_of(choice, body.slabs, cones_of(choice))
        body = replace(body, shape=shape, cost=_cost(shape, judge))
    if body.shape is None:
        return body
    if plan.breaks:
        with suppress(*KERNEL_FAILURES):
            shape, refused = with_breaks(body.shape, plan)
            made = tuple(each for each in plan.breaks if each not in refused)
            body = body.with_step(shape, judge, breaks=made)
    if plan.slopes:
        with suppress(*KERNEL_FAILURES):
            body = body.with_step(turned_down(body.shape, plan), judge, slopes=plan.slopes)
    if plan.cross_holes:
        with suppress(*KERNEL_FAILURES):
            shape, bores = with_holes(body.shape, plan)
            body = body.with_step(shape, judge, bores=bores)
    return body


def _cost(shape: TopoDS_Shape, judge: Judge) -> float:
    """mm of line that a body leaves unexplained."""
    return judge.misfit(faceted_shape(shape)).cost
