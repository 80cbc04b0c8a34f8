"""Writing that a file draws, letter by letter, of strokes or filled areas, or beside its texts.

A letter is a few strokes of one pen that touch each other and nothing longer; letters stand in
rows, alike in height, and of many shapes: the holes of a pattern and the dashes of a line are all
alike.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.file_reading.strokes_in_texts import TALLEST, strokes_within_texts
from gaussiancad_core.files.vectors import StrokeRole
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.near_points import connected_groups, near_pairs, pairs_between
from gaussiancad_core.geometry.points import Box, Point
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperSheet, PaperStroke, Points

_SMALLEST = 0.15
"""mm of a letter at least."""

_LONGEST = 3.0
"""Length of a stroke of a letter at most, in the tallest letter's height."""

_TOUCH = 0.06
"""mm within which strokes touch."""

_FEWEST_STROKES, _FEWEST_LETTERS = 6, 3
"""Strokes of a pen that writes, and letters, at least."""

_FEWEST_IN_WORD = 2
"""Letters of a word at least."""

_FEWEST_DRAWN = 4
"""Strokes of a word that is drawn of lines at least."""

_REACH, _LEAST_REACH = 1.7, 1.2
"""Distance of the middles of neighbouring letters at most, in the height of one, which counts as so
many mm at least."""

_LEVEL, _MIDDLE = 0.45, 0.3
"""Share of the height by which the feet, or the middles, of neighbouring letters differ."""

_LOWEST = 0.5
"""mm of the height of neighbouring letters at least: dashes in a row have none."""

_SPACE, _SPACE_BESIDES = 0.9, 0.3
"""Gap between letters at most, in their height, and mm besides."""

_PLAIN = 0.6
"""Share of letters from which they are holes and dashes where so many are one line or circle."""

_ROUND, _FLAT = 0.05, 1e-3
"""mm within which the ends of strokes lie on one circle; product of their spreads along and across
in the square of the sum, under which they are in line."""

_MAY_WRITE = (StrokeRole.OTHER, StrokeRole.UNKNOWN)
"""What strokes stand for by their names of which letters may be drawn."""

_CONCENTRIC = 0.05
"""mm within which arcs have one middle."""


def drawn_words(strokes: Sequence[PaperStroke]) -> tuple[list[Box], list[int]]:
    """The boxes of words that are drawn letter by letter, and the numbers of their strokes, which
    may be the chords of curves: no curve need be made whole first."""
    return _drawn_words(LabelledStrokes.open(strokes))


def _drawn_words(labelled: LabelledStrokes) -> tuple[list[Box], list[int]]:
    words, members = [], []
    for numbers in _by_pen(labelled):
        others = _long_ends(labelled.strokes, numbers)
        found, of_words = _words(labelled.strokes, numbers, others, _FEWEST_DRAWN)
        words += found
        members += of_words
    return words, members


def folded_letters(
    sheet: PaperSheet, labelled: LabelledStrokes
) -> tuple[LabelledStrokes, list[Box], set[int]]:
    """The strokes, those of letters told; the boxes of words; numbers of fills that are letters.

    Args:
        sheet: with its texts and fills.
        labelled: its strokes.
    """
    boxes = [text.box for text in sheet.texts]
    within, fills = (
        strokes_within_texts(labelled.strokes, boxes),
        strokes_within_texts(sheet.fills, boxes),
    )
    labelled = labelled.with_label(within, Label.TEXT, "within a text of the file")
    words, members = _drawn_words(labelled)
    labelled = labelled.with_label(members, Label.TEXT, "row of drawn letters")
    words = [*boxes, *words]
    in_texts = set(fills)
    free = [n for n in range(len(sheet.fills)) if n not in in_texts]
    for colour in dict.fromkeys(sheet.fills[number].pen.colour for number in free):
        numbers = [
            number
            for number in free
            if sheet.fills[number].pen.colour == colour and sheet.fills[number].size <= TALLEST
        ]
        found, members = _words(sheet.fills, numbers, None, 1)
        fills += members
        words += found
    return labelled, words, set(fills)


def _by_pen(labelled: LabelledStrokes) -> Iterable[list[int]]:
    """Numbers of the strokes of each pen that may be letters."""
    of_pen: dict[object, list[int]] = {}
    for number in labelled.numbers(Label.OPEN):
        stroke = labelled.strokes[number]
        if stroke.dashes or stroke.role not in _MAY_WRITE or stroke.size > TALLEST:
            continue
        if stroke.length <= _LONGEST * TALLEST:
            of_pen.setdefault(stroke.pen, []).append(number)
    return of_pen.values()


