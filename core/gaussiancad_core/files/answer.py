"""What a reader's process answers, as MessagePack: nothing in it can be executed.

Curves go by their types, as what is read back has to be of a known one.
"""

import json
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import msgspec
import numpy as np

from gaussiancad_core.errors import (
    GaussianCadError,
    LimitError,
    NoModelError,
    UnreadableError,
    UsageError,
)
from gaussiancad_core.files.content import FileContent, Grey, Note
from gaussiancad_core.files.vectors import (
    Colour,
    StrokeKind,
    StrokeRole,
    VectorDrawing,
    VectorStroke,
    VectorText,
)
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.messages import Message, args_of, filled

_ERRORS: dict[str, type[GaussianCadError]] = {
    kind.__name__: kind for kind in (UnreadableError, LimitError, NoModelError, UsageError)
}


class _Note(msgspec.Struct, array_like=True):
    """A note, its message as JSON: names of files may be no text, which MessagePack has not."""

    code: str
    message: bytes
    is_doubt: bool


class _Stroke(msgspec.Struct, array_like=True):
    """A stroke: its curve is the next one of its type."""

    curve: str
    width: float | None
    dashes: tuple[float, ...]
    role: StrokeRole
    layer: str
    kind: StrokeKind
    colour: Colour | None
    step: float


class _Drawing(msgspec.Struct):
    """A drawing, its curves by their types, each in the strokes' order."""

    strokes: list[_Stroke]
    lines: list[LineSegment]
    arcs: list[CircularArc]
    ellipses: list[EllipticArc]
    chains: list[Chain]
    texts: tuple[VectorText, ...]
    complete: bool
    has_paper: bool
    unit_mm: float | None
    unit_px: float | None
    pictures: tuple[Box, ...]


class _Content(msgspec.Struct, tag=True):
    """What was read: grey levels, and tints where there are some, row by row."""

    shape: tuple[int, int]
    planes: list[memoryview]
    pixels_per_inch: float | None
    vectors: _Drawing | None
    notes: list[_Note]
    pages: int
    brought_together: int | None


class _Failure(msgspec.Struct, tag=True):
    """Why nothing was read."""

    error: str
    code: str
    message: bytes


def _plain(value: Any) -> Any:  # noqa: ANN401
    """A number of numpy, or a text that knows its values, as what MessagePack has."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, str):
        return str(value)
    raise NotImplementedError(f"no part of an answer: {type(value).__name__}")


_ENCODER = msgspec.msgpack.Encoder(enc_hook=_plain)
_DECODER = msgspec.msgpack.Decoder(_Content | _Failure)


def content_bytes(content: FileContent) -> bytes:
    """What was read."""
    planes = [content.grey] if content.tint is None else [content.grey, content.tint]
    answer = _Content(
        content.grey.shape,
        [np.ascontiguousarray(plane).data.cast("B") for plane in planes],
        content.pixels_per_inch,
        None if content.vectors is None else _by_types(content.vectors),
        [_packed_note(note) for note in content.notes],
        content.pages,
        content.brought_together,
    )
    return _ENCODER.encode(answer)


def error_bytes(error: GaussianCadError) -> bytes:
    """Why nothing was read."""
    return _ENCODER.encode(_Failure(type(error).__name__, error.code, _json(error.message)))


def outcome_of(answer: bytes) -> FileContent | GaussianCadError:
    """What was read, or why nothing was.

    Raises:
        ValueError: it is no answer: the process did not come to its end.
    """
    found = _DECODER.decode(answer)
    if isinstance(found, _Failure):
        if found.error not in _ERRORS:
            raise ValueError(f"no answer: {found.error}")
        return _ERRORS[found.error](found.code, _message(found.message))
    grey, *tints = (_plane(levels, found.shape) for levels in found.planes)
    return FileContent(
        grey,
        found.pixels_per_inch,
        None if found.vectors is None else _in_order(found.vectors),
        tuple(_note(note) for note in found.notes),
        tints[0] if tints else None,
        found.pages,
        found.brought_together,
    )


def _plane(levels: memoryview, shape: tuple[int, int]) -> Grey:
    return np.frombuffer(levels, np.uint8).reshape(shape).copy()


def _packed_note(note: Note) -> _Note:
    return _Note(note.code, _json(note.message), note.is_doubt)


def _note(note: _Note) -> Note:
    return Note(note.code, _message(note.message), note.is_doubt)


def _json(message: str) -> bytes:
    """A message and its values; null for those of a plain text."""
    args = args_of(message) if isinstance(message, Message) else None
    return json.dumps([str(message), args], default=_plain).encode()


def _message(content: bytes) -> str:
    text, args = json.loads(content)
    return text if args is None else filled(text, args)


def _written(text: str) -> str:
    """A text of a file, with a sign for what is no character: some readers keep such bytes."""
    return text.encode("utf-8", "replace").decode()


def _by_types(drawing: VectorDrawing) -> _Drawing:
    curves = [stroke.curve for stroke in drawing.strokes]
    strokes = []
    for stroke in drawing.strokes:
        strokes.append(
            _Stroke(
                type(stroke.curve).__name__,
                stroke.width,
                stroke.dashes,
                stroke.role,
                _written(stroke.layer),
                stroke.kind,
                stroke.colour,
                stroke.step,
            )
        )
    return _Drawing(
        strokes,
        [curve for curve in curves if isinstance(curve, LineSegment)],
        [curve for curve in curves if isinstance(curve, CircularArc)],
        [curve for curve in curves if isinstance(curve, EllipticArc)],
        [curve for curve in curves if isinstance(curve, Chain)],
        tuple(replace(text, text=_written(text.text)) for text in drawing.texts),
        drawing.complete,
        drawing.has_paper,
        drawing.unit_mm,
        drawing.unit_px,
        drawing.pictures,
    )


def _in_order(found: _Drawing) -> VectorDrawing:
    """The drawing with its curves in the strokes' order.

    Raises:
        ValueError: there are fewer curves of a type than strokes have.
    """
    curves: dict[str, Iterator[Curve]] = {
        LineSegment.__name__: iter(found.lines),
        CircularArc.__name__: iter(found.arcs),
        EllipticArc.__name__: iter(found.ellipses),
        Chain.__name__: iter(found.chains),
    }
    try:
        strokes = tuple(
            VectorStroke(
                next(curves[stroke.curve]),
                stroke.width,
                stroke.dashes,
                stroke.role,
                stroke.layer,
                stroke.kind,
                stroke.colour,
                stroke.step,
            )
            for stroke in found.strokes
        )
    except (KeyError, RuntimeError) as error:
        raise ValueError("no answer: strokes without curves") from error
    return VectorDrawing(
        strokes,
        found.texts,
        found.complete,
        found.has_paper,
        found.unit_mm,
        found.unit_px,
        found.pictures,
    )
