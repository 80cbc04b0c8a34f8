"""Another solid that has all lines where some views draw no hidden lines.

A sheet that has hidden lines in one view is taken to draw them in all.  It may have left them out
in a view that has none, though, where the part is clear without them (ISO 128-3): what is blank
there only means that nothing is visible.  Edges that are not drawn divide no regions, so that the
views are divided as well where the other ones show an edge.  Hollows that are closed all around do
not count: they can hardly be made, and nobody who had one would leave its lines out.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain

from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.errors import LimitError
from gaussiancad_core.evidence.drawn_views import DrawnViews, silent_views
from gaussiancad_core.kernel.brep import subshapes
from gaussiancad_core.labelling.counted_work import Deadline
from gaussiancad_core.labelling.part_model import PartModel, model_part, without_undrawn
from gaussiancad_core.model.axes import Role
from gaussiancad_core.solid.candidates import Candidate, candidate_of, counting_cells
from gaussiancad_core.solid.limits import Limits, Work, search_for
from gaussiancad_core.solid.same import same_solid

_MOST, _MOST_ALONE = 2, 8
"""Other labels that are looked at; where a single direction of view has hidden lines, which leaves
all depths along it open, and many labels bound nothing sound."""

_SHARE = 0.1
"""Share of the work that it may take."""


def views_that_may_lack_lines(views: DrawnViews) -> tuple[Role, ...]:
    """Views that have no hidden line, where others have some."""
    silent = silent_views(views)
    return silent if len(silent) < len(views.roles) else ()


def other_with_undrawn_lines(work: Work, shape: TopoDS_Shape, limits: Limits) -> Candidate | None:
    """Another solid that has all lines where views without hidden lines draw none.

    Args:
        work: of the solid.
        shape: the solid, mm.
        limits: of the search.

    Returns:
        None if there is none, or none was found among the first that the cells have.
    """
    roles = views_that_may_lack_lines(work.views)
    if not roles:
        return None
    shells = _shells(shape)
    telling = {role.frame.look_axis[0] for role in work.views.roles if role not in roles}
    most = _MOST_ALONE if len(telling) == 1 else _MOST
    deadline = work.meter.until(work.meter.spent + _SHARE * limits.work)
    views = replace(work.views, undrawn=roles)
    for part in _parts(work.part, views, deadline):
        this_work = replace(
            work, part=part, views=views, search=search_for(part, limits, work.meter)
        )
        found = this_work.search.fulfilled(deadline)
        if found.labels is not None:
            others = this_work.search.others(
                found, counting_cells(this_work), most, deadline=deadline
            )
            candidates = (candidate_of(this_work, labels, deadline)[0] for labels in others.labels)
            first, _ = candidate_of(this_work, found.labels, deadline)
            return next(
                (
                    other
                    for other in chain([first], candidates)
                    if other is not None
                    and other.verification.explains
                    and _shells(other.shape) <= shells
                    and not same_solid(other.shape, shape, work.views.indistinct)
                ),
                None,
            )
    return None


def _shells(shape: TopoDS_Shape) -> int:
    """One, and one more for each closed hollow."""
    return len(subshapes(shape, TopAbs_ShapeEnum.TopAbs_SHELL))


def _parts(part: PartModel, views: DrawnViews, deadline: Deadline) -> Iterator[PartModel]:
    """The part with what views may lack, and, where no labels fit that, as it is."""
    try:
        yield model_part(views, deadline=deadline, lost_lines=True)
    except LimitError:
        return
    yield without_undrawn(part, views)
