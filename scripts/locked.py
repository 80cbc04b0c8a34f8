"""The packages that the lock files in ``core/locks`` pin."""

import re
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LOCKS = ROOT / "core" / "locks"

_ENTRY = re.compile(
    r"^(?P<name>\w[\w.-]*)==(?P<version>[^\s;\\]+)(?: ; (?P<marker>[^\\\n]*[^\\\s]))? *\\?\n"
    r"(?P<hashes>(?: +--hash=sha256:[0-9a-f]{64} *\\?\n)*)",
    re.MULTILINE,
)


class Lock(Enum):
    """The lock files, and who installs them."""

    CPU = "engine-cpu.txt"
    CUDA = "engine-cuda.txt"
    SOLID = "engine-solid.txt"
    TESTS = "tests.txt"

    @property
    def extras(self) -> tuple[str, ...]:
        """The extras of the engine whose packages it has."""
        if self is Lock.TESTS:
            return ("test", "window", "cluster", "mcp")
        return () if self is Lock.SOLID else ("surface", "compare")

    @property
    def path(self) -> Path:
        """The file."""
        return LOCKS / self.value


@dataclass(frozen=True)
class Package:
    """One entry of a lock.

    Attributes:
        name: as the index knows it, in lower case with hyphens.
        version: as pinned; PyTorch's CPU build has a local part, ``+cpu``.
        marker: where the entry counts (PEP 508), or empty for everywhere.
        hashes: SHA-256 of each wheel, in hexadecimal.
    """

    name: str
    version: str
    marker: str
    hashes: tuple[str, ...]

    @property
    def release(self) -> str:
        """The version without the part that tells one build from another."""
        return self.version.partition("+")[0]


def canonical(name: str) -> str:
    """A package's name as the locks and the index write it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def parse_lock(text: str) -> tuple[Package, ...]:
    """The entries of a lock's text, in its order.

    Raises:
        ValueError: a line is neither part of an entry nor a comment, or an entry has no hash.
    """
    found = tuple(
        Package(
            canonical(match["name"]),
            match["version"],
            match["marker"] or "",
            tuple(re.findall(r"sha256:(\w+)", match["hashes"])),
        )
        for match in _ENTRY.finditer(text)
    )
    rest = [line for line in _ENTRY.sub("", text).splitlines() if line and line[0] != "#"]
    if rest:
        raise ValueError(f"no entry of a lock: {rest[0]!r}")
    for package in found:
        if not package.hashes:
            raise ValueError(f"{package.name} has no hash")
    return found


def read_lock(lock: Lock) -> tuple[Package, ...]:
    """The entries of a lock file; ValueError as for `parse_lock`."""
    return parse_lock(lock.path.read_text(encoding="utf-8"))
