"""Strokes that a file draws twice over: one of them tells all.

Exports, merged layers and copies pasted in place leave the same curve twice.  Chords that are drawn
twice have four ends where two should meet, so that nothing goes on in anything.
"""

from collections.abc import Hashable, Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.file_curves import FLATNESS
from gaussiancad_core.files.vectors import VectorStroke
from gaussiancad_core.geometry.arcs import EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.near_points import near_pairs

_PLACES = 5
"""Points that tell ellipses apart, as five determine a conic, and most chains."""


def distinct_strokes(strokes: Sequence[VectorStroke]) -> tuple[VectorStroke, ...]:
    """The strokes without those that are drawn along another of the same pen, whichever way; of
    several the widest stays, else the first.

    Args:
        strokes: of a page; px.
    """
    groups: dict[Hashable, list[int]] = {}
    for index, stroke in enumerate(strokes):
        groups.setdefault(_pen(stroke), []).append(index)
    left_out: set[int] = set()
    for group in groups.values():
        group.sort(key=lambda index: -(strokes[index].width or 0.0))
        left_out.update(
            group[number] for number in _repeated([strokes[number] for number in group])
        )
    return tuple(
        vector_stroke for index, vector_stroke in enumerate(strokes) if index not in left_out
    )


def _pen(stroke: VectorStroke) -> Hashable:
    """What strokes have in common one of which may stand for the other."""
    return type(stroke.curve), stroke.kind, stroke.role, stroke.layer, stroke.colour, stroke.dashes


def _repeated(strokes: Sequence[VectorStroke]) -> list[int]:
    """Numbers of strokes that lie along an earlier one; all of them have curves of one type."""
    if len(strokes) < 2:
        return []
    curves = [stroke.curve for stroke in strokes]
    left_out: set[int] = set()
    first_of: dict[Hashable, int] = {}
    for index, curve in enumerate(curves):
        if first_of.setdefault(_exactly(curve), index) != index:
            left_out.add(index)
    rest = list(first_of.values())
    there = _all_places([curves[index] for index in rest])
    # Whichever way a curve is drawn, the middle of its places is one.
    one, other = near_pairs(there.mean(axis=1), np.sqrt(2.0) * FLATNESS).T
    for turned in (False, True):
        places = there[:, ::-1] if turned else there
        alike = (np.abs(there[one] - places[other]) <= FLATNESS).all(axis=(1, 2))
        for first, second in zip(one[alike].tolist(), other[alike].tolist(), strict=True):
            kept, repeated = rest[first], rest[second]
            if kept not in left_out and _is_along(curves[kept], curves[repeated], turned=turned):
                left_out.add(repeated)
    return sorted(left_out)


def _exactly(curve: Curve) -> Hashable:
    """What curves have in common that are the same to the last digit, lines whichever way."""
    return frozenset((curve.start, curve.end)) if isinstance(curve, LineSegment) else curve


def _all_places(curves: Sequence[Curve]) -> npt.NDArray[np.float64]:
    """(m, n, 2) px: the places of curves of one type."""
    lines = [(c.start, c.end) for c in curves if isinstance(c, LineSegment)]
    return np.array(lines if lines else [_places(curve) for curve in curves])


def _places(curve: Curve) -> npt.NDArray[np.float64]:
    """(n, 2) px: points from a curve's start to its end, as many of all that have its type.  Those
    of a line, an arc or an ellipse tell it from others."""
    if isinstance(curve, Chain):
        return curve.points_at(np.linspace(0.0, curve.length, _PLACES))
    return curve.spread(_PLACES) if isinstance(curve, EllipticArc) else curve.vertices(np.inf)


def _is_along(chain: Curve, other: Curve, *, turned: bool) -> bool:
    """Whether curves whose places are the same are one, the other one drawn backwards or not:
    chains may bend in any way between their places."""
    if not isinstance(chain, Chain) or not isinstance(other, Chain):
        return True
    if turned:
        other = Chain(other.points[::-1])
    shares = np.union1d(*(curve.along / max(curve.length, 1e-300) for curve in (chain, other)))
    one, two = (curve.points_at(shares * curve.length) for curve in (chain, other))
    return bool(np.abs(one - two).max() <= FLATNESS)
