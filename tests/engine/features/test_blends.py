"""Fillets and chamfers: which faces break edges, and the solid once they are put on again."""

from collections.abc import Callable

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.blends import Blend, blends_of
from gaussiancad_core.features.defeaturing import without_faces
from gaussiancad_core.features.difference import difference
from gaussiancad_core.features.dressing import breaks_of, dressed
from gaussiancad_core.features.feature_model import EdgeBreak, FeatureList
from gaussiancad_core.features.solid_faces import solid_faces
from gaussiancad_core.kernel.brep import bounding_box, edges_of, faces_of
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import (
    Point3,
    box,
    chamfered,
    cut,
    cylinder,
    edges_along,
    edges_where,
    filleted,
    fuse,
    prism,
    slot,
)

Find = Callable[[TopoDS_Shape], tuple[FeatureList, list[str]]]

_CORNERS = [(0, 0), (60, 0), (60, 40), (0, 40)]


def _at_height(shape: TopoDS_Shape, height: float) -> list:
    def wanted(start: Point3, end: Point3) -> bool:
        return max(abs(start[2] - height), abs(end[2] - height)) < 1e-6

    return edges_where(shape, wanted)


def _rounded_plate() -> TopoDS_Shape:
    plate = box((0, 0, 0), (60, 40, 12))
    return filleted(plate, edges_along(plate, Axis.Z, _CORNERS), 8.0)


def _groups(shape: TopoDS_Shape) -> tuple[tuple[Blend, ...], ...]:
    return blends_of(shape, solid_faces(shape))


def _undressed(shape: TopoDS_Shape) -> tuple[TopoDS_Shape, tuple[EdgeBreak, ...]]:
    groups = _groups(shape)
    bare, kept = without_faces(shape, [[blend.face for blend in group] for group in groups])
    assert kept == tuple(range(len(groups)))
    return bare, breaks_of([blend for group in groups for blend in group], bare)


def test_rounded_corners_of_a_plate_are_arcs_of_its_sketch(found: Find) -> None:
    plate = _rounded_plate()
    assert _groups(plate) == ()
    features, kinds = found(plate)
    assert kinds == ["pad"]
    assert sorted(
        0.0 if edge.circle is None else edge.circle.radius
        for edge in features.features[0].sketch.loops[0]
    ) == (pytest.approx([0.0] * 4 + [8.0] * 4))


def test_a_fillet_around_a_plate_with_rounded_corners_is_one_group(found: Find) -> None:
    plate = _rounded_plate()
    part = filleted(plate, _at_height(plate, 12.0), 3.0)
    (group,) = _groups(part)
    # Four cylinders along the sides, four tori around the corners.
    assert len(group) == 8
    assert [blend.size for blend in group] == pytest.approx([3.0] * 8)
    assert all(blend.is_round for blend in group)
    features, kinds = found(part)
    assert features.is_whole and kinds == ["pad", "fillet"]


def test_a_face_between_two_chamfers_is_none(found: Find) -> None:
    """The top of a bar with two broken edges lies at 45 degrees between planes at right angles,
    as they do."""
    part = prism(Axis.X, [(0, 0), (20, 0), (20, 15), (17, 18), (3, 18), (0, 15)], 0.0, 60.0)
    blends = [blend for group in _groups(part) for blend in group]
    assert [blend.size for blend in blends] == pytest.approx([3.0, 3.0])
    assert found(part)[0].is_whole


def test_a_wide_slope_is_no_chamfer() -> None:
    part = prism(Axis.X, [(0, 0), (40, 0), (40, 10), (25, 25), (0, 25)], 0.0, 60.0)
    assert _groups(part) == ()


def test_a_chamfer_at_the_rim_of_a_cylinder_is_found(found: Find) -> None:
    pin = cylinder(Axis.Z, (0, 0), 10.0, 0.0, 30.0)
    part = chamfered(pin, _at_height(pin, 30.0), 1.5)
    ((blend,),) = _groups(part)
    assert blend.size == pytest.approx(1.5) and not blend.is_round
    assert found(part)[0].is_whole


def test_edges_that_meet_in_a_corner_have_a_ball_that_breaks_none(found: Find) -> None:
    block = box((0, 0, 0), (60, 40, 20))

    def at_corner(start: Point3, end: Point3) -> bool:
        return any(np.allclose(point, (60, 40, 20)) for point in (start, end))

    part = filleted(block, edges_where(block, at_corner), 4.0)
    (group,) = _groups(part)
    assert sorted(blend.is_corner for blend in group) == [False] * 3 + [True]
    features, kinds = found(part)
    assert features.is_whole and kinds == ["pad", "fillet"]
    fillet = features.features[1]
    assert isinstance(fillet, EdgeBreak) and len(fillet.places) == 3


def test_a_rounding_of_an_inner_edge_is_a_fillet_too(found: Find) -> None:
    step = fuse(box((0, 0, 0), (60, 40, 10)), cylinder(Axis.Z, (30, 20), 9.0, 10.0, 30.0))
    part = filleted(step, _rim(step), 2.0)
    (group,) = _groups(part)
    assert [blend.size for blend in group] == pytest.approx([2.0])
    features, kinds = found(part)
    assert features.is_whole and sorted(kinds) == ["fillet", "pad", "pad"]


def _rim(shape: TopoDS_Shape) -> list:
    """Closed edges at a height of 10 mm."""

    def wanted(start: Point3, end: Point3) -> bool:
        return abs(start[2] - 10.0) < 1e-6 and np.allclose(start, end)

    return edges_where(shape, wanted)


@pytest.mark.parametrize("is_round", [True, False])
@pytest.mark.parametrize("size", [0.5, 3.0])
def test_dressing_again_gives_the_solid(is_round: bool, size: float) -> None:
    outline = slot(Axis.Z, ((20, 20), (45, 20)), 15.0, 0.0, 14.0)
    plain = cut(outline, box((25, 15, 8), (40, 25, 14)))
    make = filleted if is_round else chamfered
    rim = [e for e in _at_height(plain, 14.0) if _is_far(e)]
    part = make(plain, rim, size)
    bare, breaks = _undressed(part)
    assert difference(plain, bare).is_none
    assert [feature.is_round for feature in breaks] == [is_round]
    assert breaks[0].size == pytest.approx(size)
    again = dressed(bare, breaks)
    assert again is not None
    assert difference(part, again).is_none


def _is_far(edge: TopoDS_Shape) -> bool:
    """Whether an edge lies on the outline."""
    low, high = bounding_box(edge)
    return bool(low[1] < 10.0 or high[1] > 30.0)


def test_what_cannot_be_broken_is_none() -> None:
    block = box((0, 0, 0), (60, 40, 12))
    assert dressed(block, [EdgeBreak(((30.0, 0.0, 12.0),), 13.0, True)]) is None
    assert len(faces_of(block)) == 6 and len(edges_of(block)) == 12
