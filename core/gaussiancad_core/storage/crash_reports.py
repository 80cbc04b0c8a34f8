"""What nobody foresaw: one sentence, and a file that tells the makers what went wrong."""

import hashlib
import os
import platform
import sys
import tempfile
import traceback
from collections.abc import Iterable
from pathlib import Path

from gaussiancad_core import __version__
from gaussiancad_core.errors import EngineError
from gaussiancad_core.storage.versions import ENGINE_PACKAGES, installed_versions
from gaussiancad_protocol.codes import Code

_PREFIX = "gaussiancad-fault-"

_MOST_BYTES = 1 << 30
"""Of a file up to which its hash is told: more takes seconds."""

_MOST_DEEP = 60
"""Calls that a trace tells: an endless recursion has thousands."""


def unforeseen(error: BaseException, files: Iterable[Path] = ()) -> EngineError:
    """The error that a person is told instead of a traceback.

    A file in the system's folder for temporary files holds the trace, the versions, and names and
    hashes of the input, nothing of its content.

    Args:
        error: that escaped.
        files: of the input.
    """
    kind = type(error).__name__
    path = _written(_description(error, files))
    if path is None:
        return EngineError(
            Code.UNFORESEEN,
            "the engine met something that it does not foresee ({kind}): this is a fault of ours, "
            "please report it with the sheet",
            kind=kind,
        )
    return EngineError(
        Code.UNFORESEEN,
        "the engine met something that it does not foresee ({kind}): this is a fault of ours, "
        "please report it with the file {path}",
        case="file",
        kind=kind,
        path=path,
    )


def _description(error: BaseException, files: Iterable[Path]) -> str:
    versions = {"gaussiancad": __version__, "python": platform.python_version()}
    versions.update(installed_versions(ENGINE_PACKAGES))
    lines = [f"{name} {version}" for name, version in versions.items()]
    lines += [platform.platform(), ""]
    lines += [f"{path.name!r} {_hash_of(path)}" for path in files]
    trace = traceback.format_exception(type(error), error, error.__traceback__, limit=-_MOST_DEEP)
    return "\n".join([*lines, "", "".join(trace)])


def _hash_of(path: Path) -> str:
    try:
        size = path.stat().st_size
        if not path.is_file() or size > _MOST_BYTES:
            return f"{size} bytes"
        with path.open("rb") as file:
            return f"{size} bytes, sha256 {hashlib.file_digest(file, 'sha256').hexdigest()}"
    except (OSError, ValueError):
        return "cannot be read"


def _written(text: str) -> Path | None:
    """The file with a text, or nothing where none can be written."""
    try:
        handle, name = tempfile.mkstemp(prefix=_PREFIX, suffix=".txt")
        with os.fdopen(handle, "wb") as file:
            file.write(text.encode(sys.getfilesystemencoding(), "backslashreplace"))
    except OSError:
        return None
    return Path(name)
