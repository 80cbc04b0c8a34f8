"""Which faces of earlier features the sketches and the far ends of later ones lie in."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.feature_building import body_of, face_of, wall_of
from gaussiancad_core.features.feature_model import Extrusion, Feature, Holes, Sketch, Turning
from gaussiancad_core.features.frames import Frame
from gaussiancad_core.features.loops import Loop
from gaussiancad_core.features.supported_features import (
    Side,
    Standing,
    Support,
    along,
    edges_in,
    frame_of,
    height_of,
)
from gaussiancad_core.geometry.outline_edges import whole_circle
from gaussiancad_core.geometry.tolerances import COMPUTED, UNIT_VECTOR
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.kernel.booleans import common
from gaussiancad_core.kernel.brep import area, bounding_box
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES

_LEAST_SHARED = 1e-6
"""Share of a sketch that lies in a face for it to stand there."""

_DIGITS = 8
"""Decimal places of a length."""


def standing_of(features: Sequence[Feature]) -> tuple[Standing, ...]:
    """For each feature what it stands on.

    Of several faces in a plane that of the earliest feature counts.  Where none of them is at the
    sketch itself, the plane of the first pad still does.  A pocket or a hole that ends within a
    pad, at the height of its face but with material behind, ends at a number of its own.
    """
    faces = _Faces(features)
    found = []
    for number, feature in enumerate(features):
        begins = faces.at_start(number) if isinstance(feature, Extrusion | Holes) else None
        found.append(Standing(begins, faces.at_end(number)))
    return tuple(found)


def beginning_on_faces(features: Sequence[Feature]) -> tuple[Feature, ...]:
    """The same bodies, each with its sketch where it touches an earlier one: a pocket's at its
    mouth, not at its floor.  Pads on a plane of the origin need no offset, and stay there."""
    turned = list(features)
    faces = _Faces(turned)
    for number, feature in enumerate(features):
        if not isinstance(feature, Extrusion) or faces.touching(number) is not None:
            continue
        if feature.adds and not feature.sketch.height:
            continue
        turned[number] = _reversed(feature)
        if not faces.is_entered(number):
            turned[number] = feature
    return tuple(turned)


def _reversed(feature: Extrusion) -> Extrusion:
    end = round(feature.sketch.height + feature.length, _DIGITS) + 0.0
    return Extrusion(replace(feature.sketch, height=end), -feature.length, feature.adds)


class _Faces:
    """Faces of features, and what lies in them.

    Args:
        features: in the order in which they are made.
    """

    def __init__(self, features: Sequence[Feature]) -> None:
        self._features = features
        self._made: dict[Support, _Face] = {}

    def at_start(self, number: int) -> Support | None:
        """The face that a feature's sketch lies in."""
        feature = self._features[number]
        assert isinstance(feature, Extrusion | Holes)
        frame, height = frame_of(feature), _drawn(feature)[0].height
        found = self.touching(number)
        base = self._features[0]
        if found is None and number and isinstance(base, Extrusion):
            sides = (Support(0, side) for side in (Side.START, Side.END))
            in_plane = (
                each
                for each in sides
                if base.sketch.frame == frame
                and abs(height_of(self._features, each, frame) - height) < COMPUTED
            )
            return next(in_plane, None)
        return found

    def touching(self, number: int) -> Support | None:
        """The earliest face that some of a feature's sketch lies in."""
        feature = self._features[number]
        assert isinstance(feature, Extrusion | Holes)
        drawn = _drawn(feature)
        for support in self._in_plane(number, frame_of(feature), drawn[0].height):
            if self._shares(support, drawn):
                return support
        return None

    def is_entered(self, number: int) -> bool:
        """Whether a pad begins at a face of an earlier feature, or a pocket enters one."""
        feature, support = self._features[number], self.touching(number)
        if support is None or not isinstance(feature, Extrusion) or feature.adds:
            return support is not None
        return self._outward(support, frame_of(feature)) * feature.length < 0.0

    def at_end(self, number: int) -> Support | None:
        """The face that the far end of an extrusion or of a flat-ended hole lies in."""
        feature = self._features[number]
        if isinstance(feature, Extrusion):
            length, adds = feature.length, feature.adds
        elif isinstance(feature, Holes) and feature.depth is not None and not feature.tip:
            length, adds = (-1.0 if feature.is_downward else 1.0) * feature.depth, False
        else:
            return None
        frame = frame_of(feature)
        drawn = [replace(each, height=each.height + length) for each in _drawn(feature)]
        height = drawn[0].height
        found = outermost = None
        for support in self._in_plane(number, frame, height):
            into = self._outward(support, frame) * length < 0.0
            if not self._shares(support, drawn):
                outermost = outermost or (None if into else support)
            elif not adds and into and self._swept(support).adds:
                return None
            else:
                found = found or support
        if found is not None:
            return found
        # Where a part has a step a pocket goes on past it, as far as the part does.
        is_through = not adds and self._reaches_to(number, frame, np.sign(length) * height, length)
        return outermost if is_through else None

    def _reaches_to(self, number: int, frame: Frame, far: float, way: float) -> bool:
        """Whether none of the earlier features goes on past a place on a plane's normal."""
        normal = np.sign(way) * np.array(frame.normal)
        for feature in self._features[:number]:
            if isinstance(feature, Extrusion | Turning) and feature.adds:
                box = bounding_box(body_of(feature))
                if float(np.where(normal > 0.0, box[1], box[0]) @ normal) > far + COMPUTED:
                    return False
        return True

    def _in_plane(self, number: int, frame: Frame, height: float) -> Iterator[Support]:
        """Faces of earlier features in a plane."""
        for k, feature in enumerate(self._features[:number]):
            for support in _supports(k, feature, frame):
                if abs(height_of(self._features, support, frame) - height) < COMPUTED:
                    yield support

    def _swept(self, support: Support) -> Extrusion | Turning:
        """The feature that a face is of: only these have faces that others stand on."""
        feature = self._features[support.feature]
        assert isinstance(feature, Extrusion | Turning)
        return feature

    def _outward(self, support: Support, frame: Frame) -> float:
        """Which way along a normal a face looks: positive or negative."""
        feature = self._swept(support)
        if support.side is Side.WALL:
            axis, way = along(feature.sketch.frame, frame.normal) or (0, 1.0)
            edge = edges_in(feature.sketch)[support.edge]
            # The region is on the left of its edges.
            across = edge.end[1] - edge.start[1], edge.start[0] - edge.end[0]
            return way * across[axis]
        assert isinstance(feature, Extrusion)
        return feature.length if support.side is Side.END else -feature.length

    def _shares(self, support: Support, drawn: Sequence[Sketch]) -> bool:
        """Whether some of what is drawn lies in a face."""
        try:
            face = self._face(support)
            for sketch in drawn:
                other = _Face(face_of(sketch))
                if not face.is_near(other):
                    continue
                if area(common(face.shape, other.shape)) > _LEAST_SHARED * area(other.shape):
                    return True
        except KERNEL_FAILURES:
            return False
        return False

    def _face(self, support: Support) -> "_Face":
        feature = self._swept(support)
        if support not in self._made:
            sketch = feature.sketch
            if support.side is Side.WALL:
                made = wall_of(feature, edges_in(sketch)[support.edge])
            else:
                assert isinstance(feature, Extrusion)
                end = feature.length if support.side is Side.END else 0.0
                made = face_of(replace(sketch, height=sketch.height + end))
            self._made[support] = _Face(made)
        return self._made[support]


