"""A part sketched from the lines of its views: slabs of regions, along the cheapest axis."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import inf

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.sketch.bodies import Slab, body_of, slabs_of
from gaussiancad_core.sketch.choosing import Choice, choose
from gaussiancad_core.sketch.plan import plans_of


@dataclass(frozen=True, eq=False)
class Sketch:
    """A part as it was sketched.

    Attributes:
        choice: of regions and slabs.
        slabs: from the lowest.
        shape: the solid in mm; None where the kernel made none.
        reading: number of the reading of the sheet that it is of.
    """

    choice: Choice
    slabs: tuple[Slab, ...]
    shape: TopoDS_Shape | None
    reading: int

    @property
    def energy(self) -> float:
        """mm of line, and what counts as much, that it costs."""
        return self.choice.energy


def sketch(readings: Iterable[DrawnViews], grid: float) -> Sketch | None:
    """The part that explains the lines of a sheet best, as slabs.

    Args:
        readings: the views as each projection has them.
        grid: mm of a step of the sheet's coordinates.

    Returns:
        None where no view tells an outline, or none was chosen in time.
    """
    best: tuple[Choice, int] | None = None
    for number, views in enumerate(readings):
        for plan in sorted(plans_of(views, grid), key=lambda own: own.complexity):
            choice = choose(plan, inf if best is None else best[0].energy)
            if choice is not None and (best is None or choice.energy < best[0].energy):
                best = choice, number
    if best is None:
        return None
    choice, number = best
    slabs = slabs_of(choice)
    try:
        shape = body_of(slabs, choice.plan.axis, choice.plan.regions, grid) if slabs else None
    except KERNEL_FAILURES:
        shape = None
    return Sketch(choice, slabs, shape, number)
