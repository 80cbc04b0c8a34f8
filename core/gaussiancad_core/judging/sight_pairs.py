"""Pairs of lines of sight, and what the sheet draws between the two of each.

Beside each stroke run pairs, one line of sight on either side.  Over the rest of a view stands a
raster whose lines run through the gaps between all places that any view shows; neighbours that no
stroke parts are pairs, too, and so are a line of sight beside a stroke and the nearest ones of the
raster: what lies beside a stroke is what lies farther off in the same region.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum

import numpy as np
import numpy.typing as npt
import shapely
from scipy.spatial import cKDTree

from gaussiancad_core.judging.drawn_lines import DrawnLine, DrawnSheet, DrawnView, chords_of
from gaussiancad_core.judging.faceted_solids import Floats, Numbers
from gaussiancad_core.model.axes import ViewFrame

_SAMPLE = 1.0 / 50.0
"""Share of the longest extent that a pair beside a stroke stands for at most."""

_FEWEST, _MOST = 2, 24
"""Pairs beside a stroke."""

_GAP = 1.0 / 12.0
"""Share of a view's extent from which a gap between two places gets more than one line."""

_LINES_IN_GAP, _GAPS = 5, 42
"""Lines of the raster in a gap, and gaps along an axis that it goes through, at most."""

_OFF_MIDDLE = 0.47, 0.4437
"""Shares of a gap's part at which lines of the raster run, along right and up: not through middles,
where parts have edges, nor along diagonals."""

_EVEN = 0.5
"""Odds from which a line is likely an edge."""

_UPON = 1.5
"""Tolerances within which a stroke lies upon another."""

_BLANK, _TOWARDS = 0.8, 0.2
"""What a mm counts between two lines of the raster, and between a stroke's side and the raster, of
what it counts beside a stroke."""

_PRECEDENCE = np.array([0, 3, 1, 2])
"""Of lines upon each other the one that counts, by the numbers of :class:`Drawn`: visible edges
before tangent edges, which are as solid, before hidden edges."""

_NEAREST = 3
"""Lines of the raster that one beside a stroke is paired with."""

NO_LINE = -1
"""Number of the line of a pair between which none is drawn."""


class Drawn(IntEnum):
    """What the sheet draws between two lines of sight."""

    NOTHING = 0
    VISIBLE = 1
    HIDDEN = 2
    TANGENT = 3


@dataclass(frozen=True, eq=False)
class SightPairs:
    """The lines of sight of a view, and the pairs of them that are compared.

    Attributes:
        places: (n, 2) mm in the view's plane (right, up).
        one, other: (p,) numbers of lines of sight.
        drawn: (p,) a :class:`Drawn` each.
        weight: (p,) mm of line that a pair stands for, by the odds of that.
        line: (p,) number of the line between both; :data:`NO_LINE` where there is none.
        at: (p, 2) mm, where a pair is.
        raster: number of the first line of sight of the raster.
        cells: (n - raster,) mm, the width that a line of the raster stands for.
    """

    places: Floats
    one: Numbers
    other: Numbers
    drawn: Numbers
    weight: Floats
    line: Numbers
    at: Floats
    raster: int
    cells: Floats


@dataclass(frozen=True, eq=False)
class _Pairs:
    one: Numbers
    other: Numbers
    drawn: Numbers
    weight: Floats
    line: Numbers
    at: Floats


def sight_pairs(sheet: DrawnSheet, view: DrawnView) -> SightPairs:
    """The pairs of a view of a sheet."""
    lines = view.lines
    tree = shapely.STRtree(chords_of(lines)) if lines else None
    near = _near_strokes(lines, tree, sheet)
    raster, cells = _raster(sheet, view)
    first = 2 * len(near.at)
    sides = _sides(near)
    places = np.vstack([sides, raster.reshape(-1, 2)])
    parts = [
        _Pairs(
            np.arange(len(near.at)),
            np.arange(len(near.at)) + len(near.at),
            near.drawn,
            near.weight,
            near.line,
            near.at,
        ),
        *_neighbours(raster, cells, first, tree),
        *_towards_raster(sides, np.tile(near.weight, 2), raster, first, tree),
    ]
    mean = np.sqrt(cells[0][:, None] * cells[1][None, :])
    return SightPairs(
        places,
        np.concatenate([part.one for part in parts]),
        np.concatenate([part.other for part in parts]),
        np.concatenate([part.drawn for part in parts]),
        np.concatenate([part.weight for part in parts]),
        np.concatenate([part.line for part in parts]),
        np.concatenate([part.at for part in parts]),
        first,
        mean.reshape(-1),
    )


