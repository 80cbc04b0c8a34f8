"""Labels that explain most of a drawing, of the models of it in the order in which they are tried.

A drawing has one model as a rule.  Where its rules contradict each other, others are made: with an
open outline closed, with more surfaces, with curves instead of lines that may only follow them.
"""

from collections.abc import Iterator
from dataclasses import replace

from gaussiancad_core.coordinates.ambiguous_linetypes import with_unsure_kinds
from gaussiancad_core.evidence.drawn_views import DrawnViews, silent_views
from gaussiancad_core.hypotheses.open_outlines import with_closed_outlines
from gaussiancad_core.labelling.cell_labelling import Labelling
from gaussiancad_core.labelling.counted_work import Deadline, Meter
from gaussiancad_core.solid.limits import OTHERWISE, Limits, Modelled, Work, search_for
from gaussiancad_core.solid.other_models import (
    OtherModel,
    followed_curves,
    modelled,
    undrawn_models,
    wider_models,
)
from gaussiancad_core.solid.search_trace import Journal, ModelKind

_HARD, _RELAXED = 0.4, 0.8
"""Shares of the work at which a step ends: labels for all lines, labels for most of them."""

_LITTLE = 3.0
"""Units of line that labels give up at most for strokes to bound nothing, maybe, as they follow the
curves of surfaces."""


def first_work(
    model: Modelled, views: DrawnViews, limits: Limits, meter: Meter, journal: Journal
) -> Work:
    """What the drawing as it is gives to work on."""
    search = search_for(model.part, limits, meter)
    return Work(model.part, model.took, views, search, meter, journal)


def labelled(work: Work, limits: Limits) -> Iterator[tuple[Work, Labelling]]:
    """Labels of the part, and then of other models of it that explain more, likeliest first.

    Where there are labels for all lines, they are the only ones, but where strokes may follow the
    curves in which surfaces meet.  Models without labels are noted in the journal.

    Args:
        work: of the drawing as it is.
        limits: of the search.
    """
    meter, views = work.meter, work.views
    deadline = meter.until(OTHERWISE * limits.work)
    found = work.search.fulfilled(meter.until(_HARD * limits.work))
    if found.labels is not None:
        yield work, found
        yield from _followed(work, views, limits, deadline)
        return
    work.failed(found)
    yield from _otherwise(work, found, limits)


def _otherwise(work: Work, found: Labelling, limits: Limits) -> Iterator[tuple[Work, Labelling]]:
    """Labels of models in which the lines, as they are drawn, do not contradict each other."""
    meter, views = work.meter, work.views
    lines, silent = views, silent_views(views)
    deadline = meter.until(OTHERWISE * limits.work)
    unsure = with_unsure_kinds(views)
    model = modelled(ModelKind.OPEN_LINETYPES, unsure, work, deadline)
    if unsure is not None and model is not None:
        other = _remodelled(replace(work, views=unsure), model, limits)
        relaxed_linetypes = other.search.relaxed_linetypes(deadline)
        if relaxed_linetypes.labels is not None:
            yield other, relaxed_linetypes
            yield from _followed(other, unsure, limits, deadline)
        # What is given up may be linetypes as well.
        work, lines = other, unsure
    may_close = found.complete and work.allows_another(limits)
    closed = with_closed_outlines(lines) if may_close else None
    model = modelled(ModelKind.CLOSED_OUTLINE, closed, work, deadline)
    if closed is not None and model is not None:
        # Where the outside runs into the part nearly all lines contradict each other.
        lines, work = closed, _remodelled(work, model, limits)
        found = work.search.fulfilled(meter.until(_HARD * limits.work))
        if found.labels is not None:
            yield work, found
            yield from _followed(work, lines, limits, deadline)
            return
        work.failed(found)
    # Another model takes as long as the first: work has to remain for the least contradiction.
    others = _until(wider_models(work, lines, found.complete, deadline), limits, work)
    first = _first_fulfilled((_remodelled(work, model, limits) for model in others), deadline)
    if first is None and not limits.relaxed:
        first = work, found
    if first is not None:
        yield first
        yield from _followed(work, lines, limits, deadline)
        return
    if silent and limits.relaxed:
        # Practice leaves hidden lines out.
        works = _undrawn(work, replace(lines, undrawn=silent), limits, deadline)
        yield from _fulfilled(works, deadline)
    least = work.search.least(meter.until(_RELAXED * limits.work))
    yield work, least
    if least.labels is not None and _cost(least) < _LITTLE:
        yield from _followed(work, lines, limits, deadline)


def _undrawn(work: Work, views: DrawnViews, limits: Limits, deadline: Deadline) -> Iterator[Work]:
    """The part where some views draw no hidden lines."""
    this_work = replace(work, views=views)
    models = _until(undrawn_models(work, views, deadline), limits, work)
    return (_remodelled(this_work, model, limits) for model in models)


def _first_fulfilled(works: Iterator[Work], deadline: Deadline) -> tuple[Work, Labelling] | None:
    """The first of the models that has labels for all lines, and these."""
    return next(_fulfilled(works, deadline), None)


def _fulfilled(works: Iterator[Work], deadline: Deadline) -> Iterator[tuple[Work, Labelling]]:
    """The models that have labels for all lines, and these."""
    for work in works:
        labelling = work.search.fulfilled(deadline)
        if labelling.labels is not None:
            yield work, labelling
        else:
            work.failed(labelling)


def _followed(
    work: Work, lines: DrawnViews, limits: Limits, deadline: Deadline
) -> Iterator[tuple[Work, Labelling]]:
    """Labels of the part with the curves that strokes may follow.

    An arc or line in place of a curve may make a solid that shows all lines, with slivers.
    """
    if lines.apart is None or not work.allows_another(limits):
        return
    if (model := followed_curves(work, lines, deadline)) is not None:
        other = _remodelled(work, model, limits)
        if limits.relaxed:
            yield other, other.search.best(deadline)
        else:
            yield from _fulfilled(iter([other]), deadline)


def _remodelled(work: Work, model: OtherModel, limits: Limits) -> Work:
    kind, part = model
    return replace(work, part=part, search=search_for(part, limits, work.meter), kind=kind)


def _until(models: Iterator[OtherModel], limits: Limits, work: Work) -> Iterator[OtherModel]:
    """Models as long as there is work left for another one."""
    while work.allows_another(limits):
        if (model := next(models, None)) is None:
            return
        yield model


def _cost(labelling: Labelling) -> float:
    """Units of line that labels give up."""
    return sum(rule.weight for rule in labelling.given_up)
