"""What may repeat: single holes, pads, pockets and turned bodies, by points that tell them from
others."""

from collections.abc import Sequence
from dataclasses import astuple, dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.features.feature_model import (
    EdgeBreak,
    Extrusion,
    Feature,
    Holes,
    Sketch,
    Turning,
)
from gaussiancad_core.geometry.tolerances import COMPUTED

Points = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Member:
    """A feature, or one hole of it.

    Attributes:
        feature: its place in the list.
        centre: number of the hole's centre; None of features that are no holes.
    """

    feature: int
    centre: int | None = None

    @property
    def order(self) -> tuple[int, int]:
        """What members are sorted by."""
        return self.feature, self.centre or 0


@dataclass(frozen=True, eq=False)
class Instance:
    """A body that a feature adds or takes away.

    Attributes:
        member: what it is of.
        shape: what is the same wherever it is: kind, and sizes in mm.
        points: (n, 4) mm, where it is, and a radius.  Two of one shape are the same body if their
            points are, in any order.
    """

    member: Member
    shape: tuple[object, ...]
    points: Points

    @property
    def place(self) -> Points:
        """(3,) mm, the middle of its points."""
        return self.points[:, :3].mean(axis=0)


@dataclass(frozen=True, eq=False)
class Motion:
    """A rigid motion, or a reflection: ``matrix @ point + shift``.

    Attributes:
        matrix: (3, 3).
        shift: (3,) mm.
    """

    matrix: Points
    shift: Points

    def moved(self, points: Points) -> Points:
        """(n, 4) points of an instance, moved."""
        return np.hstack([points[:, :3] @ self.matrix.T + self.shift, points[:, 3:]])


def instances_of(features: Sequence[Feature]) -> tuple[Instance, ...]:
    """All that may repeat, in the order of the features."""
    found: list[Instance] = []
    for number, feature in enumerate(features):
        if isinstance(feature, Holes):
            found += _holes(number, feature)
        elif isinstance(feature, Extrusion):
            found.append(_extrusion(number, feature))
        elif not isinstance(feature, EdgeBreak):
            found.append(_turning(number, feature))
    return tuple(found)


def tolerance_of(instances: Sequence[Instance]) -> float:
    """mm within which places are one."""
    return COMPUTED * max((float(np.abs(each.points).max()) for each in instances), default=1.0)


def is_moved(one: Instance, motion: Motion, other: Instance, near: float) -> bool:
    """Whether one body, moved, is another, within mm."""
    if one.shape != other.shape or len(one.points) != len(other.points):
        return False
    apart, numbers = cKDTree(other.points).query(motion.moved(one.points))
    return bool((apart <= near).all()) and len(set(numbers.tolist())) == len(one.points)


def _holes(number: int, holes: Holes) -> list[Instance]:
    normal = np.array(holes.frame.normal)
    # A second point tells which way they are drilled.
    inwards = (-1.0 if holes.is_downward else 1.0) * holes.diameter * normal
    sink = () if holes.sink is None else astuple(holes.sink)
    shape = "hole", *_rounded(holes.diameter, holes.depth, holes.tip, *sink)
    found = []
    for centre, start in enumerate(holes.frame.lift(np.array(holes.centres), holes.height)):
        points = np.array([[*start, 0.0], [*(start + inwards), 0.0]])
        found.append(Instance(Member(number, centre), shape, points))
    return found


def _extrusion(number: int, feature: Extrusion) -> Instance:
    flat, radii = _outline(feature.sketch)
    frame, height = feature.sketch.frame, feature.sketch.height
    ends = [frame.lift(flat, at) for at in (height, height + feature.length)]
    shape = "extrusion", feature.adds, *_rounded(abs(feature.length))
    return Instance(Member(number), shape, np.vstack([np.hstack([end, radii]) for end in ends]))


def _turning(number: int, feature: Turning) -> Instance:
    """A turned body: how far along the axis each point of its outline is, and how far from it."""
    flat, _ = _outline(feature.sketch)
    start, way = np.array(feature.point), np.array(feature.direction)
    along = (flat - start) @ way / float(way @ way)
    on_axis = start + along[:, None] * way
    away = np.linalg.norm(flat - on_axis, axis=1)
    lifted = feature.sketch.frame.lift(on_axis, feature.sketch.height)
    shape = "turning", feature.adds
    return Instance(Member(number), shape, np.hstack([lifted, away[:, None]]))


def _outline(sketch: Sketch) -> tuple[Points, Points]:
    """(n, 2) starts and middles of a sketch's edges, and (n, 1) their radii; 0 of lines."""
    edges = [edge for loop in sketch.loops for edge in loop]
    # Of a circle the centre: it has no point that tells how it lies.
    flat = [
        e.circle.centre if e.circle is not None and e.is_circle else p
        for e in edges
        for p in (e.start, e.middle)
    ]
    radii = [
        [0.0 if edge.circle is None else edge.circle.radius] for edge in edges for _ in range(2)
    ]
    kept = [k for k in range(len(flat)) if not (edges[k // 2].is_circle and k % 2)]
    return np.array(flat)[kept], np.array(radii)[kept]


def _rounded(*values: float | None) -> tuple[float | None, ...]:
    return tuple(None if value is None else round(value, 5) for value in values)
