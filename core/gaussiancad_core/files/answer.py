"""What a reader's process answers, as JSON and grey levels: nothing in it can be executed.

A line of JSON, then the pixels row by row: grey levels, and tints where there are some.
"""

import json
from dataclasses import fields, is_dataclass
from enum import Enum
from typing import Any

import numpy as np

from gaussiancad_core.errors import (
    GaussianCadError,
    LimitError,
    NoModelError,
    UnreadableError,
    UsageError,
)
from gaussiancad_core.files.content import FileContent, Note
from gaussiancad_core.files.vectors import (
    Chain,
    CircularArc,
    EllipticArc,
    Line,
    StrokeKind,
    StrokeRole,
    VectorDrawing,
    VectorStroke,
    VectorText,
)
from gaussiancad_core.messages import Message, filled, told

_KINDS: dict[str, type[Any]] = {
    kind.__name__: kind
    for kind in (
        Note,
        Line,
        CircularArc,
        EllipticArc,
        Chain,
        StrokeRole,
        StrokeKind,
        VectorStroke,
        VectorText,
        VectorDrawing,
    )
}

_MESSAGE = Message.__name__

_ERRORS: dict[str, type[GaussianCadError]] = {
    kind.__name__: kind for kind in (UnreadableError, LimitError, NoModelError, UsageError)
}


def content_bytes(content: FileContent) -> bytes:
    """What was read."""
    head = {
        "shape": content.grey.shape,
        "pixels_per_inch": content.pixels_per_inch,
        "vectors": _plain(content.vectors),
        "notes": _plain(content.notes),
        "tinted": content.tint is not None,
        "pages": content.pages,
        "brought_together": content.brought_together,
    }
    planes = [content.grey] if content.tint is None else [content.grey, content.tint]
    return _line(head) + b"".join(np.ascontiguousarray(own).tobytes() for own in planes)


def error_bytes(error: GaussianCadError) -> bytes:
    """Why nothing was read."""
    return _line({"error": type(error).__name__, **told(error.code, error.message)})


def outcome_of(answer: bytes) -> FileContent | GaussianCadError:
    """What was read, or why nothing was.

    Raises:
        ValueError: it is no answer: the process did not come to its end.
    """
    line, _, pixels = answer.partition(b"\n")
    try:
        head = json.loads(line)
        if "error" in head:
            message = filled(str(head["message"]), head.get("args", {}))
            return _ERRORS[head["error"]](str(head["code"]), message)
        height, width = (int(length) for length in head["shape"])
        count = 2 if head["tinted"] else 1
        planes = np.frombuffer(pixels, np.uint8).reshape(count, height, width).copy()
        return FileContent(
            planes[0],
            head["pixels_per_inch"],
            _made(head["vectors"]),
            _made(head["notes"]),
            planes[1] if count > 1 else None,
            int(head["pages"]),
            head["brought_together"],
        )
    except (TypeError, LookupError, AttributeError) as error:
        raise ValueError(f"no answer: {error}") from error


def _line(head: dict[str, Any]) -> bytes:
    return json.dumps(head).encode("ascii") + b"\n"


def _plain(value: Any) -> Any:  # noqa: ANN401
    """A value as JSON has it; of those with a name the name comes first."""
    if isinstance(value, Enum):
        return {"": [type(value).__name__, value.value]}
    if isinstance(value, Message):
        return {"": [_MESSAGE, str(value), *([name, own] for name, own in value.args.items())]}
    if is_dataclass(value):
        own = [_plain(getattr(value, field.name)) for field in fields(value)]
        return {"": [type(value).__name__, *own]}
    if isinstance(value, list | tuple):
        return [_plain(each) for each in value]
    if isinstance(value, np.generic):
        return value.item()
    return value


def _made(value: Any) -> Any:  # noqa: ANN401
    if isinstance(value, dict):
        name, *own = value[""]
        if name == _MESSAGE:
            return filled(own[0], dict(own[1:]))
        return _KINDS[name](*(_made(each) for each in own))
    if isinstance(value, list):
        return tuple(_made(each) for each in value)
    return value
