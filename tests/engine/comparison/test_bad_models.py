"""What comes in wrong is told, and measured as far as it can be."""

import struct
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
from OCP.BRep import BRep_Builder
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.TopoDS import TopoDS_Shell, TopoDS_Solid

from gaussiancad_core.comparison.comparing import compare_models
from gaussiancad_core.comparison.comparison_options import (
    Alignment,
    CompareOptions,
    Protocol,
    ScaleRule,
)
from gaussiancad_core.comparison.comparison_report import Comparison, comparison_json
from gaussiancad_core.comparison.comparison_text import comparison_text
from gaussiancad_core.comparison.distances import IouMethod
from gaussiancad_core.comparison.model_files import Model, read_model
from gaussiancad_core.comparison.model_units import unit_factor
from gaussiancad_core.errors import UnreadableError, UsageError
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.kernel.brep_files import write_brep
from gaussiancad_core.model.meshes import TriangleMesh, joined, make_mesh


def _compared(result: Model, reference: Model, **options: object) -> Comparison:
    asked = CompareOptions(points=500, protocols=tuple(Protocol), **options)
    found, _ = compare_models(result, reference, asked)
    # Whatever comes in, it can be written and read.
    assert b"NaN" not in comparison_json(found)
    assert comparison_text(found)
    return found


def _codes(found: Comparison) -> set[str]:
    return {remark.code for remark in found.warnings}


@pytest.mark.parametrize("factor", [1000.0, 25.4, 1 / 25.4, 1 / 1000.0])
def test_other_units_are_told_and_the_factor_mends_them(
    bracket: TriangleMesh, factor: float
) -> None:
    other = Model(make_mesh(bracket.vertices / factor, bracket.triangles))
    found = _compared(other, Model(bracket))
    assert found.unit_factor == pytest.approx(factor)
    warning = next(remark for remark in found.warnings if remark.code == "unit-mismatch")
    assert f"--factor {factor:.6g}" in warning.message
    mended = _compared(other, Model(bracket), factor=factor)
    assert mended.unit_factor is None
    assert mended.engineering.agreement == pytest.approx(1.0, abs=0.01)
    assert mended.engineering.volume_mm3 == pytest.approx(0.0, abs=1e-6 * bracket.volume)


def test_other_sizes_are_no_other_units(box: Callable[..., TriangleMesh]) -> None:
    assert unit_factor(box(4, 3, 2), box(8, 6, 4)) is None
    assert unit_factor(box(4, 3, 2), box(4, 3, 2)) is None
    assert unit_factor(box(1, 1, 1), box(25.4, 25.4, 12)) is None
    assert unit_factor(box(1, 2, 3), box(76.2, 25.4, 50.8)) == 25.4


def test_sizes_that_no_unit_explains_are_refused(box: Callable[..., TriangleMesh]) -> None:
    with pytest.raises(UsageError) as caught:
        _compared(Model(box(3e5, 2e5, 1e5)), Model(box(3e-3, 2e-3, 1e-3)))
    assert caught.value.code == "sizes-too-different"
    # A million is what metres and micrometres differ by.
    assert _compared(Model(box(3e4, 2e4, 1e4)), Model(box(3e-2, 2e-2, 1e-2))).warnings == ()


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(
    ("scale", "corner", "code"),
    [
        (1.0, np.inf, "not-a-model"),
        (1.0, np.nan, "not-a-model"),
        (1.0, 3e38, "size-out-of-range"),
        (1e30, 0.0, "size-out-of-range"),
        (1e-30, 0.0, "size-out-of-range"),
    ],
)
def test_numbers_that_are_none_or_too_large_are_told(
    box: Callable[..., TriangleMesh], tmp_path: Path, scale: float, corner: float, code: str
) -> None:
    content = bytearray(
        box(30 * scale, 20 * scale, 10 * scale).to_trimesh().export(file_type="stl")
    )
    if corner:
        content[96:100] = struct.pack("<f", corner)
    path = tmp_path / "numbers.stl"
    path.write_bytes(content)
    with pytest.raises(UnreadableError) as caught:
        read_model(path)
    assert caught.value.code == code


def test_a_mirror_image_is_told(bracket: TriangleMesh) -> None:
    image = make_mesh(bracket.vertices * [-1, 1, 1], bracket.triangles).flipped()
    found = _compared(Model(image), Model(bracket))
    assert found.mirrored and "result-mirrored" in _codes(found)
    assert np.linalg.det(found.matrix[:3, :3]) > 0.0


