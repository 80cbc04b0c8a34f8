"""A part to start from: slabs along an axis, each with the closed area that explains most."""

from collections.abc import Sequence
from itertools import pairwise

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.feature_kernels import Operation
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet
from gaussiancad_core.proposing.loop_places import prism
from gaussiancad_core.proposing.part_features import Prism
from gaussiancad_core.proposing.plane_loops import Loop, LoopKind, PlaneLoops
from gaussiancad_core.proposing.planned_part import PlannedJudge, PlannedPart

_ROUNDS = 2
"""Times that the sections of all slabs are chosen."""

_MOST_SECTIONS, _MOST_OUTER = 140, 14
"""Areas that a slab may have as its section, and those of them that others are taken out of."""

_MOST_SLABS = 16

_OF_WHOLE, _LEAST, _MOST = 0.1, 0.02, 0.98
"""Shares: of the outline that an area has from which others are taken out of it; of the area that
these have at least and at most."""

_ALIKE = 12
"""Areas that are tried as the section of all slabs, the largest."""

_WORTH = 2.5e-4
"""Share of the lines that another section has to explain."""


def slab_start(
    judge: PlannedJudge,
    plane: PlaneLoops,
    loops: Sequence[Loop],
    until: float,
) -> PlannedPart | None:
    """The part as slabs across a plane's axis; None where there are too many places.

    Args:
        judge: before which it is planned.
        plane: across the axis.
        loops: of it.
        until: work of the judge at which it ends.
    """
    sheet, axis = judge.sheet, plane.axis
    places = _places(sheet, axis)
    sections = _sections(sheet, plane, loops)
    if len(places) > _MOST_SLABS + 1 or not sections:
        return None
    judge.refresh()
    spans = list(pairwise(places))
    outline = next((each for each in sections if each.kind is LoopKind.OUTLINE), sections[0])
    part, chosen = _all_alike(judge, [*sections], outline, places)
    picked = [chosen] * len(spans)
    for _ in range(_ROUNDS):
        is_moved = False
        for slab in sorted(range(len(spans)), key=lambda k: spans[k][0] - spans[k][1]):
            low, high = spans[slab]
            others = [
                prism(sheet, each, low, high) for each in sections if each is not picked[slab]
            ]
            gains = [part.slab_gain(each) for each in others]
            best = min(range(len(gains)), key=gains.__getitem__, default=None)
            if best is not None and gains[best] < -_WORTH * judge.length:
                part.set_slab(others[best])
                picked[slab], is_moved = others[best].loop, True
            if judge.work > until:
                break
        if judge.work > until or not is_moved:
            break
    part.features = [(Operation.ADD, each) for each in _stacked(sheet, picked, spans)]
    return part


def _all_alike(
    judge: PlannedJudge, sections: Sequence[Loop], outline: Loop, places: Sequence[float]
) -> tuple[PlannedPart, Loop]:
    """The part all of whose slabs have one section, the one that explains most."""
    tried = [outline, *sorted(sections, key=lambda each: -each.polygon.area)[:_ALIKE]]
    parts = [
        PlannedPart(judge).set_slab(prism(judge.sheet, each, places[0], places[-1]))
        for each in tried
    ]
    best = min(range(len(parts)), key=lambda k: parts[k].cost)
    return parts[best], tried[best]


def _stacked(
    sheet: PlaneSheet, picked: Sequence[Loop], spans: Sequence[tuple[float, float]]
) -> list[Prism]:
    """Slabs of one section that lie upon each other as one prism."""
    made: list[Prism] = []
    for loop, (low, high) in zip(picked, spans, strict=True):
        if made and made[-1].loop is loop:
            made[-1] = prism(sheet, loop, made[-1].low, high)
        else:
            made.append(prism(sheet, loop, low, high))
    return made


def _places(sheet: PlaneSheet, axis: Axis) -> list[float]:
    """Where slabs may end: at straight lines across an axis, in any view."""
    found = {0.0, float(sheet.size[axis.value])}
    for view in sheet.views:
        if view.axis is axis:
            continue
        column = IN_PLANE[view.axis].index(axis.value)
        for line in view.lines:
            along = line.points[:, column]
            if line.circle is None and float(along.max() - along.min()) <= sheet.tolerance:
                found.add(sheet.level(axis, float(along.mean())))
    return sorted(found)


def _sections(sheet: PlaneSheet, plane: PlaneLoops, loops: Sequence[Loop]) -> list[Loop]:
    """What a slab may have as its section: areas, and what lies between one and another in it."""
    chosen = [loop for loop in loops if loop.kind is not LoopKind.AROUND]
    whole = plane.outline.area
    plain = sorted(
        (loop for loop in chosen if not loop.polygon.interiors), key=lambda each: -each.polygon.area
    )
    for outer in plain[:_MOST_OUTER]:
        area = outer.polygon
        if area.area <= _OF_WHOLE * whole:
            continue
        wide = area.buffer(sheet.tolerance)
        for inner in plain:
            share = inner.polygon.area / area.area
            if not _LEAST < share < _MOST or len(chosen) >= _MOST_SECTIONS:
                continue
            if area.covers(inner.polygon.representative_point()) and wide.covers(inner.polygon):
                rest = area.difference(inner.polygon.buffer(0.0))
                if rest.geom_type == "Polygon":
                    chosen.append(plane.loop(rest, LoopKind.BETWEEN))
    return chosen
