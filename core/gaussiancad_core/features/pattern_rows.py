"""Features at equal distances, along a line or on a grid."""

from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np
import numpy.typing as npt

from gaussiancad_core.features.instances import Instance, Motion, is_moved
from gaussiancad_core.features.pattern_model import (
    DIGITS,
    FEWEST,
    Row,
    Step,
    positive,
    rounded_vector,
)

Points = npt.NDArray[np.float64]


def grids(group: Sequence[Instance], near: float) -> Iterator[Row]:
    """Members that fill a grid, those of each feature and plane by themselves."""
    for level in _levels(group):
        places = np.array([instance.place for instance in level])
        if len(level) < 4:
            continue
        for other in places[1:]:
            right = positive((other - places[0]) / float(np.linalg.norm(other - places[0])))
            grid = _grid(level, places, right, near)
            if grid is not None:
                yield grid
                break


def _grid(level: Sequence[Instance], places: Points, right: Points, near: float) -> Row | None:
    """All members as a grid with one direction; None where they are none."""
    away = places - places[0]
    across = away - (away @ right)[:, None] * right
    farthest = across[int(np.linalg.norm(across, axis=1).argmax())]
    if float(np.linalg.norm(farthest)) <= near:
        return None
    up = positive(farthest / float(np.linalg.norm(farthest)))
    # The direction of the larger component comes first: x before y before z.
    right, up = sorted((right, up), key=lambda way: int(np.argmax(np.abs(way))))
    levels = [_equal_levels(away @ way, near) for way in (right, up)]
    if any(found is None for found in levels):
        return None
    columns, rows = (found for found in levels if found is not None)
    if min(len(columns), len(rows)) < 2 or len(columns) * len(rows) != len(level):
        return None
    ordered = sorted(
        level,
        key=lambda instance: tuple(
            int(np.abs(np.array(at) - float((instance.place - places[0]) @ way)).argmin())
            for at, way in ((rows, up), (columns, right))
        ),
    )
    steps = tuple(
        Step(rounded_vector(way), len(at), round((at[-1] - at[0]) / (len(at) - 1), DIGITS))
        for at, way in ((columns, right), (rows, up))
    )
    shifts = [
        column * steps[0].distance * right + row * steps[1].distance * up
        for row in range(len(rows))
        for column in range(len(columns))
    ]
    return Row(tuple(o.member for o in ordered), steps) if _all_at(ordered, shifts, near) else None


def _equal_levels(values: Points, near: float) -> list[float] | None:
    """Different values, ascending; None where they are not equally far apart."""
    found: list[float] = []
    for value in sorted(values.tolist()):
        if not found or value - found[-1] > near:
            found.append(value)
    gaps = np.diff(found)
    return found if not len(gaps) or float(np.ptp(gaps)) <= near else None


def _levels(group: Sequence[Instance]) -> Iterator[list[Instance]]:
    """Holes of one feature together; other features all together."""
    by_feature: dict[int | None, list[Instance]] = {}
    for instance in group:
        key = None if instance.member.centre is None else instance.member.feature
        by_feature.setdefault(key, []).append(instance)
    yield from by_feature.values()


def rows_of(group: Sequence[Instance], near: float) -> Iterator[Row]:
    """The longest rows of members at equal distances."""
    if len(group) < FEWEST:
        return
    places = np.array([instance.place for instance in group])
    for one, other in combinations(range(len(group)), 2):
        shift = places[other] - places[one]
        length = float(np.linalg.norm(shift))
        if length <= near:
            continue
        way = positive(shift / length)
        start = one if float(shift @ way) > 0.0 else other
        if _at(places, places[start] - length * way, near) is not None:
            continue
        run: list[int] = []
        following: int | None = start
        while following is not None:
            run.append(following)
            following = _at(places, places[start] + len(run) * length * way, near)
        distance = round(length, DIGITS)
        ordered = [group[k] for k in run]
        shifts = [k * distance * way for k in range(len(run))]
        if len(run) >= FEWEST and _all_at(ordered, shifts, near):
            yield Row(
                tuple(o.member for o in ordered), (Step(rounded_vector(way), len(run), distance),)
            )


def _at(places: Points, place: Points, near: float) -> int | None:
    apart = np.abs(places - place).max(axis=1)
    nearest = int(apart.argmin())
    return nearest if float(apart[nearest]) <= near else None


def _all_at(ordered: Sequence[Instance], shifts: Sequence[Points], near: float) -> bool:
    return all(
        is_moved(ordered[0], Motion(np.eye(3), shift), instance, near)
        for instance, shift in zip(ordered, shifts, strict=True)
    )
