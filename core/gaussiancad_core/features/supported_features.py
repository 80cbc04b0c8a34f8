"""What features stand on: where a sketch lies in a face that an earlier feature made, it belongs
there, wherever that face is when a number is another.

A pad's sketch, its far end and the walls that its outline's straight edges sweep are such faces; of
turned bodies what edges across the axis sweep.  Only earlier features count, so that nothing stands
on itself.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from gaussiancad_core.features.feature_model import Extrusion, Feature, Holes, Sketch, Turning
from gaussiancad_core.features.frames import Frame
from gaussiancad_core.geometry.outline_edges import OutlineEdge
from gaussiancad_core.geometry.tolerances import UNIT_VECTOR


class Side(Enum):
    """Which face of a feature; the values stand in files."""

    START = "start"
    END = "end"
    WALL = "wall"


@dataclass(frozen=True)
class Support:
    """A face of an earlier feature.

    Attributes:
        feature: its place in the list.
        side: of it.
        edge: of a wall, the number of the straight edge of the sketch that sweeps it; else -1.
    """

    feature: int
    side: Side
    edge: int = -1


@dataclass(frozen=True)
class Standing:
    """Where a feature begins and ends.

    Attributes:
        begins: the face that its sketch lies in; None where that is a number of its own.
        ends: the face that its far end lies in; likewise.
    """

    begins: Support | None = None
    ends: Support | None = None


def standing(features: Sequence[Feature], where: Sequence[Standing]) -> tuple[Feature, ...]:
    """Features with other numbers, each begun and ended where its faces are now.

    Args:
        features: as many as before.
        where: they stood before, in the same order.
    """
    placed: list[Feature] = []
    for feature, this_standing in zip(features, where, strict=True):
        placed.append(_placed(feature, this_standing, placed))
    return tuple(placed)


def along(frame: Frame, normal: Sequence[float]) -> tuple[int, float] | None:
    """The coordinate of a plane that runs along a direction: 0 or 1, and 1 or -1 where it runs
    against it; None where neither does."""
    for axis, direction in enumerate((frame.right, frame.up)):
        product = float(np.array(direction) @ np.array(normal))
        if abs(abs(product) - 1.0) < UNIT_VECTOR:
            return axis, 1.0 if product > 0.0 else -1.0
    return None


def edges_in(sketch: Sketch) -> tuple[OutlineEdge, ...]:
    """The elements of a sketch in their order."""
    return tuple(edge for loop in sketch.loops for edge in loop)


def _placed(feature: Feature, standing: Standing, earlier: Sequence[Feature]) -> Feature:
    if not isinstance(feature, Extrusion | Holes):
        return feature
    if standing.begins is not None:
        height = height_of(earlier, standing.begins, frame_of(feature))
        if isinstance(feature, Holes):
            feature = replace(feature, height=height)
        else:
            feature = replace(feature, sketch=replace(feature.sketch, height=height))
    if standing.ends is None:
        return feature
    end = height_of(earlier, standing.ends, frame_of(feature))
    if isinstance(feature, Holes):
        return replace(feature, depth=abs(end - feature.height))
    return replace(feature, length=end - feature.sketch.height)


def frame_of(feature: Extrusion | Holes) -> Frame:
    """Of the plane that a feature begins in."""
    return feature.frame if isinstance(feature, Holes) else feature.sketch.frame


def height_of(features: Sequence[Feature], support: Support, frame: Frame) -> float:
    """mm of a face along the normal of a plane that is parallel to it."""
    feature = features[support.feature]
    assert isinstance(feature, Extrusion | Turning)
    if support.side is Side.WALL:
        found = along(feature.sketch.frame, frame.normal)
        assert found is not None
        axis, way = found
        return way * edges_in(feature.sketch)[support.edge].start[axis]
    assert isinstance(feature, Extrusion)
    ends = support.side is Side.END
    return feature.sketch.height + (feature.length if ends else 0.0)
