"""Visible or hidden, decided for each line between its meetings with all others.

Between two such points a line's visibility hardly ever changes.  Each line is therefore cut where
others cross or touch it, and sight lines beside a few points of each piece decide
(:mod:`gaussiancad_core.lines.visibility`).  Where the points of one piece disagree, more of them
are looked at: a single dissenter is overruled, and a real change, as there is when a meeting was
missed by a hair, is found by bisection.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import groupby, pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.lines.coverage import StrokeIndex
from gaussiancad_core.lines.stroke_meetings import junctions
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.lines.visibility import RayTest, Visibility
from gaussiancad_core.model.views import Linetype

Points = npt.NDArray[np.float64]
Kind = Linetype | None

_SHORT_SHARES = (0.438,)
_LONG_SHARES = (0.137, 0.438, 0.862)
"""Where in a piece the sight lines stand: not at middles, which symmetric parts align."""

_LONG = 60.0
"""Length in fragments from which a piece is looked at three times."""

_MANY_SHARES = tuple((np.arange(13) + 0.438) / 13.0)
"""The same in a piece whose spots disagree."""

_BISECTIONS = 14


@dataclass(frozen=True)
class _Spot:
    """A point of a line and what is to be drawn there.

    Attributes:
        stroke: number of the line.
        at: length along it.
        piece: (low, high) lengths of the piece that it stands for.
        kind: what is to be drawn; None for nothing.
    """

    stroke: int
    at: float
    piece: tuple[float, float]
    kind: Kind = None


@dataclass(frozen=True)
class ProjectedLine:
    """A line that may be drawn.

    Attributes:
        stroke: where it runs, in mm; its linetype does not matter.
        slack: mm by which the solid's faces may miss it.
    """

    stroke: DrawnStroke
    slack: float


class _Decider:
    """Looks at spots of the lines of one view."""

    def __init__(
        self,
        lines: Sequence[ProjectedLine],
        witness: RayTest,
        precision: Precision,
        tangent_edges: bool,
    ) -> None:
        self._strokes = [line.stroke for line in lines]
        self._slacks = np.array([line.slack for line in lines])
        self._witness = witness
        self._precision = precision
        self._tangent_edges = tangent_edges

    def spots(self) -> list[_Spot]:
        """One to three spots for every piece of every line, in order."""
        index = StrokeIndex(self._strokes)
        spots = []
        for number, stroke in enumerate(self._strokes):
            for low, high in pairwise(self._bounds(stroke, index)):
                long = high - low > _LONG * self._precision.fragment
                for share in _LONG_SHARES if long else _SHORT_SHARES:
                    spots.append(_Spot(number, low + share * (high - low), (low, high)))
        return spots

    def _bounds(self, stroke: DrawnStroke, index: StrokeIndex) -> list[float]:
        """A line's ends and, between them, its junctions that are a fragment apart."""
        least = self._precision.fragment
        bounds = [0.0]
        for at in junctions(stroke, index, 2.0 * self._precision.chord):
            if at - bounds[-1] >= least and stroke.length - at >= least:
                bounds.append(float(at))
        return [*bounds, stroke.length]

    def kinds(self, places: Sequence[tuple[int, float]]) -> list[Kind | Visibility]:
        """What is to be drawn at lengths along lines; ``UNCERTAIN`` where that cannot be seen."""
        if not places:
            return []
        points, normals = np.empty((len(places), 2)), np.empty((len(places), 2))
        for row, (number, at) in enumerate(places):
            points[row], normals[row] = self._place(self._strokes[number], at)
        kinds: dict[Visibility, Kind | Visibility] = {
            Visibility.VISIBLE: Linetype.VISIBLE,
            Visibility.HIDDEN: Linetype.HIDDEN,
            Visibility.UNCERTAIN: Visibility.UNCERTAIN,
        }
        if self._tangent_edges:
            kinds[Visibility.SMOOTH_VISIBLE] = Linetype.VISIBLE
            kinds[Visibility.SMOOTH_HIDDEN] = Linetype.HIDDEN
        slacks = self._slacks[[number for number, _ in places]]
        visibility_of = self._witness.visibility_of(points, normals, slacks)
        return [kinds.get(sighting) for sighting in visibility_of]

    def _place(self, stroke: DrawnStroke, at: float) -> tuple[Points, Points]:
        """(2,) point and (2,) unit vector across a line."""
        half = min(self._precision.fragment, stroke.length / 4.0) / 2.0
        middle = float(np.clip(at, half, stroke.length - half))
        before, point, after = stroke.points_at(np.array([middle - half, at, middle + half]))
        way = (after - before) / np.hypot(*(after - before))
        return point, np.array([-way[1], way[0]])

    def look(self, spots: Sequence[_Spot]) -> list[_Spot]:
        """The spots with their kinds, without those where nothing can be seen."""
        kinds = self.kinds([(spot.stroke, spot.at) for spot in spots])
        return [
            replace(spot, kind=kind)
            for spot, kind in zip(spots, kinds, strict=True)
            if not isinstance(kind, Visibility)
        ]

    def changes(self, pairs: Sequence[tuple[_Spot, _Spot]]) -> list[float]:
        """Where between two spots of a line its kind changes from that of the first."""
        lows = [first.at for first, _ in pairs]
        highs = [second.at for _, second in pairs]
        for _ in range(_BISECTIONS if pairs else 0):
            middles = [(low + high) / 2.0 for low, high in zip(lows, highs, strict=True)]
            places = [(first.stroke, at) for (first, _), at in zip(pairs, middles, strict=True)]
            for row, kind in enumerate(self.kinds(places)):
                if kind is pairs[row][0].kind:
                    lows[row] = middles[row]
                else:
                    highs[row] = middles[row]
        return [(low + high) / 2.0 for low, high in zip(lows, highs, strict=True)]


