"""Files that appear under their name only when whole."""

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def staging(folder: Path) -> Iterator[Path]:
    """A new folder in another one, on the same file system; what is left in it is removed.

    Raises:
        OSError: the folder cannot be written.
    """
    path = Path(tempfile.mkdtemp(prefix=".gaussiancad-", dir=folder))
    try:
        yield path
    finally:
        shutil.rmtree(path, ignore_errors=True)


def put_in_place(staged: Path, target: Path) -> None:
    """Give a whole file its name, once it is on the disk; a link of that name is replaced.

    Raises:
        OSError: it cannot be put there.
    """
    with staged.open("rb+") as file:
        os.fsync(file.fileno())
    staged.replace(target)
