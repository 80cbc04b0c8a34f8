"""Letters and digits on a sheet: small pieces of ink that no long line or circle explains."""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.corner_pieces import is_dash_corner
from gaussiancad_core.sheet.annotations.dash_rows import are_dashes
from gaussiancad_core.sheet.annotations.dash_stars import is_dash_star
from gaussiancad_core.sheet.annotations.letter_boxes import enclosed, is_boxed
from gaussiancad_core.sheet.annotations.marks import Mark, Mask
from gaussiancad_core.sheet.annotations.pockets import are_pockets

_TALLEST = 0.04
"""Height of a letter at most, as a share of the sheet's longest side."""

_EXPLAINED = 0.5
"""Share of a piece's ridge points from which shapes explain it: a dash, a small circle."""

_PARTLY = 0.3
"""Share of its ink from which a lone piece may be the corner of two dashed lines, of which one is
too short to be known as dashed."""

_LOWER, _TALLER = 0.5, 1.5
"""Height of a word in a view at least, in that of most words beside the views, and at most, in that
of the tallest."""

_HIGHER = 1.5
"""Height of a piece that lines explain in part, in that of most letters, from which it is a line
that ends with an open arrowhead at another one."""

_SPACING = 0.9
"""Gap between the letters of a word at most, in heights of a letter."""

_SHARED = 0.3
"""Share of their height, or breadth, in which letters of a word are level with each other."""

_SMALLEST_PX = 4

_SLIM = 0.4
"""Breadth of a dash, a one or an I at most, in its height."""

_POINT = 0.35
"""Height of a point or comma at most, in heights of a letter; dashes are longer."""

_HANGING = 0.4
"""Distance from their word at most, in heights of a letter."""

_CONCENTRIC = 0.12
"""Distance between the centres of pieces, as a share of the largest, up to which they are rings
and crosses around one centre."""

_BESIDE_LINE, _NEXT_ROW = 0.4, 0.5
"""Distance of a letter's middle from the line of its word at most, and from that of the next row at
least, in heights of a letter."""

_STRAIGHT = 1.35
"""Ink of a straight piece at most, in stroke widths times its diagonal."""

_THIN, _STRAIGHT_THIN = 0.8, 1.2
"""Share of the stroke width under which a piece is thinner than lines, as letters may be, and what
its ink then is at most, in its own width times its diagonal."""


@dataclass(frozen=True, eq=False)
class Letters:
    """The writing on a sheet.

    Attributes:
        mask: (h, w) bool, its ink.
        marks: one a word or line of words.
    """

    mask: Mask
    marks: tuple[Mark, ...]


def find_letters(ink: Mask, explained: Mask, stroke_width: float) -> Letters:
    """Find the writing.

    Args:
        ink: (h, w) bool, without the frame.
        explained: (h, w) bool, pixels near ridge points of shapes that are no parts of letters.
        stroke_width: px, the mean over the sheet.
    """
    tallest = _TALLEST * max(ink.shape)
    _, labels, stats, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    count = len(stats)
    sizes = stats[:, cv2.CC_STAT_AREA].astype(float)
    told = np.bincount(labels[explained & ink], minlength=count) / np.maximum(sizes, 1.0)
    long_side = np.maximum(stats[:, cv2.CC_STAT_WIDTH], stats[:, cv2.CC_STAT_HEIGHT])
    small = (long_side <= tallest) & (long_side >= _SMALLEST_PX)
    small[0] = False
    # A straight piece is a dash or a one: only its neighbours can tell.  Its area says so quickly,
    # but not where a threshold made it a pixel wider.
    own = _own_width(ink, labels, sizes)
    widths = np.where(own < _THIN * stroke_width, _STRAIGHT_THIN * own, _STRAIGHT * stroke_width)
    straight = sizes < widths * np.hypot(stats[:, 2], stats[:, 3])
    seeds = small & (told < _EXPLAINED) & ~straight
    for label in np.flatnonzero(seeds):
        seeds[label] = _breadth(labels, stats, label) > _STRAIGHT * stroke_width
    if not seeds.any():
        return Letters(np.zeros_like(ink), ())
    seeds &= (long_side <= _HIGHER * np.median(long_side[seeds])) | (told <= _PARTLY)
    glyphs = np.flatnonzero(seeds)
    words = _words(stats, glyphs, np.flatnonzero(small & ~seeds))
    corners = set(glyphs[told[glyphs] > _PARTLY].tolist())
    words = [word for word in words if not are_pockets(labels, stats, word, stroke_width)]
    pieces = set(glyphs.tolist()), corners
    words = _not_of_the_part(words, labels, stats, pieces, stroke_width)
    chosen = np.zeros(count, dtype=bool)
    marks = []
    for word in words:
        # Dots of a centre line beside a word are explained by it.
        points = [piece for piece in _points(stats, word) if told[piece] < _EXPLAINED]
        whole = [*word, *points]
        chosen[whole] = True
        marks.append(Mark(AnnotationKind.TEXT, _box_of(stats, whole)))
    return Letters(chosen[labels], tuple(marks))


