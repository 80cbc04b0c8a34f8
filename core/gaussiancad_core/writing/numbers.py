"""What the texts of a drawing say in numbers: lengths, scales, units (ISO 129-1, ASME Y14.5)."""

import re
import unicodedata
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction

from gaussiancad_core.model.length_units import MM_PER_INCH


class Unit(Enum):
    """Of lengths on a drawing."""

    MILLIMETRE = "mm"
    INCH = "in"

    @property
    def millimetres(self) -> float:
        """Length of one."""
        return MM_PER_INCH if self is Unit.INCH else 1.0


class Sign(Enum):
    """What a dimension says its length is."""

    LENGTH = ""
    DIAMETER = "diameter"
    RADIUS = "radius"


@dataclass(frozen=True)
class DimensionText:
    """A length that a text gives.

    Attributes:
        value: in its unit, without tolerance.
        sign: what of.
        unit: nothing where the text itself does not tell.
    """

    value: float
    sign: Sign = Sign.LENGTH
    unit: Unit | None = None

    def millimetres(self, usual: Unit) -> float:
        """The length in mm, where the sheet's own unit is ``usual``."""
        return self.value * (self.unit or usual).millimetres

    def digit(self, usual: Unit) -> float:
        """The last decimal that its value has, zeros apart, in mm."""
        decimals = f"{self.value:.6f}".rstrip("0").partition(".")[2]
        return 10.0 ** -len(decimals) * (self.unit or usual).millimetres


_ALIKE = str.maketrans(
    {
        "\u2300": "\u00d8",  # diameter sign
        "\u00f8": "\u00d8",
        "\u03a6": "\u00d8",
        "\u03c6": "\u00d8",
        "\u2205": "\u00d8",
        "\u00d7": "x",
        "X": "x",
        "\u2212": "-",
        "\u2013": "-",
        "\u201c": '"',
        "\u201d": '"',
        "\u2033": '"',
        "\u2044": "/",
        "\u2236": ":",
        "\uff1a": ":",
        "\uff0c": ",",
        "\uff1d": "=",
        "\u2715": "x",
        "\u00ba": "\u00b0",
        "\u00bc": " 1/4",
        "\u00bd": " 1/2",
        "\u00be": " 3/4",
    }
)
"""Characters that mean the same on a drawing."""

_DENOMINATORS = (2, 4, 8, 16, 32, 64)
"""Of an inch."""

_SIGNS = {
    "\u00d8": Sign.DIAMETER,
    "O": Sign.DIAMETER,
    "0": Sign.DIAMETER,
    "DIA": Sign.DIAMETER,
    "R": Sign.RADIUS,
}

_DIGITS = r"\d{1,15}"
"""More on end are no measure, and no number that a computer has exactly."""

DECIMAL = rf"(?:{_DIGITS}(?:[.,]{_DIGITS})?|[.,]{_DIGITS})"
"""Pattern of a decimal number."""

NUMBER = rf"(?:(?:{_DIGITS}[ -])?{_DIGITS}/{_DIGITS}|{DECIMAL})"
"""Pattern of a decimal number, or of one with a fraction."""

UNIT = r"(?:\"|''|(?i:mm\b|in(?:ch(?:es)?)?\b\.?|\u043c\u043c\b)|\u6beb\u7c73)"
"""Pattern of what a number is followed by that is a length."""

_METRIC = ("mm", "\u043c\u043c", "\u6beb\u7c73")

_DIMENSION = re.compile(
    rf"""
    (?:\d{{1,3}}\ ?x\ ?|\d{{1,3}}-(?=[\u00d8R]))?     # how often
    (?:S?(?P<sign>[\u00d8R]|DIA|[O0](?=\d))\ ?)?      # a sphere's, too; misread without its slash
    (?P<number>{NUMBER})\ ?
    (?P<unit>{UNIT})?
    (?P<after>\ ?DIA)?
    (?:
        \ ?\u00b1\ ?{NUMBER}"?                       # one tolerance both ways
      | \ ?[+-]\ ?{NUMBER}\ ?/?\ ?[+-]?\ ?{NUMBER}  # one each way
      | \ ?[A-Za-z]{{1,2}}\d{{1,2}}(?:/[a-z]{{1,2}}\d{{1,2}})?  # a fit
    )?
    (?:\ ?(?:THRU|TYP|REF)\.?)*
    (?:\ ?\[[^]]*\])?                                 # the same in another unit
    """,
    re.VERBOSE,
)

SCALE_WORD = (
    r"(?:SCALE|MA(?:SS|\u00df|\u1e9e)STAB|[E\u00c9]CHELLE|SCALA|ESCALA|SKALA|SCHAAL|M|\u041c"
    r"|\u041c\u0410\u0421\u0428\u0422(?:\u0410\u0411|\.)|\u041c\u0410\u0429\u0410\u0411"
    r"|M\u011a\u0158\u00cdTKO|MIERKA|PODZIA\u0141KA|MJERILO|MERILO|\u00d6L\u00c7EK|MITTAKAAVA"
    r"|M\u00c9RETAR\u00c1NY|SCAR\u0102|\u039a\u039b\u0399\u039c\u0391\u039a\u0391"
    r"|\u5c3a\u5ea6|\u6bd4\u4f8b(?:\u5c3a)?|\u7e2e\u5c3a|\u7f29\u5c3a|\u30b9\u30b1\u30fc\u30eb"
    r"|\ucc99\ub3c4|\ucd95\ucc99|T[\u1ef6\u1ec8] L\u1ec6)"
)
"""What stands before a ratio in the languages of those who draw, in any case."""

