"""A part sketched from the lines of its views: slabs of regions, along the cheapest axis."""

from contextlib import suppress
from dataclasses import dataclass
from math import inf

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.carriers import PartCarriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.labelling.part_model import MOST_STROKES
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.sketch.agreed_places import find_places
from gaussiancad_core.sketch.broken_edges import with_breaks
from gaussiancad_core.sketch.choosing import Choice, choose
from gaussiancad_core.sketch.edge_breaks import EdgeBreak
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
    """

    choice: Choice
    slabs: tuple[Slab, ...]
    breaks: tuple[EdgeBreak, ...]
    slopes: tuple[Slope, ...]
    bores: tuple[Bore, ...]
    shape: TopoDS_Shape | None
    carriers: PartCarriers
    at_least: float

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
    slabs = slabs_of(best)
    plan = best.plan
    shape, refused, is_turned = None, plan.breaks, False
    bores: tuple[Bore, ...] = ()
    # What the kernel cannot do any more is left out.
    with suppress(*KERNEL_FAILURES):
        if slabs:
            shape = body_of(best, slabs, cones_of(best))
            shape, refused = with_breaks(shape, plan)
            shape = turned_down(shape, plan)
            is_turned = True
            shape, bores = with_holes(shape, plan)
    made = tuple(edge_break for edge_break in plan.breaks if edge_break not in refused)
    slopes = plan.slopes if is_turned else ()
    at_least = min(at_least, best.energy)
    return Sketch(best, slabs, made, slopes, bores, shape, places.carriers, at_least)