def _own_width(
    ink: Mask, labels: npt.NDArray[np.int32], sizes: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """(n,) px, the mean width of each piece's strokes: across one, the distances to its sides are
    half of it at most, and half of that in the mean."""
    inside = cv2.distanceTransform(ink.astype(np.uint8), cv2.DIST_L2, 3)
    total = np.bincount(labels[ink], weights=inside[ink], minlength=len(sizes))
    # The distance of a pixel's centre to the side is half a pixel less.
    return 4.0 * (total / np.maximum(sizes, 1.0) - 0.5)


def _points(stats: npt.NDArray[np.int32], word: list[int]) -> list[int]:
    """The pieces that are points, commas and the like between a word's letters."""
    heights = stats[word, 2:4].max(axis=1)
    height = float(np.median(heights))
    x0, y0, x1, y1 = _box_of(stats, word)
    # A comma hangs below its line, and words may end at a point.
    slack = _HANGING * height
    low, high = stats[:, :2], stats[:, :2] + stats[:, 2:4]
    near = ((low <= (x1 + slack, y1 + slack)) & (high >= (x0 - slack, y0 - slack))).all(axis=1)
    middles = (low + high) / 2.0
    level = ((middles >= (x0, y0)) & (middles <= (x1, y1))).any(axis=1)
    point = near & level & (stats[:, 2:4].max(axis=1) <= _POINT * height)
    return [piece for piece in np.flatnonzero(point).tolist() if piece not in word]


def _breadth(labels: npt.NDArray[np.int32], stats: npt.NDArray[np.int32], label: int) -> float:
    """The shorter side in px of the smallest rectangle around the centres of a piece's pixels."""
    x, y, width, height = (int(value) for value in stats[label, :4])
    rows, columns = np.nonzero(labels[y : y + height, x : x + width] == label)
    return min(cv2.minAreaRect(np.stack([columns, rows], axis=1).astype(np.float32))[1])


def _not_of_the_part(
    words: list[list[int]],
    labels: npt.NDArray[np.int32],
    stats: npt.NDArray[np.int32],
    pieces: tuple[set[int], set[int]],
    stroke_width: float,
) -> list[list[int]]:
    """The words without what may be a small slot or pocket: a lone piece inside a view that no box
    is drawn around, corners of dashed lines with the dashes beside them, a bore with its mark, or
    pieces that are taller, or lower, than what is written beside the views.

    Where nothing is written beside the views, nothing is written in them.

    Args:
        words: numbers of pieces.
        labels, stats: of all pieces.
        pieces: those that are letters by themselves, and which of them may be corners.
        stroke_width: px.
    """
    _, areas, facts, _ = cv2.connectedComponentsWithStats(
        (labels == 0).astype(np.uint8), connectivity=4
    )
    outside = 1 + int(np.argmax(facts[1:, cv2.CC_STAT_AREA]))
    words = [
        part for word in words for part in _parted(word, areas, labels, stats, outside) if part
    ]
    around = [_paper_around(areas, labels, stats, word) for word in words]
    beside = [word for word, own in zip(words, around, strict=True) if outside in own]
    if not beside:
        return []
    heights = [int(stats[word, 2:4].max()) for word in beside]
    least, most = _LOWER * float(np.median(heights)), _TALLER * max(heights)

    def is_word(word: list[int], paper: set[int]) -> bool:
        if outside in paper:
            return True
        if stats[word, 2:4].max() > most:
            return False
        if len(word) == 1:
            return any(
                is_boxed(
                    facts[own, :4],
                    stats[word[0], :4],
                    int(enclosed(areas, own, facts[own, :4]).sum()),
                )
                for own in paper
            )
        x0, y0, x1, y1 = _box_of(stats, word)
        # A word is as high as its box, or as wide where it is written upwards.
        if min(x1 - x0, y1 - y0) < least:
            return False
        own = [piece for piece in word if piece in pieces[0]]
        if (
            _is_corner(word, *pieces)
            or _is_concentric(word, stats)
            or all(_is_dash_corner(labels, stats[piece], piece, stroke_width) for piece in own)
        ):
            return False
        boxes = stats[word, :4].astype(float)
        return _is_in_line(boxes, [piece in pieces[0] for piece in word]) and not are_dashes(boxes)

    return [word for word, paper in zip(words, around, strict=True) if is_word(word, paper)]


def _parted(
    word: list[int],
    areas: npt.NDArray[np.int32],
    labels: npt.NDArray[np.int32],
    stats: npt.NDArray[np.int32],
    outside: int,
) -> tuple[list[int], list[int]]:
    """The pieces of a word that have the paper around the views beside them, and the others: an
    outline runs between what is written beside a view and what stands in it."""
    beside = [piece for piece in word if outside in _paper_around(areas, labels, stats, [piece])]
    return beside, [piece for piece in word if piece not in beside]


def _is_corner(word: list[int], glyphs: set[int], corners: set[int]) -> bool:
    """Whether all letters of a word may be corners of dashed lines."""
    return not (glyphs & set(word)) - corners


def _is_dash_corner(
    labels: npt.NDArray[np.int32], stat: npt.NDArray[np.int32], piece: int, stroke_width: float
) -> bool:
    """Whether a letter may be the dashes of two edges that meet, or of three, each of which goes on
    no farther away than they are long."""
    x, y, width, height = (int(value) for value in stat[:4])
    own = labels[y : y + height, x : x + width] == piece
    gap = float(max(width, height))
    of_two = float(own.sum()) / (width + height)
    return is_dash_corner(labels, stat, piece, of_two, gap) or is_dash_star(
        labels, stat, piece, stroke_width, gap
    )


def _is_in_line(boxes: npt.NDArray[np.float64], letters: list[bool]) -> bool:
    """Whether pieces stand in a row, or in a few below each other with two letters each at least;
    dashes stand around what they bound.

    Args:
        boxes: (n, 4) x, y, width, height.
        letters: whether each is a letter by itself.
    """
    centres = boxes[:, :2] + boxes[:, 2:] / 2.0
    height = float(np.median(boxes[:, 2:].max(axis=1)))
    if _beside_line(centres) <= _BESIDE_LINE * height:
        return True
    own = np.array(letters)
    for axis in (1, 0):
        order = np.argsort(centres[:, axis])
        borders = np.flatnonzero(np.diff(centres[order, axis]) > _NEXT_ROW * height) + 1
        rows = np.split(order, borders)
        if len(rows) > 1 and all(
            own[row].sum() >= 2 and _beside_line(centres[row]) <= _BESIDE_LINE * height
            for row in rows
        ):
            return True
    return False


def _beside_line(points: npt.NDArray[np.float64]) -> float:
    """px by which points (n, 2) lie beside the line through them at most."""
    off = points - points.mean(axis=0)
    normal = np.linalg.svd(off, full_matrices=False)[2][-1]
    return float(np.abs(off @ normal).max()) if len(points) > 2 else 0.0


def _is_concentric(word: list[int], stats: npt.NDArray[np.int32]) -> bool:
    """Whether the pieces of a word lie around one centre; letters stand beside each other."""
    boxes = stats[word, :4].astype(float)
    centres = boxes[:, :2] + boxes[:, 2:] / 2.0
    largest = float(boxes[:, 2:].max())
    return bool(np.ptp(centres, axis=0).max() < _CONCENTRIC * largest)


def _paper_around(
    areas: npt.NDArray[np.int32],
    labels: npt.NDArray[np.int32],
    stats: npt.NDArray[np.int32],
    word: list[int],
) -> set[int]:
    """The areas of blank paper beside a word's largest piece."""
    largest = max(word, key=lambda piece: int(stats[piece, cv2.CC_STAT_AREA]))
    x, y, width, height = (int(value) for value in stats[largest, :4])
    window = slice(max(y - 2, 0), y + height + 2), slice(max(x - 2, 0), x + width + 2)
    own = (labels[window] == largest).astype(np.uint8)
    ring = (cv2.dilate(own, np.ones((3, 3), np.uint8)) > 0) & (own == 0)
    return {int(area) for area in np.unique(areas[window][ring])}


def _words(
    stats: npt.NDArray[np.int32], glyphs: npt.NDArray[np.int64], others: npt.NDArray[np.int64]
) -> list[list[int]]:
    """Groups of letters; pieces that shapes explain (an O, an I, a minus) join where letters of
    about their height stand beside them."""
    heights = np.maximum(stats[:, cv2.CC_STAT_WIDTH], stats[:, cv2.CC_STAT_HEIGHT])
    words: list[list[int]] = []
    for glyph in sorted(glyphs, key=lambda g: -int(heights[g])):
        reach = _SPACING * float(heights[glyph])
        near = [
            word
            for word in words
            if any(_gap(stats, glyph, o) <= reach and _is_level(stats, glyph, o) for o in word)
        ]
        merged = [int(glyph)] + [member for word in near for member in word]
        words = [word for word in words if word not in near] + [merged]
    letters = {int(glyph) for glyph in glyphs}
    waiting, before = [int(other) for other in others], -1
    # The one that joins may be what the next one stands beside.
    while len(waiting) != before:
        before = len(waiting)
        waiting = [other for other in waiting if not _joins(stats, words, letters, other)]
    return words


def _joins(
    stats: npt.NDArray[np.int32], words: list[list[int]], letters: set[int], other: int
) -> bool:
    """Put a piece into the word that it fits, in place, and make one of those that it stands
    between; whether there is any.

    A slim piece must stand beside a letter, or between two broad pieces of a word, as an I does
    among letters of straight strokes: dashes would join one after the other.
    """
    heights = np.maximum(stats[:, cv2.CC_STAT_WIDTH], stats[:, cv2.CC_STAT_HEIGHT])
    slim = _is_slim(stats[other])
    fitting = []
    for word in words:
        near = [o for o in word if o in letters] if slim else word
        if slim and _stands_between(stats, word, other):
            near = [o for o in word if not _is_slim(stats[o])]
        beside = [o for o in near if _gap(stats, other, o) <= 0.6 * heights[o]]
        least = 0.25 if slim and len(word) >= 2 else 0.7
        if any(least < heights[other] / heights[o] < 1.4 for o in beside):
            fitting.append(word)
    if not fitting:
        return False
    words[:] = [word for word in words if word not in fitting]
    words.append([other] + [member for word in fitting for member in word])
    return True


def _is_slim(stat: npt.NDArray[np.int32]) -> bool:
    return bool(min(stat[2:4]) < _SLIM * max(stat[2:4]))


def _stands_between(stats: npt.NDArray[np.int32], word: list[int], other: int) -> bool:
    """Whether an upright piece has broad pieces of a word close by on its left and on its right, or
    a level one above and below, where writing goes upwards."""
    x, y, width, height = (int(value) for value in stats[other, :4])
    axis, reach = (0, 0.6 * height) if height > width else (1, 0.6 * width)
    middle = (x, y)[axis] + (width, height)[axis] / 2.0
    broad = [o for o in word if not _is_slim(stats[o]) and _gap(stats, o, other) <= reach]
    middles = [stats[o, axis] + stats[o, 2 + axis] / 2.0 for o in broad]
    return any(at < middle for at in middles) and any(at > middle for at in middles)


def _gap(stats: npt.NDArray[np.int32], one: int, other: int) -> float:
    """Distance between two pieces' boxes in px."""
    ax, ay, aw, ah = (int(v) for v in stats[one, :4])
    bx, by, bw, bh = (int(v) for v in stats[other, :4])
    dx = max(ax - bx - bw, bx - ax - aw, 0)
    dy = max(ay - by - bh, by - ay - ah, 0)
    return float(np.hypot(dx, dy))


def _is_level(stats: npt.NDArray[np.int32], one: int, other: int) -> bool:
    """Whether two pieces are beside each other or one below the other, and not corner to corner, as
    numbers of two dimensions are."""
    low = np.maximum(stats[one, :2], stats[other, :2])
    high = np.minimum(*(stats[piece, :2] + stats[piece, 2:4] for piece in (one, other)))
    least = _SHARED * np.minimum(stats[one, 2:4], stats[other, 2:4])
    return bool((high - low >= least).any())


def _box_of(stats: npt.NDArray[np.int32], members: list[int]) -> tuple[float, float, float, float]:
    own = stats[members].astype(float)
    low = own[:, :2].min(0)
    high = (own[:, :2] + own[:, 2:4]).max(0)
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])
