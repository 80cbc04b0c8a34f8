"""What each tool makes of its clicks, or of its drag."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import hypot, pi

from freecad.gaussiancad.canvas.corrections import ignore_area
from freecad.gaussiancad.canvas.handles import box_between
from freecad.gaussiancad.canvas.hit_test import HitTest
from freecad.gaussiancad.canvas.sheet import Box, Point, Shape, arc_through

TOOLS = {
    "L": "line",
    "A": "arc",
    "O": "circle",
    "P": "pick",
    "B": "view",
    "M": "scale",
    "X": "plane",
    "R": "ignore-area",
}
"""What a key lets the mouse do next; Esc takes it back."""

DRAWING = ("line", "arc", "circle", "pick")
"""Tools that make strokes."""

SQUARE = ("line", "plane")
"""Tools whose lines are level or upright, unless Alt frees them."""

ONCE = ("scale", "plane")
"""Tools that are put away when they have made something; all others stay until Esc."""


@dataclass(frozen=True)
class Operations:
    """Operations are said."""

    operations: list[dict]


@dataclass(frozen=True)
class Chosen:
    """Strokes, or a view, are selected by their ids, and no others."""

    ids: frozenset[str]


@dataclass(frozen=True)
class Drawn:
    """A stroke is drawn in the view around a place."""

    shape: Shape
    at: Point


@dataclass(frozen=True)
class Traced:
    """The ink at a place is to become a stroke."""

    at: Point


@dataclass(frozen=True)
class Measured:
    """Two points, whose distance a person shall tell."""

    points: tuple[Point, Point]


@dataclass(frozen=True)
class Boxed:
    """A box, whose role a person shall tell."""

    box: Box


@dataclass(frozen=True)
class Cut:
    """A line in a view, and the view's id: which section cuts there, a person shall tell."""

    line: tuple[Point, Point]
    in_view: str


Meaning = Operations | Chosen | Drawn | Traced | Measured | Boxed | Cut
"""What a gesture means."""


@dataclass(frozen=True)
class Clicks:
    """A tool that takes clicks.

    Attributes:
        count: how many it takes.
        made: what they mean; None for nothing.
        snaps: whether they snap to places of strokes.
    """

    count: int
    made: Callable[[tuple[Point, ...]], Meaning | None]
    snaps: bool = True


def _arc(places: tuple[Point, ...]) -> Meaning | None:
    shape = arc_through(*places)
    return Drawn(("arc", shape), places[0]) if shape is not None else None


def _line(hits: HitTest, start: Point, end: Point) -> Meaning:
    first = hits.snapped(start)
    return Drawn(("line", (first, hits.snapped(end, first))), first)


def _circle(hits: HitTest, start: Point, end: Point) -> Meaning:
    centre = hits.snapped(start)
    radius = hypot(end[0] - centre[0], end[1] - centre[1])
    return Drawn(("arc", (*centre, radius, 0.0, round(2.0 * pi, 6))), centre)


def _view(_hits: HitTest, start: Point, end: Point) -> Meaning:
    return Boxed(box_between(start, end))


def _plane(hits: HitTest, start: Point, end: Point) -> Meaning | None:
    middle = (start[0] + end[0]) / 2.0, (start[1] + end[1]) / 2.0
    view = hits.sheet.view_at(middle)
    if view is None:
        return None
    return Cut((hits.snapped(start), hits.snapped(end)), view.id)


def _area(_hits: HitTest, start: Point, end: Point) -> Meaning:
    return Operations(ignore_area(box_between(start, end)))


CLICKS = {
    "scale": Clicks(2, Measured),
    "arc": Clicks(3, _arc),
    "pick": Clicks(1, lambda places: Traced(places[0]), snaps=False),
}
"""Tools that take clicks."""

DRAGS: dict[str, Callable[[HitTest, Point, Point], Meaning | None]] = {
    "line": _line,
    "circle": _circle,
    "view": _view,
    "plane": _plane,
    "ignore-area": _area,
}
"""What a drag from one place to another means with a tool."""
