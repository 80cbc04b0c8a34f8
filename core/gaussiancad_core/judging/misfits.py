"""How well a solid explains a sheet: mm of line in which both differ, with kind and place of each.

Along every stroke, over the blank of every view and along the solid's own edges, pairs of lines of
sight tell what the solid would draw (:mod:`.sight_lines`); what the sheet draws there is compared
with it (:mod:`.sight_pairs`).  Nothing is redrawn: no hidden-line algorithm has a word.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt
import shapely
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.drawn_lines import DrawnSheet, DrawnView, drawn_sheet
from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats, Numbers, faceted_shape
from gaussiancad_core.judging.sight_lines import Met, Seen, crossings, cut_open, seen
from gaussiancad_core.judging.sight_pairs import NO_LINE, Drawn, SightPairs, sight_pairs
from gaussiancad_core.model.section_planes import Cut


class Kind(Enum):
    """In what a solid and a sheet differ at a place."""

    MISSING = "missing"
    MISSING_HIDDEN = "missing-hidden"
    EXTRA = "extra"
    EXTRA_HIDDEN = "extra-hidden"
    LINETYPE = "linetype"
    TANGENT = "tangent"
    HATCHING = "hatching"


KINDS = tuple(Kind)
_NONE = -1
_NUMBER = {kind: number for number, kind in enumerate(KINDS)}

PRICES = {
    Kind.MISSING: 1.0,
    Kind.MISSING_HIDDEN: 0.7,
    Kind.EXTRA: 1.0,
    Kind.EXTRA_HIDDEN: 0.7,
    Kind.LINETYPE: 0.35,
    Kind.TANGENT: 0.1,
    Kind.HATCHING: 1.0,
}
"""What a mm of line costs.  A smooth edge may be drawn or left out; what is hidden is often left
out, and a linetype is the least sure of what a reader tells."""

_PRICES = np.array([PRICES[kind] for kind in KINDS])

_FAR, _FAR_SHARE = 2.0, 0.006
"""How far from all strokes an edge of the solid is undrawn: lengths from a stroke to the lines of
sight beside it, and share of the longest extent, at least."""

_FLAT = 0.2
"""Share of an edge's length that a view shows of it at least to look at it there."""

_EDGE_STEP = 1.0 / 60.0
"""Share of the longest extent between places on an edge."""

_ONCE = 1.0 / 120.0
"""Share of the longest extent within which what two edges draw counts once."""


@dataclass(frozen=True, eq=False)
class ViewMisfit:
    """Where a solid and a view differ.

    Attributes:
        view: of the sheet.
        kind: (d,) numbers of :data:`KINDS`.
        at: (d, 2) mm in the view's plane (right, up).
        along: (d, 2) mm, half of the piece of line that each stands for, where that is known.
        mm: (d,) of line.
        line: (d,) number of the sheet's line that is missing or of another linetype; -1 elsewhere.
        edge: (d,) number of the solid's edge that the sheet does not draw; -1 elsewhere.
        share_lost: (lines,) of each line of the view, the share that the solid does not draw at
            all.
    """

    view: DrawnView
    kind: Numbers
    at: Floats
    along: Floats
    mm: Floats
    line: Numbers
    edge: Numbers
    share_lost: Floats

    @property
    def cost(self) -> float:
        """mm of line at their prices."""
        return float((_PRICES[self.kind] * self.mm).sum())

    def of(self, *kinds: Kind) -> npt.NDArray[np.bool_]:
        """(d,) which differences are of these kinds."""
        return np.isin(self.kind, [_NUMBER[kind] for kind in kinds])


@dataclass(frozen=True, eq=False)
class Misfit:
    """How well a solid explains a sheet.

    Attributes:
        views: where they differ.
        drawn: mm of all lines of the sheet.
    """

    views: tuple[ViewMisfit, ...]
    drawn: float

    @property
    def cost(self) -> float:
        """mm of line at their prices."""
        return sum(view.cost for view in self.views)

    @property
    def share(self) -> float:
        """The cost as a share of the lines."""
        return self.cost / self.drawn if self.drawn else 1.0


