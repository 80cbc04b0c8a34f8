"""What is shown of a reading: its strokes and views, with corrections, as the engine takes them.

The reading and the corrections are what the engine's files hold, px of the sheet as stored.  The
engine itself corrects a reading when it solves; this is what a person sees meanwhile.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import atan2, cos, hypot, pi, sin

from freecad.gaussiancad.canvas.kinds import DRAWN

Point = tuple[float, float]
Box = tuple[float, float, float, float]

_STEPS = 96
"""Points of a whole circle."""


@dataclass(frozen=True)
class Stroke:
    """A stroke.

    Attributes:
        id: by which corrections name it.
        view: id of its view, or None.
        kind: what it stands for.
        shape: ``line``, ``arc`` or ``ellipse`` with its numbers, as in the file.
        confidence: how sure the kind is.
        given: whether a person drew it or said its kind.
    """

    id: str
    view: str | None
    kind: str
    shape: tuple[str, tuple]
    confidence: float = 1.0
    given: bool = False

    def points(self) -> list[Point]:
        """Along the stroke."""
        name, numbers = self.shape
        if name == "line":
            (x0, y0), (x1, y1) = numbers
            return [(x0, y0), (x1, y1)]
        if name == "arc":
            x, y, radius, first, sweep = numbers
            major, minor, turn = radius, radius, 0.0
        else:
            x, y, major, minor, turn, first, sweep = numbers
        count = max(2, int(_STEPS * sweep / (2.0 * pi)) + 1)
        found = []
        for index in range(count + 1):
            angle = first + sweep * index / count
            a, b = major * cos(angle), minor * sin(angle)
            found.append((x + a * cos(turn) - b * sin(turn), y + a * sin(turn) + b * cos(turn)))
        return found

    def target(self) -> dict:
        """How a correction names it."""
        name, numbers = self.shape
        return {"id": self.id, name: numbers}


@dataclass(frozen=True)
class View:
    """A view, or another group of lines: its id, what it shows, and the box around it."""

    id: str
    role: str
    box: Box
    used: bool = True

    def holds(self, point: Point) -> bool:
        """Whether a place is within its box."""
        x0, y0, x1, y1 = self.box
        return x0 <= point[0] <= x1 and y0 <= point[1] <= y1


@dataclass(frozen=True)
class Row:
    """A problem: how grave, what it is, its code, and its place, if it has one."""

    severity: str
    message: str
    code: str
    box: Box | None = None


@dataclass(frozen=True)
class Sheet:
    """What is shown.

    Attributes:
        strokes: that have a shape.
        views: principal ones and others.
        problems: what is in doubt.
        sha256: of the sheet's file.
        size: px, width and height; None where the reading does not tell.
    """

    strokes: tuple[Stroke, ...]
    views: tuple[View, ...]
    problems: tuple[Row, ...]
    sha256: str
    size: tuple[int, int] | None

    def view_at(self, point: Point) -> View | None:
        """The smallest used view around a place."""
        around = [own for own in self.views if own.used and own.holds(point)]
        return min(around, key=lambda own: _area(own.box), default=None)

    def like(self, stroke: Stroke) -> list[Stroke]:
        """Strokes of the same kind and shape in the same view."""
        return [
            own
            for own in self.strokes
            if (own.kind, own.view, own.shape[0]) == (stroke.kind, stroke.view, stroke.shape[0])
        ]

    def ends(self) -> list[Point]:
        """Places to snap to: ends of strokes, and centres of arcs."""
        found = []
        for own in self.strokes:
            if own.kind in DRAWN:
                points = own.points()
                found += [points[0], points[-1]]
                if own.shape[0] != "line":
                    found.append((own.shape[1][0], own.shape[1][1]))
        return found


def sheet_of(reading: dict) -> Sheet:
    """What a ``reading.json`` holds."""
    strokes = []
    for own in reading.get("strokes", ()):
        shape = next(
            ((name, _tuples(own[name])) for name in ("line", "arc", "ellipse") if name in own),
            None,
        )
        if shape is not None:
            strokes.append(
                Stroke(
                    own["id"],
                    own.get("view"),
                    own["kind"],
                    shape,
                    own.get("confidence", 1.0),
                    own.get("source") == "given",
                )
            )
    views = tuple(
        View(own["id"], own["role"], tuple(own["box"]), own.get("used", True))
        for own in reading.get("views", ())
    )
    problems = tuple(
        Row(own["severity"], own["message"], own["code"], next(map(tuple, own.get("at", ())), None))
        for own in reading.get("problems", ())
    )
    size = reading["sheet"].get("size")
    return Sheet(
        tuple(strokes),
        views,
        problems,
        reading["sheet"]["sha256"],
        tuple(size) if size else None,
    )


def corrected(sheet: Sheet, operations: list[dict]) -> Sheet:
    """The same after corrections, one after another."""
    for number, own in enumerate(operations, start=1):
        sheet = _APPLIED.get(own["op"], _unseen)(sheet, own, number)
    return sheet


def _kind(sheet: Sheet, own: dict, _: int) -> Sheet:
    name = own["target"]["id"]
    return _changed(sheet, lambda each: each.id == name, kind=own["to"], given=True)


def _erase(sheet: Sheet, own: dict, _: int) -> Sheet:
    name = own["target"]["id"]
    return replace(sheet, strokes=tuple(each for each in sheet.strokes if each.id != name))


def _draw(sheet: Sheet, own: dict, number: int) -> Sheet:
    shape = next((name, _tuples(own[name])) for name in ("line", "arc", "ellipse") if name in own)
    drawn = Stroke(f"p{number}", own["view"], own["kind"], shape, given=True)
    return replace(sheet, strokes=(*sheet.strokes, drawn))


def _view(sheet: Sheet, own: dict, _: int) -> Sheet:
    box = own.get("box")
    known = next((each for each in sheet.views if each.id == own["id"]), None)
    if box is None and known is None:
        return sheet
    made = View(own["id"], own["role"], tuple(box) if box is not None else known.box)
    rest = tuple(each for each in sheet.views if each.id != own["id"])
    return replace(sheet, views=(*rest, made))


def _region(sheet: Sheet, own: dict, _: int) -> Sheet:
    xs, ys = zip(*own["polygon"], strict=True)
    x0, y0, x1, y1 = min(xs), min(ys), max(xs), max(ys)

    def within(each: Stroke) -> bool:
        return all(x0 <= x <= x1 and y0 <= y <= y1 for x, y in each.points())

    return _changed(sheet, within, kind=own["kind"], given=True)


def _unseen(sheet: Sheet, _own: dict, _number: int) -> Sheet:
    """What changes no stroke and no view."""
    return sheet


_APPLIED = {"kind": _kind, "erase": _erase, "draw": _draw, "view": _view, "region": _region}


def _changed(sheet: Sheet, chosen, **values) -> Sheet:  # noqa: ANN001, ANN003
    strokes = tuple(replace(own, **values) if chosen(own) else own for own in sheet.strokes)
    return replace(sheet, strokes=strokes)


def arc_through(start: Point, end: Point, middle: Point) -> tuple | None:
    """Centre, radius, first angle and sweep of the arc from a start through a middle to an end;
    None where these lie in line."""
    (ax, ay), (bx, by), (cx, cy) = start, middle, end
    double = 2.0 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by))
    if abs(double) < 1e-9:
        return None
    squares = [x * x + y * y for x, y in (start, middle, end)]
    x = (squares[0] * (by - cy) + squares[1] * (cy - ay) + squares[2] * (ay - by)) / double
    y = (squares[0] * (cx - bx) + squares[1] * (ax - cx) + squares[2] * (bx - ax)) / double
    first, through, last = (atan2(q - y, p - x) for p, q in (start, middle, end))
    turn = (last - first) % (2.0 * pi)
    if (through - first) % (2.0 * pi) <= turn:
        return (x, y, hypot(ax - x, ay - y), first, turn)
    return (x, y, hypot(ax - x, ay - y), last, 2.0 * pi - turn)


def _tuples(numbers: list) -> tuple:
    return tuple(tuple(own) if isinstance(own, (list, tuple)) else own for own in numbers)


def _area(box: Box) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])
