"""Notes of how thick a plate is, in the words and letters of several countries.

*t* is the letter of ISO 129-1, *s* that of GOST 2.307, for flat parts in one view; words stand
before the number or behind it, in a longer note, too.
"""

import re
from dataclasses import dataclass

from gaussiancad_core.writing.numbers import (
    NUMBER,
    UNIT,
    Unit,
    plain_text,
    unit_of_number,
    value_of,
)

_UNITS = r"[:\u00b0%]|(?:[\u00b5\u03bcuckd]?m|[CFKs]|sec|min|h|k?Nm?|[kMG]?Pa|bar|k?g|HRC|HB|deg)\b"
"""What follows numbers that are no thickness in millimetres or inches: temperatures, times, forces,
hardnesses, other lengths; and the colon of scales."""

_NUMBER = (
    rf"(?P<number>{NUMBER})(?![\d.,/]*\d)"
    rf"(?!(?:\s?/?\s?[\u00b1+-]\s?{NUMBER})*\s?(?:{_UNITS}))"
    # Within a sentence IN is a word.
    rf"(?:\s?(?P<unit>(?!in\s+\w){UNIT}))?(?:\s?\u00b1\s?{NUMBER}(?:\s?{UNIT})?)?"
)

_PLATE = r"(?:PLATE|SHEET|STOCK|BLECH|PLATTE|T\u00d4LE|\u677f)"
"""What a note says is so thick, beside its words: a part of them."""

_BEFORE = (
    r"THK",
    r"THICK(?:NESS)?",
    r"(?:BLECH|MATERIAL)?(?:DICKE|ST\u00c4RKE|STAERKE)",
    r"\u00c9P(?:AISSEUR)?",
    r"EP(?:AISSEUR)?",
    r"SPESSORE",
    r"ESPESOR",
    r"\u0442\u043e\u043b\u0449(?:\u0438\u043d\u0430)?",
)
"""Words before a number."""

_BEHIND = (r"THK", r"THICK(?:NESS)?", r"DICK", r"STARK", r"D['\u2019]\u00c9PAISSEUR")
"""Words behind a number."""

_HAN = r"(?:\u677f\u539a|\u539a\u5ea6|\u539a\u3055|\u539a|\u03b4)"
"""Words of scripts that part none."""

_LETTER = re.compile(rf"[ts]\s?:?\s?{_NUMBER}")
_EQUAL = rf"[ts]\s?=\s?{_NUMBER}"
_WORD = rf"(?:{'|'.join(_BEFORE)})\b\.?\s?[=:]?\s?{_NUMBER}"
_HAN_WORD = rf"{_HAN}\s?[=:]?\s?{_NUMBER}"
_WORD_BEHIND = (
    rf"(?<![.,/])(?<!\d:)(?P<number>{NUMBER})\s?-?(?P<unit>{UNIT})?"
    rf"\s?-?(?:(?:{'|'.join(_BEHIND)})(?!\w)|\u539a)"
)

_PHRASES = tuple(
    re.compile(rf"{start}(?:{_PLATE}\s)?{phrase}(?:\s{_PLATE}(?!\w))?", re.IGNORECASE)
    for start, phrase in (
        (r"(?<!\w)", _EQUAL),
        (r"(?<!\w)", _WORD),
        ("", _HAN_WORD),
        (r"(?<!\w)", _WORD_BEHIND),
    )
)
"""What tells a thickness within a longer text."""

_WALLS = re.compile(
    r"WALL|COAT|PLATING|PAINT|FILM|LAYER|WAND|SCHICHT|PAROI|REV\u00caTEMENT|\u58c1|\u9540|\u6d82"
    r"|\u0441\u0442\u0435\u043d\u043a|\u043f\u043e\u043a\u0440\u044b\u0442",
    re.IGNORECASE,
)
"""Walls and coatings, whose thickness is not the part's."""


@dataclass(frozen=True)
class Thickness:
    """How thick a note says that the part is.

    Attributes:
        value: in its unit.
        unit: where the note names it.
    """

    value: float
    unit: Unit | None = None


def take_thickness(
    text: str, *, field: bool = False, bare_point_is_inch: bool = True
) -> tuple[Thickness | None, str]:
    """The thickness of a plate that a note tells first, if it tells any, and what it says besides.

    Args:
        text: of the note.
        field: whether it stands in a field of the title block, where a letter and a number are a
            material, a temper or a part's number as well: only words, or a letter with its equals
            sign, tell there.
        bare_point_is_inch: see :func:`.parse_dimension`.
    """
    plain = plain_text(text)
    if _WALLS.search(plain):
        return None, plain
    found = None if field else _LETTER.fullmatch(plain)
    for pattern in _PHRASES:
        found = found or pattern.search(plain)
    value = value_of(found["number"]) if found else 0.0
    if not found or not value:
        return None, plain
    unit = unit_of_number(found["number"], found["unit"], bare_point_is_inch=bare_point_is_inch)
    adjacent = (plain[: found.start()].rstrip(" ,;"), plain[found.end() :].lstrip(" ,;."))
    return Thickness(value, unit), ", ".join(name for name in adjacent if name)