def _long_ends(strokes: Sequence[PaperStroke], numbers: Sequence[int]) -> Points | None:
    """The ends of a pen's other strokes, which letters do not touch."""
    if not numbers:
        return None
    chosen = set(numbers)
    pen = strokes[numbers[0]].pen
    others = [
        end
        for number, stroke in enumerate(strokes)
        if number not in chosen and (stroke.pen is pen or stroke.pen == pen)
        for end in _both_ends(stroke)
    ]
    return np.array(others) if others else None


@dataclass(frozen=True, eq=False)
class _Letter:
    """Strokes that touch.

    Attributes:
        numbers: of the strokes.
        low, high: (2,) mm, corners of the box around them.
        is_plain: whether it is one line or circle, or arcs about one middle.
    """

    numbers: list[int]
    low: Points
    high: Points
    is_plain: bool


def _words(
    strokes: Sequence[PaperStroke], numbers: Sequence[int], others: Points | None, fewest: int
) -> tuple[list[Box], list[int]]:
    """The boxes of words of so many strokes or more, and the numbers of the strokes that they are
    drawn of."""
    if len(numbers) < _FEWEST_STROKES:
        return [], []
    letters = _letters(strokes, numbers, others)
    if len(letters) < _FEWEST_LETTERS:
        return [], []
    low = np.array([letter.low for letter in letters])
    high = np.array([letter.high for letter in letters])
    words = [row for row in _rows(low, high) if _is_word(row, letters, low, high, fewest)]
    # A pen that writes but two letters on all of a sheet does not write.
    if fewest > 1 and len(words) == 1 and len(words[0]) == _FEWEST_IN_WORD:
        return [], []
    boxes = [(*low[row].min(axis=0).tolist(), *high[row].max(axis=0).tolist()) for row in words]
    return boxes, [number for row in words for index in row for number in letters[index].numbers]


def _is_word(
    row: Sequence[int], letters: Sequence[_Letter], low: Points, high: Points, fewest: int
) -> bool:
    """Whether letters in a row are a word: neither of a size, nor holes and dashes."""
    if len(row) < _FEWEST_IN_WORD or sum(len(letters[index].numbers) for index in row) < fewest:
        return False
    sizes = np.round((high - low)[list(row)], 1)
    if len(row) > _FEWEST_IN_WORD and len(np.unique(sizes, axis=0)) == 1:
        return False
    return sum(letters[index].is_plain for index in row) <= _PLAIN * len(row)


def _letters(
    strokes: Sequence[PaperStroke], numbers: Sequence[int], others: Points | None
) -> list[_Letter]:
    """Groups of strokes that touch each other and nothing longer, as small as letters."""
    chains = [_corners(strokes[number]) for number in numbers]
    points = np.array([point for chain in chains for point in chain])
    owners = np.repeat(np.arange(len(numbers)), [len(chain) for chain in chains])
    groups = connected_groups(owners[near_pairs(points, _TOUCH)], len(numbers))
    touching: set[int] = set()
    if others is not None:
        is_near = pairs_between(points, others, _TOUCH)[:, 0]
        touching = set(groups[owners[is_near]].tolist())
    group_of = groups[owners]
    round_ones = _are_round(points, group_of)
    low, high = _extents(points, group_of)
    members: dict[int, list[int]] = {}
    for number, group in zip(numbers, groups.tolist(), strict=True):
        members.setdefault(group, []).append(number)
    found = []
    fits = ((high - low).max(axis=1) >= _SMALLEST) & ((high - low).max(axis=1) <= TALLEST)
    for group in np.flatnonzero(fits).tolist():
        if group not in touching:
            held = members[group]
            is_plain = round_ones[group] or _is_plain([strokes[n] for n in held])
            found.append(_Letter(held, low[group], high[group], bool(is_plain)))
    return found


def _corners(stroke: PaperStroke) -> list[Point]:
    """Corners of a chain along a stroke, mm."""
    if isinstance(stroke.curve, LineSegment):
        return [stroke.curve.start, stroke.curve.end]
    return [(x, y) for x, y in stroke.points.tolist()]


def _both_ends(stroke: PaperStroke) -> tuple[Point, Point]:
    corners = _corners(stroke)
    return corners[0], corners[-1]


