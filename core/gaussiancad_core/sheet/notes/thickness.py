"""Notes of how thick a plate is, in the words and letters of several countries.

*t* is the letter of ISO 129-1, *s* that of GOST 2.307, for flat parts in one view; words stand
before the number or behind it, in a longer note, too.
"""

import re
import unicodedata
from dataclasses import dataclass
from fractions import Fraction

from gaussiancad_core.sheet.scale.numbers import Unit

_ALIKE = str.maketrans(
    {
        "\u201c": '"',
        "\u201d": '"',
        "\u2033": '"',
        "\uff1a": ":",
        "\uff1d": "=",
        "\u00bc": " 1/4",
        "\u00bd": " 1/2",
        "\u00be": " 3/4",
    }
)
"""Characters that mean the same in a note."""

_NUMBER = r"(?P<number>(?:\d+[ -])?\d+/\d+|\d+[.,]\d+|[.,]\d+|\d+)(?![\d.,]*\d)"

_UNIT = r"""(?P<unit>"|''|mm\b|in(?:ch(?:es)?)?\b\.?|\u043c\u043c\b|\u6beb\u7c73)?"""

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

_LETTER = re.compile(rf"[ts]\s?[=:]?\s?{_NUMBER}\s?{_UNIT}(?:\s?\u00b1.*)?", re.IGNORECASE)
_EQUAL = re.compile(rf"(?<!\w)[ts]\s?=\s?{_NUMBER}\s?{_UNIT}", re.IGNORECASE)
_WORD = re.compile(
    rf"(?<!\w)(?:{'|'.join(_BEFORE)})\b\.?\s?[=:]?\s?{_NUMBER}\s?{_UNIT}", re.IGNORECASE
)
_HAN_WORD = re.compile(rf"{_HAN}\s?[=:]?\s?{_NUMBER}\s?{_UNIT}", re.IGNORECASE)
_WORD_BEHIND = re.compile(
    rf"(?<![\w.,/])(?<!\d:){_NUMBER}\s?-?{_UNIT}\s?-?(?:(?:{'|'.join(_BEHIND)})(?!\w)|\u539a)",
    re.IGNORECASE,
)

_OTHER = re.compile(
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


def parse_thickness(text: str) -> Thickness | None:
    """The thickness of a plate that a note tells; nothing where it tells none."""
    plain = " ".join(unicodedata.normalize("NFC", text).translate(_ALIKE).split())
    if _OTHER.search(plain):
        return None
    found = _LETTER.fullmatch(plain)
    for pattern in (_EQUAL, _WORD, _HAN_WORD, _WORD_BEHIND):
        found = found or pattern.search(plain)
    if found is None:
        return None
    value = _value(found["number"])
    return Thickness(value, _unit(found["unit"])) if value else None


def _value(number: str) -> float:
    """A number, 0 of a fraction that has none."""
    if "/" not in number:
        return float(number.replace(",", "."))
    *whole, part = re.split("[ -]", number)
    over, under = (int(side) for side in part.split("/"))
    return float(sum(int(own) for own in whole) + Fraction(over, under)) if under else 0.0


def _unit(mark: str | None) -> Unit | None:
    if mark is None:
        return None
    metric = mark.lower() in ("mm", "\u043c\u043c", "\u6beb\u7c73")
    return Unit.MILLIMETRE if metric else Unit.INCH
