"""Files that appear under their name only when whole."""

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
