"""``reading.json`` and what a person wrote beside it -> checked data."""

from pathlib import Path
from typing import TypeVar

import msgspec

from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.readings.schema import SheetReading

_MOST_BYTES = 64 * 2**20
"""Of such a file: a sheet of 200,000 strokes has less."""

Kind = TypeVar("Kind")


def open_reading(path: Path) -> SheetReading:
    """A reading from its file.

    Raises:
        UnreadableError: ``reading-not-read``: the file is missing, too large, or no reading; the
            message names the place.
    """
    reading = open_typed(path, SheetReading, "reading-not-read")
    for what, entries in (("views", reading.views), ("strokes", reading.strokes)):
        names = [entry.id for entry in entries]
        if len(set(names)) < len(names):
            twice = next(name for name in names if names.count(name) > 1)
            raise _wrong(path, f"{what}: two have the id {twice!r}", "reading-not-read")
    return reading


def open_typed(path: Path, kind: type[Kind], code: str) -> Kind:
    """The JSON object of a file as one of a type.

    Args:
        path: of the file.
        kind: its type.
        code: of the error.

    Raises:
        UnreadableError: it is missing, too large, or of another form; the message names the place.
    """
    try:
        if path.stat().st_size > _MOST_BYTES:
            raise _wrong(path, f"it has more than {_MOST_BYTES >> 20} MB", code)
        content = path.read_bytes()
    except UnreadableError:
        raise
    except OSError as error:
        raise _wrong(path, error.strerror or "it cannot be opened", code) from error
    try:
        return msgspec.json.decode(content, type=kind)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as error:
        raise _wrong(path, " ".join(str(error).split()), code) from error


def _wrong(path: Path, why: str, code: str) -> UnreadableError:
    return UnreadableError(
        code,
        "{path} was not taken: {reason}; write it with `gaussiancad read`, or mend that place",
        path=path,
        reason=why,
    )