@dataclass(frozen=True, eq=False)
class _Near:
    """Places on strokes.

    Attributes:
        at: (n, 2) mm.
        across: (n, 2) mm to the line of sight on one side.
        drawn, weight, line: as of the pairs.
    """

    at: Floats
    across: Floats
    drawn: Numbers
    weight: Floats
    line: Numbers


def _sides(near: _Near) -> Floats:
    return np.vstack([near.at - near.across, near.at + near.across])


def _near_strokes(
    lines: Sequence[DrawnLine], tree: shapely.STRtree | None, sheet: DrawnSheet
) -> _Near:
    """Places on strokes that no other stroke is in the way of: a stroke upon another counts once,
    the likely one, of two alike the visible one."""
    if tree is None:
        none = np.zeros(0, int)
        return _Near(np.zeros((0, 2)), np.zeros((0, 2)), none, np.zeros(0), none)
    found = [_along(line, sheet.longest) for line in lines]
    at = np.concatenate([places for places, _ in found])
    ways = np.concatenate([ways for _, ways in found])
    counts = [len(places) for places, _ in found]
    line = np.repeat(np.arange(len(lines)), counts)
    shares = [each.odds * each.length / n for each, n in zip(lines, counts, strict=True)]
    weight = np.repeat(shares, counts)
    drawn = np.array([_drawn(each) for each in lines])
    across = sheet.aside * np.stack([-ways[:, 1], ways[:, 0]], axis=1)
    probes = shapely.linestrings(np.stack([at - across, at + across], axis=1))
    probe, met = tree.query(probes, predicate="intersects")
    probe, met = probe[met != line[probe]], met[met != line[probe]]
    upon = shapely.distance(shapely.points(at[probe]), tree.geometries[met]) <= (
        _UPON * sheet.tolerance
    )
    likely = np.array([each.odds >= _EVEN for each in lines])
    # Of two alike the first counts.
    order = np.lexsort((-np.arange(len(lines)), _PRECEDENCE[drawn], likely))
    place = np.argsort(order)
    stands = place[line[probe]] > place[met]
    # What is hardly an edge is in nobody's way.
    is_aside = ~upon & (likely[met] | ~likely[line[probe]])
    dropped = np.zeros(len(at), bool)
    dropped[probe[is_aside | (upon & ~stands)]] = True
    kept = ~dropped
    return _Near(at[kept], across[kept], drawn[line][kept], weight[kept], line[kept])


def _drawn(line: DrawnLine) -> Drawn:
    if line.is_tangent:
        return Drawn.TANGENT
    return Drawn.VISIBLE if line.is_visible else Drawn.HIDDEN


def _along(line: DrawnLine, longest: float) -> tuple[Floats, Floats]:
    """(n, 2) places evenly along a line, and (n, 2) unit vectors along it there."""
    steps = np.hypot(*np.diff(line.points, axis=0).T)
    lengths = np.append(0.0, np.cumsum(steps))
    count = int(np.clip(np.ceil(lengths[-1] / (_SAMPLE * longest)), _FEWEST, _MOST))
    # Not at the middle, where other lines end.
    along = (np.arange(count) + 0.463) / count * lengths[-1]
    chord = np.clip(np.searchsorted(lengths, along) - 1, 0, len(steps) - 1)
    start, end = line.points[chord], line.points[chord + 1]
    ways = (end - start) / steps[chord, None]
    return start + ways * (along - lengths[chord])[:, None], ways


def _raster(sheet: DrawnSheet, view: DrawnView) -> tuple[Floats, tuple[Floats, Floats]]:
    """(h, w, 2) mm of the raster's lines of sight, and the widths that they stand for."""
    frame = view.role.frame
    found = [
        _through_gaps(sheet, axis.value, sign, share)
        for (axis, sign), share in zip((frame.right_axis, frame.up_axis), _OFF_MIDDLE, strict=True)
    ]
    (x, widths), (y, heights) = found
    return np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1), (widths, heights)


