"""Tips of leaders and dimension lines at circles.

A line to a bore, a boss or a rounding points at the centre of its arc (ISO 129-1).  Where its head
is no blot but barbs or a stroke across, these hang on the arc once the line is gone, and so does
the line's last piece between the barbs, or between two circles around one centre.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.arrowheads import NearWriting
from gaussiancad_core.sheet.annotations.erase import Kinds, Told
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape, points_along
from gaussiancad_core.sheet.annotations.marks import Mark, Mask, values_at
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

Point = npt.NDArray[np.float64]
Kind = list[AnnotationKind | None]

_HEAD = 14.0
"""Length of an arrowhead at most, in stroke widths."""

_LEAST = 6.0
"""Length of a line that points at a circle at least, in stroke widths."""

_SLANTED = 0.05
"""Sine of the angle between a slanted line and the sheet's axes at least: beside level ones, edges
of the part go on towards the centres of circles."""

_OFF = 1.0
"""Distance of such a line from the circle's centre at most, in stroke widths."""

_BEFORE, _BEYOND = 60.0, 3.0
"""How far the last known piece of such a line ends before the circle at most, and beyond it, in
stroke widths."""

_INKED = 0.95
"""Share of its way to the circle that has ink at least."""

_ON = 4.0
"""Distance along the circle from its drawn part at most, in stroke widths."""

_DASHES = 3
"""Runs from which a line may be dashed: all of them stay."""

_WHOLE = 0.6
"""Share of a circle that is drawn at least, for it to be no contour of a head."""

_ACROSS = 1.5
"""Width of what stays around a stroke, in widths of it."""

_TIP = 4.0
"""Distance from the tip within which a head begins, in stroke widths."""


_FROM_SHOULDER = 2.5
"""Distance of a leader's end from that of its shoulder at most, in stroke widths."""


def mark_leaders(
    shapes: list[InkedShape],
    kinds: Kinds,
    letters: Sequence[Mark],
    ink: Mask,
    stroke_width: float,
) -> None:
    """Mark lines from the end of a known line under writing to a circle as leaders, in place.

    A short one with a blot of a head on it, across another circle, is as wide as an edge.

    Args:
        shapes: lines and circles of a sheet.
        kinds: what each run is known to be.
        letters: the sheet's writing.
        ink: (h, w) bool.
        stroke_width: px.
    """
    near_writing = NearWriting(letters)
    ends = [
        place
        for shape, own in zip(shapes, kinds, strict=True)
        if isinstance(shape.geometry, Line) and min(map(abs, shape.geometry.direction)) < _SLANTED
        for run, kind in zip(shape.runs, own, strict=True)
        if kind is not None and near_writing(shape, run)
        for place in points_along(shape.geometry, run.run, 1e9)[[0, -1]]
    ]
    if not ends:
        return
    shoulders = np.array(ends)
    arcs = _arcs(shapes, kinds)
    for shape, own in zip(shapes, kinds, strict=True):
        line = shape.geometry
        if not isinstance(line, Line) or min(map(abs, line.direction)) < _SLANTED:
            continue
        for k, run in enumerate(shape.runs):
            if own[k] is not None or run.run.length < _LEAST * stroke_width:
                continue
            forth, back = (run.run.start, run.run.end, 1.0), (run.run.end, run.run.start, -1.0)
            for start, end, way in (forth, back):
                away = np.hypot(*(shoulders - line.at(start)).T)
                if away.min() < _FROM_SHOULDER * stroke_width and _reached(
                    line, (end, way), arcs, ink, stroke_width
                ):
                    own[k] = AnnotationKind.LEADER


def with_clear_tips(told: Told, ink: Mask, stroke_width: float) -> Told:
    """What is told with the heads that annotations have at circles, and their pieces before these.

    Args:
        told: what each line and circle is.
        ink: (h, w) bool, with all of these.
        stroke_width: px.
    """
    tips = list(_tips(told, ink, stroke_width))
    if not tips:
        return told
    shapes = [*told.shapes]
    kinds = [list(own) for own in told.kinds]
    for index, run, kind, _ in tips:
        for k, other in enumerate(shapes[index].runs):
            within = min(other.run.end, run.end) - max(other.run.start, run.start)
            if kinds[index][k] is None and within > 0.5 * other.run.length:
                kinds[index][k] = kind
        shapes.append(InkedShape(shapes[index].geometry, (InkedRun(run, stroke_width),)))
        kinds.append([kind])
    heads = _heads(
        Told(shapes, kinds, told.unexplained), ink, [tip[-1] for tip in tips], stroke_width
    )
    for index, shape in enumerate(shapes):
        for k, run in enumerate(shape.runs):
            if kinds[index][k] is None and run.run.length < _HEAD * stroke_width:
                on_head = values_at(heads, points_along(shape.geometry, run.run, 1.0))
                if on_head.mean() > 0.5:
                    kinds[index][k] = AnnotationKind.LEADER
    loose = heads if told.loose is None else told.loose | heads
    curves = told.unexplained & (cv2.dilate(heads.astype(np.uint8), np.ones((5, 5))) == 0)
    return replace(told, shapes=shapes, kinds=kinds, unexplained=curves, loose=loose)


