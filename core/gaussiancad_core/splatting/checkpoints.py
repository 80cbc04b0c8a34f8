"""States of a training on disk, so that a run that was killed can go on where it was.

A checkpoint appears under its name only when whole, holds plain arrays (nothing that runs when it
is read), and belongs to one training: the same start, images, settings and engine.
"""

import io
import time
import zipfile
from dataclasses import astuple, dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from gaussiancad_core import __version__
from gaussiancad_core.model.cameras import Camera
from gaussiancad_core.splatting.gaussian_model import Arrays
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.splatting.losses import Targets
from gaussiancad_core.splatting.settings import TrainingSettings
from gaussiancad_core.storage.outputs import os_error

_KEY = "training"


@dataclass(frozen=True)
class CheckpointPlace:
    """Where the checkpoints of a run go.

    Attributes:
        path: the file.
        staging: folder of the same file system in which it is written first.
        interval_s: seconds between two checkpoints at least; short trainings leave none.
        resume: whether a checkpoint that is there is taken up.
    """

    path: Path
    staging: Path
    interval_s: float = 2.0
    resume: bool = False


class Checkpoints:
    """Writes and reads the checkpoints of one training.

    Args:
        place: where.
        key: of the training, see :func:`training_key`.
    """

    def __init__(self, place: CheckpointPlace, key: str) -> None:
        self._place = place
        self._key = key
        self._last = time.monotonic()

    def load(self) -> tuple[Arrays | None, bool]:
        """The state to go on from, if one is wanted and fits; whether one was passed over."""
        if not self._place.resume or not self._place.path.is_file():
            return None, False
        try:
            with np.load(io.BytesIO(self._place.path.read_bytes()), allow_pickle=False) as file:
                state = {name: file[name] for name in file.files}
        except (OSError, ValueError, EOFError, zipfile.BadZipFile):
            return None, True
        if str(state.pop(_KEY, "")) != self._key:
            return None, True
        return state, False

    def due(self) -> bool:
        """Whether the last checkpoint is old enough for another."""
        return time.monotonic() - self._last >= self._place.interval_s

    def save(self, state: Arrays) -> None:
        """Replace the checkpoint.

        Raises:
            UsageError, LimitError: the folder cannot be written, or the disk is full.
        """
        content = io.BytesIO()
        # numpy's stub takes the names of arrays for its options.
        arrays: dict[str, Any] = {**state, _KEY: np.array(self._key)}
        np.savez(content, **arrays)
        unfinished = self._place.staging / self._place.path.name
        try:
            unfinished.write_bytes(content.getvalue())
            unfinished.replace(self._place.path)
        except OSError as error:
            raise os_error(self._place.path.parent, error) from error
        self._last = time.monotonic()


def training_key(
    start: Gaussians, cameras: tuple[Camera, ...], targets: Targets, settings: TrainingSettings
) -> str:
    """A hash of all that decides what comes out of a training."""
    found = sha256(f"{__version__} {settings!r} {targets.background}".encode())
    arrays = [*astuple(start), targets.colours.cpu().numpy(), targets.masks.cpu().numpy()]
    for camera in cameras:
        intrinsics = (camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy)
        found.update(f"{camera.role} {camera.model} {intrinsics}".encode())
        arrays += [camera.rotation, camera.translation]
    for array in arrays:
        found.update(f"{array.shape}{array.dtype}".encode() + np.ascontiguousarray(array).tobytes())
    return found.hexdigest()
