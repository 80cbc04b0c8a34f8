"""Meshes as files, in millimetres."""

from pathlib import Path

from gaussiancad_core.meshes import TriangleMesh
from gaussiancad_core.outputs import os_error


def write_stl(mesh: TriangleMesh, path: Path) -> None:
    """Write a binary STL.

    Raises:
        UsageError, LimitError: the file cannot be written.
    """
    _write(mesh, path, "stl")


def write_ply(mesh: TriangleMesh, path: Path) -> None:
    """Write a binary little-endian PLY with double coordinates.

    Raises:
        UsageError, LimitError: the file cannot be written.
    """
    _write(mesh, path, "ply")


def _write(mesh: TriangleMesh, path: Path, kind: str) -> None:
    content = mesh.to_trimesh().export(file_type=kind)
    try:
        path.write_bytes(content)
    except OSError as error:
        raise os_error(path, error) from error
