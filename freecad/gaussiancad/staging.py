"""Files that appear under their name only when whole."""

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from freecad.gaussiancad.qt import QtCore

_PREFIX = ".gaussiancad-"

_LOCK = "lock"
"""File in a staging folder that is locked as long as its process lives."""


@contextmanager
def staging(folder: Path) -> Iterator[Path]:
    """A new folder in another one, on the same file system; what is left in it is removed.

    Raises:
        OSError: the folder cannot be written.
    """
    path = Path(tempfile.mkdtemp(prefix=_PREFIX, dir=folder))
    lock = _lock_of(path)
    lock.tryLock(0)
    try:
        yield path
    finally:
        lock.unlock()
        shutil.rmtree(path, ignore_errors=True)


def sweep(folder: Path) -> None:
    """Remove staging folders whose process was killed: nobody holds their locks."""
    for path in folder.glob(f"{_PREFIX}*"):
        held = path / _LOCK
        if path.is_symlink() or held.is_symlink() or not held.is_file():
            continue
        lock = _lock_of(path)
        if lock.tryLock(0):
            lock.unlock()
            shutil.rmtree(path, ignore_errors=True)


def put_in_place(staged: Path, target: Path) -> None:
    """Give a whole file its name, once it is on the disk; a link of that name is replaced.

    Raises:
        OSError: it cannot be put there.
    """
    with staged.open("rb+") as file:
        os.fsync(file.fileno())
    staged.replace(target)


def _lock_of(path: Path) -> QtCore.QLockFile:
    lock = QtCore.QLockFile(str(path / _LOCK))
    # Only the end of its process makes a lock stale, not its age.
    lock.setStaleLockTime(0)
    return lock
