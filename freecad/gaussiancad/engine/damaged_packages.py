"""Tells which installed packages have files that are not as they were installed.

The Python of an environment runs this file by its path, on its own; for each such package it
prints a line ``damaged: NAME``.
"""

import base64
import csv
import hashlib
from collections.abc import Iterator
from importlib.metadata import Distribution, distributions
from pathlib import Path


def damaged() -> Iterator[str]:
    """Names of the packages that lack a file, or have one with other bytes."""
    for package in distributions():
        name = package.metadata["Name"]
        if name and not all(_is_as_installed(*row) for row in _recorded(package)):
            yield name


def _recorded(package: Distribution) -> Iterator[tuple[Path, str, str]]:
    """Path, hash and size of each file; ``Distribution.files`` leaves out those that are gone."""
    for row in csv.reader((package.read_text("RECORD") or "").splitlines()):
        # What Python compiled itself, it compiles anew whenever it likes.
        if len(row) == 3 and row[1] and not row[0].endswith(".pyc"):
            yield Path(package.locate_file(row[0])), row[1], row[2]


def _is_as_installed(path: Path, text: str, size: str) -> bool:
    mode, _, value = text.partition("=")
    try:
        if size and path.stat().st_size != int(size):
            return False
        with path.open("rb") as file:
            digest = hashlib.file_digest(file, mode).digest()
    except (OSError, ValueError):
        return False
    return base64.urlsafe_b64encode(digest).rstrip(b"=").decode() == value


if __name__ == "__main__":
    for damaged_name in damaged():
        print(f"damaged: {damaged_name}", flush=True)
