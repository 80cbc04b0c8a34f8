"""Equal closed areas, or profiles, as one feature: holes of one pattern are one decision."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet
from gaussiancad_core.proposing.loop_places import places_of, prism, prisms_of
from gaussiancad_core.proposing.part_features import Pattern, Turned
from gaussiancad_core.proposing.plane_loops import Loop, LoopKind

_PLAIN = (LoopKind.REGION, LoopKind.FILLED, LoopKind.CIRCLE)

_EDGES = 4
"""Edges by which two areas may differ in count: circles are divided where others meet them."""

_DIGITS = 6


def patterns_of(sheet: PlaneSheet, loops: Mapping[Axis, Sequence[Loop]]) -> Iterator[Pattern]:
    """Areas of equal size in a plane, between each two places that all of them have."""
    for of_axis in loops.values():
        groups: dict[tuple[int, int], list[Loop]] = defaultdict(list)
        for loop in of_axis:
            if loop.kind in _PLAIN:
                size = round(loop.polygon.area / (sheet.tolerance * sheet.longest))
                groups[size, len(loop.edges) // _EDGES].append(loop)
        for group in groups.values():
            if len(group) < 2:
                continue
            spans = [
                {
                    (round(each.low, _DIGITS), round(each.high, _DIGITS))
                    for each in prisms_of(sheet, loop)
                }
                for loop in group
            ]
            for low, high in sorted(set.intersection(*spans)):
                yield pattern_between(sheet, group, low, high)


def turned_patterns(turned: Sequence[Turned], near: float) -> Iterator[Pattern]:
    """Equal profiles about several axes, as far as these do not touch each other.

    Args:
        turned: of the sheet.
        near: mm within which two profiles are one.
    """
    groups: dict[tuple[int, ...], list[Turned]] = defaultdict(list)
    for each in turned:
        key = np.round(each.edges / near).astype(int).reshape(-1).tolist()
        groups[each.axis.value, *key].append(each)
    for group in groups.values():
        kept: list[Turned] = []
        for each in group:
            away = [np.hypot(*np.subtract(each.centre, other.centre)) for other in kept]
            if min(away, default=np.inf) > 2.0 * each.radius:
                kept.append(each)
        if len(kept) > 1:
            yield Pattern(tuple(kept))


def places_of_all(sheet: PlaneSheet, loops: Sequence[Loop]) -> list[float]:
    """Places at which prisms of all of some areas may end, mm, the least first."""
    found = [{round(place, _DIGITS) for place in places_of(sheet, loop)} for loop in loops]
    return sorted(set.intersection(*found))


def pattern_between(sheet: PlaneSheet, loops: Sequence[Loop], low: float, high: float) -> Pattern:
    """Areas between two places, mm along their axis."""
    return Pattern(tuple(prism(sheet, loop, low, high) for loop in loops))
