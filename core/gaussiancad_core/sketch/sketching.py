"""A part sketched from the lines of its views: slabs of regions, along the cheapest axis."""

from dataclasses import dataclass
from math import inf

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.axes import Axis
from gaussiancad_core.drawing.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.supports import PartSupports
from gaussiancad_core.sketch.bodies import (
    Slab,
    body_of,
    cones_of,
    slabs_of,
    with_holes,
    within_envelope,
)
from gaussiancad_core.sketch.breaks import EdgeBreak
from gaussiancad_core.sketch.broken_edges import with_breaks
from gaussiancad_core.sketch.choosing import Choice, choose
from gaussiancad_core.sketch.places import find_places
from gaussiancad_core.sketch.plan import plans_of

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
        shape: the part in mm; None where the kernel made none.
        supports: of the views: where their lines may lie.
        at_least: mm that every part costs, along any axis.
    """

    choice: Choice
    slabs: tuple[Slab, ...]
    breaks: tuple[EdgeBreak, ...]
    shape: TopoDS_Shape | None
    supports: PartSupports
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
        None where no view tells an outline, or none was chosen in time.
    """
    places = find_places(views, grid)
    best: Choice | None = None
    left, at_least = _EFFORT, inf
    # What is not made of slabs along an axis has many lines that nothing explains.
    for plan in sorted(plans_of(views, places), key=lambda own: own.alien):
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
    shape, refused = None, plan.breaks
    try:
        if slabs:
            sharp = body_of(best, slabs, cones_of(best))
            shape, refused = with_breaks(sharp, plan)
            shape = with_holes(within_envelope(shape, plan), plan)
    except KERNEL_FAILURES:
        shape = None
    made = tuple(own for own in plan.breaks if own not in refused)
    return Sketch(best, slabs, made, shape, places.supports, min(at_least, best.energy))
