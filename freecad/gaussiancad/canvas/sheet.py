"""What is shown of a reading: its views, strokes, numbers and planes, as the engine takes them.

The reading is what the engine's file holds, px of the sheet as stored, y down.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from math import atan2, cos, hypot, pi, sin

from freecad.gaussiancad.canvas.kinds import DOUBT, DRAWN, ROLES
from freecad.gaussiancad.engine.wording import Place, worded

Point = tuple[float, float]
Box = tuple[float, float, float, float]
Shape = tuple[str, tuple]
"""``line``, ``arc`` or ``ellipse`` with its numbers, as in the file."""

_STEPS = 96
"""Points of a whole circle."""

_WHOLE = 6.2
"""Radians from which an arc is a circle."""


@dataclass(frozen=True)
class Stroke:
    """A stroke.

    Attributes:
        id: by which corrections name it.
        view: id of its view, or None.
        kind: what it stands for.
        shape: where it runs.
        confidence: how sure the kind is.
        given: whether a person drew it or said its kind.
        why: what told its kind, as the engine names it; empty where it does not say.
        otherwise: the kind that it would be if that is wrong; empty where none is known.
    """

    id: str
    view: str | None
    kind: str
    shape: Shape
    confidence: float = 1.0
    given: bool = False
    why: str = ""
    otherwise: str = ""

    @property
    def doubtful(self) -> bool:
        """Whether its kind is so unsure that a person should look at it."""
        return self.confidence < DOUBT and not self.given

    @property
    def circle(self) -> tuple[float, float, float] | None:
        """Centre and radius of a whole circle; None of anything else."""
        name, numbers = self.shape
        return numbers[:3] if name == "arc" and numbers[4] >= _WHOLE else None

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


_FRAME = 10.0
"""px between the lines of a view and its frame."""


@dataclass(frozen=True)
class View:
    """A view, or another group of lines.

    Attributes:
        id: by which corrections name it.
        role: what it shows.
        box: around it.
        used: whether it stands for a view of the part.
        cut: whether it shows a section.
        given: whether a person said what it is.
    """

    id: str
    role: str
    box: Box
    used: bool = True
    cut: bool = False
    given: bool = False

    @property
    def shown(self) -> bool:
        """Whether the part is made from it."""
        return self.used and self.role != "ignore"

    @property
    def frame(self) -> Box:
        """What is drawn around it, a little larger than its box."""
        x0, y0, x1, y1 = self.box
        return x0 - _FRAME, y0 - _FRAME, x1 + _FRAME, y1 + _FRAME

    def holds(self, point: Point) -> bool:
        """Whether a place is within its frame."""
        x0, y0, x1, y1 = self.frame
        return x0 <= point[0] <= x1 and y0 <= point[1] <= y1


@dataclass(frozen=True)
class Number:
    """A dimension: its text, the mm that it gives, the box around it, and whether it counts."""

    id: str
    text: str
    value: float
    box: Box
    used: bool = True
    given: bool = False


@dataclass(frozen=True)
class Plane:
    """Where a section cuts: its letters, the line in another view, and the section's box."""

    label: str
    line: tuple[Point, ...]
    box: Box | None = None
    given: bool = False


@dataclass(frozen=True)
class Note:
    """What is said of a feature: the text, its box, and the circle of which a person said it."""

    text: str
    box: Box
    circle: tuple[float, float, float] | None = None


@dataclass(frozen=True)
class Row:
    """A problem: how grave, what it is, in the user's words, its code, its first place if it has
    one, which corrections may help, by their ``op``, the values in the message, and all places."""

    severity: str
    message: str
    code: str
    box: Box | None = None
    offers: tuple[str, ...] = ()
    args: Mapping[str, object] = field(default_factory=dict)
    places: tuple[Box, ...] = ()

    @property
    def unseen_axis(self) -> str:
        """The axis along which the only view does not tell the part's thickness, if it is that
        which is missing; else empty."""
        is_thickness = self.code == "one-view" and not self.args.get("case")
        return str(self.args.get("axis", "")) if is_thickness else ""

    @property
    def pinned(self) -> bool:
        """Whether its place is marked on the sheet: whole drawings have frames of their own."""
        return "view" not in self.offers

    @property
    def of_numbers(self) -> bool:
        """Whether its places are those of numbers that may be told anew."""
        return "dimension" in self.offers


