"""Titles of views: sections, views along an arrow and details by their letters (ISO 128-3)."""

import re
from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.writing.numbers import SCALE_WORD, parse_scale


class TitleKind(Enum):
    """What a title names."""

    SECTION = "section"
    VIEW = "view"
    DETAIL = "detail"


@dataclass(frozen=True)
class Title:
    """A title.

    Attributes:
        kind: what it names.
        label: the letter, or letters, of any script.
        scale: length on the sheet over length on the part, where it tells.
    """

    kind: TitleKind
    label: str
    scale: float | None = None


_L = r"([^\W\d_]{1,2})"
_SIDE = r"\d+(?:[.,]\d+)?"
_RATIO = rf"(?:\(?\s*(?:{SCALE_WORD})?\s*:?\s*({_SIDE}\s?:\s?{_SIDE})\s*\)?)?"
_SECTIONS = (
    r"SECTION|SCHNITT|SEC\.?|COUPE|SEZIONE|SECCI[O\u00d3]N|CORTE|\u5256\u9762|\u5256\u89c6|\u65ad\u9762"
    r"|\u65ad\u9762\u56f3|\u0420\u0410\u0417\u0420\u0415\u0417|\u0421\u0415\u0427\u0415\u041d\u0418\u0415"
)
_SECTION = re.compile(rf"^(?:{_SECTIONS})?\s*{_L}\s?-\s?\1\s*{_RATIO}$")
_VIEW = re.compile(
    rf"^(?:VIEW|ANSICHT|VUE|VISTA|\u89c6\u56fe|\u0412\u0418\u0414)\s+{_L}\s*{_RATIO}$"
)
_DETAIL = re.compile(
    rf"^(?:(?:DETAIL|EINZELHEIT|\u5c40\u90e8\u653e\u5927\u56fe)\s+{_L}\s*{_RATIO}"
    r"|([^\W\d_])\s*\(\s*(\d+(?:[.,]\d+)?\s?:\s?\d+(?:[.,]\d+)?)\s*\))$"
)
_DASHES = str.maketrans("\u2010\u2011\u2013\u2014\u2212\uff1a", "-----:")

_ALIKE = str.maketrans(
    "\u0410\u0412\u0415\u041a\u041c\u041d\u041e\u0420\u0421\u0422\u0423\u0425"
    "\u0391\u0392\u0395\u0396\u0397\u0399\u039a\u039c\u039d\u039f\u03a1\u03a4\u03a5\u03a7",
    "ABEKMHOPCTYXABEZHIKMNOPTYX",
)
"""Letters of other scripts that look like Latin ones: Cyrillic, then Greek."""


def looks_of(label: str) -> str:
    """A label as Latin letters where its own look like these.

    Two labels of one look are two on a sheet that has both, and one where a letter was typed or
    read in the wrong script.
    """
    return label.translate(_ALIKE)


def parse_title(text: str) -> Title | None:
    """The title that a text is; nothing where it is none."""
    plain = " ".join(text.translate(_DASHES).upper().split())
    for pattern, kind in ((_SECTION, TitleKind.SECTION), (_VIEW, TitleKind.VIEW)):
        found = pattern.match(plain)
        if found:
            return Title(kind, found[1], _scale(found[2]))
    found = _DETAIL.match(plain)
    if found:
        return Title(TitleKind.DETAIL, found[1] or found[3], _scale(found[2] or found[4]))
    return None


def _scale(ratio: str | None) -> float | None:
    return parse_scale(" : ".join(ratio.replace(" ", "").split(":"))) if ratio else None
