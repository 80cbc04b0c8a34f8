"""What a line is by those that it meets: edges end at edges, and a figure is of one kind.

The network sees each pixel's surroundings; that an outline closes it does not ask.  Three relations
say more: an edge that ends where no other edge or break line is costs something, so that a doubtful
piece between two loose ends is an edge; so does annotation that ends at a corner, as edges do, for
its lines run past each other or end at nothing; and lines that hang together are all of a view or
all of a pictorial.
"""

from collections.abc import Iterable, Sequence

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from gaussiancad_core.sheet.annotations.inked_shapes import InkedShape, points_along
from gaussiancad_core.sheet.labels.ink_classes import PART, InkClass
from gaussiancad_core.sheet.labels.line_decoding import LabelledRun
from gaussiancad_core.sheet.log_odds import SURE
from gaussiancad_core.sheet.picture_noise import COARSE_STEP

Floats = npt.NDArray[np.float64]

_LOOSE_END = 6.0
"""Cost of an end of a visible edge at which there is no other edge, as log-odds."""

_BROKEN_END = 3.0
"""The same where it meets what may be a break line."""

_CORNER = 2.0
"""Cost of an end of annotation that meets the end of a line of another direction; hatching ends
where edges do."""

_BENT = 0.3
"""Sine of the angle between two directions from which they make a corner."""

_REACH = 1.2
"""Distance from an end to the edge that it meets at most, in stroke widths."""

_SPARE_PX = 2.0
"""The same, px more."""

_ROUNDS = 20
"""Turns of one group or piece after which it is enough."""

_LEAST_GAIN = 1e-9
"""What a turn has to save at least."""

Labelled = list[list[LabelledRun]]


def related(shapes: Sequence[InkedShape], labelled: Labelled, stroke_width: float) -> Labelled:
    """The labels of pieces, changed where those of their neighbours say otherwise.

    Args:
        shapes: lines and circles.
        labelled: the pieces of each.
        stroke_width: px.
    """
    pieces = [run for each in labelled for run in each]
    if not pieces:
        return labelled
    points = [
        points_along(shape.geometry, run.run.run, COARSE_STEP)
        for shape, each in zip(shapes, labelled, strict=True)
        for run in each
    ]
    ends = _meetings(points, _REACH * stroke_width + _SPARE_PX)
    pieces = _of_one_figure(pieces, ends)
    corners = _corners(points, _REACH * stroke_width + _SPARE_PX)
    pieces = _without_loose_ends(pieces, ends, corners)
    rest = iter(pieces)
    return [[next(rest) for _ in each] for each in labelled]


def _meetings(points: Sequence[Floats], reach: float) -> list[tuple[list[int], list[int]]]:
    """For both ends of each piece the others that pass there."""
    every = np.concatenate(points)
    owner = np.repeat(np.arange(len(points)), [len(point) for point in points])
    tree = cKDTree(every)
    firsts = tree.query_ball_point(np.array([point[0] for point in points]), reach)
    lasts = tree.query_ball_point(np.array([point[-1] for point in points]), reach)
    return [
        (
            sorted(set(owner[near_first].tolist()) - {k}),
            sorted(set(owner[near_last].tolist()) - {k}),
        )
        for k, (near_first, near_last) in enumerate(zip(firsts, lasts, strict=True))
    ]


def _corners(points: Sequence[Floats], reach: float) -> npt.NDArray[np.int64]:
    """(n,) how many ends of each piece meet an end of one of another direction."""
    ends = np.array([(point[0], point[-1]) for point in points]).reshape(-1, 2)
    ways = np.array([(point[1] - point[0], point[-1] - point[-2]) for point in points])
    ways = ways.reshape(-1, 2) / np.maximum(np.hypot(*ways.reshape(-1, 2).T), 1e-9)[:, None]
    one, other = cKDTree(ends).query_pairs(reach, output_type="ndarray").reshape(-1, 2).T
    bent = np.abs(ways[one, 0] * ways[other, 1] - ways[one, 1] * ways[other, 0]) > _BENT
    met = np.zeros(len(ends), bool)
    met[one[bent]] = met[other[bent]] = True
    return met.reshape(-1, 2).sum(axis=1)


