"""The three protocols on pairs whose numbers are known or counted by other libraries."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
from OCP.BRepPrimAPI import BRepPrimAPI_MakeCylinder, BRepPrimAPI_MakeTorus

from gaussiancad_core.comparison.comparing import compare_models
from gaussiancad_core.comparison.comparison_options import (
    Alignment,
    CompareOptions,
    Protocol,
    ScaleRule,
)
from gaussiancad_core.comparison.comparison_report import PROTOCOL, Comparison, comparison_dict
from gaussiancad_core.comparison.deepcad import squared_chamfer
from gaussiancad_core.comparison.distances import IouMethod
from gaussiancad_core.comparison.engineering import (
    EngineeringResult,
    area_of,
    signed_distances,
    volume_of,
)
from gaussiancad_core.comparison.model_files import Model, read_model
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.remarks import remarks_on
from gaussiancad_core.comparison.topology import topology_of
from gaussiancad_core.errors import UsageError
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

ALL = tuple(Protocol)


def _moved(mesh: TriangleMesh, *shift: float) -> TriangleMesh:
    return make_mesh(mesh.vertices + np.array(shift), mesh.triangles)


def _compared(result: TriangleMesh, reference: TriangleMesh, **options: object) -> Comparison:
    asked = CompareOptions(points=800, protocols=ALL, **options)
    return compare_models(Model(result), Model(reference), asked)[0]


def _engineering(
    result: TriangleMesh, reference: TriangleMesh, **options: object
) -> EngineeringResult:
    return _compared(result, reference, **options).engineering


def test_shifted_cubes_left_where_they_are(box: Callable[..., TriangleMesh]) -> None:
    """Edge 2, half a mm aside: the closed forms."""
    cube = box(2, 2, 2)
    found = _engineering(_moved(cube, 0.5, 0, 0), cube, alignment=Alignment.NONE)
    assert found.volume_iou.value == pytest.approx(1.5 / 2.5, abs=1e-6)
    assert found.volume_iou.method is IouMethod.BOOLEAN
    assert found.result_to_reference.greatest == pytest.approx(0.5, abs=1e-6)
    assert found.result_to_reference.least == pytest.approx(-0.5, abs=1e-2)
    assert found.placed_bounds_mm == pytest.approx(np.array([[0.5, 0, 0], [2.5, 2, 2]]), abs=1e-9)
    assert found.matrix == pytest.approx(np.eye(4), abs=1e-9)
    assert (found.volume_mm3, found.area_mm2) == pytest.approx((0.0, 0.0), abs=1e-9)
    # Four sides slide along the reference's for 1.5 of their 2 mm: 12 of 24 mm2 agree.
    assert found.agreement == pytest.approx(0.5, abs=0.04)


def test_a_cube_within_a_cube(box: Callable[..., TriangleMesh]) -> None:
    """Edges 2 and 4, centred: every point of the inner one is 1 mm inside."""
    found = _engineering(box(2, 2, 2), box(4, 4, 4), alignment=Alignment.AXES)
    inner = found.result_to_reference
    assert (inner.mean, inner.mean_absolute, inner.rms) == pytest.approx((-1, 1, 1), abs=1e-6)
    assert (inner.least, inner.greatest) == pytest.approx((-1.0, -1.0), abs=1e-6)
    assert list(inner.percentiles.values()) == pytest.approx([1.0] * 4, abs=1e-6)
    assert found.reference_to_result.greatest == pytest.approx(np.sqrt(3), abs=1e-6)
    assert found.volume_iou.value == pytest.approx(1 / 8, abs=1e-6)
    assert found.volume_mm3 == pytest.approx(8 - 64)
    assert found.volume_share == pytest.approx(-7 / 8)
    assert found.area_share == pytest.approx(-3 / 4)
    assert found.agreement == 0.0


def test_two_spheres() -> None:
    """Radii 10 and 11; the triangles of the finer sphere are within 0.01 mm of it."""
    small, large = (trimesh.creation.icosphere(4, radius) for radius in (10.0, 11.0))
    found = _engineering(
        make_mesh(large.vertices, large.faces), make_mesh(small.vertices, small.faces)
    )
    assert found.result_to_reference.mean == pytest.approx(1.0, abs=0.02)
    assert found.reference_to_result.mean == pytest.approx(-1.0, abs=0.02)
    assert found.volume_iou.value == pytest.approx((10 / 11) ** 3, abs=1e-6)


def test_distances_and_signs_are_trimeshs(bracket: TriangleMesh) -> None:
    """Trimesh finds the nearest triangle with an R-tree, in double precision."""
    points = np.random.default_rng(3).uniform(-5.0, 45.0, (300, 3))
    expected = -trimesh.proximity.signed_distance(bracket.to_trimesh(), points)
    assert signed_distances(SurfaceQueries(bracket), points) == pytest.approx(expected, abs=1e-6)


def test_turned_normals_do_not_agree(box: Callable[..., TriangleMesh]) -> None:
    """A mesh inside out lies on the reference, but its surface looks the other way."""
    cube = box(2, 2, 2)
    same = _engineering(cube, cube, alignment=Alignment.NONE)
    turned = _engineering(cube.flipped(), cube, alignment=Alignment.NONE)
    assert same.agreement == 1.0
    assert turned.result_to_reference.within == 0.0
    assert turned.result_to_reference.rms == pytest.approx(0.0, abs=1e-9)


def test_squared_chamfer_of_known_points() -> None:
    first, second = np.zeros((1, 3)), np.array([[3.0, 0, 0], [0, 5.0, 0]])
    assert squared_chamfer(first, second) == pytest.approx(9.0 + (9.0 + 25.0) / 2.0)


def test_deepcad_scales_but_does_not_turn(bracket: TriangleMesh) -> None:
    same = _compared(_moved(bracket, 3, 4, 5), bracket).deepcad
    assert same.points == 8192
    assert same.invalid is None
    assert same.chamfer_x1000 == pytest.approx(same.floor_x1000, rel=0.05)
    assert same.volume_iou.value == pytest.approx(1.0, abs=1e-6)
    turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    turned = _compared(make_mesh(bracket.vertices @ turn.T, bracket.triangles), bracket)
    assert turned.deepcad.chamfer_x1000 > 20 * same.chamfer_x1000
    assert turned.point_to_surface < 1e-5


def test_deepcad_is_the_same_whatever_the_other_options(bracket: TriangleMesh) -> None:
    one = _compared(bracket, bracket).deepcad
    other = compare_models(
        Model(bracket),
        Model(bracket),
        CompareOptions(500, protocols=ALL, alignment=Alignment.AXES, scale=ScaleRule.FIXED),
    )[0].deepcad
    assert one == other


def test_exact_solids_are_measured_exactly(tmp_path: Path) -> None:
    rod, ring = tmp_path / "rod.step", tmp_path / "ring.step"
    write_step(BRepPrimAPI_MakeCylinder(5.0, 20.0).Shape(), rod)
    write_step(BRepPrimAPI_MakeTorus(20.0, 5.0).Shape(), ring)
    first, second = read_model(rod), read_model(ring)
    assert volume_of(first) == pytest.approx(500 * np.pi, rel=1e-9)
    assert area_of(first) == pytest.approx(250 * np.pi, rel=1e-9)
    assert (first.exact.faces, first.exact.valid) == (3, True)
    assert volume_of(second) == pytest.approx(2 * np.pi**2 * 20 * 25, rel=1e-6)
    topologies = topology_of(first.mesh), topology_of(second.mesh)
    assert [each.betti for each in topologies] == [(1, 0, 0), (1, 1, 0)]
    remarks = remarks_on((first, second), topologies, False, None)
    assert [remark.code for remark in remarks] == ["topology-differs"]
    assert "0 through holes" in remarks[0].message and "1 through hole," in remarks[0].message
    # In inches: all exact facts follow.
    inches = first.scaled(1 / 25.4)
    assert volume_of(inches) == pytest.approx(500 * np.pi / 25.4**3, rel=1e-9)


def test_a_scale_that_is_free_is_found(bracket: TriangleMesh) -> None:
    smaller = make_mesh(bracket.vertices * 0.9 + 7.0, bracket.triangles)
    fixed = _engineering(smaller, bracket)
    free = _engineering(smaller, bracket, scale=ScaleRule.FREE)
    assert np.linalg.det(fixed.matrix[:3, :3]) == pytest.approx(1.0)
    assert np.cbrt(np.linalg.det(free.matrix[:3, :3])) == pytest.approx(1 / 0.9, rel=1e-5)
    assert fixed.agreement < 0.5 < free.agreement
    assert free.volume_mm3 == pytest.approx(0.0, abs=1.0)


def test_a_fixed_scale_keeps_the_papers_units_those_of_the_reference(
    box: Callable[..., TriangleMesh],
) -> None:
    found = _compared(box(20, 10, 10), box(10, 10, 10), scale=ScaleRule.FIXED)
    assert np.linalg.det(found.matrix[:3, :3]) == pytest.approx(1.0)
    # In the reference's box the cube is 5 units long, and the result 10: 2.5 units stand out.
    assert found.distances.hausdorff == pytest.approx(2.5, abs=0.1)
    assert found.volume_iou.value == pytest.approx(0.5, abs=1e-6)


def test_another_registration_is_named(bracket: TriangleMesh) -> None:
    plain = comparison_dict(_compared(bracket, bracket))
    other = comparison_dict(_compared(bracket, bracket, alignment=Alignment.NONE))
    assert plain["protocol"] == PROTOCOL
    assert other["protocol"] != PROTOCOL and "registration none" in other["protocol"]
    assert set(plain["protocols"]) == {"gaussiancad", "deepcad", "engineering"}
    assert plain["protocols"]["gaussiancad"]["chamfer"] == plain["chamfer"]


@pytest.mark.parametrize(
    ("options", "code"),
    [
        (CompareOptions(factor=0.0), "factor-not-positive"),
        (CompareOptions(factor=float("nan")), "factor-not-positive"),
        (CompareOptions(tolerance_mm=-1.0), "tolerance-not-positive"),
        (
            CompareOptions(protocols=(Protocol.DEEPCAD,), alignment=Alignment.ICP),
            "protocol-has-no-registration",
        ),
    ],
)
def test_options_that_cannot_be(options: CompareOptions, code: str) -> None:
    with pytest.raises(UsageError) as caught:
        options.check()
    assert caught.value.code == code
