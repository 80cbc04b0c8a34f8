"""Words of call-outs as the signs of ISO 129-1: through, deep, wider, how often.

Words are those of English, German, French, Italian, Spanish, Russian and Chinese drawings.  A text
in signs has a grammar that no language changes.
"""

import re
from collections.abc import Iterable

from gaussiancad_core.writing.numbers import DECIMAL, UNIT

DEPTH = "\u21a7"
"""Sign before a depth."""

THROUGH = "\u21a7\u221e"
"""What stands for *through* in a text in signs."""

BORE, SINK = "\u2334", "\u2335"
"""Signs of counterbores (spot faces, too) and of countersinks."""

NUMBER = rf"(?<![\d/])(?:{DECIMAL})(?![.,/]?\d)"
"""Pattern of a whole decimal number."""

_LETTER = r"[^\W\d_]"


def _any(words: Iterable[str], han: str) -> str:
    """A pattern of words that stand alone, with or without a point, or of Chinese ones."""
    return rf"(?:(?<!{_LETTER})(?:{'|'.join(words)})(?!{_LETTER})\.?|{han})"


_THROUGH_WORDS = _any(
    (
        r"THRU(?:\s?-?\s?ALL)?",
        r"THROUGH(?:\s?-?\s?ALL)?",
        r"DURCH(?:GEHENDE?|GANG|GANGS(?:BOHRUNG|LOCH))?",
        r"D[\u00c9E]BOUCHANTE?S?",
        r"TRAVERSANTE?S?",
        r"PASS?ANT[EI]?S?",
        r"\u0441\u043a\u0432\u043e\u0437\u043d\w*",
        r"\u043d\u0430\u0441\u043a\u0432\u043e\u0437\u044c",
    ),
    r"\u5b8c\u5168\u8d2f\u7a7f|\u8d2f\u7a7f|\u8d2f\u901a|\u901a\u5b54",
)

_DEEP_WORDS = _any(
    (
        r"DP",
        r"DEEP",
        r"DEPTH",
        r"TIEFE?",
        r"PROF(?:ONDEUR|ONDIT[\u00c0A]|UNDIDAD|ONDO|UNDO)?",
        r"\u0433\u043b(?:\u0443\u0431(?:\u0438\u043d\w*)?)?",
    ),
    r"\u21a7|\u6df1\u5ea6?",
)

_BORE_WORDS = _any(
    (
        r"C\s?['\u2019./-]?\s?BORED?",
        r"COUNTER\s?-?\s?BORED?",
        r"S\s?['\u2019]?\s?FACED?",
        r"SPOT\s?-?\s?FACED?",
        r"S\.?\s?F",
        r"(?:ZYL(?:INDER|\.)?\s?|FLACH|PLAN|STIRN)?SENKUNG",
        r"LAMAGES?",
        r"LAM\u00c9",
        r"LAMATUR[AE]",
        r"LAMATO",
        r"ABOCARDADO",
        r"REFRENTADO",
        r"\u0446\u0435\u043a\w*",
    ),
    r"\u2334|\u6c89\u5b54|\u9525\u5e73|\u9504\u5e73|\u67f1\u5f62\u6c89\u5934\u5b54",
)

_SINK_WORDS = _any(
    (
        r"CSK",
        r"C\s?['\u2019./-]?\s?SINK",
        r"COUNTER\s?-?\s?(?:SINK|SUNK)",
        r"KEGELSENKUNG",
        r"FRAISURES?",
        r"FRAIS\u00c9",
        r"SVASATUR[AE]",
        r"SVASATO",
        r"AVELLANADO",
        r"\u0437\u0435\u043d\u043a\w*",
    ),
    r"\u2335|\u57cb\u5934\u5b54|\u9525\u5f62\u6c89(?:\u5934)?\u5b54",
)

_MAKING = _any(
    (
        r"DRILL(?:ED)?",
        r"REAM(?:ED)?",
        r"TAP(?:PED)?",
        r"HOLES?",
        r"BOHRUNG(?:EN)?",
        r"GEWINDE",
        r"TROUS?",
        r"TARAUD(?:AGE|\u00c9)",
        r"FOR[OI]",
        r"AGUJEROS?",
        r"TALADROS?",
        r"\u043e\u0442\u0432(?:\u0435\u0440\u0441\u0442\w*)?",
    ),
    r"\u94bb\u5b54?",
)
"""How a hole is made, which says nothing of its shape."""