_SIDE = r"\d{1,9}(?:[.,]\d+)?"

_SCALE = re.compile(
    rf"(?P<word>{SCALE_WORD}\.?\ ?[:=]?\ ?)?"
    rf"\(?(?P<sheet>{_SIDE})(?P<mark>\ ?[:/]\ ?)(?P<part>{_SIDE})\)?",
    re.IGNORECASE,
)

_FULL_SCALE = re.compile(rf"{SCALE_WORD}\ ?[:=]?\ ?FULL|FULL\ (?:SCALE|SIZE)", re.IGNORECASE)

_LARGEST_RATIO = 5000.0

_MILLIMETRES = re.compile(r"\bMM(?:GS)?\b|\bMILLIMET(?:ER|RE)S?\b|\u6beb\u7c73|\u043c\u043c")
_INCHES = re.compile(r"\bINCH(?:ES)?\b|\bIPS\b|\bZOLL\b")
"""Words for units, and the systems of units of CAD programs that have them."""


def parse_dimension(text: str, *, bare_point_is_inch: bool = True) -> DimensionText | None:
    """The length that a text gives; nothing for threads, angles, scales and words.

    Args:
        text: of the dimension.
        bare_point_is_inch: whether a number that begins with its point is one of inches, as ASME
            Y14.5 has it; where the file says its unit that counts, and the zero was only left out.
    """
    plain = plain_text(text)
    if plain.startswith("(") and plain.endswith(")"):
        # Given for reference only, but as true as the others.
        plain = plain[1:-1].strip()
    found = _DIMENSION.fullmatch(plain)
    if found is None:
        return None
    value = value_of(found["number"])
    if not value:
        return None
    sign = _SIGNS.get(found["sign"] or ("DIA" if found["after"] else ""), Sign.LENGTH)
    unit = unit_of_number(found["number"], found["unit"], bare_point_is_inch=bare_point_is_inch)
    return DimensionText(value, sign, unit)


def plain_text(text: str) -> str:
    """A text in one line, with one character for all that mean the same on a drawing."""
    return " ".join(unicodedata.normalize("NFC", text).translate(_ALIKE).split())


def value_of(number: str) -> float:
    """What a match of :data:`NUMBER` or :data:`DECIMAL` is worth; 0 of fractions that no rule
    has."""
    if "/" not in number:
        return float(number.replace(",", "."))
    *whole, part = re.split("[ -]", number)
    over, under = (int(side) for side in part.split("/"))
    if under not in _DENOMINATORS or not 0 < over < under:
        return 0.0
    return float(sum(int(inches) for inches in whole) + Fraction(over, under))


def unit_of_number(number: str, mark: str | None, *, bare_point_is_inch: bool) -> Unit | None:
    """The unit of a number, where it tells.

    Args:
        number: a match of :data:`NUMBER`.
        mark: of :data:`UNIT`, if any follows.
        bare_point_is_inch: see :func:`parse_dimension`.
    """
    if mark:
        return Unit.MILLIMETRE if mark.lower() in _METRIC else Unit.INCH
    # Millimetres have a zero before the point, inches have none (ASME Y14.5).
    bare_point = bare_point_is_inch and number.startswith(".")
    return Unit.INCH if "/" in number or bare_point else None


def parse_scale(text: str) -> float | None:
    """Length on the sheet over length on the part, where a text is a scale note.

    Alone, a ratio has a one (ISO 5455) or is set apart from its colon, as programs write it: 12:30
    is a time.
    """
    plain = unicodedata.normalize("NFKC", plain_text(text))
    if _FULL_SCALE.fullmatch(plain):
        return 1.0
    found = _SCALE.fullmatch(plain)
    if found is None or ("/" in found["mark"] and not found["word"]):
        return None
    sheet, part = (float(found[side].replace(",", ".")) for side in ("sheet", "part"))
    surely = found["word"] or found["mark"] == " : " or 1.0 in (sheet, part)
    if min(sheet, part) <= 0.0 or not surely:
        return None
    ratio = sheet / part
    return ratio if 1.0 / _LARGEST_RATIO <= ratio <= _LARGEST_RATIO else None


def parse_unit(text: str, field: bool = False) -> Unit | None:
    """The unit that a note names, such as ``DIMENSIONS IN MM`` or ``UNIT SYSTEM: MMGS``.

    Args:
        text: of the note.
        field: whether it stands in a field of the title block, where IN alone is a unit; elsewhere
            it is a word.
    """
    plain = " ".join(text.upper().split())
    millimetres = _MILLIMETRES.search(plain) is not None
    inches = _INCHES.search(plain) is not None or (field and plain in ("IN", "IN."))
    if millimetres == inches:
        return None
    return Unit.MILLIMETRE if millimetres else Unit.INCH
