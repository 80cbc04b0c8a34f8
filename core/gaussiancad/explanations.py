"""Why a reading or a part is what it is, in sentences."""

import json
from collections.abc import Sequence
from math import isfinite
from pathlib import Path
from typing import Any

from gaussiancad.part_result import Result
from gaussiancad.sheet_reading import Reading
from gaussiancad_core.errors import UnreadableError, UsageError
from gaussiancad_protocol.codes import Code

_CONSTRUCTION_FILE = "construction.json"
_READING_FILE = "reading.json"


def explain(
    known: Result | Reading, *, at: Sequence[float] | None = None, view: str | None = None
) -> tuple[str, ...]:
    """Say why a part, or what was read of a sheet, is what it is.

    Args:
        known: what a sheet gave, or what was read of one.
        at: a place on the sheet, x and y in px as stored: what is known of it alone.
        view: the role of a view: what is known of it alone.

    Returns:
        Sentences, a line each; some are empty, between paragraphs.

    Raises:
        UsageError: ``unknown-view``; ``wrong-usage``, both a place and a view, or no such place.
        UnreadableError: ``no-report``, ``damaged-report``: a file of the result is missing, or of
            no known form.
    """
    place = None if at is None else _place(at)
    if place is not None and view is not None:
        raise UsageError(Code.WRONG_USAGE, "give a place or a view, not both")
    try:
        if isinstance(known, Reading):
            return tuple(_of_reading(known, place, view))
        return tuple(_of_result(known, place, view))
    except (KeyError, TypeError) as error:
        raise UnreadableError(
            Code.DAMAGED_REPORT,
            "{path} cannot be read: {reason}",
            path=known.folder or "the reading",
            reason=error,
        ) from error


def _of_result(known: Result, place: tuple[float, float] | None, view: str | None) -> list[str]:
    from gaussiancad_core.report.construction_sentences import construction_in_words
    from gaussiancad_core.report.explanation import explained, explained_place, explained_view

    if place is not None:
        return explained_place(known.report, _values(known.folder / _READING_FILE), place)
    if view is not None:
        _check_view(view, known.report["views"])
        return explained_view(known.report, _values(known.folder / _READING_FILE), view)
    lines = explained(known.report)
    if (known.folder / _CONSTRUCTION_FILE).is_file():
        lines += ["", "How it was put together:"]
        lines += construction_in_words(_values(known.folder / _CONSTRUCTION_FILE))
    return lines


def _of_reading(known: Reading, place: tuple[float, float] | None, view: str | None) -> list[str]:
    from gaussiancad_core.report.explanation import read_place, read_sheet_in_words, read_view

    if place is not None:
        return read_place(known.data, place)
    if view is not None:
        _check_view(view, [entry["role"] for entry in known.data["views"]])
        return read_view(known.data, view)
    return read_sheet_in_words(known.data)


def _check_view(view: str, roles: Sequence[str]) -> None:
    if view not in roles:
        raise UsageError(
            Code.UNKNOWN_VIEW,
            "the sheet has no view {view}; it has: {known}",
            view=view,
            known=", ".join(dict.fromkeys(roles)) or "none",
        )


def _place(at: Sequence[float]) -> tuple[float, float]:
    try:
        x, y = (float(value) for value in at)
    except (TypeError, ValueError):
        x = y = float("nan")
    if not (isfinite(x) and isfinite(y)):
        raise UsageError(Code.WRONG_USAGE, "a place is two numbers, x and y in px of the sheet")
    return x, y


def _values(path: Path) -> dict[str, Any]:
    """The JSON object of a file of a result."""
    try:
        values = json.loads(path.read_bytes())
    except FileNotFoundError:
        raise UnreadableError(
            Code.NO_REPORT, "{path} does not exist: run the sheet again", path=path
        ) from None
    except (OSError, ValueError, RecursionError) as error:
        raise UnreadableError(
            Code.DAMAGED_REPORT, "{path} cannot be read: {reason}", path=path, reason=error
        ) from error
    if not isinstance(values, dict):
        raise UnreadableError(
            Code.DAMAGED_REPORT, "{path} cannot be read: {reason}", path=path, reason="no object"
        )
    return values
