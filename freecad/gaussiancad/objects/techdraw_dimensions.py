"""Dimensions of a TechDraw page as SVG elements: the number, thin lines and arrowheads (ISO 129-1).

Where FreeCAD draws a dimension needs a window; what it measures and where its number stands do not.
"""

from collections.abc import Iterator
from math import atan2, degrees, hypot
from xml.sax.saxutils import escape

import FreeCAD

_PEN = 'class="dimension" stroke-width="0.18"'
_HEAD = 'class="dimension" fill="black" stroke="none"'

_LETTERS = 3.5
"""mm of the letters' size (ISO 3098)."""

_HEAD_LENGTH, _HEAD_HALF = 2.5, 0.4
"""mm along and across an arrowhead."""

_GAP, _BEYOND = 0.8, 1.5
"""mm between an edge and its extension line, and by which that goes on past the dimension line."""

_LETTER_GAP = 0.8
"""mm between a dimension line and the number on it."""

_ROUND = 4
"""Decimals of a millimetre that are written."""

_LEAST = 1e-6

Point = tuple[float, float]
"""On the page, mm, y down."""

_SIGNS = {"Diameter": "\u2300", "Radius": "R"}


def dimension_elements(dimension: FreeCAD.DocumentObject, origin: Point) -> Iterator[str]:
    """A dimension's elements; none where it measures an angle, or nothing.

    Args:
        dimension: a ``TechDraw::DrawViewDimension``.
        origin: centre of its view.
    """
    text = dimension_text(dimension)
    if not text:
        return
    label = origin[0] + float(dimension.X), origin[1] - float(dimension.Y)
    if dimension.Type in _SIGNS:
        centre, first = (_on_page(point, origin) for point in dimension.getArcPoints()[:2])
        yield from _leader(text, label, centre, hypot(first[0] - centre[0], first[1] - centre[1]))
        return
    start, end = (_on_page(point, origin) for point in dimension.getLinearPoints()[:2])
    along = {"DistanceX": (1.0, 0.0), "DistanceY": (0.0, 1.0)}.get(dimension.Type)
    along = along or _direction(start, end)
    if along is not None:
        yield from _linear(text, label, (start, end), along)


def dimension_text(dimension: FreeCAD.DocumentObject) -> str:
    """What a dimension says: the words that a person put there, else its length in mm; empty for
    angles."""
    if dimension.Type not in ("Distance", "DistanceX", "DistanceY", *_SIGNS):
        return ""
    if dimension.Arbitrary:
        return str(dimension.FormatSpec).strip()
    value = round(abs(float(dimension.getRawValue())), _ROUND)
    return f"{_SIGNS.get(dimension.Type, '')}{value:.10g}" if value > 0.0 else ""


def text_element(text: str, at: Point, turn: float = 0.0, anchor: str = "start") -> str:
    """A line of text.

    Args:
        text: its characters.
        at: on its base line.
        turn: degrees by which it is turned clockwise.
        anchor: ``start`` or ``middle``, which of it is there.
    """
    x, y = at
    turned = f' transform="rotate({turn:.6g} {x:.6f} {y:.6f})"' if turn else ""
    return (
        f'<text x="{x:.6f}" y="{y:.6f}" font-family="sans-serif" font-size="{_LETTERS}" '
        f'text-anchor="{anchor}" fill="black" stroke="none"{turned}>{escape(text)}</text>'
    )


def _on_page(point: FreeCAD.Vector, origin: Point) -> Point:
    return origin[0] + point.x, origin[1] + point.y


def _direction(start: Point, end: Point) -> Point | None:
    x, y = end[0] - start[0], end[1] - start[1]
    length = hypot(x, y)
    return (x / length, y / length) if length > _LEAST else None


def _linear(text: str, label: Point, ends: tuple[Point, Point], along: Point) -> Iterator[str]:
    """Extension lines, the dimension line with its arrowheads, and the number above it."""
    normal = -along[1], along[0]
    level = _dot(label, normal)
    feet = [_plus(_plus((0.0, 0.0), along, _dot(end, along)), normal, level) for end in ends]
    for point, foot in zip(ends, feet, strict=True):
        out = _direction(point, foot)
        if out is not None:
            yield _line(_plus(point, out, _GAP), _plus(foot, out, _BEYOND))
    inward = _direction(feet[0], feet[1])
    if inward is None:
        return
    yield _line(*feet)
    yield _head(feet[0], inward)
    yield _head(feet[1], (-inward[0], -inward[1]))
    turn = degrees(atan2(along[1], along[0]))
    # Numbers are read from below or from the right.
    turn = (turn + 90.0) % 180.0 - 90.0
    if turn > 90.0 - _LEAST:
        turn -= 180.0
    up = (0.0, -1.0) if abs(turn) < _LEAST else (-1.0, 0.0) if abs(turn + 90.0) < _LEAST else normal
    centre = _plus((0.0, 0.0), along, _dot(label, along))
    base = _plus(_plus(centre, normal, level), up, _LETTER_GAP)
    yield text_element(text, base, turn, "middle")


def _leader(text: str, label: Point, centre: Point, radius: float) -> Iterator[str]:
    """A line that points at a circle, its arrowhead, and the number at its end."""
    out = _direction(centre, label)
    if out is None or radius < _LEAST:
        return
    tip = _plus(centre, out, radius)
    yield _line(tip, label)
    is_outside = hypot(label[0] - centre[0], label[1] - centre[1]) > radius
    yield _head(tip, out if is_outside else (-out[0], -out[1]))
    x, y = label
    width = 0.6 * _LETTERS * len(text)
    shelf = width if out[0] >= 0.0 else -width
    yield _line(label, (x + shelf, y))
    yield text_element(text, (x + 0.5 * shelf, y - _LETTER_GAP), 0.0, "middle")


def _dot(one: Point, other: Point) -> float:
    return one[0] * other[0] + one[1] * other[1]


def _plus(point: Point, way: Point, length: float) -> Point:
    return point[0] + length * way[0], point[1] + length * way[1]


def _line(start: Point, end: Point) -> str:
    return f'<path {_PEN} d="M{_at(start)}L{_at(end)}"/>'


def _head(tip: Point, inward: Point) -> str:
    """A filled arrowhead at a tip, its body on the way that is given."""
    base, across = _plus(tip, inward, _HEAD_LENGTH), (-inward[1], inward[0])
    sides = (_plus(base, across, _HEAD_HALF), _plus(base, across, -_HEAD_HALF))
    return f'<path {_HEAD} d="M{_at(tip)}L{_at(sides[0])}L{_at(sides[1])}Z"/>'


def _at(point: Point) -> str:
    return f"{point[0]:.6f} {point[1]:.6f}"
