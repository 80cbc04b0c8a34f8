"""Features that repeat: in a row, on a grid, around an axis, or mirrored in a plane of the part.

Only what is certain is told: each member is the first one, moved, within the tolerance of places;
rows and circles have three members at least, and a plane that mirrors two features mirrors the body
that the part begins with as well.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain, combinations

import numpy as np

from gaussiancad_core.features.feature_model import Feature
from gaussiancad_core.features.frames import frame_across
from gaussiancad_core.features.instances import (
    Instance,
    Member,
    Motion,
    instances_of,
    is_moved,
    tolerance_of,
)
from gaussiancad_core.features.pattern_circles import axes_of, circles, middles
from gaussiancad_core.features.pattern_model import DIGITS, Mirror, Pattern
from gaussiancad_core.features.pattern_rows import grids, rows_of


def patterns_of(features: Sequence[Feature]) -> tuple[Pattern, ...]:
    """The patterns of a part; each feature, or hole, is a member of one at most."""
    instances = instances_of(features)
    near = tolerance_of(instances)
    axes = list(axes_of(features))
    body = next((instance for instance in instances if instance.shape[0] != "hole"), None)
    found: list[Pattern] = []
    for group in _alike(instances):
        left = group
        searches: tuple[Callable[[list[Instance]], Iterable[Pattern]], ...] = (
            # Around an axis that the part has, rather than on a grid of as many.
            lambda item: chain(circles(item, axes, near), grids(item, near)),
            lambda item: rows_of(item, near),
            lambda item: circles(item, middles(item), near, whole=True),
            lambda item: _mirrors(item, body, near),
        )
        for search in searches:
            found += _largest_first(search(left))
            taken = {member for pattern in found for member in pattern.members}
            left = [instance for instance in group if instance.member not in taken]
    return tuple(sorted(found, key=lambda pattern: pattern.members[0].order))


def _alike(instances: Sequence[Instance]) -> Iterator[list[Instance]]:
    groups: dict[tuple[object, ...], list[Instance]] = {}
    for instance in instances:
        groups.setdefault((instance.shape, len(instance.points)), []).append(instance)
    yield from (group for group in groups.values() if len(group) > 1)


def _largest_first(offered: Iterable[Pattern]) -> Iterator[Pattern]:
    """The patterns with the most members, none of which is in two."""
    taken: set[Member] = set()
    for pattern in sorted(offered, key=lambda each: -len(each.members)):
        if taken.isdisjoint(pattern.members):
            taken.update(pattern.members)
            yield pattern


def _mirrors(group: Sequence[Instance], body: Instance | None, near: float) -> Iterator[Mirror]:
    """Pairs that planes mirror which mirror the part's first body as well."""
    if body is None:
        return
    for one, other in combinations(group, 2):
        shift = other.place - one.place
        length = float(np.linalg.norm(shift))
        if length <= near or body in (one, other):
            continue
        way, middle = shift / length, (one.place + other.place) / 2.0
        if abs(float((body.place - middle) @ way)) > near:
            continue
        frame = frame_across(tuple(way.tolist()))
        normal = np.array(frame.normal)
        height = float(middle @ normal)
        motion = Motion(np.eye(3) - 2.0 * np.outer(normal, normal), 2.0 * height * normal)
        if is_moved(one, motion, other, near) and is_moved(body, motion, body, near):
            yield Mirror((one.member, other.member), frame, round(height, DIGITS) + 0.0)
