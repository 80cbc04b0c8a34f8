"""Equal closed areas of a plane as one feature: holes of one pattern are one decision."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet
from gaussiancad_core.proposing.loop_places import places_of, prism, prisms_of
from gaussiancad_core.proposing.part_features import Pattern
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
                yield Pattern(tuple(prism(sheet, loop, low, high) for loop in group))


def places_of_all(sheet: PlaneSheet, pattern: Pattern) -> list[float]:
    """Places at which each of a pattern's prisms may end, mm, the least first."""
    found = [
        {round(place, _DIGITS) for place in places_of(sheet, part.loop)} for part in pattern.parts
    ]
    return sorted(set.intersection(*found))


def pattern_between(sheet: PlaneSheet, pattern: Pattern, low: float, high: float) -> Pattern:
    """The same areas between other places, mm along their axis."""
    return Pattern(tuple(prism(sheet, part.loop, low, high) for part in pattern.parts))
