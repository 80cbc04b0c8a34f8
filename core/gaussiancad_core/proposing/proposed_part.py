"""The part that is proposed for a sheet: found among features, built, and judged again."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.agreed_places import find_places
from gaussiancad_core.coordinates.carriers import PartCarriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.faceted_solids import faceted_shape
from gaussiancad_core.judging.misfits import Judge
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.proposing.breaking_edges import with_breaks
from gaussiancad_core.proposing.broken_corners import EdgeBreak
from gaussiancad_core.proposing.face_breaks import EdgeBreaks, without_breaks
from gaussiancad_core.proposing.feature_kernels import Operation
from gaussiancad_core.proposing.feature_solids import solid_of
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet
from gaussiancad_core.proposing.part_features import Feature
from gaussiancad_core.proposing.part_search import PartSearch
from gaussiancad_core.proposing.planned_part import PlannedPart

_WORSE = 0.01
"""Share of the lines that a solid may explain less than what was planned, for its features to be
left as they are."""

_MANY_STROKES = 200
"""Strokes from which a second search takes too long."""

_MOST_UNDONE = 4
"""Features that are taken out again for a try."""

_MANY_FACES = 80
"""Faces of a solid from which that takes too long."""

_EXPLAINED = 1e-3
"""Share of the lines that a part without a feature has to explain more."""

_FIRM = 0.05
"""Share of the lines that a part with broken edges leaves unexplained at most for nothing else to
be looked for."""

_LEAK = 0.5
"""Share of the lines that it counts as where the triangles of a solid bound no body: it can be
neither measured nor printed."""

WORK = 2.4e8
"""Steps of the search's kernels: about ten seconds of a processor."""


Features = tuple[tuple[Operation, Feature], ...]


@dataclass(frozen=True, eq=False)
class ProposedPart:
    """A part as it was put together.

    Attributes:
        features: in order.
        shape: mm; None where the kernel made none.
        planned: share of the lines that it leaves unexplained as it was planned.
        cost: mm of line that its solid does; infinite without one.
        sheet: whose surfaces the features have.
        carriers: of the views: where their lines may lie.
        breaks: of its edges, put on last.
    """

    features: Features
    shape: TopoDS_Shape | None
    planned: float
    cost: float
    sheet: PlaneSheet
    carriers: PartCarriers
    breaks: tuple[EdgeBreak, ...] = ()


def proposed_part(views: DrawnViews, grid: float, work: float = WORK) -> ProposedPart | None:
    """The part that explains views best among those that are put together of what they show: with
    edges sharp that are broken around a face, and broken at the end, or with all lines as they are.

    Args:
        views: of the part, with what the sheet's numbers say.
        grid: mm of a step of the sheet's coordinates.
        work: steps of the search's kernels at most.

    Returns:
        None where nothing tells a start.
    """
    sharp, breaks = without_breaks(views)
    if not breaks.each:
        return _searched(views, grid, work)
    judge = Judge(drawn_sheet(views))
    found = _with_breaks(_searched(sharp, grid, work / 2.0), breaks, sharp, judge)
    if found is not None and found.cost <= _FIRM * judge.sheet.length:
        return found
    if found is not None and sum(map(len, views.strokes.values())) > _MANY_STROKES:
        return found
    plain = _searched(views, grid, work / 2.0)
    if found is None or (plain is not None and plain.cost <= found.cost):
        return plain
    return found


def _with_breaks(
    found: ProposedPart | None, breaks: EdgeBreaks, views: DrawnViews, judge: Judge
) -> ProposedPart | None:
    """A part with its edges broken, before the judge of the lines as they are."""
    if found is None or found.shape is None:
        return None

    shape, made = with_breaks(found.shape, breaks, views.tolerance, partial(_share, judge))
    return replace(found, shape=shape, breaks=made, cost=_cost(judge, shape))


def _searched(views: DrawnViews, grid: float, work: float) -> ProposedPart | None:
    """The part that was put together of lines as they are; None where nothing tells a start."""
    places = find_places(views, grid)
    search = PartSearch(views, places, work)
    part = search.best()
    if part is None:
        return None
    judge = Judge(drawn_sheet(views))

    share = partial(_share, judge)
    features = tuple(part.features)
    shape = solid_of(features, search.sheet, part.share, share)
    if shape is not None and share(shape) > part.share + _WORSE:
        features, shape = _undone(part, shape, search.sheet, share)
    cost = _cost(judge, shape) if shape is not None else float("inf")
    return ProposedPart(features, shape, part.share, cost, search.sheet, places.carriers)


def _share(judge: Judge, shape: TopoDS_Shape) -> float:
    """The share of the lines that a solid leaves unexplained, and what counts as much."""
    return _cost(judge, shape) / judge.sheet.length


def _cost(judge: Judge, shape: TopoDS_Shape) -> float:
    """mm of line that a solid leaves unexplained, and what counts as much."""
    solid = faceted_shape(shape)
    leaks = 0.0 if solid.is_closed else _LEAK * judge.sheet.length
    return judge.misfit(solid).cost + leaks


def _undone(
    part: PlannedPart,
    shape: TopoDS_Shape,
    sheet: PlaneSheet,
    share: Callable[[TopoDS_Shape], float],
) -> tuple[Features, TopoDS_Shape]:
    """A part without those of its features whose edges the sheet does not draw: a plan looks along
    strokes, the judge of a solid along its edges, too.  Tried are those that explain less than the
    solid lacks, the least first."""
    features, best = tuple(part.features), share(shape)
    if len(faces_of(shape)) > _MANY_FACES:
        return features, shape
    rests = (
        PlannedPart(part.judge).followed_by([*features[:number], *features[number + 1 :]]).share
        for number in range(1, len(features))
    )
    worth = sorted((rest - part.share, number) for number, rest in enumerate(rests, 1))
    for lost, number in worth[:_MOST_UNDONE]:
        if lost > best - part.share:
            break
        rest = tuple(each for each in features if each is not part.features[number])
        made = solid_of(rest, sheet, best, share)
        if made is not None and share(made) < best - _EXPLAINED:
            features, shape, best = rest, made, share(made)
    return features, shape
