"""Files that a person names, as far as they are files: opening a pipe waits for ever, and a device
ends never."""

import errno
import os
from pathlib import Path


def check_plain(path: Path) -> None:
    """Refuse what is there and no plain file, a folder among it.

    Raises:
        OSError: with the system's word for it.
    """
    if path.exists() and not path.is_file():
        code = errno.EISDIR if path.is_dir() else errno.ENXIO
        reason = os.strerror(code) if path.is_dir() else "it is a device or a pipe"
        raise OSError(code, reason, str(path))


def plain_bytes(path: Path) -> bytes:
    """The content of a plain file.

    Raises:
        OSError: it cannot be read, or is none.
    """
    check_plain(path)
    return path.read_bytes()
