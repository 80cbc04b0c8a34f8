"""The engine's events: JSON lines of protocol 1, taken from a stream that may hold anything.

The stream arrives in pieces that split lines and characters.  Lines that are no events are noise
of some library, and are handed on as plain text.
"""

import json
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

PROTOCOL = 1
"""Version of the events; fields and events may be added to it, none changes its meaning."""

LONGEST_LINE = 1 << 20
"""Bytes without a line's end after which the rest of the line is dropped."""


class EventKind(Enum):
    """The events of protocol 1."""

    HELLO = "hello"
    STAGE = "stage"
    PROGRESS = "progress"
    READING = "reading"
    SOLID = "solid"
    PREVIEW = "preview"
    WARNING = "warning"
    SHEET = "sheet"
    RESULT = "result"
    ERROR = "error"


@dataclass(frozen=True)
class Event:
    """One event.

    Attributes:
        kind: which event.
        fields: its JSON values; which keys there are depends on the kind.
    """

    kind: EventKind
    fields: dict[str, Any] = field(default_factory=dict)

    def text(self, key: str) -> str:
        """The field as text, empty if it is missing."""
        value = self.fields.get(key)
        return "" if value is None else str(value)

    def is_set(self, key: str) -> bool:
        """Whether the field is true."""
        return self.fields.get(key) is True

    def values(self, key: str) -> dict[str, Any]:
        """The field as an object, empty if it is missing."""
        value = self.fields.get(key)
        return value if isinstance(value, dict) else {}

    def number(self, key: str) -> float | None:
        """The field as a finite number, or None."""
        value = self.fields.get(key)
        if isinstance(value, bool) or not isinstance(value, int | float):
            return None
        return float(value) if abs(value) < float("inf") else None


class LineBuffer:
    """Turns pieces of a byte stream into whole lines of text."""

    def __init__(self) -> None:
        self._pending = bytearray()
        self._overlong = False

    def feed(self, data: bytes) -> list[str]:
        """Take the next piece; return the lines that it completes, without their ends."""
        self._pending += data
        lines: list[str] = []
        while (end := self._pending.find(b"\n")) >= 0:
            line = bytes(self._pending[:end])
            del self._pending[: end + 1]
            if self._overlong:
                self._overlong = False
            else:
                lines.append(_decode(line))
        if len(self._pending) > LONGEST_LINE:
            self._pending.clear()
            self._overlong = True
        return lines

    def rest(self) -> list[str]:
        """The last line, if the stream ended without a line's end."""
        line = _decode(bytes(self._pending))
        self._pending.clear()
        return [line] if line and not self._overlong else []


def parse_event(line: str) -> Event | None:
    """The event in a line, or None if the line is something else."""
    try:
        values = json.loads(line)
    except (ValueError, RecursionError):
        return None
    if not isinstance(values, dict):
        return None
    name = values.pop("event", None)
    try:
        return Event(EventKind(name), values)
    except ValueError:
        return None


def _decode(line: bytes) -> str:
    return line.decode("utf-8", errors="replace").rstrip("\r")
