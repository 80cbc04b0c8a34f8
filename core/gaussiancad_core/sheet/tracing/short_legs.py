"""Chamfers and drill tips of a dash or less: hidden, slanted, in the ink of the strokes they join.

Most of such a leg merges with the corner that it leaves and the stroke that it meets.  But its
angle is one of a few, and what ink is left beside the others says whether it is there.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import DARK, FAINT, INFERRED, ON_LINE, STEP
from gaussiancad_core.sheet.tracing.corner_dashes import longest_blank
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm, widest_gap
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.leftover import Leftover, leftover_ink
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to
from gaussiancad_core.sheet.tracing.small_fillets import boxes_of
from gaussiancad_core.sheet.work_limits import ENDS

Floats = npt.NDArray[np.float64]

_ANGLES = np.radians([45.0, 30.0, 60.0])
"""Between a leg and the line that it leaves, the most frequent first."""

_LONGEST, _WIDE = 1.5, 4.0
"""Dashes, or line widths, that a leg is long at most: longer ones show beside the others' ink."""

_SHORTEST = 2.5
"""Line widths that it is long at least."""

_LEAST, _INKED = 2.5, 0.35
"""px of a leg's own ink at least, and share of its own way."""

_LAST_GAP = 1.1
"""Gaps of the dashes between a leg's last ink and the stroke that it meets, at most."""


@dataclass(frozen=True)
class _View:
    """Pieces of a view with their boxes, its ink, what they leave of it, and the rhythm of its
    dashes."""

    pieces: Sequence[Placed]
    boxes: Floats
    sheet: CleanSheet
    left: Leftover
    rhythm: Rhythm

    @property
    def longest(self) -> float:
        """px of a leg, at most."""
        return max(_LONGEST * self.rhythm.dash, _WIDE * self.sheet.stroke_width)


def with_short_legs(pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm) -> list[Placed]:
    """The pieces, and short legs from the ends of hidden lines to another stroke or to a tip.

    Args:
        pieces: of a view, with their ends at junctions; px, pixel centres at integers.
        sheet: its ink.
        rhythm: of its dashes.
    """
    hidden = [
        (geometry, piece)
        for geometry, piece in pieces
        if isinstance(geometry, Line) and piece.linetype is Linetype.HIDDEN
    ]
    if not hidden or 2 * len(hidden) > ENDS:
        return list(pieces)
    view = _View(pieces, boxes_of(pieces), sheet, leftover_ink(pieces, sheet), rhythm)
    found: list[tuple[Floats, Floats]] = []
    for line, piece in hidden:
        ends = line.points_at(np.array([piece.start, piece.end]))
        for legs in (*_tips(line, ends, view), *_legs(line, ends, view)):
            if not any(_is_known(leg, other) for leg in legs for other in found):
                found += legs
    return [*pieces, *(_hidden(*leg) for leg in found)]


def _tips(line: Line, ends: Floats, view: _View) -> Iterator[list[tuple[Floats, Floats]]]:
    """The two legs from both ends of a line to a tip before its middle."""
    half = 0.5 * float(np.hypot(*(ends[1] - ends[0])))
    normal = np.array([-line.direction[1], line.direction[0]])
    for angle in _ANGLES:
        if not _SHORTEST * view.sheet.stroke_width <= half / np.cos(angle) <= view.longest:
            continue
        for side in (normal, -normal):
            tip = ends.mean(0) + half * np.tan(angle) * side
            if all(_is_drawn(end, tip, view) for end in ends):
                yield [(ends[0], tip), (ends[1], tip)]


def _legs(line: Line, ends: Floats, view: _View) -> Iterator[list[tuple[Floats, Floats]]]:
    """Legs from an end of a line to the next stroke on their way."""
    along = np.array(line.direction)
    normal = np.array([-along[1], along[0]])
    places = np.arange(0.0, view.longest, STEP)
    for corner in ends:
        others: list[Placed] | None = None
        for angle in _ANGLES:
            for a, b in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
                way = a * np.cos(angle) * along + b * np.sin(angle) * normal
                points = corner + places[:, None] * way
                if (_at(view.left.ink, points) > FAINT).sum() * STEP < 0.5 * _LEAST:
                    continue
                if others is None:
                    others = _around(corner, view)
                distance = np.min([distances_to(other, points) for other in others], 0, initial=1e3)
                met = np.flatnonzero(
                    (distance < ON_LINE) & (places >= _SHORTEST * view.sheet.stroke_width)
                )
                if len(met) and _is_drawn(corner, points[met[0]], view):
                    yield [(corner, points[_nearest(distance, int(met[0]))])]


def _around(corner: Floats, view: _View) -> list[Placed]:
    """Pieces within a leg's reach that do not meet at a corner."""
    low, high = view.boxes[:, 0] - view.longest, view.boxes[:, 1] + view.longest
    near = ((low <= corner) & (corner <= high)).all(axis=1)
    around = [view.pieces[k] for k in np.flatnonzero(near).tolist()]
    return [item for item in around if distances_to(item, corner[None])[0] > ON_LINE]


def _nearest(distance: Floats, first: int) -> int:
    """The place from ``first`` on at which a stroke is reached."""
    return first + int(np.argmin(distance[first : first + 4]))


def _is_drawn(start: Floats, end: Floats, view: _View) -> bool:
    """Whether ink that other strokes leave lies on a way as dashes have it."""
    length = float(np.hypot(*(end - start)))
    points = start + np.arange(0.0, length, STEP)[:, None] * (end - start) / length
    dark = _at(view.sheet.weight, points) > DARK
    # Beside edges pale dashes stay as pale as they were plotted.
    dark |= _at(view.left.ink, points) > FAINT
    values = _at(view.left.expected, points) < FAINT
    inked = np.flatnonzero(dark & values)
    if len(inked) * STEP < _LEAST or dark[values].mean() < _INKED:
        return False
    if longest_blank(dark) * STEP > widest_gap(view.rhythm):
        return False
    # The last dash ends where the stroke begins.
    if (np.flatnonzero(values)[-1] - inked[-1]) * STEP > _LAST_GAP * view.rhythm.gap:
        return False
    return view.left.is_mostly_on(start, end, view.sheet.stroke_width)


def _at(image: npt.NDArray[np.float32], points: Floats) -> npt.NDArray[np.float32]:
    return sample(image, points[:, :1], points[:, 1:])[:, 0]


def _is_known(leg: tuple[Floats, Floats], other: tuple[Floats, Floats]) -> bool:
    """Whether two legs leave one corner to one side, or are one."""
    for start, end in (leg, leg[::-1]):
        if np.hypot(*(start - other[0])) < 1.0:
            one, two = end - start, other[1] - other[0]
            cosine = float(one @ two) / float(np.hypot(*one) * np.hypot(*two))
            if cosine > np.cos(np.radians(35.0)):
                return True
    return False


def _hidden(start: Floats, end: Floats) -> Placed:
    length = float(np.hypot(*(end - start)))
    dx, dy = (end - start) / length
    line = Line((float(start[0]), float(start[1])), (float(dx), float(dy)))
    return line, Piece(0.0, length, Linetype.HIDDEN, INFERRED)
