"""Gaussians as PLY files, in the layout that viewers of 3D Gaussian splatting read.

Binary little endian, one vertex a Gaussian: ``x y z nx ny nz f_dc_0..2 opacity scale_0..2
rot_0..3``, all float32.  Positions and scales (logarithms) are in model millimetres, opacities are
logits, rotations are quaternions with the scalar first.  Colours are the constant term of spherical
harmonics.  The normals, which the original layout leaves at zero, hold those of the start.
"""

from pathlib import Path

import numpy as np

from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.storage.single_file import write_whole

SH_CONSTANT = 0.28209479177387814
"""Value of the constant spherical harmonic, 1 / (2 sqrt(pi))."""

_FIELDS = (
    *("x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2", "opacity"),
    *("scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"),
)


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
