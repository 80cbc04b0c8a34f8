"""The models of a drawing, and the labels that explain most of it.

A drawing has one model as a rule.  Where its rules contradict each other, others are made: with an
open outline closed, with more surfaces, with curves instead of lines that may only follow them.
"""

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from math import inf

from gaussiancad_core.errors import LimitError
from gaussiancad_core.reasoning.drawn_views import EXACT_TOLERANCE, DrawnViews
from gaussiancad_core.reasoning.fewest_strokes import fewest_strokes
from gaussiancad_core.reasoning.followed import with_followed_curves
from gaussiancad_core.reasoning.labelling import Effort, Labelling, Search
from gaussiancad_core.reasoning.open_outlines import with_closed_outlines
from gaussiancad_core.reasoning.part import (
    NEAR,
    Contradict,
    PartModel,
    model_part,
    with_lone_bodies,
)
from gaussiancad_core.reasoning.rough_arcs import ROUGHLY, without_rough_arcs
from gaussiancad_core.reasoning.solvers import Deadline
from gaussiancad_core.reasoning.unsure_kinds import with_unsure_kinds

_HARD, _OTHERWISE, _RELAXED = 0.4, 0.55, 0.8
"""Shares of the time at which a step's solvers end: labels for all lines, for all with more
surfaces, for most lines.  Machines that are not busy have done with them long before."""

_MANY = 4000
"""Rules of a part up to which it is modelled again with ends of strokes left open: labels for more
of them take long, and the more lines there are the more of them are close by."""

_LITTLE = 3.0
"""Units of line that labels give up at least for other models to be asked for better ones."""

_LONG = 3.0
"""Deterministic time of telling which rules to give up from which no other model is tried: each
would take as long again, and strokes misread by some pixels contradict each other more simply."""

_FINER = 4.0
"""Times as long as the first model that the one takes in which views may lack lines."""

_MOST_LACKING = 9_000
"""Rules up to which it is told which strokes are lacking; with more only lines along the axes may
be, and of more still nothing is told in time."""

_PATIENT = 0.7
"""Share of the time that is left in which that is told."""

_STRICTER = 0.65
"""Share of the tolerance at which the places of lines that were read are one, where
labels contradict them with the whole of it."""

_LOOSER = (1.5, 2.5, 3.5)
"""Times the tolerance at which places of lines are one that nobody has made one: two that are off
by as much as one may be are twice as far apart, and the side of a circle is off by its centre and
its radius."""

_BETTER = 0.7
"""Share of what the first model gives up that another one gives up at most to be the better one."""


@dataclass(frozen=True)
class Limits:
    """How far the search goes.

    Attributes:
        effort: of the labelling, deterministic.
        alternatives: solids looked at beside the first.
        relaxed: whether lines may be given up where all together fit no solid.
        seconds: after which no further alternative is begun, and by which solvers have ended.
        conflict: deterministic time for telling which lines contradict each other, where no solid
            has all of them, lines may be given up, and a quarter of ``seconds`` is not over.
    """

    effort: Effort = field(default_factory=Effort)
    alternatives: int = 8
    relaxed: bool = True
    seconds: float = 60.0
    conflict: float = 2.0


