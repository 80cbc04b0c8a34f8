"""``check.json`` as data: whether a model agrees with its drawing, and where it does not.

Missing fields read as nothing, since fields may be added; a file without a verdict is an error.
"""

import math
from dataclasses import dataclass, replace
from enum import Enum
from pathlib import Path
from typing import Any

from freecad.gaussiancad.engine.report import (
    Remark,
    as_number,
    as_numbers,
    as_remarks,
    read_object,
    unreadable,
)

Place = tuple[float, float, float]
"""mm in the model's own coordinates."""

Piece = tuple[Place, Place]
"""The ends of a piece of line; twice the same place where only a spot is known."""

_SIZED = ("given", "dimension")
"""Sources of a scale with which a model's size is checked."""


class CheckVerdict(Enum):
    """Whether a model agrees with its drawing."""

    AGREES = "agrees"
    DIFFERS = "differs"
    CANNOT_TELL = "cannot-tell"


class DifferenceKind(Enum):
    """In what a model and a drawing differ."""

    MISSING = "missing"
    EXTRA = "extra"
    LINETYPE = "linetype"
    PLACE = "place"
    NUMBER = "number"
    NOTE = "note"


@dataclass(frozen=True)
class CheckDifference:
    """A place at which a model and its drawing differ.

    Attributes:
        view: front, top, right, left, bottom or rear, for a section with its letters after it.
        kind: in what; None for a kind that is not known here.
        is_hidden: whether it is about a hidden line.
        length: mm of line.
        pieces: where it is, on the side of the model that the view shows.
        text: of a note; empty for all else.
        stated, measured: mm that a number says and the model has, or holes that a note speaks of
            and the model has; None for lines.
    """

    view: str
    kind: DifferenceKind | None
    is_hidden: bool
    length: float
    pieces: tuple[Piece, ...]
    text: str = ""
    stated: float | None = None
    measured: float | None = None


@dataclass(frozen=True)
class CheckEdit:
    """A single change of the model with which it explains the drawing better.

    Attributes:
        what: ``fill``, ``drill``, ``move``, ``shift`` or ``mirror``.
        message: the engine's own sentence, English.
        length: mm of line that the drawing explains better with it.
        start, end: where what is changed is, and where it goes; None where it has no place.
        diameter: mm, of a hole; None of all else.
    """

    what: str
    message: str
    length: float
    start: Place | None
    end: Place | None
    diameter: float | None


@dataclass(frozen=True)
class SheetCheck:
    """A model against its drawing.

    Attributes:
        verdict: whether they agree.
        reasons: why, or why nobody can tell; the strongest first.
        differences: the worst first.
        edits: the best first.
        is_size_checked: False where the drawing does not say how large the part is; all mm are
            those of the model then.
        axes: the drawing's x, y and z as directions of length 1 in the model's own coordinates;
            None where the model fits in no position.
    """

    verdict: CheckVerdict
    reasons: tuple[Remark, ...]
    differences: tuple[CheckDifference, ...]
    edits: tuple[CheckEdit, ...]
    is_size_checked: bool = True
    axes: tuple[Place, Place, Place] | None = None


def read_check(path: Path) -> SheetCheck:
    """Read a ``check.json``.

    Raises:
        WorkbenchError: the file is missing, or has no verdict.
    """
    _, values = read_object(path)
    try:
        return parse_check(values)
    except ValueError as error:
        raise unreadable(path, str(error)) from error


def parse_check(values: dict[str, Any]) -> SheetCheck:
    """The check in a file's JSON.

    Raises:
        ValueError: it has no verdict.
    """
    pose = values.get("pose")
    pose = pose if isinstance(pose, dict) else {}
    is_size_checked = not pose or pose.get("scale_source") in _SIZED
    scale = 1.0 if is_size_checked else as_number(pose.get("scale")) or 1.0
    return SheetCheck(
        CheckVerdict(values.get("verdict")),
        tuple(_in_model_mm(each, scale) for each in as_remarks(values.get("reasons"))),
        tuple(_difference(each, scale) for each in _objects(values.get("differences"))),
        tuple(_edit(each, scale) for each in _objects(values.get("edits"))),
        is_size_checked,
        _axes(pose.get("matrix")),
    )


def _in_model_mm(reason: Remark, scale: float) -> Remark:
    """A reason with its lengths in mm of the model."""
    args = {
        name: scale * value if name.endswith("_mm") and as_number(value) is not None else value
        for name, value in reason.args.items()
    }
    return replace(reason, args=args)


def _difference(values: dict[str, Any], scale: float) -> CheckDifference:
    kind = values.get("kind")
    known = {each.value for each in DifferenceKind}
    pieces = values.get("model")
    found = [_piece(each) for each in pieces] if isinstance(pieces, list) else []
    factor = 1.0 if kind == DifferenceKind.NOTE.value else scale
    stated, measured = (as_number(values.get(name)) for name in ("stated", "measured"))
    return CheckDifference(
        str(values.get("view", "")),
        DifferenceKind(kind) if kind in known else None,
        values.get("of") == "hidden line",
        scale * (as_number(values.get("length_mm")) or 0.0),
        tuple(each for each in found if each is not None),
        str(values.get("text") or ""),
        None if stated is None else factor * stated,
        None if measured is None else factor * measured,
    )


def _edit(values: dict[str, Any], scale: float) -> CheckEdit:
    diameter = as_number(values.get("diameter_mm"))
    return CheckEdit(
        str(values.get("what", "")),
        str(values.get("message", "")),
        scale * (as_number(values.get("mm")) or 0.0),
        _place(values.get("model_from")),
        _place(values.get("model_to")),
        None if diameter is None else scale * diameter,
    )


def _axes(rows: object) -> tuple[Place, Place, Place] | None:
    """The first three numbers of a matrix's rows, each row as long as 1."""
    found = [as_numbers(row)[:3] for row in rows] if isinstance(rows, list) else []
    lengths = [math.hypot(*row) for row in found[:3]]
    if len(lengths) < 3 or any(len(row) < 3 for row in found[:3]) or min(lengths) <= 0.0:
        return None
    x, y, z = (
        (row[0] / length, row[1] / length, row[2] / length)
        for row, length in zip(found, lengths, strict=False)
    )
    return x, y, z


def _objects(values: object) -> list[dict[str, Any]]:
    return [each for each in values if isinstance(each, dict)] if isinstance(values, list) else []


def _piece(values: object) -> Piece | None:
    ends = [_place(end) for end in values] if isinstance(values, list) else []
    return (ends[0], ends[1]) if len(ends) == 2 and None not in ends else None


def _place(values: object) -> Place | None:
    numbers = as_numbers(values)
    return (numbers[0], numbers[1], numbers[2]) if len(numbers) == 3 else None
