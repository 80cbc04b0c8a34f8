"""A part with one thing wrong, as a supplier's model may be: a hole, a depth, a side, a length."""

from collections.abc import Callable, Iterator
from contextlib import suppress

import numpy as np
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
from OCP.gp import gp_Trsf, gp_Vec
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.judging.faceted_solids import FacetedSolid, faceted_shape
from gaussiancad_core.judging.model_features import Bore, FlatFace, bores_of, flat_faces
from gaussiancad_core.kernel.booleans import fused, unified, without
from gaussiancad_core.kernel.brep import bounding_box, faces_of, is_valid, volume
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cylinder

_MOVED, _MOVED_SHARE = 2.0, 0.03
"""mm, and share of the longest extent, by which a hole is moved; the less counts."""

_SHALLOWER = 0.1
"""Share of the way to the other side by which a face is moved."""

_LONGER = 1.03
"""Factor of the middle extent."""

_BLOCK, _BLOCK_HEIGHT = 0.08, 0.05
"""Sides and height of a block that is put on, shares of the longest extent."""

_DRILL = 0.03
"""Radius of a hole that no view has, share of the longest extent."""

_LEAST = 4e-4
"""Area of a face that is moved at least, share of the longest extent's square."""

_CHANGED = 1e-6
"""Share of the volume by which a part is another one."""

KINDS = ("filled", "moved", "depth", "block", "drilled", "stretched", "mirrored")


def wrong_parts(shape: TopoDS_Shape) -> Iterator[tuple[str, FacetedSolid]]:
    """A part with one thing wrong, of each of :data:`KINDS` that it allows.

    Args:
        shape: one valid solid, mm.
    """
    part = faceted_shape(shape)
    longest = float(part.extent.max())
    bores = sorted(bores_of(part), key=lambda bore: bore.widest)
    if bores:
        bore = bores[len(bores) // 2]
        yield from _made("filled", shape, lambda: _filled(shape, bore))
        yield from _made("moved", shape, lambda: _moved(shape, part, bore))
    faces = [face for face in flat_faces(part) if face.area >= _LEAST * longest**2]
    for face in faces:
        found = list(_made("depth", shape, lambda face=face: _deeper(shape, part, face)))
        if found:
            yield from found
            break
    for kind, make in (("block", _with_block), ("drilled", _drilled)):
        for face in faces[:4]:
            found = list(_made(kind, shape, lambda f=face, m=make: m(shape, part, f)))
            if found:
                yield from found
                break
    middle = int(np.argsort(part.extent)[1])
    factors = np.ones(3)
    factors[middle] = _LONGER
    yield "stretched", part.mapped(np.diag(factors), np.zeros(3))
    yield "mirrored", part.mapped(np.diag([-1.0, 1.0, 1.0]), np.zeros(3))


def _made(
    kind: str, shape: TopoDS_Shape, make: Callable[[], TopoDS_Shape]
) -> Iterator[tuple[str, FacetedSolid]]:
    """A part if the kernel makes one, and another one than it was."""
    with suppress(*KERNEL_FAILURES):
        made = unified(make())
        same = abs(volume(made) - volume(shape)) <= _CHANGED * volume(shape)
        if is_valid(made) and (kind == "moved" or not same):
            yield kind, faceted_shape(made)


def _plug(bore: Bore) -> TopoDS_Shape:
    return cylinder(bore.axis, bore.centre, bore.widest, bore.low, bore.high)


def _filled(shape: TopoDS_Shape, bore: Bore) -> TopoDS_Shape:
    return fused([shape, _plug(bore)])


def _moved(shape: TopoDS_Shape, part: FacetedSolid, bore: Bore) -> TopoDS_Shape:
    """A hole moved towards the middle of the part."""
    plug = _plug(bore)
    void = without(plug, [shape])
    across = [axis.value for axis in Axis if axis is not bore.axis]
    away = part.box.mean(axis=0)[across] - np.array(bore.centre)
    along = across[int(np.abs(away).argmax())]
    step = min(_MOVED, _MOVED_SHARE * float(part.extent.max()))
    move = np.zeros(3)
    move[along] = step if away[int(np.abs(away).argmax())] >= 0.0 else -step
    motion = gp_Trsf()
    motion.SetTranslation(gp_Vec(*move.tolist()))
    moved = BRepBuilderAPI_Transform(void, motion, True).Shape()
    return without(fused([shape, plug]), [moved])


def _deeper(shape: TopoDS_Shape, part: FacetedSolid, face: FlatFace) -> TopoDS_Shape:
    """A face moved outwards by a tenth of the way to the side of the part; a face that lies there
    changes nothing."""
    low, high = part.box[:, face.axis.value]
    way = (high - face.at if face.side > 0 else face.at - low) * _SHALLOWER
    move = np.zeros(3)
    move[face.axis.value] = face.side * way
    found = next(
        each
        for each in faces_of(shape)
        if np.abs(bounding_box(each)[:, face.axis.value] - face.at).max() < 1e-4
    )
    return fused([shape, BRepPrimAPI_MakePrism(found, gp_Vec(*move.tolist())).Shape()])


def _middle(part: FacetedSolid, face: FlatFace) -> np.ndarray:
    """(3,) mm, the middle of the largest triangle of a face."""
    a, b, c = (part.vertices[part.triangles[face.triangles, k]] for k in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    triangle = int(face.triangles[int(areas.argmax())])
    return part.vertices[part.triangles[triangle]].mean(axis=0)


def _with_block(shape: TopoDS_Shape, part: FacetedSolid, face: FlatFace) -> TopoDS_Shape:
    longest, axis = float(part.extent.max()), face.axis.value
    height = min(_BLOCK_HEIGHT * longest, 0.3 * float(part.extent.min()))
    low = _middle(part, face) - _BLOCK * longest / 2.0
    high = low + _BLOCK * longest
    low[axis], high[axis] = sorted(
        (face.at - 0.02 * face.side * height, face.at + face.side * height)
    )
    return fused([shape, box(tuple(low.tolist()), tuple(high.tolist()))])


def _drilled(shape: TopoDS_Shape, part: FacetedSolid, face: FlatFace) -> TopoDS_Shape:
    longest = float(part.extent.max())
    across = [axis.value for axis in Axis if axis is not face.axis]
    centre = _middle(part, face)[across]
    low, high = part.box[:, face.axis.value]
    tool = cylinder(
        face.axis, (float(centre[0]), float(centre[1])), _DRILL * longest, low - 1.0, high + 1.0
    )
    return without(shape, [tool])