_TYPICAL = _any((r"TYP(?:ICAL|ISCH|IQUE)?", r"\u0442\u0438\u043f"), r"\u5178\u578b")

_TIMES = _any(
    (
        r"PL(?:ACE|C)?S?",
        r"HOLES?",
        r"OFF",
        r"STELLEN?",
        r"BOHRUNG(?:EN)?",
        r"L\u00d6CHER",
        r"TROUS?",
        r"FOIS",
        r"ENDROITS?",
        r"FOR[OI]",
        r"POSIZION[EI]",
        r"VOLTE",
        r"AGUJEROS?",
        r"TALADROS?",
        r"LUGARES",
        r"VECES",
        r"\u043e\u0442\u0432(?:\u0435\u0440\u0441\u0442\w*)?",
        r"\u043c\u0435\u0441\u0442\u0430?",
    ),
    r"\u5904|\u4e2a\u5b54|\u4e2a|\u5b54",
)

_LENGTH = rf"({NUMBER})(?:\s?{UNIT})?"
_SIGNS = tuple(
    (re.compile(pattern, re.IGNORECASE), sign)
    for pattern, sign in (
        (_THROUGH_WORDS, f" {THROUGH} "),
        # A number behind the word is its own, before one that is in front of it.
        (
            rf"(?:(?<!{_LETTER})x\s?)?(?<![\u00d8MR])(?<!\u00d8\s){_LENGTH}\s?{_DEEP_WORDS}"
            rf"(?!\s?[:=]?\s?[\d\u221e])",
            rf" {DEPTH}\1 ",
        ),
        (rf"(?:(?<!{_LETTER})x\s?)?{_DEEP_WORDS}\s?[:=]?\s?{_LENGTH}", rf" {DEPTH}\1 "),
        (_SINK_WORDS, f" {SINK} "),
        (_BORE_WORDS, f" {BORE} "),
    )
)

_COUNTS = tuple(
    re.compile(pattern, re.IGNORECASE)
    for pattern in (
        rf"^\(?(\d{{1,3}})\s?[x*]\)?(?=[\s\u00d8\u2334\u2335\d]|{_LETTER})",
        r"^(\d{1,3})-(?=(?:\u00d8|R|M)\s?\d)",
        rf"(?<![\w.,/-])(?<!\u00d8\s)\(?(\d{{1,3}})\s?{_TIMES}\)?",
    )
)
"""Where how often stands: before all, or as a number of places or holes."""

_COUNT_BEHIND = re.compile(r"(?<=\s)x\s?(\d{1,3})$", re.IGNORECASE)

_IDLE = re.compile(rf"\(?(?:{_MAKING}|{_TYPICAL})\)?", re.IGNORECASE)
_TYPICALLY = re.compile(_TYPICAL, re.IGNORECASE)


def in_signs(text: str) -> tuple[int, str]:
    """How many features a call-out speaks of, and the rest of it with signs for words.

    Words that say nothing of a feature's shape are left out, depths stand behind their sign, and
    *through* is :data:`THROUGH`.

    Args:
        text: plain, see :func:`.plain_text`.

    Returns:
        The count, 1 where it says none, and the text.
    """
    count, text = _take_count(text, _COUNTS)
    for pattern, sign in _SIGNS:
        text = pattern.sub(sign, text)
    if count is None and BORE not in text and SINK not in text:
        count, text = _take_count(text.strip(), (_COUNT_BEHIND,))
    return 1 if count is None else count, " ".join(_IDLE.sub(" ", text).split())


def is_typical(text: str) -> bool:
    """Whether a call-out says that it speaks of all features of its kind."""
    return _TYPICALLY.search(text) is not None


def _take_count(text: str, patterns: Iterable[re.Pattern[str]]) -> tuple[int | None, str]:
    for pattern in patterns:
        found = pattern.search(text)
        if found is not None:
            return int(found[1]), f"{text[: found.start()]} {text[found.end() :]}".strip()
    return None, text
