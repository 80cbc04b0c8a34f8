"""Parts with planes that no view sees edge-on: exactly the solid that was drawn."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.cells.half_spaces import HalfSpace
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import faces_of, moved_to_origin, soundness, volume
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Axis, Role, Vector
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_core.solid.extra_faces import body_faces
from gaussiancad_core.solid.reasons import ASSUMED, UNDRAWN, has_hidden_lines
from sample_parts.classed import PartClass, classed_part
from sample_parts.classed.outlines import convex, frustum, regular
from sample_parts.modelling import Point2, box, cut, cylinder, fuse, prism

Draw = Callable[..., DrawnViews]


def _cut_corner() -> TopoDS_Shape:
    """A block of 60 x 40 x 30 without a tetrahedron of legs 20, 15 and 10."""
    corners = [(x, y, z) for x in (0.0, 60.0) for y in (0.0, 40.0) for z in (0.0, 30.0)]
    corners.remove((60.0, 0.0, 30.0))
    return convex([*corners, (40.0, 0.0, 30.0), (60.0, 15.0, 30.0), (60.0, 0.0, 20.0)])


def _two_cut_corners() -> TopoDS_Shape:
    """The same with a second corner cut diagonally below; one of the two cuts is hidden."""
    corners = [(x, y, z) for x in (0.0, 60.0) for y in (0.0, 40.0) for z in (0.0, 30.0)]
    for corner in ((60.0, 0.0, 30.0), (0.0, 40.0, 0.0)):
        corners.remove(corner)
    return convex(
        [
            *corners,
            *((40.0, 0.0, 30.0), (60.0, 15.0, 30.0), (60.0, 0.0, 20.0)),
            *((18.0, 40.0, 0.0), (0.0, 28.0, 0.0), (0.0, 40.0, 12.0)),
        ]
    )


def _polygon(count: int, radius: float) -> list[Point2]:
    return [(x, y) for x, y, _ in regular((30.0, 30.0), radius, count)]


def _pentagonal_frustum() -> TopoDS_Shape:
    # Views begin at 0 where their part does, and a pentagon is not as wide as its circle.
    return moved_to_origin(frustum(Axis.Z, _polygon(5, 30.0), _polygon(5, 20.0), (0.0, 25.0)))


def _frustum_on_a_block() -> TopoDS_Shape:
    top = frustum(Axis.Z, _polygon(6, 22.0), _polygon(6, 14.0), (20.0, 36.0))
    return fuse(box((0.0, 0.0, 0.0), (60.0, 60.0, 20.0)), top)


def _tapered_pocket() -> TopoDS_Shape:
    hollow = frustum(Axis.Z, _polygon(4, 12.0), _polygon(4, 24.0), (12.0, 30.0))
    return cut(box((0.0, 0.0, 0.0), (60.0, 60.0, 30.0)), hollow)


def _turned_roof() -> TopoDS_Shape:
    """A rectangle below and a rhomb above, with eight triangles between them."""
    lower = [(0.0, 0.0), (50.0, 0.0), (50.0, 36.0), (0.0, 36.0)]
    upper = [(8.0, 18.0), (25.0, 6.0), (42.0, 18.0), (25.0, 30.0)]
    return frustum(Axis.Z, lower, upper, (0.0, 22.0))


def _tilted() -> TopoDS_Shape:
    """A pentagonal frustum that lies on its side, on a plate with a hole."""
    lying = frustum(Axis.X, _polygon(5, 18.0), _polygon(5, 11.0), (10.0, 44.0))
    return cut(
        fuse(prism(Axis.Z, [(0, 0), (60, 0), (60, 60), (0, 60)], 0.0, 20.0), lying),
        cylinder(Axis.Z, (53.0, 30.0), 4.0, 0.0, 20.0),
    )


@pytest.mark.parametrize(
    ("make", "faces"),
    [
        (_cut_corner, 7),
        (_two_cut_corners, 8),
        (_pentagonal_frustum, 7),
        (_frustum_on_a_block, 13),
        (_tapered_pocket, 11),
        (_turned_roof, 10),
        (_tilted, None),
        (lambda: classed_part(PartClass.OBLIQUE, 2, 2), 26),
    ],
)
def test_the_part_is_found_with_its_volume_and_faces(
    make: Callable[[], TopoDS_Shape], faces: int | None, drawn: Draw
) -> None:
    truth = make()
    views = drawn(truth)
    result = exact_solid(views)
    # Hidden lines that a view may not draw are all that may be in doubt.
    assert {code for code, _ in result.reasons} <= {ASSUMED}
    assert (UNDRAWN in result.reasons) == (not has_hidden_lines(views))
    assert result.shape is not None
    state = soundness(result.shape)
    assert (state.valid, state.closed, state.solids) == (True, True, 1)
    assert state.faces == len(faces_of(truth)) == (faces or state.faces)
    assert state.volume_mm3 == pytest.approx(volume(truth), rel=1e-9)
    left = BRepAlgoAPI_Cut(truth, result.shape)
    assert volume(left.Shape()) == pytest.approx(0.0, abs=1e-6 * state.volume_mm3)


def test_the_volume_of_a_cut_corner_is_that_of_the_block_less_a_tetrahedron(drawn: Draw) -> None:
    result = exact_solid(drawn(_cut_corner()))
    assert result.shape is not None
    assert volume(result.shape) == pytest.approx(60 * 40 * 30 - 20 * 15 * 10 / 6, rel=1e-12)


def test_a_half_space_has_a_face_for_each_hull() -> None:
    normal: Vector = (3**-0.5, 3**-0.5, 3**-0.5)
    one = ((3.0, 0.0, 0.0), (0.0, 3.0, 0.0), (0.0, 0.0, 3.0))
    other = ((6.0, -3.0, 0.0), (9.0, -3.0, -3.0), (9.0, -6.0, 0.0))
    faces = body_faces(HalfSpace(normal, 3**0.5, (one, other)))
    areas = []
    for face in faces:
        properties = GProp_GProps()
        BRepGProp.SurfaceProperties_s(face, properties)
        areas.append(properties.Mass())
    assert areas == pytest.approx([4.5 * 3**0.5, 4.5 * 3**0.5])


def test_a_tip_is_where_edges_cross(drawn: Draw, iou: Callable[..., float]) -> None:
    """The diagonals of a pyramid were read as two lines, and its heights a little beside."""
    base = [(0.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0)]
    pyramid = convex([(x, y, 0.0) for x, y in base] + [(20.0, 20.0, 50.0)])
    views = drawn(pyramid)
    off = {Role.FRONT: 0.0006, Role.RIGHT: -0.0013}

    def read(role: Role, curves: Sequence[DrawnStroke]) -> tuple[DrawnStroke, ...]:
        if role is Role.TOP:
            outline = [s for s in curves if min(np.abs(np.subtract(s.end, s.start))) < 1.0]
            diagonals = [((0.0, 0.0), (40.0, 40.0)), ((0.0, 40.0), (40.0, 0.0))]
            return (*outline, *(Segment(a, b, Linetype.VISIBLE) for a, b in diagonals))
        tip = 20.0 + off[role], 50.0
        return tuple(
            Segment(*(tip if end[1] > 25.0 else end for end in (s.start, s.end)), Linetype.VISIBLE)
            for s in curves
        )

    strokes = {role: read(role, stroke) for role, stroke in views.strokes.items()}
    result = exact_solid(replace(views, strokes=strokes, tolerance=0.08, apart=0.025))
    assert result.reasons == (UNDRAWN,)
    assert soundness(result.shape).faces == 5
    assert iou(result.shape, pyramid) > 0.9999
