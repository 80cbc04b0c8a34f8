"""Arcs of one circle or ellipse that follow each other, joined to one: halves, quarters, pieces."""

from collections import defaultdict
from collections.abc import Hashable, Iterator, Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.near_points import connected_groups, near_pairs
from gaussiancad_core.geometry.points import FULL_TURN, wrapped
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke

_MEET = 0.02
"""mm within which the ends of arcs are one, and circles and ellipses too, by centre and axes."""

_Arc = CircularArc | EllipticArc


def joined_arcs(strokes: Sequence[PaperStroke]) -> list[PaperStroke]:
    """The strokes with one arc, or the whole curve, in place of arcs of one pen that lie on one
    circle or ellipse and meet end to end."""
    kept = []
    of_pen: dict[Hashable, list[PaperStroke]] = defaultdict(list)
    for stroke in strokes:
        curve = stroke.curve
        if isinstance(curve, _Arc) and not curve.is_closed:
            look = stroke.pen, stroke.role, stroke.kind, stroke.dashes
            of_pen[type(curve), look].append(stroke)
        else:
            kept.append(stroke)
    for arcs in of_pen.values():
        whole = places_of(np.array([_numbers(stroke.curve) for stroke in arcs]), _MEET)
        of_one: dict[int, list[PaperStroke]] = defaultdict(list)
        for number, stroke in zip(whole.tolist(), arcs, strict=True):
            of_one[number].append(stroke)
        for alike in of_one.values():
            kept += _joined(alike) if len(alike) > 1 else alike
    return kept


def places_of(points: npt.NDArray[np.float64], near: float) -> npt.NDArray[np.int64]:
    """(n,) number of the place of each of (n, d) points; those that are near each other are at
    one."""
    if not len(points):
        return np.zeros(0, dtype=np.int64)
    return connected_groups(_near_pairs(points, near), len(points))


def _near_pairs(points: npt.NDArray[np.float64], near: float) -> npt.NDArray[np.int64]:
    """(m, 2) pairs by which points that are near each other hang together: points at the very same
    place, of which there may be any number, by one of them."""
    _, firsts, same = np.unique(points, axis=0, return_index=True, return_inverse=True)
    of_each = np.stack([np.arange(len(points)), firsts[same.reshape(-1)]], axis=1)
    between = near_pairs(points[firsts], near)
    return np.concatenate([of_each, firsts[between].reshape(-1, 2)])


def _numbers(curve: object) -> tuple[float, ...]:
    """Numbers in mm that tell the circle or ellipse of an arc from others."""
    if isinstance(curve, CircularArc):
        return *curve.centre, curve.radius
    assert isinstance(curve, EllipticArc)
    # The foci tell the rotation, the more of it the less round the ellipse is.
    half = np.sqrt(max(curve.semi_major**2 - curve.semi_minor**2, 0.0))
    turned = half * np.exp(2j * curve.rotation)
    return *curve.centre, curve.semi_major, curve.semi_minor, turned.real, turned.imag


def _joined(strokes: Sequence[PaperStroke]) -> Iterator[PaperStroke]:
    """Strokes along one circle or ellipse, those joined that follow each other."""
    like = strokes[0].curve
    assert isinstance(like, _Arc)
    spans = sorted((*_span(stroke.curve, like), number) for number, stroke in enumerate(strokes))
    near = _MEET / (like.radius if isinstance(like, CircularArc) else like.semi_minor)
    first, end, number = spans[0]
    runs: list[tuple[float, float, list[int]]] = [(first, end, [number])]
    for start, far, number in spans[1:]:
        before, last, numbers = runs[-1]
        if abs(start - last) <= near:
            runs[-1] = before, far, [*numbers, number]
        else:
            runs.append((start, far, [number]))
    if len(runs) > 1 and abs(runs[-1][1] - FULL_TURN - runs[0][0]) <= near:
        start, _, numbers = runs.pop()
        runs[0] = start - FULL_TURN, runs[0][1], [*numbers, *runs[0][2]]
    for start, far, numbers in runs:
        stroke = strokes[numbers[0]]
        if len(numbers) == 1:
            yield stroke
            continue
        sweep = FULL_TURN if abs(far - start - FULL_TURN) <= near else far - start
        sweep = min(sweep, FULL_TURN)
        if isinstance(like, CircularArc):
            curve: _Arc = replace(like, start_angle=wrapped(start), sweep=sweep)
        else:
            curve = replace(like, start=wrapped(start), sweep=sweep)
        yield replace(stroke, curve=curve)


def _span(curve: object, like: _Arc) -> tuple[float, float]:
    """Where an arc begins, from 0 to a turn, and ends, by the angles of one of the same curve."""
    if isinstance(curve, CircularArc):
        start = wrapped(curve.start_angle)
        return start, start + curve.sweep
    assert isinstance(curve, EllipticArc)
    assert isinstance(like, EllipticArc)
    # A half turn of the axes is one of the parameter.
    turned = abs(np.angle(np.exp(1j * (curve.rotation - like.rotation)))) > np.pi / 2.0
    start = wrapped(curve.start + (np.pi if turned else 0.0))
    return start, start + curve.sweep