def _through_gaps(sheet: DrawnSheet, axis: int, sign: int, share: float) -> tuple[Floats, Floats]:
    """Lines of the raster through the gaps between places along an axis: (k,) mm along a view's
    right or up, and the widths that they stand for."""
    levels, size = levels_along(sheet, axis), float(sheet.size[axis])
    gaps = np.diff(levels)
    # In a gap as narrow as strokes are looked beside, a line would run along an edge.
    wide = np.flatnonzero(gaps > 2.0 * sheet.aside)
    kept = np.sort(wide[np.argsort(-gaps[wide], kind="stable")[:_GAPS]])
    places, widths = [], []
    for gap in kept.tolist():
        count = int(np.clip(np.ceil(gaps[gap] / (_GAP * size)), 1, _LINES_IN_GAP))
        places += [levels[gap] + (k + share) / count * gaps[gap] for k in range(count)]
        widths += [gaps[gap] / count] * count
    order = np.argsort(sign * np.array(places))
    return sign * np.array(places)[order], np.array(widths)[order]


def levels_along(sheet: DrawnSheet, axis: int) -> Floats:
    """Places in mm along an axis of the part at which any view shows an end or an extreme."""
    values = [np.array([0.0, sheet.size[axis]])]
    for view in sheet.views:
        for column, (shown, sign) in enumerate(_plane_axes(view.role.frame)):
            if shown == axis:
                for line in view.lines:
                    along = sign * line.points[:, column]
                    values.append(np.array([along[0], along[-1], along.min(), along.max()]))
    ordered = np.sort(np.concatenate(values))
    ordered = ordered[(ordered >= 0.0) & (ordered <= sheet.size[axis])]
    first = np.append(True, np.diff(ordered) > 2.0 * sheet.tolerance)
    return ordered[first]


def _plane_axes(frame: ViewFrame) -> tuple[tuple[int, int], tuple[int, int]]:
    """Axis of the part and sign along it of a view's right and up."""
    (right, right_sign), (up, up_sign) = frame.right_axis, frame.up_axis
    return (right.value, right_sign), (up.value, up_sign)


def _neighbours(
    raster: Floats, cells: tuple[Floats, Floats], first: int, tree: shapely.STRtree | None
) -> list[_Pairs]:
    """Pairs of neighbours of the raster that no stroke parts."""
    numbers = first + np.arange(raster.shape[0] * raster.shape[1]).reshape(raster.shape[:2])
    found = []
    for axis in (0, 1):
        one, other = (
            np.take(numbers, range(start, raster.shape[axis] - 1 + start), axis=axis).reshape(-1)
            for start in (0, 1)
        )
        across = cells[1][None, :] if axis == 0 else cells[0][:, None]
        widths = np.broadcast_to(across, raster.shape[:2]).reshape(-1)[one - first]
        flat = raster.reshape(-1, 2)
        ends = flat[one - first], flat[other - first]
        kept = ~_is_parted(*ends, tree)
        found.append(
            _blank(one[kept], other[kept], _BLANK * widths[kept], (ends[0] + ends[1])[kept] / 2.0)
        )
    return found


def _towards_raster(
    sides: Floats, weights: Floats, raster: Floats, first: int, tree: shapely.STRtree | None
) -> list[_Pairs]:
    """Pairs of a line of sight beside a stroke and near ones of the raster."""
    flat = raster.reshape(-1, 2)
    if not len(sides) or not len(flat):
        return []
    near = cKDTree(flat).query(sides, k=min(_NEAREST, len(flat)))[1].reshape(len(sides), -1)
    found = []
    for column in near.T:
        kept = np.flatnonzero(~_is_parted(sides, flat[column], tree))
        found.append(_blank(kept, first + column[kept], _TOWARDS * weights[kept], sides[kept]))
    return found


def _blank(one: Numbers, other: Numbers, weight: Floats, at: Floats) -> _Pairs:
    nothing = np.full(len(one), Drawn.NOTHING.value)
    return _Pairs(one, other, nothing, weight, np.full(len(one), NO_LINE), at)


def _is_parted(one: Floats, other: Floats, tree: shapely.STRtree | None) -> npt.NDArray[np.bool_]:
    """(n,) whether a stroke runs between two places."""
    parted = np.zeros(len(one), bool)
    if tree is not None and len(one):
        probes = shapely.linestrings(np.stack([one, other], axis=1))
        parted[tree.query(probes, predicate="intersects")[0]] = True
    return parted
