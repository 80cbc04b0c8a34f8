"""Extension lines that come out of a view, on sheets whose lines are all of one width.

An extension line begins a little off its edge (ISO 129-1).  Where it belongs to the outline it has
that gap there; one that runs across the outline without a gap comes from an edge inside the view,
and lies over the view as far as the gap before that edge.  There it may shut off areas with other
lines, as an edge does.  Where the edge is one side of a slot, the slot's end fills the gap.
"""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from scipy.ndimage import map_coordinates

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.blank_areas import BlankAreas, blank_areas
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import (
    InkedRun,
    InkedShape,
    normals_along,
    points_along,
)
from gaussiancad_core.sheet.annotations.marks import Mask, values_at
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

_WIDEST = 8.0
"""Gap between an edge and its extension line at most, in stroke widths."""

_WIDEST_WITHIN = 3.0
"""The same within a view, where the line has crossed the outline."""

_LEAST_PX = 0.75
"""px of paper that are a gap at least."""

_LEAST = 3
"""Extension lines with a gap that are a sheet's habit at least."""

_HABIT = 0.5
"""Share of all gaps that are alike at least."""

_ALIKE = 0.5, 1.6
"""A gap in its sheet's usual one, from and to."""

_SHORTEST = 3.0
"""Length of an extension line beside a view at least, in stroke widths."""

_OFF = 0.4
"""Distance of a line from a circle that it touches at most, in stroke widths."""

_BRIDGE_PX = 7
"""px; closes gaps of an outline of fewer."""

_BESIDE_PX = 2.5
"""px beside a line, beyond half of it, at which its areas lie."""

_LEAST_OUT_PX = 3
"""px of an extension line that lie over the paper around the views at least."""

_OUTSIDE = 0.15
"""Share of a stretch beside which the paper around the view may lie, where it crosses the
outline."""

_CROSSED = 6.0
"""Stretch along which an outline aslant is crossed at most, in stroke widths."""

_AROUND = np.stack(np.meshgrid((-1.0, 0.0, 1.0), (-1.0, 0.0, 1.0)), axis=2).reshape(-1, 2)
"""(9, 2) directions, of which one at least is ink where an edge is."""

_PAPER = 0.35
"""Weight of ink under which it is paper."""

_STEP = 0.25
"""px between the places that are looked at."""

Weight = npt.NDArray[np.float32]
Floats = npt.NDArray[np.float64]


def mark_led_out(
    shapes: list[InkedShape], kinds: Kinds, weight: Weight, left: Mask, stroke_width: float
) -> None:
    """Mark what lies between an extension line that crosses the outline and its edge, in place.

    Args:
        shapes: lines and circles of a sheet.
        kinds: what each run is; extension lines are known where they lie over paper.
        weight: (h, w) darkness of the ink.
        left: (h, w) bool, the ink without what was marked.
        stroke_width: px.
    """
    usual = _usual_gap(shapes, kinds, weight, left, stroke_width)
    if not usual:
        return
    sizes = weight, usual, stroke_width
    areas = blank_areas(left, _BRIDGE_PX)
    circles = [shape.geometry for shape in shapes if isinstance(shape.geometry, Circle)]
    for index, (shape, own) in enumerate(zip(shapes, kinds, strict=True)):
        if not isinstance(shape.geometry, Line) or AnnotationKind.EXTENSION not in own:
            continue
        runs, marks = list(shape.runs), list(own)
        touched = _touched(shape.geometry, circles, stroke_width)
        for way in (1, -1):
            _follow_in(shape.geometry, (runs, marks), way, (touched, areas), sizes)
        shapes[index], kinds[index] = InkedShape(shape.geometry, tuple(runs)), marks


def _follow_in(
    line: Line,
    told: tuple[list[InkedRun], list[AnnotationKind | None]],
    way: int,
    around: tuple[Floats, BlankAreas],
    sizes: tuple[Weight, float, float],
) -> None:
    """Mark the runs, or parts of them, that extension lines go on as, one way along the line, which
    touches circles at some positions, and never along the outline."""
    touched, areas = around
    runs, marks = told
    weight, usual, stroke_width = sizes
    k = 0 if way > 0 else len(runs) - 1
    led = False
    while 0 <= k + way < len(runs):
        outer, inner = runs[k].run, runs[k + way].run
        # What parts nothing may be the end of an edge, in a corner full of ink.
        extends = marks[k] is AnnotationKind.EXTENSION
        led = extends and (led or _is_over_paper(line, outer, areas, stroke_width))
        joined = _apart(outer, inner) < _LEAST_PX
        long = outer.length >= _SHORTEST * stroke_width
        if led and joined and long and marks[k + way] is None:
            begin, end = (inner.start, inner.end) if way > 0 else (inner.end, inner.start)
            gap = _first_gap(line, begin, end + way * (usual * _ALIKE[1] + stroke_width), weight)
            ahead = way * (touched - begin)
            ahead = ahead[(ahead > usual + stroke_width) & (ahead < way * (end - begin))]
            if gap is None and len(ahead):
                gap = begin + way * (float(ahead.min()) - usual), usual
            inside = gap is not None and _is_inside(line, begin, gap[0], areas, stroke_width)
            if gap is not None and inside and _ALIKE[0] * usual <= gap[1] <= _ALIKE[1] * usual:
                width, at = runs[k + way].width, gap[0]
                beyond = at + way * gap[1]
                if (end - at) * way <= stroke_width:
                    marks[k + way] = AnnotationKind.EXTENSION
                else:
                    near, far = Run(*sorted((begin, at))), Run(*sorted((beyond, end)))
                    parts = [InkedRun(near, width), InkedRun(far, width)]
                    both = [AnnotationKind.EXTENSION, None]
                    runs[k + way : k + way + 1] = parts if way > 0 else parts[::-1]
                    marks[k + way : k + way + 1] = both if way > 0 else both[::-1]
        k += way


