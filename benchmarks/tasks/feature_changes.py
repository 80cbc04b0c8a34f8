"""The numbers that drive features, and the solid when one of them is another."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from benchmarks.tasks.feature_sketches import UnsolvedError, solved
from gaussiancad_core.features.constraints import Constraint, Kind, Numbers, constraints_of
from gaussiancad_core.features.dressing import dressed
from gaussiancad_core.features.drilling import body_of_holes
from gaussiancad_core.features.feature_building import combined
from gaussiancad_core.features.feature_model import (
    EdgeBreak,
    Extrusion,
    Feature,
    FeatureList,
    Holes,
    Turning,
)
from gaussiancad_core.features.loops import Loop
from gaussiancad_core.features.supported_features import Standing, standing
from gaussiancad_core.features.supporting_faces import standing_of
from gaussiancad_core.geometry.outline_edges import whole_circle
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.kernel.booleans import unified, without
from gaussiancad_core.kernel.brep import bounding_box, is_valid, subshapes
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES

_ROUND = (Kind.RADIUS, Kind.DIAMETER)


@dataclass(frozen=True)
class Number:
    """A number that drives a feature.

    Attributes:
        feature: its place in the list.
        name: of the feature's attribute, or the number of a constraint.
        kind: ``length``, ``place``, ``diameter``, ``depth``, ``angle``, ``size``, or
            ``distance`` and ``radius`` of sketches.
    """

    feature: int
    name: str | int
    kind: str


def numbers_of(features: Sequence[Feature]) -> Iterator[Number]:
    """All of them, feature by feature; what follows from others is none."""
    for k, (feature, where) in enumerate(zip(features, standing_of(features), strict=True)):
        if isinstance(feature, EdgeBreak):
            yield Number(k, "size", "size")
            continue
        if isinstance(feature, Holes):
            yield from _of_holes(k, feature, where)
        elif feature.sketch.height and where.begins is None:
            yield Number(k, "height", "place")
        if isinstance(feature, Extrusion) and where.ends is None:
            yield Number(k, "length", "length")
        for number, constraint in enumerate(constraints_of(outlines(feature), Numbers())):
            if constraint.value is None:
                continue
            is_round = constraint.kind in _ROUND
            if not (is_round and isinstance(feature, Holes)):
                yield Number(k, number, "radius" if is_round else "distance")


def _of_holes(k: int, holes: Holes, where: Standing) -> Iterator[Number]:
    yield Number(k, "diameter", "diameter")
    if holes.height and where.begins is None:
        yield Number(k, "height", "place")
    if holes.depth is not None and where.ends is None:
        yield Number(k, "depth", "depth")
    if holes.tip:
        yield Number(k, "tip", "angle")
    if holes.sink is not None:
        yield Number(k, "sink.diameter", "diameter")
        is_cone = holes.sink.angle > 0.0
        yield Number(k, "sink.angle" if is_cone else "sink.depth", "angle" if is_cone else "depth")


def outlines(feature: Extrusion | Turning | Holes) -> tuple[Loop, ...]:
    """A feature's sketch; of holes their circles."""
    if not isinstance(feature, Holes):
        return feature.sketch.loops
    radius = feature.diameter / 2.0
    return tuple((whole_circle(Circle(centre, radius)),) for centre in feature.centres)


def changed(features: Sequence[Feature], number: Number, factor: float) -> tuple[Feature, ...]:
    """Features with one number as many times as large; what stands on others goes with them.

    Raises:
        UnsolvedError: the sketch has no solution then.
    """
    feature = features[number.feature]
    made = _changed(feature, number, factor)
    others = (*features[: number.feature], made, *features[number.feature + 1 :])
    return standing(others, standing_of(features))


def _changed(feature: Feature, number: Number, factor: float) -> Feature:
    name = number.name
    if isinstance(name, int):
        assert not isinstance(feature, EdgeBreak)
        loops = outlines(feature)
        found = solved(loops, _scaled(constraints_of(loops, Numbers()), name, factor))
        if isinstance(feature, Holes):
            centres = tuple(edge.circle.centre for edge, *_ in found if edge.circle is not None)
            return replace(feature, centres=centres)
        return replace(feature, sketch=replace(feature.sketch, loops=found))
    if name.startswith("sink."):
        assert isinstance(feature, Holes)
        name = name.removeprefix("sink.")
        return replace(
            feature, sink=replace(feature.sink, **{name: _times(feature.sink, name, factor)})
        )
    if name == "height" and not isinstance(feature, Holes):
        assert not isinstance(feature, EdgeBreak)
        sketch = replace(feature.sketch, height=feature.sketch.height * factor)
        return replace(feature, sketch=sketch)
    return replace(feature, **{name: _times(feature, name, factor)})


def _times(whole: object, name: str, factor: float) -> float:
    return float(getattr(whole, name)) * factor


def _scaled(
    constraints: Sequence[Constraint], number: int, factor: float
) -> tuple[Constraint, ...]:
    return tuple(
        replace(each, value=each.value * factor) if k == number and each.value is not None else each
        for k, each in enumerate(constraints)
    )


def rebuilt(features: Sequence[Feature], base: TopoDS_Shape | None) -> TopoDS_Shape | None:
    """The one valid solid that features make; None where they make none."""
    try:
        bodies = [f for f in features if isinstance(f, Extrusion | Turning)]
        made = combined(bodies) if base is None else base
        breaks = [feature for feature in features if isinstance(feature, EdgeBreak)]
        holes = [feature for feature in features if isinstance(feature, Holes)]
        dressed_body = dressed(made, breaks) if breaks else made
        if dressed_body is None:
            return None
        if holes:
            reach = 4.0 * float(np.abs(bounding_box(dressed_body)).max() + 1.0)
            tools = [body_of_holes(each, reach) for each in holes]
            dressed_body = without(dressed_body, tools)
        found = subshapes(unified(dressed_body), TopAbs_ShapeEnum.TopAbs_SOLID)
    except KERNEL_FAILURES:
        return None
    return found[0] if len(found) == 1 and is_valid(found[0]) else None


def failure_of(found: FeatureList, number: Number, factor: float) -> str | None:
    """What goes wrong when a number is another: ``unsolved`` or ``unbuilt``; None if nothing."""
    try:
        features = changed(found.features, number, factor)
    except UnsolvedError:
        return "unsolved"
    return None if rebuilt(features, found.base) is not None else "unbuilt"
