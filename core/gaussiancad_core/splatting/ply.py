"""Gaussians as PLY files, in the layout that viewers of 3D Gaussian splatting read.

Binary little endian, one vertex a Gaussian: ``x y z nx ny nz f_dc_0..2 opacity scale_0..2
rot_0..3``, all float32.  Positions and scales (logarithms) are in model millimetres, opacities are
logits, rotations are quaternions with the scalar first.  Colours are the constant term of spherical
harmonics.  The normals, which the original layout leaves at zero, hold those of the start.
"""

from pathlib import Path

import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.splatting.gaussians import Gaussians, rotation_matrices
from gaussiancad_core.storage.plain_files import plain_bytes
from gaussiancad_core.storage.single_file import write_whole
from gaussiancad_protocol.codes import Code

SH_CONSTANT = 0.28209479177387814
"""Value of the constant spherical harmonic, 1 / (2 sqrt(pi))."""

_FIELDS = (
    *("x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2", "opacity"),
    *("scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"),
)

_TYPES = {"float": "<f4", "float32": "<f4", "double": "<f8", "float64": "<f8"} | {
    "char": "i1",
    "int8": "i1",
    "uchar": "u1",
    "uint8": "u1",
    "short": "<i2",
    "int16": "<i2",
    "ushort": "<u2",
    "uint16": "<u2",
    "int": "<i4",
    "int32": "<i4",
    "uint": "<u4",
    "uint32": "<u4",
}

_LARGEST_HEADER = 1 << 16


def write_gaussians(gaussians: Gaussians, path: Path) -> None:
    """Write Gaussians; the file appears under its name only when whole.

    Raises:
        UsageError, LimitError: the folder cannot be written, or the disk is full.
    """
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(gaussians)}"]
    header += [f"property float {name}" for name in _FIELDS]
    columns = (
        gaussians.means,
        gaussians.normals,
        (gaussians.colours - 0.5) / SH_CONSTANT,
        gaussians.logit_opacities[:, None],
        gaussians.log_scales,
        gaussians.quaternions,
    )
    table = np.concatenate([column.astype("<f4") for column in columns], axis=1)
    write_whole(path, "\n".join([*header, "end_header", ""]).encode("ascii") + table.tobytes())


def read_gaussians(path: Path) -> Gaussians:
    """Read Gaussians of this or any other program that writes the layout, binary little endian.

    Other properties are passed over.  Where normals are missing or zero, the thinnest axis stands
    in, on the side that points away from the middle.

    Raises:
        UnreadableError: ``gaussians-unreadable``, the file is missing, damaged or of another kind.
    """
    try:
        content = plain_bytes(path)
    except OSError as error:
        raise _unreadable(path, error.strerror or str(error)) from error
    end = content.find(b"end_header\n", 0, _LARGEST_HEADER)
    if not content.startswith(b"ply") or end < 0:
        raise _unreadable(path, "it is no PLY file")
    count, kind = _layout(path, content[:end].decode("ascii", "replace").split("\n"))
    body = content[end + len(b"end_header\n") :]
    if len(body) < count * kind.itemsize:
        raise _unreadable(path, "it ends too early")
    return _gaussians(np.frombuffer(body, dtype=kind, count=count))


def _layout(path: Path, lines: list[str]) -> tuple[int, np.dtype]:
    """Number of vertices and what each holds."""
    words = [line.split() for line in lines]
    if ["format", "binary_little_endian", "1.0"] not in words:
        raise _unreadable(path, "only binary little-endian PLY files are read")
    elements = [word for word in words if word[:1] == ["element"]]
    if len(elements) != 1 or elements[0][1] != "vertex" or not elements[0][-1].isdigit():
        raise _unreadable(path, "it holds no plain list of Gaussians")
    properties = [word for word in words if word[:1] == ["property"]]
    known = all(len(word) == 3 and word[1] in _TYPES for word in properties)
    names = [word[-1] for word in properties]
    needed = [name for name in _FIELDS if name not in ("nx", "ny", "nz")]
    if not known or len(set(names)) != len(names) or not set(needed) <= set(names):
        raise _unreadable(path, "it holds points or a mesh, no Gaussians")
    return int(elements[0][-1]), np.dtype([(word[2], _TYPES[word[1]]) for word in properties])


def _gaussians(table: np.ndarray) -> Gaussians:
    def columns(*names: str) -> npt.NDArray[np.float32]:
        return np.stack([table[name].astype(np.float32) for name in names], axis=1)

    means = columns("x", "y", "z")
    quaternions = columns("rot_0", "rot_1", "rot_2", "rot_3")
    log_scales = columns("scale_0", "scale_1", "scale_2")
    normals = np.zeros_like(means)
    if {"nx", "ny", "nz"} <= set(table.dtype.names or ()):
        normals = columns("nx", "ny", "nz")
    missing = np.linalg.norm(normals, axis=1) < 0.5
    if missing.any():
        thinnest = np.argmin(log_scales[missing], axis=1)
        rotations = rotation_matrices(quaternions[missing])
        axes = rotations[np.arange(len(thinnest)), :, thinnest]
        away = ((means[missing] - means.mean(axis=0)) * axes).sum(axis=1)
        normals[missing] = np.where(away[:, None] < 0.0, -axes, axes)
    return Gaussians(
        means=means,
        quaternions=quaternions,
        log_scales=log_scales,
        logit_opacities=table["opacity"].astype(np.float32),
        colours=columns("f_dc_0", "f_dc_1", "f_dc_2") * np.float32(SH_CONSTANT) + np.float32(0.5),
        normals=normals,
    )


def _unreadable(path: Path, reason: str) -> UnreadableError:
    return UnreadableError(
        Code.GAUSSIANS_UNREADABLE,
        "cannot read Gaussians from {path}: {reason}; choose another file",
        path=path,
        reason=reason,
    )
