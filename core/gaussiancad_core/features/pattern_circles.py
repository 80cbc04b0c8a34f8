"""Features at equal angles around an axis."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.features.feature_model import Extrusion, Feature, Holes, Turning
from gaussiancad_core.features.frames import frame_across
from gaussiancad_core.features.instances import Instance, Motion, is_moved
from gaussiancad_core.features.pattern_model import (
    DIGITS,
    FEWEST,
    Circle,
    positive,
    rounded_vector,
)

Points = npt.NDArray[np.float64]


def axes_of(features: Sequence[Feature]) -> Iterator[tuple[Points, Points]]:
    """(3,) point and (3,) direction of each axis that the part has."""
    for feature in features:
        if isinstance(feature, Holes):
            # Of several like holes none is what others are around.
            if len(feature.centres) == 1:
                (place,) = feature.frame.lift(np.array(feature.centres), feature.height)
                yield place, np.array(feature.frame.normal)
        elif isinstance(feature, Turning):
            frame, height = feature.sketch.frame, feature.sketch.height
            x, y = feature.direction
            (place,) = frame.lift(np.array([feature.point]), height)
            yield place, x * np.array(frame.right) + y * np.array(frame.up)
        elif isinstance(feature, Extrusion):
            frame = feature.sketch.frame
            edges = (edge for loop in feature.sketch.loops for edge in loop)
            centres = {edge.circle.centre for edge in edges if edge.circle is not None}
            for centre in sorted(centres):
                yield frame.lift(np.array([centre]), 0.0)[0], np.array(frame.normal)


def middles(group: Sequence[Instance]) -> list[tuple[Points, Points]]:
    """The axes across the planes that members lie in, through the middle of all of them."""
    if len(group) < FEWEST:
        return []
    places = np.array([instance.place for instance in group])
    middle = places.mean(axis=0)
    _, sizes, ways = np.linalg.svd(places - middle)
    return [(middle, ways[2])] if sizes[1] > sizes[0] / 2.0 else []


def circles(
    group: Sequence[Instance],
    axes: Iterable[tuple[Points, Points]],
    near: float,
    *,
    whole: bool = False,
) -> Iterator[Circle]:
    """Members around axes.

    Args:
        group: of one shape.
        axes: (3,) points and (3,) directions.
        near: mm within which places are one.
        whole: whether only whole turns are looked for.
    """
    for point, direction in axes:
        way = positive(direction / float(np.linalg.norm(direction)))
        for ring in _rings(group, point, way, near):
            for ordered, angle in _orders(ring, point, way, whole):
                turns = [_turned(point, way, k * angle) for k in range(len(ordered))]
                moved = zip(turns, ordered, strict=True)
                if all(is_moved(ordered[0], turn, instance, near) for turn, instance in moved):
                    yield _circle(ordered, point, way, angle)
                    break


def _orders(
    ring: Sequence[Instance], point: Points, way: Points, whole: bool
) -> Iterator[tuple[list[Instance], float]]:
    """Members from the first one on, and degrees between them, if they repeat: in a whole turn,
    which begins with the first feature; in a part of one, which begins after the widest gap."""
    first = min(range(len(ring)), key=lambda k: ring[k].member.order)
    yield [*ring[first:], *ring[:first]], 360.0 / len(ring)
    if not whole:
        angles = np.array([_angle(instance.place - point, way) for instance in ring])
        gaps = np.diff([*angles, angles[0] + 360.0])
        widest = int(np.argmax(gaps))
        angle = float(np.delete(gaps, widest).mean())
        yield [*ring[widest + 1 :], *ring[: widest + 1]], angle


def _circle(ring: Sequence[Instance], point: Points, way: Points, angle: float) -> Circle:
    away = ring[0].place - point
    along = float(away @ way)
    diameter = 2.0 * float(np.linalg.norm(away - along * way))
    place = point + along * way
    members = tuple(instance.member for instance in ring)
    return Circle(
        members,
        rounded_vector(np.round(place, DIGITS)),
        rounded_vector(way),
        round(angle, DIGITS),
        round(diameter, DIGITS),
    )


def _rings(
    group: Sequence[Instance], point: Points, way: Points, near: float
) -> Iterator[list[Instance]]:
    """Members that are equally far from an axis and along it, in the order of their angles."""
    away = np.array([instance.place for instance in group]) - point
    along = away @ way
    radii = np.linalg.norm(away - along[:, None] * way, axis=1)
    rings: dict[tuple[int, int], list[int]] = {}
    for k, key in enumerate(zip(_classes(along, near), _classes(radii, near), strict=True)):
        rings.setdefault(key, []).append(k)
    for ring in rings.values():
        if len(ring) >= FEWEST and radii[ring[0]] > near:
            yield [group[k] for k in sorted(ring, key=lambda k: _angle(away[k], way))]


def _classes(values: Points, near: float) -> list[int]:
    """Numbers of the groups that values fall in between which there are wider gaps."""
    order = np.argsort(values)
    steps = np.diff(values[order], prepend=values[order[0]]) > near
    found = np.empty(len(values), dtype=np.int64)
    found[order] = np.cumsum(steps)
    return found.tolist()


def _turned(point: Points, way: Points, angle: float) -> Motion:
    """The turn around an axis by degrees."""
    x, y, z = way
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    turn = np.radians(angle)
    matrix = np.eye(3) + np.sin(turn) * cross + (1.0 - np.cos(turn)) * cross @ cross
    return Motion(matrix, point - matrix @ point)


def _angle(away: Points, way: Points) -> float:
    """Degrees around an axis, 0 to 360, from one direction across it."""
    right = np.array(frame_across(tuple(way.tolist())).right)
    return float(np.degrees(np.arctan2(away @ np.cross(way, right), away @ right))) % 360.0