@pytest.mark.parametrize("seed", [1, 17, 19])
def test_few_points_make_no_mirror_image(box: Callable[..., TriangleMesh], seed: int) -> None:
    # How many of 300 points lie where a triangle is missing is chance: of one of the equal corners
    # of a box more than of another.
    whole = box(40, 20, 10)
    cracked = make_mesh(whole.vertices, whole.triangles[:-1])
    asked = CompareOptions(300, seed)
    found, _ = compare_models(Model(cracked), Model(whole), asked)
    assert not found.mirrored


def test_overlapping_bodies_count_once_and_mirror_nothing(box: Callable[..., TriangleMesh]) -> None:
    whole = box(20, 10, 10)
    apart = make_mesh(whole.vertices + np.array([5.0, 0.0, 0.0]), whole.triangles)
    both = Model(joined([whole, apart]))
    asked = {"alignment": Alignment.NONE, "scale": ScaleRule.FIXED}
    found = _compared(both, Model(whole), **asked)
    # 25 mm of bodies against 20 mm of one; boxes lie with their middles on each other.
    assert found.volume_iou.method is IouMethod.BOOLEAN
    assert found.volume_iou.value == pytest.approx(20.0 / 25.0, abs=1e-9)
    assert found.engineering.volume_iou.value == pytest.approx(20.0 / 25.0, abs=1e-9)
    ball, other = (trimesh.creation.icosphere(3, 10.0) for _ in range(2))
    other.apply_translation((3.0, 0.0, 0.0))
    spheres = [make_mesh(each.vertices, each.faces) for each in (ball, other)]
    assert not _compared(Model(joined(spheres)), Model(spheres[0]), **asked).mirrored


def test_a_sheet_of_two_sides_agrees_with_itself() -> None:
    corners = [[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]]
    sheet = Model(make_mesh(corners, [[0, 1, 2], [0, 2, 3], [0, 2, 1], [0, 3, 2]]))
    assert _compared(sheet, sheet).engineering.agreement == 1.0


def test_an_open_mesh_has_no_volume(bracket: TriangleMesh) -> None:
    opened = Model(make_mesh(bracket.vertices, bracket.triangles[1:]))
    found = _compared(opened, Model(bracket))
    assert "model-open" in _codes(found)
    assert found.result.volume_mm3 is None
    assert found.engineering.volume_mm3 is None
    assert not found.engineering.reference_to_result.signed
    assert found.engineering.result_to_reference.signed
    assert found.volume_iou.method is IouMethod.OCCUPANCY
    assert found.deepcad.invalid is not None


def test_a_flat_model_is_told(box: Callable[..., TriangleMesh]) -> None:
    """Two rectangles, back to back, closed along their border."""
    corners = np.array([[0.0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]])
    flat = make_mesh(corners, [[0, 1, 2], [0, 2, 3], [1, 0, 3], [1, 3, 2]])
    assert flat.watertight
    found = _compared(Model(flat), Model(box(4, 3, 2)))
    assert "no-volume" in _codes(found)
    assert found.engineering.volume_share == pytest.approx(-1.0)
    assert found.volume_iou.value == 0.0
    assert found.deepcad.invalid is not None
    both = _compared(Model(flat), Model(flat))
    assert both.volume_iou.value is None
    assert both.engineering.result_to_reference.rms == pytest.approx(0.0, abs=1e-9)


def test_a_solid_without_a_face_is_invalid(tmp_path: Path) -> None:
    builder, shell, solid = BRep_Builder(), TopoDS_Shell(), TopoDS_Solid()
    builder.MakeShell(shell)
    for face in faces_of(BRepPrimAPI_MakeBox(4.0, 3.0, 2.0).Shape())[1:]:
        builder.Add(shell, face)
    builder.MakeSolid(solid)
    builder.Add(solid, shell)
    path = tmp_path / "open.brep"
    write_brep(solid, path)
    model = read_model(path)
    assert (model.exact.faces, model.exact.closed, model.exact.valid) == (5, False, False)
    found = _compared(model, model)
    assert "solid-invalid" in _codes(found)
    assert found.result.volume_mm3 is None
    assert found.deepcad.invalid is not None