def _is_inside(
    line: Line, begin: float, end: float, areas: BlankAreas, stroke_width: float
) -> bool:
    """Whether the paper around the views is on neither side of a stretch of a line, once it crossed
    the outline: what is known to be an extension line may end before that."""
    out = _paper_beside(line, Run(*sorted((begin, end))), areas, stroke_width)
    out = out if begin < end else out[:, ::-1]
    crossing = int(np.argmin(out.all(axis=0)))
    beyond = out.any(axis=0)[crossing:]
    within = beyond[int(min(_CROSSED * stroke_width, np.argmin(beyond))) :]
    return not beyond.all() and float(within.mean()) <= _OUTSIDE


def _is_over_paper(line: Line, run: Run, areas: BlankAreas, stroke_width: float) -> bool:
    """Whether the paper around the views is on both sides of a run somewhere."""
    out = _paper_beside(line, run, areas, stroke_width).all(axis=0)
    return int(out.sum()) >= _LEAST_OUT_PX


def _paper_beside(
    line: Line, run: Run, areas: BlankAreas, stroke_width: float
) -> npt.NDArray[np.bool_]:
    """(2, n) whether the paper around the views is on either side, about every px of a run."""
    points, normals = points_along(line, run, 1.0), normals_along(line, run, 1.0)
    beside = stroke_width / 2 + _BESIDE_PX
    sides = (values_at(areas.labels, points + way * beside * normals) for way in (-1.0, 1.0))
    return np.array([side == areas.paper for side in sides])


def _touched(line: Line, circles: Sequence[Circle], stroke_width: float) -> Floats:
    """(n,) positions along a line at which it touches circles."""
    if not circles:
        return np.empty(0)
    along, across = line.coordinates(np.array([circle.centre for circle in circles]))
    radii = np.array([circle.radius for circle in circles])
    return along[np.abs(np.abs(across) - radii) <= _OFF * stroke_width]


def _usual_gap(
    shapes: Sequence[InkedShape], kinds: Kinds, weight: Weight, left: Mask, stroke_width: float
) -> float:
    """px between edges and the extension lines that begin at them; 0 where none is usual.

    A gap for a number, or between two dimensions, has no edge beyond it.
    """
    gaps = []
    for shape, own in zip(shapes, kinds, strict=True):
        if not isinstance(shape.geometry, Line):
            continue
        for k, run in enumerate(shape.runs):
            if own[k] is not AnnotationKind.EXTENSION or run.run.length < _SHORTEST * stroke_width:
                continue
            for way in (-1, 1):
                last = _last_touching(shape.runs, k, way)
                end = shape.runs[last].run.start if way < 0 else shape.runs[last].run.end
                inside = end - way * stroke_width
                ahead = end + way * (_WIDEST if last == k else _WIDEST_WITHIN) * stroke_width
                gap = _first_gap(shape.geometry, inside, ahead, weight)
                if gap is None:
                    continue
                edge = np.array(shape.geometry.at(gap[0] + way * (gap[1] + 0.5 * stroke_width)))
                # At a corner of two edges their ends may not fill it.
                if values_at(left, edge + 0.5 * stroke_width * _AROUND).any():
                    gaps.append(gap[1])
    if len(gaps) < _LEAST:
        return 0.0
    # Lines that begin at the height of the whole view, and not at their edge, have others.
    alike = max(
        ([gap for gap in gaps if _ALIKE[0] * own <= gap <= _ALIKE[1] * own] for own in gaps),
        key=len,
    )
    return float(np.median(alike)) if len(alike) >= max(_LEAST, _HABIT * len(gaps)) else 0.0


def _last_touching(runs: Sequence[InkedRun], first: int, way: int) -> int:
    """The last of the runs that go on as each other without a gap, one way from one of them."""
    k = first
    while 0 <= k + way < len(runs) and _apart(runs[k].run, runs[k + way].run) < _LEAST_PX:
        k += way
    return k


def _first_gap(line: Line, begin: float, end: float, weight: Weight) -> tuple[float, float] | None:
    """Where the first gap between ink on the way from one position on a line to another begins, and
    how many px of paper it has; nothing where there is none."""
    count = max(2, round(abs(end - begin) / _STEP) + 1)
    at = np.linspace(begin, end, count)
    places = np.array(line.point) + at[:, None] * np.array(line.direction)
    blank = map_coordinates(weight, places[:, ::-1].T, order=1, mode="nearest") < _PAPER
    first = int(np.argmax(~blank))
    step = abs(end - begin) / (count - 1)
    borders = np.flatnonzero(np.diff(blank[first:].astype(np.int8))) + 1 + first
    for start, stop in zip(borders[::2], borders[1::2], strict=False):
        if (stop - start) * step >= _LEAST_PX:
            return float(at[start]), float((stop - start) * step)
    return None


def _apart(one: Run, other: Run) -> float:
    return max(other.start - one.end, one.start - other.end)
