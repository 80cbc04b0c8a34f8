"""Frames of drawings in free space, which no paper tells from an outline.

The box around a drawing that has no paper is the drawing's own: a plate with holes spans it as a
frame does.  A frame goes around everything, notes and dimensions with it, and holds views: large
groups of lines that hold closed ones (a view with a hole, which would lie in the air otherwise), or
that have lines which end on others of them (edges; holes have none), and outlines in a row with
such.  All closed lines are of views: a hole beside what looks like one is in the part that the
outline is of.

That is certain where a table hangs together with the frame, where two boxes have the margins of
ISO 5457 between them, or where there are several views.  Else it is a guess: a plate that has a
pocket with a hole in its floor looks like a view of a smaller one in a frame.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from gaussiancad_core.files.vectors import VectorText
from gaussiancad_core.sheet.graph.stroke_groups import EVEN, Groups, grouped, within
from gaussiancad_core.sheet.graph.touching_ends import Flags, Floats, Ints, Touches
from gaussiancad_core.sheet.votes import NEARLY_ALL

_VIEW = 0.1
"""Share of a frame's width and height that a view in it has at least: engraved letters have
less."""

_FILING, _OFF = 2.0, 0.1
"""The filing margin, on the left, over the other ones, which are alike (ISO 5457: 20 and 10 mm),
and share by which margins may differ from that."""

_MOST = 6
"""Boxes around a drawing that are looked at, the largest first: frames have two or three lines."""


@dataclass(frozen=True, eq=False)
class Spanning:
    """Lines of one pen that touch and span a drawing both ways.

    Attributes:
        lines: their numbers.
        box: (4,) px around them.
        has_table: whether they make a table's cells.
    """

    lines: Ints
    box: Floats
    has_table: bool


class _Surety(Enum):
    """How sure it is that lines are a frame."""

    NONE = 0
    GUESSED = 1
    CERTAIN = 2


def free_frames(
    spanning: Sequence[Spanning],
    tables: Flags,
    annotations: Flags,
    touches: Touches,
    texts: Sequence[VectorText],
) -> tuple[Flags, bool]:
    """(n,) which strokes are frames of a drawing in free space, and whether any are a mere guess.

    Args:
        spanning: what spans the drawing.
        tables: (n,) lines of tables.
        annotations: (n,) strokes that show no part by the file's own word.
        touches: of the strokes.
        texts: of the drawing.
    """
    frames = np.zeros(len(tables), dtype=bool)
    guessed = False
    # The outer ones first: what they are leaves what the inner ones go around.
    order = sorted(spanning, key=lambda each: -float(np.prod(each.box[2:] - each.box[:2])))[:_MOST]
    for each in order:
        values = np.zeros(len(tables), dtype=bool)
        values[each.lines] = True
        rest = ~values & ~frames & ~tables
        if not _holds_all(each.box, touches.boxes[rest], texts):
            continue
        surety = _Surety.CERTAIN
        if not each.has_table:
            has_margins = any(_have_margins(each.box, other.box) for other in order)
            surety = _by_views(each.box, rest & ~annotations, touches, has_margins=has_margins)
        if surety is not _Surety.NONE:
            frames |= values
            guessed |= surety is _Surety.GUESSED
    return frames, guessed


def _holds_all(box: Floats, rest: Floats, texts: Sequence[VectorText]) -> bool:
    """Whether a box goes around all else that there is."""
    written = np.array([text.box for text in texts]).reshape(-1, 4)
    return len(rest) > 0 and bool(within(rest, box).all() and within(written, box).all())


def _have_margins(one: Floats, other: Floats) -> bool:
    """Whether one of two boxes has the other one's lines beside it as far as ISO 5457 has them."""
    gaps = (other - one) * (1.0, 1.0, -1.0, -1.0)
    left, *others = (np.abs(gaps) / (_FILING, 1.0, 1.0, 1.0)).tolist()
    is_around = bool((gaps > EVEN).all() or (gaps < -EVEN).all())
    mean = sum(others) / len(others)
    return is_around and max(abs(item - mean) for item in (left, *others)) <= _OFF * mean


def _by_views(box: Floats, rest: Flags, touches: Touches, *, has_margins: bool) -> _Surety:
    """How sure it is that lines are a frame, by the views that it has.

    Args:
        box: around the lines, px.
        rest: (n,) what they go around.
        touches: of all strokes.
        has_margins: whether other lines are beside these as the edge of a sheet is.
    """
    if not rest.any():
        return _Surety.NONE
    groups = grouped(touches, rest)
    closed = groups.means(touches.closed | touches.met(rest).all(axis=1)) >= NEARLY_ALL
    large = (groups.sizes >= _VIEW * (box[2:] - box[:2])).all(axis=1)
    divided = groups.sums(touches.dividing(rest)) > 0
    views = large & (divided | _holding(groups, large & closed, closed))
    if not views.any():
        return _Surety.NONE
    if has_margins:
        return _Surety.CERTAIN
    # Those of plates on edge are thin, and have no edges within.
    views |= closed & _in_rows(groups.boxes, views)
    held = np.zeros(len(views), dtype=bool)
    for view in np.flatnonzero(views).tolist():
        held |= _within_other(groups.boxes, view)
    if (closed & ~views & ~held).any():
        return _Surety.NONE
    return _Surety.CERTAIN if (views & ~held).sum() > 1 else _Surety.GUESSED


def _holding(groups: Groups, some: Flags, closed: Flags) -> Flags:
    """(k,) which of some groups have other closed ones within them; circles around one middle are a
    hole with a counterbore or countersink."""
    found = np.zeros(len(some), dtype=bool)
    for number in np.flatnonzero(some).tolist():
        held = closed & _within_other(groups.boxes, number)
        if groups.counts[number] == 1:
            middles = groups.boxes[:, :2] + groups.boxes[:, 2:]
            held &= np.abs(middles - middles[number]).max(axis=1) / 2.0 > EVEN
        found[number] = held.any()
    return found


def _within_other(boxes: Floats, number: int) -> Flags:
    """(k,) which boxes lie within that of another number."""
    found = within(boxes, boxes[number])
    found[number] = False
    return found


def _in_rows(boxes: Floats, some: Flags) -> Flags:
    """(k,) which boxes begin and end where one of some does, across or up, as views in a row do."""
    found = np.zeros(len(boxes), dtype=bool)
    for box in boxes[some]:
        off = np.abs(boxes - box)
        found |= np.minimum(off[:, ::2].max(axis=1), off[:, 1::2].max(axis=1)) <= EVEN
    return found
