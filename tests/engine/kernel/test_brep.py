import errno
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
from OCP.gp import gp_Pln
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.errors import UnreadableError, UsageError
from gaussiancad_core.kernel import brep
from gaussiancad_core.kernel.brep import (
    bounding_box,
    faces_of,
    soundness,
    tessellate,
    volume,
)
from gaussiancad_core.kernel.brep_files import read_solid, readable, write_brep, write_step
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cut, cylinder, sphere


@pytest.fixture
def bored() -> object:
    return cut(box((0, 0, 0), (40, 30, 20)), cylinder(Axis.Z, (12, 10), 5, -1, 21))


@pytest.mark.parametrize("name", ["part.step", "孔 板 (1).stp", "ünï cödé.STEP"])
def test_step_round_trip_keeps_the_solid(bored: object, tmp_path: Path, name: str) -> None:
    write_step(bored, tmp_path / name)
    assert [entry.name for entry in tmp_path.iterdir()] == [name]
    back = read_solid(tmp_path / name)
    assert back.ShapeType() == TopAbs_ShapeEnum.TopAbs_SOLID
    assert volume(back) == pytest.approx(40 * 30 * 20 - np.pi * 25 * 20, rel=1e-12)
    np.testing.assert_allclose(bounding_box(back), [[0, 0, 0], [40, 30, 20]], atol=1e-9)


def test_the_same_shape_gives_the_same_step_bytes(bored: object, tmp_path: Path) -> None:
    for folder in ("one", "two"):
        (tmp_path / folder).mkdir()
        write_step(bored, tmp_path / folder / "plate.step")
    one, two = ((tmp_path / folder / "plate.step").read_bytes() for folder in ("one", "two"))
    assert one == two
    assert b"PRODUCT('plate','plate'" in one
    assert b"SI_UNIT(.MILLI.,.METRE.)" in one


def test_a_file_with_a_byte_order_mark_and_blank_lines_is_read(
    bored: object, tmp_path: Path
) -> None:
    write_step(bored, tmp_path / "a.step")
    content = b"\xef\xbb\xbf\r\n" + (tmp_path / "a.step").read_bytes()
    (tmp_path / "b.step").write_bytes(content)
    assert soundness(read_solid(tmp_path / "b.step")).faces == 7


def test_brep_round_trip(bored: object, tmp_path: Path) -> None:
    write_brep(bored, tmp_path / "名.brep")
    assert soundness(read_solid(tmp_path / "名.brep")) == soundness(bored)


def test_several_solids_stay_together(tmp_path: Path) -> None:
    both = brep.compound_of([box((0, 0, 0), (1, 1, 1)), box((3, 0, 0), (5, 1, 1))])
    write_step(both, tmp_path / "two.step")
    found = soundness(read_solid(tmp_path / "two.step"))
    assert (found.solids, found.faces, found.closed) == (2, 12, True)
    assert found.volume_mm3 == pytest.approx(3.0)


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (b"", "empty-file"),
        (b" \n", "empty-file"),
        (b"solid ascii STL", "not-a-solid"),
        (b"ISO-10303-21;\nHEADER;\n", "file-damaged"),
        (b"ISO-10303-21;\nhello\nEND-ISO-10303-21;\n", "file-damaged"),
        (b"DBRep_DrawableShape\n\nCASCADE Topology V1\nnothing", "file-damaged"),
    ],
)
def test_what_is_no_solid_is_told(tmp_path: Path, content: bytes, code: str) -> None:
    path = tmp_path / "x.step"
    path.write_bytes(content)
    with pytest.raises(UnreadableError) as caught:
        read_solid(path)
    assert caught.value.code == code
    assert str(path) in caught.value.message


def test_missing_and_unreadable_files_are_told(tmp_path: Path) -> None:
    for path, code in ((tmp_path / "no.step", "file-missing"), (tmp_path, "file-not-readable")):
        with pytest.raises(UnreadableError) as caught:
            read_solid(path)
        assert caught.value.code == code