class Judge:
    """The pairs of a sheet, made once for all solids that are compared with it.

    Args:
        sheet: what it draws.
    """

    def __init__(self, sheet: DrawnSheet) -> None:
        self.sheet = sheet
        self.pairs = tuple(sight_pairs(sheet, view) for view in sheet.views)
        self._chords = tuple(_chords(view) for view in sheet.views)

    def misfit(self, solid: FacetedSolid) -> Misfit:
        """How well a solid that lies on the sheet's axes explains the sheet, wholly."""
        views = [
            _view_misfit(solid, self.sheet, view, pairs, chords)
            for view, pairs, chords in zip(self.sheet.views, self.pairs, self._chords, strict=True)
        ]
        return Misfit(tuple(views), self.sheet.length)

    def sighted(self, solid: FacetedSolid) -> tuple[Met, ...]:
        """What the lines of sight of each view meet of a solid, as if nothing were cut open."""
        return tuple(
            crossings(solid, view.role.frame, pairs.places)
            for view, pairs in zip(self.sheet.views, self.pairs, strict=True)
        )

    def cost_of(self, met: Sequence[Met], smooth: Numbers) -> float:
        """mm of the misfit of what lines of sight meet, without a solid's own edges.

        Args:
            met: in each view, as of :meth:`sighted`.
            smooth: of each surface, the first that it passes into smoothly.
        """
        total = 0.0
        with_cut = np.append(smooth, len(smooth))
        for view, pairs, each in zip(self.sheet.views, self.pairs, met, strict=True):
            opened = _opened(each, view, pairs.places, len(smooth))
            signs = seen(opened, with_cut)
            ends = pairs.one, pairs.other
            kind = _kinds(signs, ends, pairs.drawn, draws_hidden=view.draws_hidden)
            wrong = kind != _NONE
            total += float((_PRICES[kind[wrong]] * pairs.weight[wrong]).sum())
        return total

    def rough_cost(self, solid: FacetedSolid, every: int) -> float:
        """mm of the misfit by one of so many pairs, without the solid's own edges."""
        total = 0.0
        for view, pairs in zip(self.sheet.views, self.pairs, strict=True):
            strokes = np.flatnonzero(pairs.drawn != Drawn.NOTHING)[:: max(1, every // 2)]
            blank = np.flatnonzero(pairs.drawn == Drawn.NOTHING)[::every]
            chosen = np.concatenate([strokes, blank])
            used = np.unique(np.concatenate([pairs.one[chosen], pairs.other[chosen]]))
            met = _met(solid, view, pairs.places[used])
            ends = (
                np.searchsorted(used, pairs.one[chosen]),
                np.searchsorted(used, pairs.other[chosen]),
            )
            signs = seen(met, _with_cut(solid))
            kind = _kinds(signs, ends, pairs.drawn[chosen], draws_hidden=view.draws_hidden)
            wrong = kind != _NONE
            total += float((_PRICES[kind[wrong]] * pairs.weight[chosen][wrong]).sum())
        return total


def solid_misfit(shape: TopoDS_Shape, views: DrawnViews) -> Misfit:
    """How well an exact solid that lies on the views' axes explains them."""
    return Judge(drawn_sheet(views)).misfit(faceted_shape(shape))


def _chords(view: DrawnView) -> shapely.STRtree:
    """The chords of a view's lines, each by itself: what is near is found much sooner so."""
    ends = [np.stack([line.points[:-1], line.points[1:]], axis=1) for line in view.lines]
    return shapely.STRtree(shapely.linestrings(np.concatenate(ends)) if ends else [])


def _with_cut(solid: FacetedSolid) -> Numbers:
    """The solid's surfaces, and one more for what a plane cuts."""
    return np.append(solid.smooth, len(solid.smooth))


def _met(solid: FacetedSolid, view: DrawnView, places: Floats) -> Met:
    met = crossings(solid, view.role.frame, places)
    return _opened(met, view, places, len(solid.smooth))


def _opened(met: Met, view: DrawnView, places: Floats, cut: int) -> Met:
    """What is met in a view where it is cut open; ``cut`` is the number of what is cut."""
    if view.cut is None:
        return met
    return cut_open(met, _cut_depths(view, places), cut)


def _cut_depths(view: DrawnView, places: Floats) -> Floats:
    """(n,) mm along the look where a view is cut at places; NaN where it is not."""
    depths = np.full(len(places), np.nan)
    if view.cut is None:
        return depths
    sign = view.role.frame.look_axis[1]
    for opening in reversed(view.cut.openings):
        inside = (
            np.ones(len(places), bool)
            if opening.region is None
            else shapely.contains_xy(opening.region, places[:, 0], places[:, 1])
        )
        depths[inside] = sign * opening.at
    return depths


def _view_misfit(
    solid: FacetedSolid,
    sheet: DrawnSheet,
    view: DrawnView,
    pairs: SightPairs,
    chords: shapely.STRtree,
) -> ViewMisfit:
    met = _met(solid, view, pairs.places)
    signs = seen(met, _with_cut(solid))
    kind = _kinds(signs, (pairs.one, pairs.other), pairs.drawn, draws_hidden=view.draws_hidden)
    lost = np.isin(kind, [_NUMBER[Kind.MISSING], _NUMBER[Kind.MISSING_HIDDEN]])
    wrong = kind != _NONE
    rows = [
        (
            kind[wrong],
            pairs.at[wrong],
            _halves(pairs, wrong),
            pairs.weight[wrong],
            pairs.line[wrong],
            np.full(int(wrong.sum()), _NONE),
        ),
        _undrawn_edges(solid, sheet, view, chords),
    ]
    if view.cut is not None and view.cut.areas is not None:
        rows.append(_hatched_otherwise(view.cut, pairs, signs, len(solid.smooth)))
    kinds, at, along, mm, line, edge = (
        np.concatenate(column) for column in zip(*rows, strict=True)
    )
    share_lost = _shares(pairs, lost, len(view.lines))
    return ViewMisfit(view, kinds, at, along, mm, line, edge, share_lost)


def _halves(pairs: SightPairs, chosen: npt.NDArray[np.bool_]) -> Floats:
    """(c, 2) mm along the line of each chosen pair, half of what it stands for."""
    across = pairs.places[pairs.other[chosen]] - pairs.places[pairs.one[chosen]]
    length = np.maximum(np.hypot(*across.T), 1e-12)
    along = np.stack([across[:, 1], -across[:, 0]], axis=1) / length[:, None]
    return along * (pairs.weight[chosen] / 2.0)[:, None]


def _shares(pairs: SightPairs, lost: npt.NDArray[np.bool_], count: int) -> Floats:
    """(lines,) share of each line's pairs that are lost."""
    near = pairs.line != NO_LINE
    every = np.bincount(pairs.line[near], minlength=count)
    gone = np.bincount(pairs.line[near & lost], minlength=count)
    return gone / np.maximum(every, 1)


def _kinds(
    signs: Seen, ends: tuple[Numbers, Numbers], drawn: Numbers, *, draws_hidden: bool
) -> Numbers:
    """(p,) number of the kind in which each pair differs from what is drawn; -1 where it does
    not."""
    one, other = ends
    same = signs.sharp[one] == signs.sharp[other]
    shown = signs.first[one] != signs.first[other]
    smooth = same & (signs.every[one] != signs.every[other])
    nothing, visible, hidden = (drawn == each for each in Drawn)
    kind = np.full(len(drawn), _NONE)
    kind[nothing & ~same & shown] = _NUMBER[Kind.EXTRA]
    if draws_hidden:
        kind[nothing & ~same & ~shown] = _NUMBER[Kind.EXTRA_HIDDEN]
    kind[visible & same] = _NUMBER[Kind.MISSING]
    kind[hidden & same] = _NUMBER[Kind.MISSING_HIDDEN]
    kind[~nothing & smooth] = _NUMBER[Kind.TANGENT]
    kind[visible & ~same & ~shown] = _NUMBER[Kind.LINETYPE]
    kind[hidden & ~same & shown] = _NUMBER[Kind.LINETYPE]
    return kind


_Rows = tuple[Numbers, Floats, Floats, Floats, Numbers, Numbers]


def _undrawn_edges(
    solid: FacetedSolid, sheet: DrawnSheet, view: DrawnView, chords: shapely.STRtree
) -> _Rows:
    """Places on the solid's edges that it shows in a view where no stroke is near."""
    frame = view.role.frame
    axes = np.array([frame.right, frame.up], dtype=np.float64)
    at, way, mm, edge = _on_edges(solid, _EDGE_STEP * sheet.longest)
    at, way = at @ axes.T, way @ axes.T
    flat = np.hypot(*way.T)
    chosen = flat > _FLAT
    least = max(_FAR * sheet.aside, _FAR_SHARE * sheet.longest)
    chosen[chords.query(shapely.points(at), predicate="dwithin", distance=least)[0]] = False
    at, way, mm, edge = (
        at[chosen],
        way[chosen] / flat[chosen, None],
        (mm * flat)[chosen],
        edge[chosen],
    )
    if not len(at):
        none = np.zeros(0, int)
        return none, np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0), none, none
    across = sheet.aside * np.stack([-way[:, 1], way[:, 0]], axis=1)
    signs = seen(_met(solid, view, np.vstack([at - across, at + across])), _with_cut(solid))
    numbers = np.arange(len(at))
    kind = _kinds(
        signs,
        (numbers, numbers + len(at)),
        np.full(len(at), Drawn.NOTHING.value),
        draws_hidden=view.draws_hidden,
    )
    kept = (kind != _NONE) & _first_at(at, _ONCE * sheet.longest)
    return (
        kind[kept],
        at[kept],
        way[kept] * (mm[kept] / 2.0)[:, None],
        mm[kept],
        np.full(int(kept.sum()), NO_LINE),
        edge[kept],
    )


def _on_edges(solid: FacetedSolid, step: float) -> tuple[Floats, Floats, Floats, Numbers]:
    """(n, 3) places on the solid's edges, unit vectors along them, mm that each stands for, and
    numbers of the edges."""
    ways = solid.sharp[:, 1] - solid.sharp[:, 0]
    lengths = np.linalg.norm(ways, axis=1)
    counts = np.maximum(np.ceil(lengths / step), 1).astype(np.int64)
    chord = np.repeat(np.arange(len(counts)), counts)
    share = (np.arange(len(chord)) - np.repeat(np.cumsum(counts) - counts, counts) + 0.47) / counts[
        chord
    ]
    at = solid.sharp[chord, 0] + share[:, None] * ways[chord]
    units = ways[chord] / np.maximum(lengths, 1e-12)[chord, None]
    return at, units, (lengths / counts)[chord], solid.edges[chord]


def _first_at(at: Floats, step: float) -> npt.NDArray[np.bool_]:
    """(n,) whether no earlier place lies in the same square."""
    first = np.zeros(len(at), bool)
    first[np.unique(np.round(at / step).astype(np.int64), axis=0, return_index=True)[1]] = True
    return first


def _hatched_otherwise(cut: Cut, pairs: SightPairs, signs: Seen, surface: int) -> _Rows:
    """Lines of sight of the raster that meet a cut where nothing is hatched, or the other way."""
    places = pairs.places[pairs.raster :]
    is_open = np.zeros(len(places), bool)
    for opening in cut.openings:
        is_open |= (
            np.ones(len(places), bool)
            if opening.region is None
            else shapely.contains_xy(opening.region, places[:, 0], places[:, 1])
        )
    hatched = shapely.contains_xy(cut.areas, places[:, 0], places[:, 1])
    is_cut = signs.first[pairs.raster :] == surface
    wrong = is_open & (hatched != is_cut)
    count = int(wrong.sum())
    none = np.full(count, _NONE)
    kinds = np.full(count, _NUMBER[Kind.HATCHING])
    return kinds, places[wrong], np.zeros((count, 2)), pairs.cells[wrong], none, none


def total_mm(misfit: Misfit, kinds: Sequence[Kind]) -> float:
    """mm of line, unpriced, that differ in one of these ways."""
    return sum(float(view.mm[view.of(*kinds)].sum()) for view in misfit.views)


def lost_lines(misfit: Misfit, least: float) -> Iterable[tuple[DrawnView, int]]:
    """Views and numbers of their lines of which the solid draws too little.

    Args:
        misfit: of the solid.
        least: share of a line that is lost from which it counts.
    """
    for view in misfit.views:
        for number in np.flatnonzero(view.share_lost >= least).tolist():
            yield view.view, number
