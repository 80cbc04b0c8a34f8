"""A solid without round holes and edge breaks as pads and pockets."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.body_cover import cheapest_cover, offered
from gaussiancad_core.features.difference import Difference, difference
from gaussiancad_core.features.feature_building import combined, in_order_of_making
from gaussiancad_core.features.feature_model import Extrusion, Sketch, Turning
from gaussiancad_core.features.frames import MAIN_FRAMES, Frame, frame_across
from gaussiancad_core.features.inside_rays import Rays
from gaussiancad_core.features.loops import OpenLoopError, loops_of
from gaussiancad_core.features.prisms import prism_plane, prisms_of
from gaussiancad_core.features.sample_points import joined
from gaussiancad_core.features.solid_faces import Kind, SolidFace, solid_faces
from gaussiancad_core.features.sweeps import Sweep, SweptPlane
from gaussiancad_core.features.turned_bodies import in_sketch, turned_planes, turned_sweeps
from gaussiancad_core.kernel.brep import bounding_box, edges_of
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES

Points = npt.NDArray[np.float64]

_ROUNDS = 4
"""Times that a cover is looked for: each time the points at which the last one was wrong come
with it."""


_MOST_OBLIQUE = 12
"""Planes but the main ones that sketches are looked for on."""

_SAME_DIRECTION = 9
"""Decimal places within which components of unit vectors are one."""


_FAILURES: tuple[type[Exception], ...] = (OpenLoopError, *KERNEL_FAILURES)


@dataclass(frozen=True, eq=False)
class Decomposition:
    """Bodies that make up a solid.

    Attributes:
        bodies: pads first.
        shape: that they make up.
        difference: between that and the solid.
    """

    bodies: tuple[Extrusion | Turning, ...]
    shape: TopoDS_Shape
    difference: Difference


def decomposed(shape: TopoDS_Shape) -> Decomposition | None:
    """Pads and pockets that make up a solid; None where there are none.

    Args:
        shape: one solid; units.
    """
    faces = solid_faces(shape)
    box = bounding_box(shape)
    rays = Rays(shape, 4.0 * float(np.abs(box).max() + 1.0))
    edges = edges_of(shape)
    flat = [prism_plane(edges, faces, frame, _box_in(frame, box), rays) for frame in _frames(faces)]
    prisms = [found for found in flat if found is not None]
    turned = list(turned_planes(faces, box, rays))
    planes = [*(found.plane for found, _ in prisms), *(found.plane for found, _ in turned)]
    if not planes:
        return None
    seen = joined([*(samples for _, samples in prisms), *(samples for _, samples in turned)])
    best, before = None, None
    for _ in range(_ROUNDS):
        sweeps: list[Sweep] = []
        for number, (found, _) in enumerate(prisms):
            sweeps += prisms_of(found, number, seen)
        for number, (turned_plane, _) in enumerate(turned, len(prisms)):
            sweeps += turned_sweeps(turned_plane, number, seen)
        chosen = cheapest_cover(offered(sweeps, planes, seen), seen)
        if chosen is None or chosen == before:
            return best
        before = chosen
        try:
            bodies = in_order_of_making([_feature(sweep, planes) for sweep in chosen])
            made = combined(bodies)
        except _FAILURES:
            return best
        apart = difference(shape, made)
        best = Decomposition(bodies, made, apart)
        if apart.is_none or not len(apart.points):
            return best
        seen = seen.with_others(apart.points, apart.is_inside)
    return best


def _frames(faces: Sequence[SolidFace]) -> list[Frame]:
    """The planes that sketches may lie on: the main ones, and those that most plane faces are
    parallel to."""
    oblique: dict[Frame, int] = {}
    for face in faces:
        if face.kind is Kind.PLANE:
            # Of a direction and its opposite one counts.
            way = np.sign(face.direction[int(np.argmax(np.abs(face.direction)))])
            x, y, z = np.round(way * face.direction, _SAME_DIRECTION).tolist()
            frame = frame_across((x, y, z))
            oblique[frame] = oblique.get(frame, 0) + 1
    others = [frame for frame in oblique if frame not in MAIN_FRAMES]
    others.sort(key=lambda frame: -oblique[frame])
    return [*MAIN_FRAMES, *others[:_MOST_OBLIQUE]]


def _box_in(frame: Frame, box: Points) -> tuple[Points, Points]:
    corners = np.array(np.meshgrid(*box.T)).reshape(3, -1).T
    seen = frame.project(corners)
    return seen.min(axis=0), seen.max(axis=0)


def _feature(sweep: Sweep, planes: Sequence[SweptPlane]) -> Extrusion | Turning:
    plane = planes[sweep.plane]
    loops = loops_of(plane.cells, sweep.cells)
    if plane.axis is None:
        # A sketch on an origin plane needs no offset.
        start, end = sorted(sweep.ends, key=abs)
        return Extrusion(Sketch(plane.frame, start, loops), end - start, sweep.adds)
    x, y, height = plane.frame.project(np.array([plane.axis.point]))[0].tolist()
    way = plane.frame.project(np.array([plane.axis.direction]))[0, :2].tolist()
    sketch = Sketch(plane.frame, height, tuple(in_sketch(loop, plane) for loop in loops))
    return Turning(sketch, (x, y), (way[0], way[1]), sweep.adds)
