"""Edges of which a file has only pieces, each a stroke of its own.

Many programs plot curves as short chords, and cut straight edges where something touches them.
Lines that go on in each other, where nothing else meets them, are a chain: it becomes the arcs that
a plotter drew as chords (:mod:`gaussiancad_core.files.plotted`), and one line where it is
straight.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from gaussiancad_core.files.plotted import lines_and_arcs
from gaussiancad_core.files.vectors import VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import Points as Floats
from gaussiancad_core.geometry.points import to_point
from gaussiancad_core.sheet.file_noise import SAME_POINT

_BESIDE = 0.01
"""px by which points of a straight edge may lie beside it, and what they are rounded to besides."""

_SHARP = np.cos(np.radians(50.0))
"""Cosine of the turn at which a chain ends."""


def with_whole_edges(strokes: Sequence[VectorStroke]) -> tuple[VectorStroke, ...]:
    """The strokes, with whole edges instead of their pieces.

    Args:
        strokes: of the part's pen; px.
    """
    lines = {
        index: stroke.curve
        for index, stroke in enumerate(strokes)
        if isinstance(stroke.curve, LineSegment)
    }
    kept = [stroke for index, stroke in enumerate(strokes) if index not in lines]
    offset = _BESIDE + 0.5 * max((stroke.step for stroke in strokes), default=0.0)
    for first, points in _chains(lines):
        whole = _whole(points, strokes[first].step, offset)
        kept += [replace(strokes[first], curve=curve) for curve in whole]
    return tuple(kept)


def _whole(points: Floats, step: float, offset: float) -> Iterator[Curve]:
    """Arcs and lines along a chain.

    Args:
        points: (n, 2) px.
        step: px to which they were rounded.
        offset: px within which lines are one that is straight.
    """
    run: list[LineSegment] = []
    for curve in lines_and_arcs(points, step):
        if isinstance(curve, LineSegment) and _is_straight([*run, curve], offset):
            run.append(curve)
            continue
        if run:
            yield LineSegment(run[0].start, run[-1].end)
        run = [curve] if isinstance(curve, LineSegment) else []
        if not run:
            yield curve
    if run:
        yield LineSegment(run[0].start, run[-1].end)


def _is_straight(run: Sequence[LineSegment], offset: float) -> bool:
    points = np.array([run[0].start, *(line.end for line in run)])
    chord = points[-1] - points[0]
    length = float(np.hypot(*chord))
    ways = np.diff(points, axis=0) @ chord
    across = np.abs((points - points[0]) @ np.array([-chord[1], chord[0]]))
    return length > 0.0 and bool((ways > 0.0).all() and across.max() <= offset * length)


def _chains(lines: dict[int, LineSegment]) -> Iterator[tuple[int, Floats]]:
    """The first line of each run of lines that go on in each other, and its (n, 2) points."""
    at: dict[tuple[int, int], list[int]] = {}
    for index, line in lines.items():
        for end in (line.start, line.end):
            at.setdefault(_place(end), []).append(index)
    left = set(lines)
    for index, line in lines.items():
        if index not in left:
            continue
        left.discard(index)
        points = [line.start, line.end]
        for _ in range(2):
            while (step := _next(points, at, lines, left)) is not None:
                left.discard(step[0])
                points.append(step[1])
            points.reverse()
        yield index, np.array(points)


def _place(point: tuple[float, float]) -> tuple[int, int]:
    return round(point[0] / SAME_POINT), round(point[1] / SAME_POINT)


def _next(
    points: Sequence[tuple[float, float]],
    at: dict[tuple[int, int], list[int]],
    lines: dict[int, LineSegment],
    left: set[int],
) -> tuple[int, tuple[float, float]] | None:
    """The line that alone goes on at the end of a chain, and its far end."""
    before, end = points[-2:]
    here = at[_place(end)]
    others = [number for number in here if number in left]
    if len(here) != 2 or len(others) != 1:
        return None
    line = lines[others[0]]
    far = line.end if _place(line.start) == _place(end) else line.start
    one, other = np.subtract(end, before), np.subtract(far, end)
    turns = one @ other < _SHARP * np.hypot(*one) * np.hypot(*other)
    return None if turns else (others[0], to_point(np.array(far)))
