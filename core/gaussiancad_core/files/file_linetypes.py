"""What the names of linetypes and layers, and dash patterns, say about a stroke (ISO 128-2).

Names are those that CAD systems write: AutoCAD's ``acad.lin`` and ``acadiso.lin``, ISO's and JIS'
numbered ones, and the words for hidden and centre lines in the languages that layers are named in.
"""

import re
from functools import lru_cache

from gaussiancad_core.files.vectors import StrokeRole

_WORDS: tuple[tuple[StrokeRole, tuple[str, ...]], ...] = (
    # Double-dotted lines first: their names contain those of the dotted ones.
    (
        StrokeRole.OTHER,
        ("phantom", "divide", "border", r"iso0[56]w", r"iso1[2-5]w", "zweipunkt", "双点", "二点鎖"),
    ),
    (
        StrokeRole.CENTRE,
        (
            "cent(?:er|re|ro)",
            "dash[ _-]?dot",
            "chain",
            "symmet",
            r"iso0[48]w",
            r"iso1[01]w",
            "jis_08",
            "mittel?",
            "strich[ _-]?punkt",
            "mezzeria",
            r"(?:^|\W|_)(?:axis|axes?|achsen?|assi?|ejes?)(?:$|\W|_)",
            "осев",
            "штрих-?пункт",
            "中心",
            "点划",
            "点画",
            "一点鎖",
        ),
    ),
    (
        StrokeRole.HATCH,
        ("hatch", "schraff", "hachur", "rayado", "achurad", "штриховк", "剖面线", "ハッチ"),
    ),
    (
        StrokeRole.HIDDEN,
        (
            "hidden",
            "dash",
            r"iso0[23]w",
            "jis_02",
            "verdeckt",
            "unsichtbar",
            "invisib",
            "strichl",
            "gestrichelt",
            "cach[eé]",
            "interromp",
            "ocult",
            "trazos",
            "nascost",
            "tratteggi",
            "ukryt",
            "niewidoczn",
            "скрыт",
            "невидим",
            "штрих",
            "虚线",
            "隐藏",
            "かくれ",
            "隠れ",
            "破線",
        ),
    ),
    (
        StrokeRole.OTHER,
        (
            r"(?:^|\W|_)dim",
            "text",
            "note",
            "title",
            "frame",
            "bema(?:ß|ss)",
            "cota",
            "quot",
            "标注",
            "尺寸",
            "剖面",
            "文字",
            "図枠",
        ),
    ),
    (
        StrokeRole.VISIBLE,
        ("visible", "outline", "contour", "kontur", "sichtbar", "轮廓", "粗实", "外形"),
    ),
)
"""In this order: the first that is found in a name counts."""

_PATTERNS = tuple((role, re.compile("|".join(words))) for role, words in _WORDS)

_SHORT = 0.6
"""A dash under this share of the longest in a pattern is a short one, or a dot."""


@lru_cache(maxsize=1024)
def role_by_name(name: str) -> StrokeRole | None:
    """What a linetype's or a layer's name says; None if nothing."""
    folded = name.casefold()
    return next((role for role, words in _PATTERNS if words.search(folded)), None)


def role_by_dashes(dashes: tuple[float, ...]) -> StrokeRole:
    """What a dash pattern says: even dashes are hidden, long-short is centre, long-short-short
    phantom.

    Args:
        dashes: lengths of dash and gap in turn, in any unit; empty for a solid line.
    """
    inked = dashes[::2]
    if not inked:
        return StrokeRole.UNKNOWN
    longest = max(inked)
    if longest <= 0.0:
        return StrokeRole.OTHER
    short = [length < _SHORT * longest for length in inked]
    # Which dash comes first does not matter, nor how often the pattern is repeated.
    runs = len(short) / max(len(short) - sum(short), 1)
    if not any(short):
        return StrokeRole.HIDDEN
    return StrokeRole.CENTRE if runs <= 2.0 else StrokeRole.OTHER


def stroke_role(linetype: str, layer: str, dashes: tuple[float, ...]) -> StrokeRole:
    """What a stroke of a named linetype on a named layer stands for.

    A dashed line is what its linetype is called, or else what its dashes look like.  A solid line
    is what its layer is called, or else a visible edge.
    """
    if dashes:
        named = role_by_name(linetype)
        if named in (None, StrokeRole.VISIBLE):
            return role_by_dashes(dashes)
        return named
    return role_by_name(layer) or StrokeRole.VISIBLE
