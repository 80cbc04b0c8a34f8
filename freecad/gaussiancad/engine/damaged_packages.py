"""Tells which installed packages have files that are not as they were installed.

The Python of an environment runs this file by its path, on its own; for each such package it
prints a line ``damaged: NAME``.
"""

import base64
import hashlib
from collections.abc import Iterator
from importlib.metadata import Distribution, PackagePath, distributions
from pathlib import Path


def damaged() -> Iterator[str]:
    """Names of the packages that lack a file, or have one with other bytes."""
    for package in distributions():
        name = package.metadata["Name"]
        if name and not _is_whole(package):
            yield name


def _is_whole(package: Distribution) -> bool:
    return all(_is_as_installed(own) for own in package.files or () if own.hash is not None)


def _is_as_installed(own: PackagePath) -> bool:
    path = Path(own.locate())
    try:
        if own.size is not None and path.stat().st_size != own.size:
            return False
        with path.open("rb") as file:
            digest = hashlib.file_digest(file, own.hash.mode).digest()
    except (OSError, ValueError):
        return False
    return base64.urlsafe_b64encode(digest).rstrip(b"=").decode() == own.hash.value


if __name__ == "__main__":
    for damaged_name in damaged():
        print(f"damaged: {damaged_name}", flush=True)
