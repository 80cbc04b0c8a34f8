"""The form of a sheet's centre marks, and those that other strokes touch.

A program draws all marks of a sheet alike: a cross of one size, then a gap, then arms that lead by
one length beyond the circle.  Around small circles cross and arms are one: lines that lead beyond
the circle by that length.  Marks that stand free tell these forms.  Where arms of neighbours run
into each other, or an arm ends at an edge, a mark is told by it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.marks import Mask
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

_EVEN = 3.0
"""px by which marks of one form may differ."""

_OFF = 2.0
"""px by which a mark may miss its circle's centre: those drawn on whole pixels do."""

_INKED = 0.9
"""Share of each of a mark's lines that is ink at least."""

_BLANK = 0.8
"""Share of the gaps between its cross and an arm that is blank at least, on two sides."""

_LEAST_ARM = 3.0
"""px of an arm at least, for it to be looked for."""

_STRAIGHT = 0.05
"""Sine of the angle between a mark's lines, as short as they may be, and the sheet's axes at
most."""

_SIDES = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))


@dataclass(frozen=True)
class FreeMark:
    """A centre mark that stands free, px.

    Attributes:
        circle: around it.
        cross: from the centre to the cross's ends.
        inner, outer: from the centre to where its arms begin and end; nothing without arms.
    """

    circle: Circle
    cross: float
    inner: float | None = None
    outer: float | None = None


@dataclass(frozen=True)
class MarkForm:
    """The form of a sheet's centre marks, px.

    Attributes:
        cross: from the centre to the cross's ends.
        inner: from the centre to where arms begin.
        over: by which arms lead beyond the circle.
    """

    cross: float
    inner: float
    over: float


@dataclass(frozen=True)
class WholeForm:
    """The form of marks without gaps: crosses that lead beyond their circles.

    Attributes:
        over: by which they do, px.
    """

    over: float


Form = MarkForm | WholeForm


def learned_form(marks: Sequence[FreeMark]) -> MarkForm | None:
    """The form that most free marks with arms have; nothing where they differ, or have none.

    Around concentric circles an arm leads beyond one of them, no one says which.
    """
    armed = [mark for mark in marks if mark.inner is not None and mark.outer is not None]
    if not armed:
        return None
    rows = np.array([(m.cross, m.inner, m.outer - m.circle.radius) for m in armed])
    middle = np.median(rows[rows[:, 2] > 0.0] if (rows[:, 2] > 0.0).any() else rows, axis=0)
    alike = (np.abs(rows - middle) <= _EVEN).all(axis=1)
    if alike.mean() <= 0.5 or middle[2] <= 0.0:
        return None
    return MarkForm(*rows[alike].mean(axis=0).tolist())


def whole_forms(marks: Sequence[FreeMark], circles: Sequence[Circle]) -> list[WholeForm]:
    """The forms that free marks without arms may have.

    Around concentric circles there is one for each that the mark leads beyond.
    """
    found: list[WholeForm] = []
    for mark in marks:
        centre = np.array(mark.circle.centre)
        around = [c for c in circles if np.abs(centre - c.centre).max() <= _OFF]
        for over in sorted(mark.cross - circle.radius for circle in around):
            known = any(abs(over - form.over) <= _EVEN for form in found)
            if mark.inner is None and over > _LEAST_ARM and not known:
                found.append(WholeForm(over))
    return found


def mark_by_form(
    shapes: list[InkedShape], kinds: Kinds, ink: Mask, form: Form, circles: Sequence[Circle]
) -> None:
    """Tell the runs of all marks of a form, in place; runs that go on beyond one are cut there.

    Args:
        shapes: lines and circles of the sheet.
        kinds: what each run is known to be.
        ink: (h, w) bool.
        form: of the sheet's marks.
        circles: that may have one.
    """
    pieces = [
        (np.array(circle.centre), np.array(side), piece)
        for circle in circles
        if _is_drawn(circle, form, ink)
        for side in _SIDES
        for piece in _pieces(circle, form)
    ]
    for k, shape in enumerate(shapes):
        line = shape.geometry
        if isinstance(line, Line) and min(map(abs, line.direction)) < _STRAIGHT:
            covered = _along(line, pieces)
            if covered:
                shapes[k], kinds[k] = _split(shape, kinds[k], covered)


