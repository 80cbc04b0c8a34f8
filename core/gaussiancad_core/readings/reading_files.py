"""``reading.json`` and what a person wrote beside it -> checked data."""

from collections import Counter
from pathlib import Path
from typing import TypeVar

import msgspec

from gaussiancad_core.errors import LimitError, UnreadableError
from gaussiancad_core.readings.correction_operations import Corrections
from gaussiancad_core.readings.reading_schema import SheetReading
from gaussiancad_core.storage.plain_files import check_plain
from gaussiancad_protocol.codes import Code

_MOST_BYTES = 64 * 2**20
"""Of such a file: a sheet of 200,000 strokes has less."""

_MOST_STROKES = 20_000
"""Of a reading: views of a part have some hundred, and each is looked at beside the others."""

_MOST_OPERATIONS = 2_000
"""Of a person: each looks through the strokes."""

Kind = TypeVar("Kind")


def open_reading(path: Path) -> SheetReading:
    """A reading from its file.

    Raises:
        UnreadableError: ``reading-not-read``: the file is missing, too large, or no reading; the
            message names the place.
        LimitError: ``too-many-elements``: it has more strokes than are taken.
    """
    reading = open_typed(path, SheetReading, Code.READING_NOT_READ)
    if len(reading.strokes) > _MOST_STROKES:
        raise LimitError(
            Code.TOO_MANY_ELEMENTS,
            "{path} has {count:,} strokes, at most {most:,} are taken: read the views alone",
            case="reading",
            path=path,
            count=len(reading.strokes),
            most=_MOST_STROKES,
        )
    for what, entries in (("views", reading.views), ("strokes", reading.strokes)):
        counts = Counter(entry.id for entry in entries)
        twice = next((name for name, count in counts.items() if count > 1), None)
        if twice is not None:
            raise _wrong(path, f"{what}: two have the id {twice!r}", Code.READING_NOT_READ)
    return reading


def open_corrections(path: Path) -> Corrections:
    """A person's corrections from their file.

    Raises:
        UnreadableError: ``corrections-not-read``: the file is missing, too large, or of another
            form; the message names the place.
        LimitError: ``too-many-elements``: it has more corrections than are taken.
    """
    corrections = open_typed(path, Corrections, Code.CORRECTIONS_NOT_READ)
    if len(corrections.ops) > _MOST_OPERATIONS:
        raise LimitError(
            Code.TOO_MANY_ELEMENTS,
            "{path} has {count:,} corrections, at most {most:,} are taken: remove those that no "
            "longer matter",
            case="corrections",
            path=path,
            count=len(corrections.ops),
            most=_MOST_OPERATIONS,
        )
    return corrections


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
        check_plain(path)
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
