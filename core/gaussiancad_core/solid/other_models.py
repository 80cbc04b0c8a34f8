"""Other models of a drawing: what may have been meant where its lines contradict each other.

With more surfaces, with places as one that are farther apart or closer together, with curves
instead of lines that may only follow them, with ends of strokes left open.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from gaussiancad_core.errors import LimitError
from gaussiancad_core.reasoning.drawn_views import EXACT_TOLERANCE, DrawnViews
from gaussiancad_core.reasoning.followed import with_followed_curves
from gaussiancad_core.reasoning.part import (
    Contradict,
    PartModel,
    model_part,
    with_lone_bodies,
    without_undrawn,
)
from gaussiancad_core.reasoning.rough_arcs import ROUGHLY, without_rough_arcs
from gaussiancad_core.reasoning.work import Deadline
from gaussiancad_core.solid.limits import Work
from gaussiancad_core.solid.trace import Attempt, ModelKind, Outcome

_MANY = 4000
"""Rules of a part up to which it is modelled again with ends of strokes left open: labels for more
of them take long, and the more lines there are the more of them are close by."""

_STRICTER = 0.65
"""Share of the tolerance at which the places of lines that were read are one, where
labels contradict them with the whole of it."""

_LOOSER = (1.5, 2.5, 3.5)
"""Times the tolerance at which places of lines are one that nobody has made one: two that are off
by as much as one may be are twice as far apart, and the side of a circle is off by its centre and
its radius."""

Modelled = tuple[ModelKind, PartModel]

_MOST_FINER = 4_000
"""Rules up to which lines that views may lack are admitted before the views are taken as they
are."""


def modelled(
    kind: ModelKind, views: DrawnViews | None, work: Work, deadline: Deadline, **more: object
) -> Modelled | None:
    """A model of some views, if there are such; None, and noted, where it is too large."""
    if views is None:
        return None
    try:
        return kind, model_part(views, deadline=deadline, **more)
    except LimitError:
        work.journal.add(Attempt(kind, Outcome.TOO_LARGE, work=work.meter.spent))
        return None


def followed_curves(work: Work, lines: DrawnViews, deadline: Deadline) -> Modelled | None:
    """The part with the curves that strokes may follow."""
    followed = with_followed_curves(lines, work.part.supports)
    return modelled(ModelKind.FOLLOWED_CURVES, followed, work, deadline)


def wider_models(
    work: Work, lines: DrawnViews, contradict: bool, deadline: Deadline
) -> Iterator[Modelled]:
    """The part with more surfaces, and, where its lines do ``contradict``, without rough arcs."""
    if (wider := _wider(work, deadline)) is not None:
        yield ModelKind.LONE_BODIES, wider
    # Arcs that only follow curves are what files have; what is read may have some as well.
    few = lines.apart is None or len(work.part.rules) <= _MANY
    smooth = without_rough_arcs(lines) if contradict and few else None
    model = modelled(ModelKind.SMOOTH_ARCS, smooth, work, deadline, near=ROUGHLY)
    if model is not None:
        yield model


def looser_models(work: Work, lines: DrawnViews, deadline: Deadline) -> Iterator[Modelled]:
    """The part with places as one that are farther apart than lines should miss each other.

    Those come first of which all places turn out to be multiples of a step.
    """
    if lines.apart is not None or lines.tolerance <= EXACT_TOLERANCE * max(lines.size):
        return
    found: list[Modelled] = []
    for times in _LOOSER:
        looser = replace(lines, tolerance=times * lines.tolerance)
        model = modelled(ModelKind.WIDER_PLACES, looser, work, deadline)
        known = (work.part, *(own for _, own in found))
        if model is not None and all(model[1].rules != own.rules for own in known):
            found.append(model)
    yield from sorted(found, key=lambda model: not model[1].supports.nominal)


def misread_models(work: Work, lines: DrawnViews, deadline: Deadline) -> Iterator[Modelled]:
    """The part as it may be if strokes were misread by some pixels.

    With places as one only if they are closer together; with the curves that strokes may follow
    instead of these; with ends of strokes left open; and with values as one that are less than a
    pixel apart.
    """
    # Where features are hardly larger, what is a pixel apart has to be two.
    if lines.apart is not None:
        strict = replace(lines, tolerance=_STRICTER * lines.tolerance)
        model = modelled(ModelKind.FINER_PLACES, strict, work, deadline)
        if model is not None and model[1].rules != work.part.rules:
            yield model
    if (model := followed_curves(work, lines, deadline)) is not None:
        # What contradicted the lines may be gone.
        kind, part = model
        yield kind, _widened(part, _never, deadline) or part
    if len(work.part.rules) <= _MANY and lines.apart is not None:
        earlier: PartModel | None = None
        for kind, loose in (
            (ModelKind.OPEN_ENDS, lines),
            (ModelKind.MERGED_VALUES, replace(lines, apart=None)),
        ):
            model = modelled(kind, loose, work, deadline, open_ends=True)
            # Mostly no values are that close.
            if model is not None and (earlier is None or model[1].rules != earlier.rules):
                yield model
            earlier = model[1] if model is not None else None


def undrawn_models(work: Work, views: DrawnViews, deadline: Deadline) -> Iterator[Modelled]:
    """The part where some views draw no hidden lines: with the lines along the axes and circles
    that these may lack, and as it is.

    Args:
        work: with the part as all views draw them.
        views: with those that draw none.
        deadline: by which they have to be made.
    """
    plain = ModelKind.UNDRAWN_LINES, without_undrawn(work.part, views)
    finer = modelled(ModelKind.UNDRAWN_LINES, views, work, deadline, lost_lines=True)
    if views.cuts:
        found = (finer,)
    elif finer is not None and len(finer[1].rules) <= _MOST_FINER:
        found = (finer, plain)
    else:
        # Of so many cells the labels take nearly all of the work.
        found = (plain, finer)
    yield from (own for own in found if own is not None)


def lacking_model(work: Work, views: DrawnViews, most: int, deadline: Deadline) -> Modelled | None:
    """The part with the lines that views may lack, if it has no more rules than ``most``."""
    for along_axes in (False, True):
        model = modelled(
            ModelKind.LOST_LINES, views, work, deadline, lost_lines=True, along_axes=along_axes
        )
        if model is not None and len(model[1].rules) <= most:
            return model
    return None


def _wider(work: Work, deadline: Deadline) -> PartModel | None:
    def contradict(but: Sequence[int]) -> bool:
        return work.search.contradict(but, deadline)

    return _widened(work.part, contradict, deadline)


def _never(_: Sequence[int]) -> bool:
    return False


def _widened(part: PartModel, contradict: Contradict, deadline: Deadline) -> PartModel | None:
    try:
        return with_lone_bodies(part, contradict, deadline)
    except LimitError:
        return None
