"""What features stand on as plain values, for ``features.json``."""

from collections import deque
from collections.abc import Sequence
from typing import Any

from gaussiancad_core.features.feature_model import Extrusion, Feature, Holes, Turning
from gaussiancad_core.features.frames import Frame
from gaussiancad_core.features.supported_features import Side, Support, along, edges_in, frame_of
from gaussiancad_core.features.supporting_faces import standing_of
from gaussiancad_core.geometry.tolerances import COMPUTED

_AXES = ("distance-x", "distance-y")
"""Kinds of dimensions along the coordinates of a sketch."""

Values = dict[str, Any]


def with_standing(features: Sequence[Feature], values: Sequence[Values]) -> list[Values]:
    """Values of features, with what those that begin in a plane stand on and end at.

    Args:
        features: of a solid.
        values: of each, as :func:`.as_json.feature_values` has them.
    """
    found = []
    for feature, value, where in zip(features, values, standing_of(features), strict=True):
        if isinstance(feature, Extrusion | Holes):
            frame = frame_of(feature)
            begins, ends = (
                None if each is None else _support(each, features, values, frame)
                for each in (where.begins, where.ends)
            )
            found.append({**value, "stands_on": begins, "ends_at": ends})
        else:
            found.append(value)
    return found


def _support(
    support: Support, features: Sequence[Feature], values: Sequence[Values], frame: Frame
) -> Values:
    stated = values[support.feature]
    found = {"feature": stated["name"], "side": support.side.value}
    if support.side is not Side.WALL:
        return found
    feature = features[support.feature]
    assert isinstance(feature, Extrusion | Turning)
    axis, way = along(feature.sketch.frame, frame.normal) or (0, 1.0)
    coordinate = edges_in(feature.sketch)[support.edge].start[axis]
    dimensions = dimensions_to(coordinate, axis, stated["sketch"])
    if dimensions is not None:
        dimensions = {name: int(way * sign) for name, sign in dimensions.items()}
    return {**found, "edge": support.edge, "dimensions": dimensions}


def dimensions_to(coordinate: float, axis: int, sketch: Values) -> dict[str, int] | None:
    """The fewest dimensions of a sketch that lead from its origin to a coordinate, with 1 where
    they count and -1 where they are taken off; None where none do.

    Args:
        coordinate: mm.
        axis: 0 or 1.
        sketch: its values, with geometry and constraints.
    """
    steps: list[tuple[float, float, str]] = []
    for constraint in sketch["constraints"]:
        if constraint["kind"] == _AXES[axis]:
            low, high = _ends(sketch, constraint["of"], axis)
            steps += [(low, high, constraint["name"]), (high, low, constraint["name"])]
    ways: deque[tuple[float, dict[str, int]]] = deque([(0.0, {})])
    seen = [0.0]
    while ways:
        place, known = ways.popleft()
        if abs(place - coordinate) < COMPUTED:
            return known
        for start, end, name in steps:
            if abs(start - place) < COMPUTED and all(abs(end - other) > COMPUTED for other in seen):
                seen.append(end)
                ways.append((end, {**known, name: 1 if end > start else -1}))
    return None


def _ends(sketch: Values, of: Sequence[tuple[int, str | None]], axis: int) -> list[float]:
    """Coordinates of what a distance is between: two points, or the ends of a line."""
    if len(of) == 1:
        of = [(of[0][0], "start"), (of[0][0], "end")]
    return [
        0.0 if element < 0 else float(sketch["geometry"][element][spot or "start"][axis])
        for element, spot in of
    ]
