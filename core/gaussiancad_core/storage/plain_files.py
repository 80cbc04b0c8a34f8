"""Files that a person names, as far as they are files: opening a pipe waits for ever, and a device
ends never."""

import errno
import os
from pathlib import Path

from gaussiancad_core.errors import UnreadableError
from gaussiancad_protocol.codes import Code


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


def model_bytes(path: Path) -> bytes:
    """What a file of a model holds, whatever its format.

    Raises:
        UnreadableError: ``file-missing``, ``file-not-readable``, ``empty-file``.
    """
    try:
        content = plain_bytes(path)
    except FileNotFoundError as error:
        raise UnreadableError(
            Code.FILE_MISSING, "{path} does not exist: check the path", path=path
        ) from error
    except OSError as error:
        reason = error.strerror or str(error)
        raise UnreadableError(
            Code.FILE_NOT_READABLE,
            "cannot read {path} ({reason}): check what and whose it is",
            path=path,
            reason=reason,
        ) from error
    if not content.strip():
        raise UnreadableError(Code.EMPTY_FILE, "{path} is empty: export the model again", path=path)
    return content
