"""Sentences that still know what fills their places.

A message is written once, as a template with the values of its places, as in ``Message("{path} has
{count} pages", path=path, count=count)``.  It is an English sentence wherever a text is wanted;
whoever words it anew, in another language or for a window, takes its code and its ``args``.  Where
one code has several sentences, ``case`` among the values tells which it is.
"""

from collections.abc import Callable, Iterable, Mapping
from enum import Enum
from numbers import Integral, Real
from types import MappingProxyType
from typing import Any

Box = tuple[float, float, float, float]
"""x0, y0, x1, y1."""

Argument = str | int | float
"""What travels of a value, as JSON has it."""


class Message(str):
    """A sentence for a person.

    Args:
        template: the sentence, with ``{name}`` for each value; text without values as it is.
        boxes: where on the sheet that is of which it speaks, px.
        values: by the names of their places; they may be of any type that formats.

    Attributes:
        args: the values as numbers and texts; those of enums, and the texts of all else.
        boxes: as given.
    """

    args: Mapping[str, Argument]
    boxes: tuple[Box, ...]

    def __new__(cls, template: str, /, boxes: Iterable[Box] = (), **values: object) -> "Message":
        """Fill the places."""
        plain = {name: _plain(value) for name, value in values.items()}
        made = super().__new__(cls, template.format(**plain) if plain else template)
        made.args = MappingProxyType(plain)
        made.boxes = tuple(boxes)
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies and pickles keep the values."""
        return filled, (str(self), dict(self.args), self.boxes)

    def moved(self, move: Callable[[Box], Box]) -> "Message":
        """The same with its boxes somewhere else, as on the sheet as stored."""
        return filled(str(self), self.args, map(move, self.boxes))


def filled(text: str, args: Mapping[str, Argument], boxes: Iterable[Box] = ()) -> Message:
    """A sentence whose values and boxes are known beside it, as from JSON."""
    made = Message(text)
    made.args = MappingProxyType(dict(args))
    made.boxes = tuple(boxes)
    return made


def args_of(message: str) -> dict[str, Argument]:
    """The values in a message; none in a text that is no :class:`Message`."""
    return dict(message.args) if isinstance(message, Message) else {}


def boxes_of(message: str) -> tuple[Box, ...]:
    """Where that is of which a message speaks; nowhere in a text that is no :class:`Message`."""
    return message.boxes if isinstance(message, Message) else ()


def on_one_line(message: str) -> Message:
    """The same without line breaks, and with an escape for what else does not print."""
    plain = "".join(
        text if text.isprintable() else _escape(text) for text in " ".join(message.split())
    )
    return filled(plain, args_of(message), boxes_of(message))


def _escape(character: str) -> str:
    return character.encode("unicode_escape").decode("ascii")


def event_fields(code: str, message: str) -> dict[str, Any]:
    """A message as JSON has it: ``code``, ``message`` and, where it has them, ``args`` and ``at``,
    boxes on the sheet."""
    args, boxes = args_of(message), boxes_of(message)
    at = [[round(float(value), 1) for value in box] for box in boxes]
    known = {"args": args, "at": at}
    return {
        "code": code,
        "message": str(message),
        **{name: value for name, value in known.items() if value},
    }


def _plain(value: object) -> Argument:
    if isinstance(value, Enum):
        value = value.value
    if isinstance(value, Integral):
        return int(value)
    return float(value) if isinstance(value, Real) else str(value)
