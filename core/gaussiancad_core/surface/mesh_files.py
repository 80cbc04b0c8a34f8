"""Meshes as files, in millimetres; each appears under its name only when whole."""

from pathlib import Path

from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.storage.single_file import write_whole
from gaussiancad_core.surface.decimate import FACETED_LIMIT, decimated
from gaussiancad_core.surface.faceted import faceted_solid


def write_stl(mesh: TriangleMesh, path: Path) -> None:
    """Write a binary STL.

    Raises:
        UsageError, LimitError: the folder cannot be written, or the disk is full.
    """
    write_whole(path, _exported(mesh, "stl"))


def write_ply(mesh: TriangleMesh, path: Path) -> None:
    """Write a binary little-endian PLY.

    Raises:
        UsageError, LimitError: the folder cannot be written, or the disk is full.
    """
    write_whole(path, _exported(mesh, "ply"))


def _exported(mesh: TriangleMesh, kind: str) -> bytes:
    content = mesh.to_trimesh().export(file_type=kind)
    assert isinstance(content, bytes)
    return content


def write_faceted_step(mesh: TriangleMesh, path: Path, limit: int = FACETED_LIMIT) -> int:
    """Write a faceted solid of at most ``limit`` triangles as STEP.

    Args:
        mesh: watertight, oriented outward, mm; decimated where it has more triangles.
        path: the file.
        limit: most triangles.

    Returns:
        The number of triangles of the solid.

    Raises:
        EngineError: the mesh cannot be decimated or made a solid.
        UsageError, LimitError: the folder cannot be written, or the disk is full.
    """
    fewer = decimated(mesh, limit)
    write_step(faceted_solid(fewer), path)
    return len(fewer.triangles)