@dataclass(frozen=True)
class Sheet:
    """What is shown.

    Attributes:
        strokes: that have a shape.
        views: principal ones and others.
        problems: what is in doubt.
        sha256: of the sheet's file.
        size: px, width and height; None where the reading does not tell.
        numbers, planes, notes: what else is said on the sheet.
        projection: ``first`` or ``third``.
        unit: ``mm`` or ``in``.
        mm_per_px: the scale; None where it is not known.
    """

    strokes: tuple[Stroke, ...]
    views: tuple[View, ...]
    problems: tuple[Row, ...]
    sha256: str
    size: tuple[int, int] | None
    numbers: tuple[Number, ...] = ()
    planes: tuple[Plane, ...] = ()
    notes: tuple[Note, ...] = ()
    projection: str = "third"
    unit: str = "mm"
    mm_per_px: float | None = None

    def view_at(self, point: Point) -> View | None:
        """The smallest used view around a place."""
        around = [view for view in self.views if view.used and view.holds(point)]
        return min(around, key=lambda item: _area(item.box), default=None)

    def stroke_at(self, point: Point, reach: float) -> Stroke | None:
        """The stroke nearest to a place within so many px, those of the part first."""
        near = [
            (stroke.kind not in DRAWN, distance(stroke.points(), point), stroke)
            for stroke in self.strokes
        ]
        found = [item for item in near if item[1] <= reach]
        return min(found, key=lambda item: item[:2])[2] if found else None

    def like(self, stroke: Stroke) -> list[Stroke]:
        """Strokes of the same kind and shape in the same view."""
        return [
            this_stroke
            for this_stroke in self.strokes
            if (this_stroke.kind, this_stroke.view, this_stroke.shape[0])
            == (stroke.kind, stroke.view, stroke.shape[0])
        ]

    def drawn(self) -> list[Stroke]:
        """The strokes that the part is made of."""
        return [stroke for stroke in self.strokes if stroke.kind in DRAWN]

    @property
    def sections(self) -> list[View]:
        """Views that may be sections: those that are hatched, or all of the part where none is."""
        cut = [view for view in self.views if view.cut]
        return cut or [view for view in self.views if view.shown and view.role in ROLES]


def sheet_of(reading: dict) -> Sheet:
    """What a ``reading.json`` holds."""
    size = reading["sheet"].get("size")
    return Sheet(
        tuple(_strokes(reading)),
        tuple(
            View(
                item["id"],
                item["role"],
                tuple(item["box"]),
                item.get("used", True),
                bool(item.get("hatch")),
                item.get("source") == "given",
            )
            for item in reading.get("views", ())
        ),
        tuple(
            Row(
                item["severity"],
                worded(item["code"], item["message"], item.get("args"), Place.CANVAS),
                item["code"],
                next(map(tuple, item.get("at", ())), None),
                tuple(item.get("offers", ())),
                dict(item.get("args", {})),
                tuple(map(tuple, item.get("at", ()))),
            )
            for item in reading.get("problems", ())
        ),
        reading["sheet"]["sha256"],
        tuple(size) if size else None,
        numbers=tuple(
            Number(
                item["id"],
                item["text"],
                item["value_mm"],
                tuple(item["box"]),
                bool(item.get("used")),
            )
            for item in reading.get("dimensions", ())
        ),
        planes=tuple(
            Plane(item["label"], tuples(item.get("path") or item["line"]), tuple(item["box"]))
            for item in reading.get("sections", ())
            if item.get("line")
        ),
        notes=tuple(
            Note(
                item["text"],
                tuple(item["box"]),
                tuple(item["circle"]) if "circle" in item else None,
            )
            for item in reading.get("notes", ())
        ),
        projection=reading.get("projection", {}).get("value", "third"),
        unit=reading.get("unit", {}).get("value", "mm"),
        mm_per_px=reading.get("scale", {}).get("mm_per_px"),
    )


def _strokes(reading: dict) -> list[Stroke]:
    found = []
    for item in reading.get("strokes", ()):
        shape = shape_in(item)
        if shape is not None:
            why = item.get("why") or {}
            stated = item.get("confidence", 1.0), item.get("source") == "given"
            reasons = why.get("by", ""), why.get("otherwise", "")
            found.append(
                Stroke(item["id"], item.get("view"), item["kind"], shape, *stated, *reasons)
            )
    return found


def shape_in(item: dict) -> Shape | None:
    """The shape that an entry or an operation names; None where it names none."""
    names = ("line", "arc", "ellipse")
    return next(((name, tuples(item[name])) for name in names if name in item), None)


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


def tuples(numbers: list) -> tuple:
    """Lists of a file as tuples."""
    return tuple(
        tuple(number) if isinstance(number, (list, tuple)) else number for number in numbers
    )


def _area(box: Box) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])


def distance(points: list[Point], at: Point) -> float:
    """px from a place to a chain of points."""
    best = float("inf")
    for (x0, y0), (x1, y1) in pairwise(points):
        dx, dy = x1 - x0, y1 - y0
        length = dx * dx + dy * dy
        share = 0.0
        if length:
            share = min(1.0, max(0.0, ((at[0] - x0) * dx + (at[1] - y0) * dy) / length))
        best = min(best, hypot(at[0] - x0 - share * dx, at[1] - y0 - share * dy))
    return best
