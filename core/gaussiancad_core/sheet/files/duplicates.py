"""Strokes that a file draws twice over: one of them tells all.

Exports, merged layers and copies pasted in place leave the same curve twice.  Chords that are drawn
twice have four ends where two should meet, so that nothing goes on in anything.
"""

from collections.abc import Hashable, Sequence

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.sheet.files.vectors import VectorStroke

_SAME = 0.02
"""px within which curves are one: chains follow what they stand for as closely."""


def distinct_strokes(strokes: Sequence[VectorStroke]) -> tuple[VectorStroke, ...]:
    """The strokes without those that are drawn along another of the same pen, whichever way; of
    several the widest stays, else the first.

    Args:
        strokes: of a page; px.
    """
    groups: dict[Hashable, list[int]] = {}
    for index, own in enumerate(strokes):
        groups.setdefault(_pen(own), []).append(index)
    left_out: set[int] = set()
    for group in groups.values():
        group.sort(key=lambda index: -(strokes[index].width or 0.0))
        left_out.update(group[number] for number in _repeated([strokes[own] for own in group]))
    return tuple(own for index, own in enumerate(strokes) if index not in left_out)


def _pen(own: VectorStroke) -> Hashable:
    """What strokes have in common one of which may stand for the other."""
    return type(own.curve), own.kind, own.role, own.layer, own.colour, own.dashes


def _repeated(strokes: Sequence[VectorStroke]) -> list[int]:
    """Numbers of strokes that lie along an earlier one."""
    if len(strokes) < 2:
        return []
    there = np.array([_places(own) for own in strokes])
    back = np.concatenate([there[:, 4:6], there[:, 2:4], there[:, :2], there[:, 6:]], axis=1)
    tree = cKDTree(there)
    reach = _SAME * np.sqrt(there.shape[1])
    left_out: set[int] = set()
    for index in range(len(strokes)):
        if index in left_out:
            continue
        for way in (there[index], back[index]):
            near = tree.query_ball_point(way, reach)
            left_out.update(
                other
                for other in near
                if other > index and np.abs(there[other] - way).max() <= _SAME
            )
    return sorted(left_out)


def _places(own: VectorStroke) -> npt.NDArray[np.float64]:
    """(8,) px: start, middle and end of a curve, and its length twice, by which those of closed
    curves are told apart."""
    points = own.curve.sample(np.inf)
    count = len(points)
    middle = (points[(count - 1) // 2] + points[count // 2]) / 2.0
    return np.concatenate([points[0], middle, points[-1], [own.curve.length] * 2])
