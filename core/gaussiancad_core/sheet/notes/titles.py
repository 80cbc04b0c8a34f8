"""Titles of views: sections, views along an arrow and details by their letters (ISO 128-3)."""

import re
from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.sheet.scale.numbers import parse_scale


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
        label: the letter, or letters.
        scale: length on the sheet over length on the part, where it tells.
    """

    kind: TitleKind
    label: str
    scale: float | None = None


_L = r"([A-Z]{1,2})"
_SIDE = r"\d+(?:[.,]\d+)?"
_RATIO = rf"(?:\(?\s*(?:SCALE|MASSSTAB|M|\u6bd4\u4f8b)?\s*:?\s*({_SIDE}\s?:\s?{_SIDE})\s*\)?)?"
_SECTION = re.compile(
    rf"^(?:SECTION|SCHNITT|SEC\.?|COUPE|SEZIONE|\u5256\u9762|\u5256\u89c6)?\s*{_L}\s?-\s?\1\s*{_RATIO}$"
)
_VIEW = re.compile(rf"^(?:VIEW|ANSICHT|VUE|VISTA|\u89c6\u56fe)\s+{_L}\s*{_RATIO}$")
_DETAIL = re.compile(
    rf"^(?:(?:DETAIL|EINZELHEIT|\u5c40\u90e8\u653e\u5927\u56fe)\s+{_L}\s*{_RATIO}"
    r"|([A-Z])\s*\(\s*(\d+(?:[.,]\d+)?\s?:\s?\d+(?:[.,]\d+)?)\s*\))$"
)
_DASHES = str.maketrans("\u2013\u2014\u2212\uff1a", "---:")


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
    return parse_scale(ratio.replace(" ", "")) if ratio else None
