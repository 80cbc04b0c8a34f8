"""How well a solid explains a sheet: mm of line in which both differ, with kind and place of each.

Along every stroke, over the blank of every view and along the solid's own edges, pairs of lines of
sight tell what the solid would draw (:mod:`.lines_of_sight`); what the sheet draws there is
compared with it (:mod:`.sight_pairs`).  Nothing is redrawn: no hidden-line algorithm has a word.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.difference_kinds import (
    NO_KIND,
    NUMBER,
    PRICES_OF_NUMBERS,
    Kind,
    kinds_between,
)
from gaussiancad_core.judging.drawn_lines import DrawnSheet, DrawnView, drawn_sheet
from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats, Numbers, faceted_shape
from gaussiancad_core.judging.lines_of_sight import Met, Seen, crossings, seen
from gaussiancad_core.judging.opened_views import met_in, opened, with_cut
from gaussiancad_core.judging.sight_pairs import NO_LINE, Drawn, SightPairs, sight_pairs
from gaussiancad_core.judging.undrawn_edges import Rows, undrawn_edges
from gaussiancad_core.model.section_planes import Cut


@dataclass(frozen=True, eq=False)
class ViewMisfit:
    """Where a solid and a view differ.

    Attributes:
        view: of the sheet.
        kind: (d,) numbers of :data:`.KINDS`.
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
        return float((PRICES_OF_NUMBERS[self.kind] * self.mm).sum())

    def of(self, *kinds: Kind) -> npt.NDArray[np.bool_]:
        """(d,) which differences are of these kinds."""
        return np.isin(self.kind, [NUMBER[kind] for kind in kinds])


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
        surfaces = np.append(smooth, len(smooth))
        for view, pairs, each in zip(self.sheet.views, self.pairs, met, strict=True):
            open_met = opened(each, view, pairs.places, len(smooth))
            signs = seen(open_met, surfaces)
            ends = pairs.one, pairs.other
            kind = kinds_between(signs, ends, pairs.drawn, view)
            wrong = kind != NO_KIND
            total += float((PRICES_OF_NUMBERS[kind[wrong]] * pairs.weight[wrong]).sum())
        return total

    def rough_cost(self, solid: FacetedSolid, every: int) -> float:
        """mm of the misfit by one of so many pairs, without the solid's own edges."""
        total = 0.0
        for view, pairs in zip(self.sheet.views, self.pairs, strict=True):
            strokes = np.flatnonzero(pairs.drawn != Drawn.NOTHING)[:: max(1, every // 2)]
            blank = np.flatnonzero(pairs.drawn == Drawn.NOTHING)[::every]
            chosen = np.concatenate([strokes, blank])
            used = np.unique(np.concatenate([pairs.one[chosen], pairs.other[chosen]]))
            met = met_in(solid, view, pairs.places[used])
            ends = (
                np.searchsorted(used, pairs.one[chosen]),
                np.searchsorted(used, pairs.other[chosen]),
            )
            signs = seen(met, with_cut(solid))
            kind = kinds_between(signs, ends, pairs.drawn[chosen], view)
            wrong = kind != NO_KIND
            total += float((PRICES_OF_NUMBERS[kind[wrong]] * pairs.weight[chosen][wrong]).sum())
        return total


def solid_misfit(shape: TopoDS_Shape, views: DrawnViews) -> Misfit:
    """How well an exact solid that lies on the views' axes explains them."""
    return Judge(drawn_sheet(views)).misfit(faceted_shape(shape))


def _chords(view: DrawnView) -> shapely.STRtree:
    """The chords of a view's lines, each by itself: what is near is found much sooner so."""
    ends = [np.stack([line.points[:-1], line.points[1:]], axis=1) for line in view.lines]
    return shapely.STRtree(shapely.linestrings(np.concatenate(ends)) if ends else [])


def _view_misfit(
    solid: FacetedSolid,
    sheet: DrawnSheet,
    view: DrawnView,
    pairs: SightPairs,
    chords: shapely.STRtree,
) -> ViewMisfit:
    met = met_in(solid, view, pairs.places)
    signs = seen(met, with_cut(solid))
    kind = kinds_between(signs, (pairs.one, pairs.other), pairs.drawn, view)
    lost = np.isin(kind, [NUMBER[Kind.MISSING], NUMBER[Kind.MISSING_HIDDEN]])
    wrong = kind != NO_KIND
    rows = [
        (
            kind[wrong],
            pairs.at[wrong],
            _halves(pairs, wrong),
            pairs.weight[wrong],
            pairs.line[wrong],
            np.full(int(wrong.sum()), NO_KIND),
        ),
        undrawn_edges(solid, sheet, view, chords),
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


def _hatched_otherwise(cut: Cut, pairs: SightPairs, signs: Seen, surface: int) -> Rows:
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
    none = np.full(count, NO_KIND)
    kinds = np.full(count, NUMBER[Kind.HATCHING])
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
