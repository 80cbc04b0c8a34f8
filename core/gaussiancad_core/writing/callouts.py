"""Notes at features: what they name, how often, how large, how deep (ISO 129-1, ASME Y14.5).

Words for *through*, *deep* and the like are those of English, German, Chinese, French, Italian and
Russian drawings.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum

from gaussiancad_core.writing.numbers import (
    DECIMAL,
    Sign,
    Unit,
    parse_dimension,
    plain_text,
    value_of,
)
from gaussiancad_core.writing.thickness import take_thickness


class NoteKind(Enum):
    """What a note speaks of."""

    LENGTH = "length"
    DIAMETER = "diameter"
    RADIUS = "radius"
    ANGLE = "angle"
    THREAD = "thread"
    COUNTERBORE = "counterbore"
    COUNTERSINK = "countersink"
    CHAMFER = "chamfer"
    DEPTH = "depth"
    THICKNESS = "thickness"
    ALL_CHAMFERS = "all-chamfers"
    ALL_FILLETS = "all-fillets"


@dataclass(frozen=True)
class Callout:
    """What one note says of one feature.

    Attributes:
        kind: of the feature.
        value: diameter, radius, length, size of a chamfer, nominal diameter of a thread; degrees
            of an angle; nothing where the note gives none.
        count: how many features it speaks of.
        depth: that it tells, in the note's unit.
        through: whether it says that the feature goes through.
        angle: degrees, of a countersink or a chamfer.
        reference: whether the number is given for reference only.
        unit: where the note itself tells.
    """

    kind: NoteKind
    value: float | None = None
    count: int = 1
    depth: float | None = None
    through: bool = False
    angle: float | None = None
    reference: bool = False
    unit: Unit | None = None

    def millimetres(self, value: float | None, usual: Unit) -> float | None:
        """A length of the note in mm."""
        return None if value is None else value * (self.unit or usual).millimetres


_N = rf"(?<!\d)({DECIMAL})(?![.,]?\d)"
_COUNT = re.compile(r"^\(?(\d{1,3})\s?[xX*](?=\s|\u00d8|[A-Z]|\d)\s?|(?<=\s)[xX]\s?(\d{1,3})$")
_THROUGH = re.compile(
    r"(?<![A-Za-z])(?:THRU|THROUGH|DURCH(?:GEHEND)?|DEBOUCHANT|PASSANTE?|PASSANT)\b(?:\s+ALL)?"
    r"|\u5b8c\u5168\u8d2f\u7a7f|\u8d2f\u7a7f|\u901a\u5b54|\u0441\u043a\u0432\u043e\u0437\u043d\w*",
    re.IGNORECASE,
)
_DEPTH = re.compile(
    rf"(?:\u21a7|\u6df1|\bDEPTH\b|\bDP\.?|\bTIEF\b)\s?:?\s?{_N}|{_N}\s?(?:\bDEEP\b|\bTIEF\b)",
    re.IGNORECASE,
)
_BORE = re.compile(
    rf"(?:\u2334|\bC'?BORE\b|\bCOUNTERBORE\b|\bSENKUNG\b)\s?\u00d8?\s?{_N}", re.IGNORECASE
)
_SINK = re.compile(
    rf"(?:\u2335|\bCSK\b|\bC'?SINK\b|\bCOUNTERSINK\b)\s?\u00d8?\s?{_N}"
    rf"(?:\s?[xX]\s?{_N}\s?\u00b0)?",
    re.IGNORECASE,
)
_THREAD = re.compile(
    rf"\bM{_N}(?:\s?[xX]\s?{_N})?(?=$|[\s\-,;)]|\u6df1|\u21a7)|(#?\d{{1,2}}|\d/\d{{1,2}})-(\d{{2}})\s?UN[CF]",
)
_CHAMFER = re.compile(rf"{_N}\s?[xX]\s?{_N}\s?\u00b0|(?<![A-Za-z])C\s?{_N}(?![A-Za-z\d])")
_ANGLE = re.compile(rf"^{_N}\s?\u00b0$")
_ALL = re.compile(
    r"\bALL\b|\bUNLESS\b|\bALLE\b|\bUNBEMASSTE?\b|\u672a\u6807|\u672a\u6ce8|\u6240\u6709",
    re.IGNORECASE,
)
_ROUND = re.compile(rf"(?<![A-Za-z])R\s?{_N}(?![A-Za-z])")

_SCREW_INCHES = {"4": 0.112, "6": 0.138, "8": 0.164, "10": 0.19}
"""Nominal diameters of numbered screws in inches (ASME B1.1)."""


def parse_callout(
    text: str, *, field: bool = False, bare_point_is_inch: bool = True
) -> tuple[Callout, ...]:
    """What a line of a note says; nothing where it speaks of no feature.

    Args:
        text: of the note.
        field: whether it stands in a field of the title block.
        bare_point_is_inch: see :func:`.parse_dimension`.
    """
    plain = plain_text(text)
    reference = plain.startswith("(") and plain.endswith(")")
    if reference:
        plain = plain[1:-1].strip()
    found: list[Callout] = []
    while True:
        thick, plain = take_thickness(plain, field=field, bare_point_is_inch=bare_point_is_inch)
        if thick is None:
            break
        found.append(Callout(NoteKind.THICKNESS, thick.value, unit=thick.unit))
    found += _of_all(plain) if _ALL.search(plain) else _of_one(plain, bare_point_is_inch)
    return tuple(replace(callout, reference=reference) for callout in found)


def thread_name(text: str) -> str | None:
    """The thread that a note names, as ``M6``, ``M8x1`` or ``1/4-20 UNC``; None where it names
    none."""
    found = _THREAD.search(plain_text(text))
    if found is None:
        return None
    if found[1] is None:
        return found[0]
    sizes = [size.replace(",", ".") for size in (found[1], found[2]) if size is not None]
    return "M" + "x".join(sizes)


def _of_one(plain: str, bare_point_is_inch: bool) -> tuple[Callout, ...]:
    """Notes about the features that they stand at."""
    count, rest = _counted(plain)
    through = _THROUGH.search(rest) is not None
    rest = _THROUGH.sub(" ", rest).strip()
    found = _feature(rest, bare_point_is_inch)
    return tuple(_completed(callout, count, through) for callout in found)


def _completed(callout: Callout, count: int, through: bool) -> Callout:
    """The same with what a note says of all that it names; what goes through is a hole."""
    kind = NoteKind.DIAMETER if through and callout.kind is NoteKind.LENGTH else callout.kind
    goes = through and kind in (NoteKind.DIAMETER, NoteKind.THREAD)
    return replace(callout, kind=kind, count=count, through=goes)


def _of_all(plain: str) -> tuple[Callout, ...]:
    """Notes about all edges that have none of their own."""
    found = []
    chamfer, rounding = _CHAMFER.search(plain), _ROUND.search(plain)
    if chamfer:
        found.append(Callout(NoteKind.ALL_CHAMFERS, value_of(chamfer[3] or chamfer[1])))
    if rounding:
        found.append(Callout(NoteKind.ALL_FILLETS, value_of(rounding[1])))
    return tuple(found)


def _counted(plain: str) -> tuple[int, str]:
    found = _COUNT.search(plain)
    if found is None:
        return 1, plain
    rest = (plain[: found.start()] + " " + plain[found.end() :]).strip()
    return int(found[1] or found[2]), rest


def _feature(rest: str, bare_point_is_inch: bool) -> tuple[Callout, ...]:
    depth, rest = _taken(_DEPTH, rest)
    deep = value_of(depth[1] or depth[2]) if depth else None
    found: list[Callout] = []
    for pattern, kind in ((_BORE, NoteKind.COUNTERBORE), (_SINK, NoteKind.COUNTERSINK)):
        match, rest = _taken(pattern, rest)
        if match:
            angle = value_of(match[2]) if kind is NoteKind.COUNTERSINK and match[2] else None
            found.append(Callout(kind, value_of(match[1]), depth=deep, angle=angle))
    if found and not rest:
        return tuple(found)
    first = _plain_feature(rest, bare_point_is_inch)
    if first is None:
        if deep is not None and not found and not rest:
            return (Callout(NoteKind.DEPTH, deep),)
        return tuple(found)
    if deep is not None and not found:
        first = replace(first, depth=deep)
    return (first, *found)


def _plain_feature(rest: str, bare_point_is_inch: bool) -> Callout | None:
    for pattern, made in _FEATURES:
        found = pattern.search(rest)
        if found:
            return made(found)
    said = parse_dimension(rest, bare_point_is_inch=bare_point_is_inch)
    if said is None:
        return None
    kinds = {Sign.DIAMETER: NoteKind.DIAMETER, Sign.RADIUS: NoteKind.RADIUS}
    return Callout(kinds.get(said.sign, NoteKind.LENGTH), said.value, unit=said.unit)


def _thread(found: re.Match[str]) -> Callout | None:
    if found[1]:
        return Callout(NoteKind.THREAD, value_of(found[1]), unit=Unit.MILLIMETRE)
    size = _screw(found[3])
    return None if size is None else Callout(NoteKind.THREAD, size, unit=Unit.INCH)


def _chamfer(found: re.Match[str]) -> Callout:
    if found[3]:
        return Callout(NoteKind.CHAMFER, value_of(found[3]), angle=45.0)
    return Callout(NoteKind.CHAMFER, value_of(found[1]), angle=value_of(found[2]))


_FEATURES: tuple[tuple[re.Pattern[str], Callable[[re.Match[str]], Callout | None]], ...] = (
    (_THREAD, _thread),
    (_ANGLE, lambda found: Callout(NoteKind.ANGLE, value_of(found[1]))),
    (_CHAMFER, _chamfer),
)


def _screw(name: str) -> float | None:
    """Inches of a screw's nominal diameter, by its number or fraction."""
    if "/" in name:
        over, under = name.split("/")
        return int(over) / int(under) if int(under) else None
    return _SCREW_INCHES.get(name.lstrip("#"))


def _taken(pattern: re.Pattern[str], text: str) -> tuple[re.Match[str] | None, str]:
    """The first place where a pattern matches, and the text without it."""
    found = pattern.search(text)
    if found is None:
        return None, text
    return found, " ".join((text[: found.start()] + " " + text[found.end() :]).split())