def decided(
    lines: Sequence[ProjectedLine], witness: RayTest, precision: Precision, tangent_edges: bool
) -> list[DrawnStroke]:
    """The parts of lines that are visible or hidden, with their linetypes.

    Args:
        lines: the lines of one view, each once.
        witness: looks beside them.
        precision: parts shorter than its fragment are not told apart.
        tangent_edges: whether lines between faces that meet smoothly are kept.
    """
    decider = _Decider(lines, witness, precision, tangent_edges)
    seen = _agreed(decider, decider.look(decider.spots()))
    missed = [
        (first, second)
        for first, second in pairwise(seen)
        if _same_piece(first, second) and first.kind is not second.kind
    ]
    cuts = dict(zip((first for first, _ in missed), decider.changes(missed), strict=True))
    this_spots: list[list[_Spot]] = [[] for _ in lines]
    for spot in seen:
        this_spots[spot.stroke].append(spot)
    return [
        stroke
        for line, spots in zip(lines, this_spots, strict=True)
        for stroke in _parts(line.stroke, spots, cuts, precision.fragment)
    ]


def _same_piece(first: _Spot, second: _Spot) -> bool:
    return (first.stroke, first.piece) == (second.stroke, second.piece)


def _agreed(decider: _Decider, seen: Sequence[_Spot]) -> list[_Spot]:
    """The spots, with more of them in pieces whose spots disagree, and no single dissenters."""
    pieces = [list(group) for _, group in groupby(seen, lambda spot: (spot.stroke, spot.piece))]
    mixed = [len({spot.kind for spot in spots}) > 1 for spots in pieces]
    more = decider.look(
        [
            replace(
                spots[0], at=spots[0].piece[0] + share * (spots[0].piece[1] - spots[0].piece[0])
            )
            for spots, disagree in zip(pieces, mixed, strict=True)
            if disagree
            for share in _MANY_SHARES
        ]
    )
    dense = {
        key: list(group) for key, group in groupby(more, lambda spot: (spot.stroke, spot.piece))
    }
    agreed: list[_Spot] = []
    for spots in pieces:
        many = dense.get((spots[0].stroke, spots[0].piece), spots)
        agreed.extend(_without_dissenters(many))
    return agreed


def _without_dissenters(spots: list[_Spot]) -> list[_Spot]:
    """Spots without those that differ from both neighbours (at an end: from the next two)."""
    if len(spots) <= len(_LONG_SHARES):
        return spots
    kept = []
    for index, spot in enumerate(spots):
        around = [max(0, index - 1), min(len(spots) - 1, index + 1)]
        if index == 0:
            around = [1, 2]
        elif index == len(spots) - 1:
            around = [index - 2, index - 1]
        if any(spots[neighbour].kind is spot.kind for neighbour in around):
            kept.append(spot)
    return kept or spots


def _parts(
    stroke: DrawnStroke, spots: Sequence[_Spot], cuts: dict[_Spot, float], fragment: float
) -> list[DrawnStroke]:
    """One stroke for every run of spots of one kind; ``cuts`` end a spot before its piece does."""
    runs: list[tuple[float, float, Kind]] = []
    for index, spot in enumerate(spots):
        last = index + 1 == len(spots)
        high = stroke.length if last else cuts.get(spot, spot.piece[1])
        if not last and spot not in cuts and _same_piece(spot, spots[index + 1]):
            high = spots[index + 1].at
        low = runs[-1][1] if runs else 0.0
        if runs and (runs[-1][2] is spot.kind or high - low < fragment):
            runs[-1] = (runs[-1][0], high, runs[-1][2])
        else:
            runs.append((low, high, spot.kind))
    if len(runs) > 1 and stroke.is_closed and runs[0][2] is runs[-1][2]:
        # The run that goes over the start of a closed line.
        first = runs.pop()
        runs[0] = (first[0] - stroke.length, runs[0][1], first[2])
    return [replace(stroke.part(low, high), linetype=kind) for low, high, kind in runs if kind]