@dataclass(frozen=True, eq=False)
class _Face:
    shape: TopoDS_Shape

    @cached_property
    def box(self) -> np.ndarray:
        """(2, 3) mm."""
        return bounding_box(self.shape)

    def is_near(self, other: "_Face") -> bool:
        """Whether their boxes touch."""
        (low, high), (others_low, others_high) = self.box, other.box
        return bool(np.all(low <= others_high + COMPUTED) and np.all(others_low <= high + COMPUTED))


def _drawn(feature: Extrusion | Holes) -> list[Sketch]:
    """What lies in the plane that a feature begins in."""
    if isinstance(feature, Extrusion):
        return [feature.sketch]
    radius = feature.diameter / 2.0
    discs: list[Loop] = [(whole_circle(Circle(at, radius)),) for at in feature.centres]
    return [Sketch(feature.frame, feature.height, (disc,)) for disc in discs]


def _supports(number: int, feature: Feature, frame: Frame) -> Iterator[Support]:
    """The faces of a feature that are parallel to a plane."""
    if not isinstance(feature, Extrusion | Turning):
        return
    this_frame = feature.sketch.frame
    if isinstance(feature, Extrusion) and this_frame == frame:
        yield Support(number, Side.START)
        yield Support(number, Side.END)
        return
    found = along(this_frame, frame.normal)
    if found is None:
        return
    axis = found[0]
    if isinstance(feature, Turning) and abs(feature.direction[1 - axis]) > UNIT_VECTOR:
        return
    for k, edge in enumerate(edges_in(feature.sketch)):
        if edge.circle is None and abs(edge.start[axis] - edge.end[axis]) < COMPUTED:
            yield Support(number, Side.WALL, k)