class Clock:
    """Seconds of named steps."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self._start = self._last = time.perf_counter()

    def lap(self, name: str) -> None:
        """Seconds since the last lap belong to the step of that name."""
        now = time.perf_counter()
        self.seconds[name] = self.seconds.get(name, 0.0) + now - self._last
        self._last = now

    @property
    def total(self) -> float:
        """Since the start."""
        return time.perf_counter() - self._start

    def deadline(self, seconds: float) -> Deadline:
        """So many seconds after the start."""
        return Deadline(self._start + seconds)


@dataclass(frozen=True)
class Work:
    """What candidates are made from.

    Attributes:
        part, views: that are explained.
        search: for labels of the part.
        clock: of all that is done.
        fewest: whether the labels are those by which the fewest strokes are wrong or lacking.
        loose: whether places are one that are farther apart than the tolerance.
    """

    part: PartModel
    views: DrawnViews
    search: Search
    clock: Clock
    fewest: bool = False
    loose: bool = False


def labelled(
    part: PartModel, views: DrawnViews, limits: Limits, clock: Clock
) -> Iterator[tuple[Work, Labelling]]:
    """Labels of the part, and then of other models of it that explain more, likeliest first.

    Where there are labels for all lines, they are the only ones, but where strokes may follow the
    curves in which surfaces meet.
    """
    work = Work(part, views, Search(part.rules, limits.effort), clock)
    found = work.search.fulfilled(clock.deadline(_HARD * limits.seconds))
    lines = views
    deadline = clock.deadline(_OTHERWISE * limits.seconds)
    if found.labels is not None:
        yield work, found
        yield from _followed(work, lines, limits, deadline)
        return
    unsure = with_unsure_kinds(views)
    if unsure is not None and (model := _modelled(unsure, deadline)) is not None:
        other = _remodelled(replace(work, views=unsure), model, limits)
        retold = other.search.retold(deadline)
        if retold.labels is not None:
            yield other, retold
            yield from _followed(other, unsure, limits, deadline)
        # What is given up may be linetypes as well.
        work, lines = other, unsure
    closed = with_closed_outlines(lines) if found.complete else None
    if closed is not None and (model := _modelled(closed, deadline)) is not None:
        # Where the outside runs into the part nearly all lines contradict each other.
        lines, work = closed, _remodelled(work, model, limits)
        found = work.search.fulfilled(clock.deadline(_HARD * limits.seconds))
        if found.labels is not None:
            yield work, found
            yield from _followed(work, lines, limits, deadline)
            return
    # Another model takes as long as the first: time has to remain for the least contradiction.
    others = _until(_otherwise(work, lines, found.complete, deadline), limits, clock)
    first = _first_fulfilled((_remodelled(work, model, limits) for model in others), deadline)
    if first is None and not limits.relaxed:
        first = work, found
    if first is None and found.complete:
        others = _until(_looser(work, lines, deadline), limits, clock)
        loose = (replace(_remodelled(work, model, limits), loose=True) for model in others)
        first = _first_fulfilled(loose, deadline)
    if first is not None:
        yield first
        yield from _followed(work, lines, limits, deadline)
        return
    latest = clock.deadline(_RELAXED * limits.seconds)
    # Where readers lead ends to the wrong lines nearly all strokes are a little wrong.
    if views.apart is None and (lacking := _lacking(work, views, limits, latest)) is not None:
        yield lacking
    least = work.search.least(latest)
    yield work, least
    if least.effort <= _LONG:
        yield from _clearer(work, lines, _cost(least), limits)


def _clearer(
    work: Work, lines: DrawnViews, cost: float, limits: Limits
) -> Iterator[tuple[Work, Labelling]]:
    """Labels of models that give up clearly less than so many units of line; where that is hardly
    any, of the one with the curves that strokes may follow, for these may bound nothing."""
    deadline = work.clock.deadline(_OTHERWISE * limits.seconds)
    latest = work.clock.deadline(_RELAXED * limits.seconds)
    if cost < _LITTLE:
        yield from _followed(work, lines, limits, deadline)
        return
    for model in _until(_misread(work, lines, deadline), limits, work.clock):
        other = _remodelled(work, model, limits)
        more = other.search.best(latest)
        if _cost(more) < _BETTER * cost:
            yield other, more


def _first_fulfilled(works: Iterator[Work], deadline: Deadline) -> tuple[Work, Labelling] | None:
    """The first of the models that has labels for all lines, and these."""
    for work in works:
        labelling = work.search.fulfilled(deadline)
        if labelling.labels is not None:
            return work, labelling
    return None


def _followed(
    work: Work, lines: DrawnViews, limits: Limits, deadline: Deadline
) -> Iterator[tuple[Work, Labelling]]:
    """Labels of the part with the curves that strokes may follow.

    An arc or line in place of a curve may make a solid that shows all lines, with slivers.
    """
    if lines.apart is None or work.clock.total + work.clock.seconds["model"] > (
        _OTHERWISE * limits.seconds
    ):
        return
    followed = with_followed_curves(lines, work.part.supports)
    if followed is not None and (model := _modelled(followed, deadline)) is not None:
        other = _remodelled(work, model, limits)
        yield other, other.search.best(deadline)


def _lacking(
    work: Work, views: DrawnViews, limits: Limits, latest: Deadline
) -> tuple[Work, Labelling] | None:
    """The part with the lines that views may lack, and labels for all but the fewest strokes."""
    if work.clock.total + _FINER * work.clock.seconds["model"] > _OTHERWISE * limits.seconds:
        return None
    deadline = work.clock.deadline(_OTHERWISE * limits.seconds)
    model = _modelled(views, deadline, lost_lines=True)
    if model is None or len(model.rules) > _MOST_LACKING:
        model = _modelled(views, deadline, lost_lines=True, along_axes=True)
    if model is None or len(model.rules) > _MOST_LACKING:
        return None
    other = replace(_remodelled(work, model, limits), fewest=True)
    # Where that does not end in time, rules are given up one by one, which takes as long.
    share = work.clock.deadline(work.clock.total + _PATIENT * latest.left)
    return other, fewest_strokes(model, limits.effort, share)


def _remodelled(work: Work, model: PartModel, limits: Limits) -> Work:
    return replace(work, part=model, search=Search(model.rules, limits.effort))


def _until(models: Iterator[PartModel], limits: Limits, clock: Clock) -> Iterator[PartModel]:
    """Models as long as there is time for another one."""
    while clock.total + clock.seconds["model"] < _OTHERWISE * limits.seconds:
        if (model := next(models, None)) is None:
            return
        yield model


def _cost(labelling: Labelling) -> float:
    """Units of line that labels give up."""
    if labelling.labels is None:
        return inf
    return sum(rule.weight for rule in labelling.given_up)


def _modelled(
    views: DrawnViews, deadline: Deadline, near: float = NEAR, **more: bool
) -> PartModel | None:
    try:
        return model_part(views, near, deadline, **more)
    except LimitError:
        return None


def _otherwise(
    work: Work, lines: DrawnViews, contradict: bool, deadline: Deadline
) -> Iterator[PartModel]:
    """The part with more surfaces, and, where its lines do ``contradict``, without rough arcs."""
    if (wider := _wider(work, deadline)) is not None:
        yield wider
    # Arcs that only follow curves are what files have; what is read may have some as well.
    few = lines.apart is None or len(work.part.rules) <= _MANY
    smooth = without_rough_arcs(lines) if contradict and few else None
    if smooth is not None and (model := _modelled(smooth, deadline, ROUGHLY)) is not None:
        yield model


def _looser(work: Work, lines: DrawnViews, deadline: Deadline) -> Iterator[PartModel]:
    """The part with places as one that are farther apart than lines should miss each other.

    Those come first of which all places turn out to be multiples of a step.
    """
    if lines.apart is not None or lines.tolerance <= EXACT_TOLERANCE * max(lines.size):
        return
    found: list[PartModel] = []
    for times in _LOOSER:
        model = _modelled(replace(lines, tolerance=times * lines.tolerance), deadline)
        if model is not None and all(model.rules != own.rules for own in (work.part, *found)):
            found.append(model)
    yield from sorted(found, key=lambda model: not model.supports.nominal)


def _misread(work: Work, lines: DrawnViews, deadline: Deadline) -> Iterator[PartModel]:
    """The part as it may be if strokes were misread by some pixels.

    With places as one only if they are closer together; with the curves that strokes may follow
    instead of these; with ends of strokes left open; and with values as one that are less than a
    pixel apart.
    """
    # Where features are hardly larger, what is a pixel apart has to be two.
    if lines.apart is not None:
        strict = replace(lines, tolerance=_STRICTER * lines.tolerance)
        model = _modelled(strict, deadline)
        if model is not None and model.rules != work.part.rules:
            yield model
    followed = with_followed_curves(lines, work.part.supports)
    if followed is not None and (model := _modelled(followed, deadline)) is not None:
        # What contradicted the lines may be gone.
        yield _widened(model, _never, deadline) or model
    if len(work.part.rules) <= _MANY and lines.apart is not None:
        earlier: PartModel | None = None
        for loose in (lines, replace(lines, apart=None)):
            model = _modelled(loose, deadline, open_ends=True)
            # Mostly no values are that close.
            if model is not None and (earlier is None or model.rules != earlier.rules):
                yield model
            earlier = model


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