def _pieces(circle: Circle, form: Form) -> list[tuple[float, float]]:
    """From and to where a mark is drawn on each side of the centre, px from it."""
    if isinstance(form, WholeForm):
        return [(0.0, circle.radius + form.over)]
    pieces = [(0.0, form.cross)]
    if circle.radius + form.over - form.inner > _LEAST_ARM:
        pieces.append((form.inner, circle.radius + form.over))
    return pieces


def _is_drawn(circle: Circle, form: Form, ink: Mask) -> bool:
    """Whether all of a circle's mark is ink, and on two sides its gap, or what is ahead of it if it
    has none, is blank."""
    blank = 0
    pieces = _pieces(circle, form)
    for side in _SIDES:
        for piece in pieces:
            if _share(circle, side, piece, ink) < _INKED:
                return False
        for (_, end), (start, _) in pairwise(pieces):
            gap = end + _EVEN, start - _EVEN
            # The circle itself may pass there.
            blank += gap[1] > gap[0] and _share(circle, side, gap, ink) <= 1.0 - _BLANK
        if isinstance(form, WholeForm):
            end = circle.radius + form.over
            ahead = end + _EVEN, end + 2.0 * _EVEN
            blank += _share(circle, side, ahead, ink) <= 1.0 - _BLANK
    return blank >= 2 or (isinstance(form, MarkForm) and len(pieces) == 1)


def _share(
    circle: Circle, side: tuple[float, float], piece: tuple[float, float], ink: Mask
) -> float:
    """Share of a stretch on one side of a centre that is ink within half a px, but for where the
    circle passes."""
    start, end = piece
    away = np.arange(start + 1.0, max(end - 1.0, start + 1.5), 0.5)
    away = away[np.abs(away - circle.radius) > _EVEN]
    if not len(away):
        return 1.0
    places = np.array(circle.centre) + away[:, None] * np.array(side)
    columns, rows = np.rint(places).astype(int).T
    inside = (columns >= 0) & (rows >= 0) & (columns < ink.shape[1]) & (rows < ink.shape[0])
    return float(ink[rows[inside], columns[inside]].sum()) / len(away)


def _along(
    line: Line, pieces: Sequence[tuple[np.ndarray, np.ndarray, tuple[float, float]]]
) -> list[tuple[float, float]]:
    """The pieces of marks on a line, px along it, those that touch made one."""
    found = []
    for centre, side, piece in pieces:
        places = centre + np.outer(piece, side)
        along, across = line.coordinates(places)
        if np.abs(across).max() <= _OFF:
            found.append((float(along.min()), float(along.max())))
    merged: list[tuple[float, float]] = []
    for start, end in sorted(found):
        if merged and start <= merged[-1][1] + _EVEN:
            merged[-1] = merged[-1][0], max(end, merged[-1][1])
        else:
            merged.append((start, end))
    return merged


def _split(
    shape: InkedShape,
    own: list[AnnotationKind | None],
    covered: Sequence[tuple[float, float]],
) -> tuple[InkedShape, list[AnnotationKind | None]]:
    """A line's runs with what they are, cut where pieces of marks end within them.

    A run that goes on at both ends of a piece has no gap there: it is an edge.
    """
    runs: list[InkedRun] = []
    kinds: list[AnnotationKind | None] = []
    for run, kind in zip(shape.runs, own, strict=True):
        start, end = run.run.start, run.run.end
        parts = [(start, end, kind)]
        for low, high in covered:
            before, after = start < low - _EVEN, end > high + _EVEN
            apart = end < low + _EVEN or start > high - _EVEN
            if kind is not None or apart or (before and after):
                continue
            parts = [(start, low, None)] if before else []
            parts.append((max(start, low) if before else start, high if after else end, _CENTRE))
            parts += [(high, end, None)] if after else []
            break
        runs += [InkedRun(Run(a, b), run.width) for a, b, _ in parts]
        kinds += [told for *_, told in parts]
    return InkedShape(shape.geometry, tuple(runs)), kinds


_CENTRE = AnnotationKind.CENTRE_LINE