def _tips(
    told: Told, ink: Mask, stroke_width: float
) -> Iterator[tuple[int, Run, AnnotationKind, Point]]:
    """Of each line that points at a circle: its number, the run from its last known piece to the
    circle, its kind, and its tip."""
    arcs = _arcs(told.shapes, told.kinds)
    for index, (shape, own) in enumerate(zip(told.shapes, told.kinds, strict=True)):
        line = shape.geometry
        if not isinstance(line, Line) or min(map(abs, line.direction)) < _SLANTED:
            continue
        for run, kind in zip(shape.runs, own, strict=True):
            if kind is None or run.run.length < _LEAST * stroke_width:
                continue
            for end, way in ((run.run.start, -1.0), (run.run.end, 1.0)):
                reached = _reached(line, (end, way), arcs, ink, stroke_width)
                if reached:
                    tip = max(reached, key=lambda place: way * place)
                    last = Run(min(end, tip), max(end, tip))
                    yield index, last, kind, np.array(line.at(tip))


def _arcs(shapes: list[InkedShape], kinds: Kinds) -> list[tuple[InkedShape, Kind]]:
    """Circles of the part, or of nothing that is known."""
    return [
        (shape, own)
        for shape, own in zip(shapes, kinds, strict=True)
        if isinstance(shape.geometry, Circle) and None in own
    ]


def _reached(
    line: Line,
    end: tuple[float, float],
    arcs: list[tuple[InkedShape, Kind]],
    ink: Mask,
    stroke_width: float,
) -> list[float]:
    """Positions at which a line that points at arcs' centres meets these, from an end and the way
    (1 or -1) in which it goes on there."""
    start, way = end
    return [
        place
        for arc, marks in arcs
        for place in _on_arc(line, arc, marks, stroke_width)
        if -_BEYOND * stroke_width < way * (place - start) < _BEFORE * stroke_width
        and _is_inked(line, start, place, ink)
    ]


def _on_arc(line: Line, arc: InkedShape, kinds: Kind, stroke_width: float) -> list[float]:
    """Positions at which a line that points at an arc's centre crosses what is drawn of it."""
    circle = arc.geometry
    centre = np.array(circle.centre)[None]
    (along,), (across,) = line.coordinates(centre)
    if abs(across) > _OFF * stroke_width:
        return []
    places = []
    for place in (along - circle.radius, along + circle.radius):
        (at,) = circle.positions(np.array(line.at(place))[None])
        for run, kind in zip(arc.runs, kinds, strict=True):
            near = run.run.start + (at - run.run.start) % circle.around
            short = min(near - run.run.end, run.run.start + circle.around - near)
            if kind is None and short < _ON * stroke_width:
                places.append(float(place))
                break
    return places


def _is_inked(line: Line, start: float, end: float, ink: Mask) -> bool:
    along = np.linspace(start, end, max(2, int(abs(end - start)) + 1))
    return bool(values_at(ink, line.points_at(along)).mean() >= _INKED)


def _heads(told: Told, ink: Mask, tips: list[Point], stroke_width: float) -> Mask:
    """(h, w) bool, ink around tips that is on no stroke longer than a head."""
    strokes = np.zeros(ink.shape, np.uint8)
    lines = np.zeros(ink.shape, np.uint8)
    for shape, own in zip(told.shapes, told.kinds, strict=True):
        kept = [run for run, kind in zip(shape.runs, own, strict=True) if kind is None]
        total = sum(run.run.length for run in kept)
        whole = isinstance(shape.geometry, Circle) and total >= _WHOLE * shape.geometry.around
        for run, kind in zip(shape.runs, own, strict=True):
            path = np.rint(points_along(shape.geometry, run.run, 1.0) * 8).astype(np.int32)
            wide = int(np.ceil(_ACROSS * (run.width or stroke_width))) + 1
            if kind is not None:
                cv2.polylines(lines, [path], False, 1, wide, shift=3)
            elif whole or len(kept) >= _DASHES or total >= _HEAD * stroke_width:
                cv2.polylines(strokes, [path], False, 1, wide, shift=3)
    curves = cv2.dilate(told.unexplained.astype(np.uint8), np.ones((3, 3), np.uint8))
    _, labels, facts, _ = cv2.connectedComponentsWithStats(curves, connectivity=8)
    long = facts[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1) > _HEAD * stroke_width
    long[0] = False
    left = ink & (strokes == 0) & ~long[labels]
    heads = np.zeros(ink.shape, dtype=bool)
    reach = int(np.ceil(_HEAD * stroke_width))
    for tip in tips:
        low = np.maximum(np.rint(tip).astype(int) - reach, 0)
        window = tuple(slice(first, first + 2 * reach + 1) for first in low[::-1])
        down, right = np.indices(left[window].shape)
        away = np.hypot(right + low[0] - tip[0], down + low[1] - tip[1])
        _, pieces = cv2.connectedComponents(
            (left[window] & (away < reach)).astype(np.uint8), connectivity=8
        )
        # What goes on further, and not as a line that is known, is more than a head.
        further = np.unique(pieces[(away >= reach - 2) & (lines[window] == 0)])
        here = np.setdiff1d(pieces[away < _TIP * stroke_width], [0, *further])
        heads[window] |= np.isin(pieces, here)
    return heads
