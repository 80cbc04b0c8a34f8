"""The lock files in ``core/locks``: which packages the engine needs, with their hashes."""

import re
import shutil
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from freecad.gaussiancad.paths import CORE

_ENTRY = re.compile(r"([A-Za-z0-9][A-Za-z0-9._-]*)==([^\s;\\]+)\s*(;?)")


class EngineBuild(Enum):
    """The engines that there are locks for: by the build of PyTorch, or without it."""

    CPU = "cpu"
    CUDA = "cuda"
    SOLID = "solid"

    @property
    def lock(self) -> Path:
        """The lock file."""
        return CORE / "locks" / f"engine-{self.value}.txt"


@dataclass(frozen=True)
class Pin:
    """A package of a lock.

    Attributes:
        name: normalised: small letters, with ``-`` between words.
        version: the only one that will do.
        everywhere: whether every machine needs it; others need it on some systems or Pythons only.
    """

    name: str
    version: str
    everywhere: bool


def suggested_build() -> EngineBuild:
    """CUDA where an NVIDIA card's driver is seen, else the processor's."""
    return EngineBuild.CUDA if shutil.which("nvidia-smi") else EngineBuild.CPU


def pins(lock_text: str) -> list[Pin]:
    """The packages of a lock."""
    found = (_ENTRY.match(line) for line in lock_text.splitlines())
    return [Pin(normalised(one[1]), one[2], not one[3]) for one in found if one is not None]


def entries(lock_text: str, names: set[str]) -> str:
    """The lines of a lock that pin some packages, with their hashes.

    Args:
        lock_text: the lock.
        names: normalised names of the packages.
    """
    lines: list[str] = []
    taken = False
    for line in lock_text.splitlines():
        if (one := _ENTRY.match(line)) is not None:
            taken = normalised(one[1]) in names
        elif not line.startswith(" "):
            taken = False
        if taken:
            lines.append(line)
    return "\n".join([*lines, ""])


def normalised(name: str) -> str:
    """A package's name as indexes compare it."""
    return re.sub(r"[-_.]+", "-", name).lower()
