"""Notes at features: what they name, how often, how large, how deep (ISO 129-1, ASME Y14.5).

Words are read as signs (:mod:`.callout_words`); what is read here is the grammar of signs.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum

from gaussiancad_core.writing.callout_words import BORE, DEPTH, NUMBER, SINK, in_signs
from gaussiancad_core.writing.numbers import (
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


_N = rf"({NUMBER})"
_THREAD = re.compile(
    rf"\bM{_N}(?:\s?[xX]\s?{_N})?(?=$|[\s\-,;)\u21a7])"
    rf"|(#?\d{{1,2}}|\d/\d{{1,2}})-(\d{{2}})\s?UN[CF]"
)
_CHAMFER = re.compile(rf"{_N}\s?[xX]\s?{_N}\s?\u00b0|(?<![A-Za-z])C\s?{_N}(?![A-Za-z\d])")
_ANGLE = re.compile(rf"^{_N}\s?\u00b0$")
_DEPTH = re.compile(rf"{DEPTH}(\u221e|{NUMBER})")
_WIDER = re.compile(rf"([{BORE}{SINK}])")
_WIDE_ANGLE = re.compile(rf"(?:x\s?)?{_N}\s?\u00b0", re.IGNORECASE)
_WIDE = re.compile(rf"(?:(?:\u00d8|DIA)\s?)?(?<![A-Za-z]){_N}", re.IGNORECASE)
_SECOND = re.compile(rf"x\s?{_N}", re.IGNORECASE)
_BEHIND = re.compile(
    rf"(?:\u00d8\s?|(?<![\w\u00d8])(?<!\u00d8\s)){_N}(?:\s?x?\s?{_N}\s?\u00b0)?$"
    rf"|(?<!\w){_N}\s?\u00b0$",
    re.IGNORECASE,
)
"""What may stand in front of the word for a wider hole: its diameter, its angle."""

_SINK_ANGLES = 60.0, 120.0
"""Degrees that countersinks have, from and to (ISO 15065, ASME B18.3)."""

_ALL = re.compile(
    r"\bALL\b|\bUNLESS\b|\bALLE\b|\bUNBEMASSTE?\b|\u672a\u6807|\u672a\u6ce8|\u6240\u6709",
    re.IGNORECASE,
)
_ROUND = re.compile(rf"(?<![A-Za-z])R\s?{_N}(?![A-Za-z])")

_PARTING = " ,;/-()"
"""Characters that part the features of one call-out."""

_FIRST_DIAMETER = re.compile(rf"\u00d8\s?{_N}(?=\s)")
"""A diameter before words of which nothing is known: a hole if it has a depth."""

_OPEN = re.compile(r"\s?[xX]$")
"""A sign of multiplication before a depth."""

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
    count, signs = in_signs(plain)
    if _ALL.search(signs):
        found += _of_all(plain)
    else:
        found += [replace(each, count=count) for each in _of_one(signs, bare_point_is_inch)]
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


def _of_one(signs: str, bare_point_is_inch: bool) -> list[Callout]:
    """Notes about the features that they stand at: a hole, and where it is wider."""
    head, *rest = _WIDER.split(signs)
    wider = []
    for sign, behind in zip(rest[::2], rest[1::2], strict=True):
        front = ""
        if not _WIDE.search(_WIDE_ANGLE.sub(" ", _DEPTH.sub(" ", behind))) or _is_angle(head):
            head, front = _split_behind(head)
        wider.append((sign, f"{front} {behind}"))
    callouts = _plain_features(head, bare_point_is_inch)
    return [*callouts, *filter(None, (_wider(sign, body) for sign, body in wider))]


def _is_angle(head: str) -> bool:
    return head.rstrip().endswith("\u00b0")


def _split_behind(head: str) -> tuple[str, str]:
    """What stands before a word for a wider hole, parted in front of what is said of that hole."""
    found = _BEHIND.search(head.rstrip())
    return (head, "") if found is None else (head[: found.start()], found[0])


def _wider(sign: str, body: str) -> Callout | None:
    """A counterbore or countersink by its sign and what is said of it; None without a diameter."""
    depth, body = _taken(_DEPTH, body)
    angle, body = _taken(_WIDE_ANGLE, body)
    wide, body = _taken(_WIDE, body)
    if wide is None:
        return None
    second, body = _taken(_SECOND, body)
    more = value_of(second[1]) if second else None
    deep = _value(depth)
    degrees = _value(angle)
    if sign == SINK and degrees is None and more and _SINK_ANGLES[0] <= more <= _SINK_ANGLES[1]:
        degrees, more = more, None
    kind = NoteKind.COUNTERBORE if degrees is None and sign == BORE else NoteKind.COUNTERSINK
    return Callout(kind, value_of(wide[1]), depth=more if deep is None else deep, angle=degrees)


def _value(found: re.Match[str] | None) -> float | None:
    return None if found is None or found[1] == "\u221e" else value_of(found[1])


def _plain_features(head: str, bare_point_is_inch: bool) -> list[Callout]:
    """Features without a sign of a wider hole, each with the depth behind it."""
    parts = _DEPTH.split(head)
    found: list[Callout] = []
    ahead: str | None = None
    for number, part in enumerate(parts[::2]):
        depth = parts[2 * number + 1] if 2 * number + 1 < len(parts) else None
        words = _OPEN.sub("", part.strip(_PARTING))
        feature = _plain_feature(words, bare_point_is_inch) if words else None
        if feature is None and len(parts) > 1 and (first := _FIRST_DIAMETER.match(words)):
            feature = _plain_feature(first[0], bare_point_is_inch)
        if feature is not None:
            if depth is None and ahead is not None:
                depth, ahead = ahead, None
            found.append(_deep(feature, depth))
        elif words:
            return found
        elif depth is not None:
            ahead = depth
    if ahead is not None and not found:
        return [_deep(Callout(NoteKind.DEPTH), ahead)]
    return found


def _deep(callout: Callout, depth: str | None) -> Callout:
    """The same with its depth; what has one, or goes through, is a hole."""
    if depth is None:
        return callout
    through = depth == "\u221e"
    deep = None if through else value_of(depth)
    if callout.kind is NoteKind.DEPTH:
        return replace(callout, value=deep, through=through)
    kind = NoteKind.DIAMETER if callout.kind is NoteKind.LENGTH else callout.kind
    hole = kind in (NoteKind.DIAMETER, NoteKind.THREAD)
    return replace(callout, kind=kind, depth=deep, through=through and hole)


def _of_all(plain: str) -> tuple[Callout, ...]:
    """Notes about all edges that have none of their own."""
    found = []
    chamfer, rounding = _CHAMFER.search(plain), _ROUND.search(plain)
    if chamfer:
        found.append(Callout(NoteKind.ALL_CHAMFERS, value_of(chamfer[3] or chamfer[1])))
    if rounding:
        found.append(Callout(NoteKind.ALL_FILLETS, value_of(rounding[1])))
    return tuple(found)


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