def _cut_off(share: float) -> Callable[[bytes], bytes]:
    return lambda content: content[: int(share * len(content))]


def _without_lines(content: bytes) -> bytes:
    lines = content.split(b";\n")
    return b";\n".join(lines[:60] + lines[70:])


def _with_lists(start: bytes) -> Callable[[bytes], bytes]:
    lists = b"#9999=X(" + start + b"(" * 1000 + b")" * 1000 + b");\n"
    return lambda content: content.replace(b"ENDSEC;\nEND", lists + b"ENDSEC;\nEND")


@pytest.mark.parametrize(
    "damage",
    [*map(_cut_off, (0.3, 0.7, 0.99)), _without_lines, *map(_with_lists, (b"", b")" * 1000))],
)
def test_a_step_file_that_is_cut_or_lacks_lines_or_has_lists_in_lists_is_damaged(
    bored: object, tmp_path: Path, damage: Callable[[bytes], bytes]
) -> None:
    path = tmp_path / "a.step"
    write_step(bored, path)
    content = path.read_bytes()
    path.write_bytes(damage(content))
    assert path.read_bytes() != content
    with pytest.raises(UnreadableError) as caught:
        read_solid(path)
    assert caught.value.code == "file-damaged"


def test_parentheses_in_names_are_no_lists(bored: object, tmp_path: Path) -> None:
    path = tmp_path / "a.step"
    write_step(bored, path)
    path.write_bytes(path.read_bytes().replace(b"'a'", b"'" + b"(" * 1000 + b"'"))
    assert soundness(read_solid(path)).valid


def test_a_surface_is_no_solid(tmp_path: Path) -> None:
    write_step(BRepBuilderAPI_MakeFace(gp_Pln(), 0.0, 1.0, 0.0, 1.0).Face(), tmp_path / "f.step")
    with pytest.raises(UnreadableError) as caught:
        read_solid(tmp_path / "f.step")
    assert caught.value.code == "not-a-solid"


def test_a_folder_that_does_not_exist_is_told(bored: object, tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught:
        write_step(bored, tmp_path / "none" / "a.step")
    assert caught.value.code == "output-not-writable"
    assert caught.value.__cause__.errno == errno.ENOENT


def test_the_bounding_box_ignores_tolerances_and_triangles() -> None:
    ball = sphere((1, 2, 3), 5)
    tessellate(ball, 2.0)
    np.testing.assert_allclose(bounding_box(ball), [[-4, -3, -2], [6, 7, 8]], atol=1e-6)


def test_soundness_sees_an_open_and_an_inverted_solid(bored: object) -> None:
    sound = soundness(bored)
    assert (sound.valid, sound.closed, sound.solids, sound.faces) == (True, True, 1, 7)
    assert not soundness(bored.Reversed()).valid
    shell = brep.compound_of(faces_of(bored)[:-1])
    assert not soundness(shell).closed


@pytest.mark.parametrize("deflection", [1.0, 0.05])
def test_tessellation_is_watertight_and_within_the_deflection(
    bored: object, deflection: float
) -> None:
    vertices, triangles = tessellate(bored, deflection)
    mesh = trimesh.Trimesh(vertices, triangles, process=False)
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    # A chord of a hole lies inside it, so the mesh holds a little more than the solid.
    excess = mesh.volume - volume(bored)
    assert 0.0 < excess < deflection * 2.0 * np.pi * 5 * 20
    wall = vertices[np.abs(np.hypot(vertices[:, 0] - 12, vertices[:, 1] - 10) - 5) < 1e-9]
    assert len(wall) > 8


def test_what_the_kernel_cannot_measure_is_a_damaged_file(tmp_path: Path) -> None:
    with pytest.raises(UnreadableError) as caught, readable(tmp_path / "void.step"):
        bounding_box(TopoDS_Shape())
    assert caught.value.code == "file-damaged"
    assert "void.step" in caught.value.message
