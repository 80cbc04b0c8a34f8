"""Other models of a drawing: what may have been meant where its lines contradict each other.

With more surfaces, with curves instead of lines that may only follow them, without arcs that only
follow curves, with lines that views without hidden ones may lack.
"""

from collections.abc import Iterator, Sequence

from gaussiancad_core.errors import LimitError
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.tolerances import SAME_PLACE
from gaussiancad_core.hypotheses.intersection_curves import with_followed_curves
from gaussiancad_core.hypotheses.rough_arcs import ROUGHLY, without_rough_arcs
from gaussiancad_core.labelling.counted_work import Deadline
from gaussiancad_core.labelling.part_model import (
    PartModel,
    model_part,
    with_lone_bodies,
    without_undrawn,
)
from gaussiancad_core.solid.limits import Work
from gaussiancad_core.solid.search_trace import Attempt, ModelKind, Outcome

_MANY = 4000
"""Rules of a picture's part up to which arcs are taken off it that only follow curves: they are
what files have."""

OtherModel = tuple[ModelKind, PartModel]


def modelled(
    kind: ModelKind,
    views: DrawnViews | None,
    work: Work,
    deadline: Deadline,
    *,
    near: float = SAME_PLACE,
    lost_lines: bool = False,
) -> OtherModel | None:
    """A model of some views, if there are such; None, and noted, where it is too large."""
    if views is None:
        return None
    try:
        return kind, model_part(views, near, deadline, lost_lines=lost_lines)
    except LimitError:
        work.journal.add(Attempt(kind, Outcome.TOO_LARGE, work=work.meter.spent))
        return None


def followed_curves(work: Work, lines: DrawnViews, deadline: Deadline) -> OtherModel | None:
    """The part with the curves that strokes may follow."""
    followed = with_followed_curves(lines, work.part.carriers)
    return modelled(ModelKind.FOLLOWED_CURVES, followed, work, deadline)


def wider_models(
    work: Work, lines: DrawnViews, contradict: bool, deadline: Deadline
) -> Iterator[OtherModel]:
    """The part with more surfaces, and, where its lines do ``contradict``, without rough arcs."""
    if (wider := _wider(work, deadline)) is not None:
        yield ModelKind.LONE_BODIES, wider
    # Arcs that only follow curves are what files have; what is read may have some as well.
    few = lines.apart is None or len(work.part.rules) <= _MANY
    smooth = without_rough_arcs(lines) if contradict and few else None
    model = modelled(ModelKind.SMOOTH_ARCS, smooth, work, deadline, near=ROUGHLY)
    if model is not None:
        yield model


def undrawn_models(work: Work, views: DrawnViews, deadline: Deadline) -> Iterator[OtherModel]:
    """The part where some views draw no hidden lines: with the lines along the axes and circles
    that these may lack, and as it is.

    Args:
        work: with the part as all views draw them.
        views: with those that draw none.
        deadline: by which they have to be made.
    """
    plain = ModelKind.UNDRAWN_LINES, without_undrawn(work.part, views)
    finer = modelled(ModelKind.UNDRAWN_LINES, views, work, deadline, lost_lines=True)
    found: tuple[OtherModel | None, ...]
    if views.cuts:
        found = (finer,)
    elif finer is not None and len(finer[1].rules) <= _MANY:
        found = (finer, plain)
    else:
        # Of so many cells the labels take nearly all of the work.
        found = (plain, finer)
    yield from (pair for pair in found if pair is not None)


def _wider(work: Work, deadline: Deadline) -> PartModel | None:
    def contradict(but: Sequence[int]) -> bool:
        return work.search.contradict(but, deadline)

    try:
        return with_lone_bodies(work.part, contradict, deadline)
    except LimitError:
        return None
