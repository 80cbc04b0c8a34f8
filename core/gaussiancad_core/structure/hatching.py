"""Hatching: families of slanted parallels at one distance (ISO 128-3)."""

from collections import defaultdict
from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from gaussiancad_core.files.vectors import StrokeKind, StrokeRole
from gaussiancad_core.geometry.near_points import connected_groups, near_pairs
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, lines_of

_SHORTEST = 0.4
"""mm of a line of hatching at least."""

_SLANTED = 4.0
"""Degrees from the sheet's axes at least."""

_NEAR = 5.0
"""mm between neighbouring lines at most."""

_FEWEST, _FEWEST_NAMED = 4, 2
"""Lines of a family, and of one that the file names."""

_LEAST_STEP, _LARGEST_STEP = 0.15, 8.0
"""mm from one line to the next."""

_EVEN, _MOST = 0.15, 0.65
"""Share of a step by which lines may lie beside whole ones; share of the lines that lie so."""

_ALONG, _ROUNDED = 1.0, 0.04
"""Degrees by which lines of one family may differ, and mm by which the ends of short ones may lie
aside besides."""

_MEET = 0.05
"""mm within which ends meet."""


def hatching_apart(
    labelled: LabelledStrokes,
) -> tuple[LabelledStrokes, list[list[PaperStroke]]]:
    """The strokes, hatching told, and its families."""
    families = list(_families(labelled))
    named = [
        number
        for number in labelled.numbers(Label.OPEN, Label.OTHER)
        if is_named(labelled.strokes[number])
    ]
    numbers = [*named, *(number for family in families for number in family)]
    labelled = labelled.with_label(numbers, Label.HATCH, "one of a family of parallels")
    return labelled, [[labelled.strokes[number] for number in family] for family in families]


def is_named(stroke: PaperStroke) -> bool:
    """Whether a file says that a stroke is hatching."""
    return stroke.kind is StrokeKind.HATCH or stroke.role is StrokeRole.HATCH


def _families(labelled: LabelledStrokes) -> Iterator[list[int]]:
    """Numbers of the lines of each family; a file that names its hatching has no other."""
    has_names = any(is_named(stroke) for stroke in labelled.strokes)
    chamfers = set() if has_names else _between_corners(labelled)
    degrees: dict[object, list[tuple[float, float, int]]] = defaultdict(list)
    for number in labelled.numbers(Label.OPEN, Label.OTHER):
        stroke = labelled.strokes[number]
        if number in chamfers:
            continue
        if not stroke.is_line or stroke.length <= _SHORTEST or is_named(stroke) != has_names:
            continue
        angle = float(np.degrees(np.arctan2(stroke.way[1], stroke.way[0]))) % 180.0
        if has_names:
            degrees[None].append((angle, stroke.length, number))
        elif not stroke.dashes and stroke.role is not StrokeRole.VISIBLE and _is_slanted(angle):
            degrees[stroke.pen].append((angle, stroke.length, number))
    fewest = _FEWEST_NAMED if has_names else _FEWEST
    for of_pen in degrees.values():
        for parallels in _parallels(sorted(of_pen)):
            for family in _beside_each_other(labelled.strokes, parallels, fewest):
                if has_names or _is_even([labelled.strokes[number] for number in family]):
                    yield family


def _between_corners(labelled: LabelledStrokes) -> set[int]:
    """Numbers of lines both of whose ends are at ends of others, as those of chamfers are: hatching
    ends anywhere along an outline."""
    numbers = labelled.numbers(Label.OPEN, Label.OTHER)
    if len(numbers) < _FEWEST:
        return set()
    ends = np.concatenate([labelled.strokes[number].ends for number in numbers])
    meets = np.zeros(len(ends), dtype=bool)
    meets[near_pairs(ends, _MEET).reshape(-1)] = True
    return {numbers[index] for index in np.flatnonzero(meets.reshape(-1, 2).all(axis=1))}


def _is_slanted(angle: float) -> bool:
    return min(angle % 90.0, 90.0 - angle % 90.0) >= _SLANTED


def _parallels(by_angle: Sequence[tuple[float, float, int]]) -> Iterator[list[int]]:
    """Numbers of lines whose directions follow each other closely."""
    group: list[int] = []
    last = -np.inf
    for angle, length, number in by_angle:
        apart = _ALONG + float(np.degrees(np.arctan2(_ROUNDED, length)))
        if angle - last > apart and group:
            yield group
            group = []
        group.append(number)
        last = angle
    if group:
        yield group


def _beside_each_other(
    strokes: Sequence[PaperStroke], numbers: Sequence[int], fewest: int
) -> Iterator[list[int]]:
    if len(numbers) < fewest:
        return
    lines = lines_of([strokes[number] for number in numbers])
    pairs = shapely.STRtree(lines).query(lines, "dwithin", _NEAR)
    groups = connected_groups(pairs.T, len(lines))
    for group in np.unique(groups).tolist():
        members = np.flatnonzero(groups == group).tolist()
        if len(members) >= fewest:
            yield [numbers[index] for index in members]


def _is_even(lines: Sequence[PaperStroke]) -> bool:
    """Whether parallel lines lie whole steps of one distance apart."""
    ways = np.array([line.way * (1.0 if line.way[0] > 0.0 else -1.0) for line in lines])
    along = np.median(ways, axis=0)
    across = np.array([-along[1], along[0]])
    places = np.sort([float(line.points.mean(axis=0) @ across) for line in lines])
    steps = np.diff(places)
    steps = steps[steps > _LEAST_STEP]
    if len(steps) < _FEWEST - 1:
        return False
    step = float(np.median(steps))
    off = np.abs(steps / step - np.rint(steps / step))
    return step < _LARGEST_STEP and bool((off < _EVEN).mean() > _MOST)