def _of_one_figure(
    pieces: list[LabelledRun], ends: list[tuple[list[int], list[int]]]
) -> list[LabelledRun]:
    """Pieces of a view or a pictorial, as most of what hangs together with them is."""
    kinds = (*PART, InkClass.PICTORIAL)
    figure = np.array([piece.ink in kinds for piece in pieces])
    pairs = [(k, j) for k, both in enumerate(ends) for near in both for j in near]
    pairs = [(k, j) for k, j in pairs if figure[k] and figure[j]]
    groups = _components(len(pieces), pairs)
    turned = list(pieces)
    for group in _members(groups):
        members = [k for k in group if figure[k]]
        pictorial = [k for k in members if pieces[k].ink is InkClass.PICTORIAL]
        if not pictorial or len(pictorial) == len(members):
            continue
        odds = sum(
            pieces[k].run.run.length
            * (pieces[k].log_p[InkClass.PICTORIAL] - np.logaddexp(*pieces[k].log_p[list(PART)]))
            for k in members
        )
        total = sum(pieces[k].run.run.length for k in members)
        for k in members:
            pictured = pieces[k].ink is InkClass.PICTORIAL
            if odds > 0.0 and not pictured:
                turned[k] = pieces[k].as_figure(InkClass.PICTORIAL, odds / total)
            elif odds <= 0.0 and pictured:
                turned[k] = pieces[k].no_longer(InkClass.PICTORIAL)
    return turned


def _without_loose_ends(
    pieces: list[LabelledRun],
    ends: list[tuple[list[int], list[int]]],
    corners: npt.NDArray[np.int64],
) -> list[LabelledRun]:
    """Turn pieces, or groups of doubtful ones that hang together, as long as that costs less."""
    touched: list[set[int]] = [set() for _ in pieces]
    for k, both in enumerate(ends):
        for j in (*both[0], *both[1]):
            touched[j].add(k)
    # What the rest of its line decided against its own ink stays as it is.
    doubtful = {
        k
        for k, piece in enumerate(pieces)
        if abs(piece.margin) <= SURE and piece.is_part is (piece.margin > 0.0)
    }
    part = [piece.is_part for piece in pieces]
    pairs = [(k, j) for k in doubtful for near in ends[k] for j in near if j in doubtful]
    apart = [(k, j) for k, j in pairs if not part[k] and not part[j]]
    # What hangs together by itself, and by edges in doubt between.
    together = {
        frozenset(k for k in group if k in doubtful and not part[k])
        for by in (apart, pairs)
        for group in _members(_components(len(pieces), by))
    }
    chosen = [{k} for k in sorted(doubtful)]
    chosen += [set(items) for items in sorted(together, key=sorted) if len(items) > 1]

    def looseness(near: Sequence[int]) -> float:
        if any(part[j] for j in near):
            return 0.0
        broken = any(pieces[j].ink is InkClass.OTHER for j in near)
        return _BROKEN_END if broken else _LOOSE_END

    def cost(around: Iterable[int]) -> float:
        total = 0.0
        for k in around:
            total -= pieces[k].evidence * (0.5 if part[k] else -0.5)
            if not part[k] and pieces[k].ink is not InkClass.HATCHING:
                total += _CORNER * float(corners[k])
            if part[k] and pieces[k].log_p[InkClass.VISIBLE] >= pieces[k].log_p[InkClass.HIDDEN]:
                total += sum(looseness(near) for near in ends[k])
        return total

    surroundings = [set(group).union(*(touched[k] for k in group)) for group in chosen]

    def turn(group: Iterable[int]) -> None:
        for k in group:
            part[k] = not part[k]

    def saved(number: int) -> float:
        group, around = chosen[number], surroundings[number]
        before = cost(around)
        turn(group)
        after = cost(around)
        turn(group)
        return before - after

    asking: list[list[int]] = [[] for _ in pieces]
    for number, around in enumerate(surroundings):
        for k in around:
            asking[k].append(number)
    supports: dict[int, float] = {}
    gains = np.array([saved(number) for number in range(len(chosen))])
    for _ in range(_ROUNDS):
        if not (gains > _LEAST_GAIN).any():
            break
        best = int(gains.argmax())
        turned = chosen[best]
        supports.update(dict.fromkeys(turned, float(gains[best])))
        turn(turned)
        # What others save depends on their surroundings and on what the ends of these meet.
        changed = turned.union(*(touched[k] for k in turned))
        for number in {number for k in changed for number in asking[k]}:
            gains[number] = saved(number)
    return [
        piece if piece.is_part is state else piece.turned(supports.get(k))
        for k, (piece, state) in enumerate(zip(pieces, part, strict=True))
    ]


def _members(groups: npt.NDArray[np.int32]) -> list[list[int]]:
    """The members of each group, ascending, by the groups' numbers."""
    order = np.argsort(groups, kind="stable")
    starts = np.flatnonzero(np.diff(groups[order])) + 1
    return [values.tolist() for values in np.split(order, starts)]


def _components(count: int, pairs: Sequence[tuple[int, int]]) -> npt.NDArray[np.int32]:
    """(count,) the number of the group that each belongs to."""
    rows, columns = np.array(pairs, dtype=np.int64).reshape(-1, 2).T
    graph = coo_array((np.ones(len(rows)), (rows, columns)), shape=(count, count))
    return connected_components(graph, directed=False)[1]
