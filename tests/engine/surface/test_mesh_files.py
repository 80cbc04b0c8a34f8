"""Files: what is written is what comes back."""

from pathlib import Path

import pytest
import trimesh

from gaussiancad_core.errors import UsageError
from gaussiancad_core.kernel.brep import soundness
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.surface.mesh_files import write_faceted_step, write_ply, write_stl


@pytest.mark.parametrize(
    ("write", "name", "magic"),
    [(write_stl, "tür 1.stl", b""), (write_ply, "tür 1.ply", b"ply\nformat binary_little_endian")],
)
def test_meshes_come_back(
    tmp_path: Path, ball: TriangleMesh, write: object, name: str, magic: bytes
) -> None:
    path = tmp_path / name
    write(ball, path)
    assert path.read_bytes().startswith(magic)
    assert not path.read_bytes().startswith(b"solid")
    loaded = trimesh.load(path)
    assert len(loaded.faces) == len(ball.triangles)
    assert loaded.is_watertight
    assert loaded.volume == pytest.approx(ball.volume, rel=1e-5)
    assert [entry.name for entry in tmp_path.iterdir()] == [name]


def test_faceted_step_is_a_solid_in_millimetres(tmp_path: Path, ball: TriangleMesh) -> None:
    path = tmp_path / "surface.step"
    assert write_faceted_step(ball, path, limit=400) <= 400
    state = soundness(read_solid(path))
    assert (state.valid, state.closed, state.solids) == (True, True, 1)
    assert state.faces <= 400
    assert state.volume_mm3 == pytest.approx(ball.volume, rel=0.04)
    assert "MILLI" in path.read_text()


def test_a_missing_folder_is_told(tmp_path: Path, box: TriangleMesh) -> None:
    for write in (write_stl, write_ply, write_faceted_step):
        with pytest.raises(UsageError):
            write(box, tmp_path / "none" / "file")
