"""Reading models, good and bad."""

import os
from pathlib import Path

import numpy as np
import pytest
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder

from gaussiancad_core.comparison.model_files import load_model
from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.kernel.brep_files import write_brep, write_step
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_protocol.exit_codes import ExitCode


@pytest.mark.parametrize("suffix", ["stl", "ply", "obj", "STL", "Obj"])
def test_meshes_come_back_whole(bracket: TriangleMesh, tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"Ein Träger – 支架.{suffix}"
    path.write_bytes(_bytes(bracket.to_trimesh().export(file_type=suffix.lower())))
    mesh = load_model(path)
    assert mesh.watertight
    assert len(mesh.vertices) == len(bracket.vertices)
    assert len(mesh.triangles) == len(bracket.triangles)
    assert mesh.volume == pytest.approx(bracket.volume, rel=1e-6)


def test_an_ascii_stl_is_read(bracket: TriangleMesh, tmp_path: Path) -> None:
    path = tmp_path / "ascii.stl"
    path.write_bytes(_bytes(bracket.to_trimesh().export(file_type="stl_ascii")))
    assert load_model(path).volume == pytest.approx(bracket.volume, rel=1e-5)


def test_an_inside_out_mesh_is_turned(bracket: TriangleMesh, tmp_path: Path) -> None:
    path = tmp_path / "inverted.ply"
    path.write_bytes(bracket.flipped().to_trimesh().export(file_type="ply"))
    assert load_model(path).volume == pytest.approx(bracket.volume, rel=1e-6)


@pytest.mark.parametrize("name", ["a box.step", "a box.STP", "kästchen.brep"])
def test_a_solid_box_is_twelve_triangles(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    shape = BRepPrimAPI_MakeBox(30.0, 20.0, 10.0).Shape()
    (write_brep if path.suffix == ".brep" else write_step)(shape, path)
    mesh = load_model(path)
    assert (len(mesh.vertices), len(mesh.triangles)) == (8, 12)
    assert mesh.volume == pytest.approx(6000.0)
    assert mesh.bounds == pytest.approx(np.array([[0, 0, 0], [30, 20, 10]]), abs=1e-7)


def test_a_solid_cylinder_is_fine_and_closed(tmp_path: Path) -> None:
    path = tmp_path / "rod.step"
    write_step(BRepPrimAPI_MakeCylinder(5.0, 20.0).Shape(), path)
    mesh = load_model(path)
    assert mesh.watertight
    assert mesh.volume == pytest.approx(np.pi * 500.0, rel=5e-4)


@pytest.mark.parametrize(
    ("name", "content", "code"),
    [
        ("part.dwg", b"AC1032", "model-format-unknown"),
        ("part", b"solid", "model-format-unknown"),
        ("part.stl", b"", "empty-file"),
        ("part.obj", b"  \n\n", "empty-file"),
        ("part.step", b"", "empty-file"),
        ("part.stl", b"this is not a model at all", "not-a-model"),
        ("part.stl", bytes(range(256)) * 8, "not-a-model"),
        ("part.ply", b"ply\nformat ascii 1.0\nelement vertex 9\n", "not-a-model"),
        ("part.ply", b"\x89PNG\r\n\x1a\n" + bytes(100), "not-a-model"),
        ("part.obj", b"\x00\x01\x02 nothing", "not-a-model"),
        ("part.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "not-a-model"),
        ("part.obj", b"v 0\nv 1\nv 2\nf 1 2 3\n", "not-a-model"),
        ("part.obj", b"v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n", "not-a-model"),
        ("part.obj", b"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "empty-model"),
        ("part.obj", b"v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", "not-a-model"),
        ("part.step", b"ISO-10303-21; HEADER; oops", "file-damaged"),
        ("part.brep", b"no solid here", "not-a-solid"),
    ],
)
def test_bad_files_say_what_is_wrong(tmp_path: Path, name: str, content: bytes, code: str) -> None:
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(UnreadableError) as caught:
        load_model(path)
    assert caught.value.code == code
    assert caught.value.exit_code is ExitCode.UNREADABLE
    assert name in caught.value.message
    assert "\n" not in caught.value.message


def test_a_point_cloud_is_told_apart(tmp_path: Path) -> None:
    import trimesh

    path = tmp_path / "gaussians.ply"
    points = np.random.default_rng(0).normal(size=(30, 3))
    path.write_bytes(trimesh.PointCloud(points).export(file_type="ply"))
    with pytest.raises(UnreadableError) as caught:
        load_model(path)
    assert caught.value.code == "point-cloud"


def _bytes(content: str | bytes) -> bytes:
    return content.encode() if isinstance(content, str) else content


@pytest.mark.parametrize("suffix", [".step", ".brep", ".stl", ".ply", ".obj"])
def test_a_folder_a_pipe_and_what_is_missing_are_no_models(tmp_path: Path, suffix: str) -> None:
    codes = {"gone": "file-missing", "folder": "file-not-readable"}
    (tmp_path / f"folder{suffix}").mkdir()
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / f"pipe{suffix}")
        codes["pipe"] = "file-not-readable"
    for name, code in codes.items():
        with pytest.raises(UnreadableError) as caught:
            load_model(tmp_path / f"{name}{suffix}")
        assert caught.value.code == code