def _extents(points: Points, groups: npt.NDArray[np.int64]) -> tuple[Points, Points]:
    """(m, 2) low and high corners of the boxes around each group of (n, 2) points."""
    count = int(groups.max()) + 1
    low, high = np.full((count, 2), np.inf), np.full((count, 2), -np.inf)
    np.minimum.at(low, groups, points)
    np.maximum.at(high, groups, points)
    return low, high


def _are_round(points: Points, groups: npt.NDArray[np.int64]) -> npt.NDArray[np.bool_]:
    """(m,) which groups of (n, 2) points lie around on one circle, as the chords of a hole do: by
    the circle with the least squares of its equation (Kåsa), of all groups at once."""
    counts = np.bincount(groups)

    def mean(values: Points) -> Points:
        return np.bincount(groups, values) / counts

    middles = np.stack([mean(points[:, 0]), mean(points[:, 1])], axis=1)
    x, y = (points - middles[groups]).T
    squares = x * x + y * y
    xx, xy, yy = mean(x * x), mean(x * y), mean(y * y)
    right, upward = 0.5 * mean(squares * x), 0.5 * mean(squares * y)
    determinant = xx * yy - xy * xy
    is_flat = determinant <= _FLAT * (xx + yy) ** 2
    under = np.where(is_flat, 1.0, determinant)
    centre = np.stack([right * yy - upward * xy, upward * xx - right * xy], axis=1)
    centre /= under[:, None]
    radii = np.sqrt(mean(squares) + (centre**2).sum(axis=1))
    away = np.hypot(x - centre[groups, 0], y - centre[groups, 1]) - radii[groups]
    is_near = np.ones(len(counts), dtype=bool)
    is_near[groups[np.abs(away) > _ROUND]] = False
    return np.asarray(is_near & ~is_flat & (counts > 2 * _FEWEST_STROKES))


def _is_plain(strokes: Sequence[PaperStroke]) -> bool:
    if len(strokes) == 1:
        return strokes[0].is_line or strokes[0].is_circle
    centres = [s.curve.centre for s in strokes if isinstance(s.curve, CircularArc)]
    return len(centres) == len(strokes) and float(np.ptp(centres, axis=0).max()) < _CONCENTRIC


def _rows(low: Points, high: Points) -> list[list[int]]:
    """Numbers of letters that stand in rows, across the sheet or up it."""
    middles, sizes = (low + high) / 2.0, high - low
    reach = _REACH * np.maximum(sizes.max(axis=1), _LEAST_REACH)
    one, other = _near_pairs(middles, reach).T
    if not len(one):
        return []
    linked = np.zeros(len(one), dtype=bool)
    for axis in (0, 1):
        across = 1 - axis
        height = np.maximum(sizes[one, across], sizes[other, across])
        feet = np.abs(high[one, across] - high[other, across]) <= _LEVEL * height
        middle = np.abs(middles[one, across] - middles[other, across]) <= _MIDDLE * height
        gap = np.maximum(low[one, axis] - high[other, axis], low[other, axis] - high[one, axis])
        is_next = gap <= _SPACE * height + _SPACE_BESIDES
        linked |= (height >= _LOWEST) & (feet | middle) & is_next
    groups = connected_groups(np.stack([one[linked], other[linked]], axis=1), len(low))
    rows: dict[int, list[int]] = {}
    for index, group in enumerate(groups.tolist()):
        rows.setdefault(group, []).append(index)
    return list(rows.values())


def _near_pairs(middles: Points, reach: Points) -> npt.NDArray[np.int64]:
    """(m, 2) numbers of letters of which one reaches the other: a point is small beside a digit.

    Letters of one size are asked at a time, the largest of which reach over hundreds of small ones.
    """
    sizes = np.floor(np.log2(reach))
    found = [np.zeros((0, 2), dtype=np.int64)]
    for size in np.unique(sizes):
        numbers = np.flatnonzero(sizes <= size)
        near = float(reach[sizes == size].max())
        pairs = numbers[near_pairs(middles[numbers], near)]
        pairs = pairs[(sizes[pairs] == size).any(axis=1)]
        apart = np.hypot(*(middles[pairs[:, 0]] - middles[pairs[:, 1]]).T)
        found.append(pairs[apart <= reach[pairs].max(axis=1)])
    return np.concatenate(found)
