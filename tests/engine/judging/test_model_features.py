"""Bores and flat faces by triangles: exact solids and meshes alike."""

from collections.abc import Callable

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.judging.faceted_solids import FacetedSolid, faceted_mesh, faceted_shape
from gaussiancad_core.judging.model_features import bores_of, flat_faces
from gaussiancad_core.kernel.brep import tessellate
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.meshes import make_mesh
from sample_parts.modelling import box, cone, cut, cylinder, fuse

_BLOCK = box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0))


def _as_mesh(shape: TopoDS_Shape) -> FacetedSolid:
    return faceted_mesh(make_mesh(*tessellate(shape, 0.003, 0.1)))


@pytest.mark.parametrize("made", [faceted_shape, _as_mesh])
def test_a_stepped_bore_is_one_with_its_ends(made: Callable[[TopoDS_Shape], FacetedSolid]) -> None:
    part = cut(
        _BLOCK,
        cylinder(Axis.Y, (20.0, 15.0), 4.0, -1.0, 41.0),
        cylinder(Axis.Y, (20.0, 15.0), 7.0, 30.0, 41.0),
    )
    (bore,) = bores_of(made(part))
    assert bore.axis is Axis.Y
    assert bore.centre == pytest.approx((20.0, 15.0), abs=0.01)
    assert (bore.radius, bore.widest) == pytest.approx((4.0, 7.0), abs=0.02)
    assert (bore.low, bore.high) == pytest.approx((0.0, 40.0), abs=0.01)


def test_a_countersink_belongs_to_its_bore() -> None:
    part = cut(
        _BLOCK,
        cylinder(Axis.Z, (20.0, 15.0), 4.0, -1.0, 31.0),
        cone(Axis.Z, (20.0, 15.0), (4.0, 7.0), 27.0, 30.0),
    )
    (bore,) = bores_of(faceted_shape(part))
    assert (bore.radius, bore.widest) == pytest.approx((4.0, 7.0), abs=1e-3)
    assert (bore.low, bore.high) == pytest.approx((0.0, 30.0))


def test_a_boss_and_a_rounded_corner_are_no_bores() -> None:
    part = fuse(_BLOCK, cylinder(Axis.Z, (20.0, 15.0), 4.0, 29.0, 40.0))
    notched = cut(part, cylinder(Axis.Z, (60.0, 40.0), 5.0, -1.0, 31.0))
    assert bores_of(faceted_shape(notched)) == ()


def test_flat_faces_tell_their_place_and_side() -> None:
    part = cut(_BLOCK, box((40.0, -1.0, 18.0), (61.0, 41.0, 31.0)))
    faces = flat_faces(faceted_shape(part))
    found = {(face.axis, round(face.at, 6), face.side): face.area for face in faces}
    assert found[Axis.Z, 18.0, 1] == pytest.approx(20.0 * 40.0)
    assert found[Axis.Z, 30.0, 1] == pytest.approx(40.0 * 40.0)
    assert found[Axis.Z, 0.0, -1] == pytest.approx(60.0 * 40.0)
    assert found[Axis.X, 40.0, 1] == pytest.approx(40.0 * 12.0)
    areas = [face.area for face in faces]
    assert areas == sorted(areas, reverse=True)
    assert np.isclose(sum(areas), 2 * (60 * 40 + 40 * 30 + 60 * 30 - 20 * 12))
