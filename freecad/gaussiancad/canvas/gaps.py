"""Where the outline of a view is open, and the lines that would close it."""

from __future__ import annotations

from itertools import combinations
from math import hypot

from freecad.gaussiancad.canvas.sheet import Box, Point, Sheet, Stroke, View, distance
from freecad.gaussiancad.language import translate

OPEN = "open-outline"
"""The engine's code for a view whose outline has a gap."""

_MEET_PX = 3.0
"""px within which an end meets another stroke."""

_PIN = 8.0
"""px of the sheet around an end that is marked."""

_FAR = 0.5
"""Share of a view's longer side that a gap is long at most."""


def open_ends(sheet: Sheet, view: View) -> list[Point]:
    """Ends of visible strokes of a view that meet no other stroke of it."""
    return [end for _, end in _open(sheet, view)]


def closing_lines(sheet: Sheet, view: View) -> list[tuple[Point, Point]]:
    """Lines between open ends of a view's strokes, the nearest to each other first, each end once;
    ends that have none within half of the view stay open."""
    x0, y0, x1, y1 = view.box
    far = _FAR * max(x1 - x0, y1 - y0)
    pairs = sorted(
        (hypot(a[0] - b[0], a[1] - b[1]), a, b)
        for (one, a), (other, b) in combinations(_open(sheet, view), 2)
        if one != other
    )
    taken: set[Point] = set()
    found = []
    for apart, a, b in pairs:
        if apart <= far and not taken & {a, b}:
            taken |= {a, b}
            found.append((a, b))
    return found


def problem_marks(sheet: Sheet) -> list[tuple[Box, str]]:
    """Places of problems and what they are; where outlines are open, of the ends that nothing
    meets."""
    marks = [
        (problem.box, problem.message)
        for problem in sheet.problems
        if problem.box and problem.pinned
    ]
    if any(problem.code == OPEN for problem in sheet.problems):
        text = translate("GaussianCAD", "Nothing meets this end")
        marks += [
            ((x - _PIN, y - _PIN, x + _PIN, y + _PIN), text)
            for view in sheet.views
            if view.shown
            for x, y in open_ends(sheet, view)
        ]
    return marks


def _open(sheet: Sheet, view: View) -> list[tuple[str, Point]]:
    strokes = [
        stroke for stroke in sheet.strokes if stroke.view == view.id and stroke.kind == "visible"
    ]
    return [
        (stroke.id, end)
        for stroke in strokes
        if stroke.circle is None
        for end in (stroke.points()[0], stroke.points()[-1])
        if not _meets(end, stroke, strokes)
    ]


def _meets(end: Point, stroke: Stroke, strokes: list[Stroke]) -> bool:
    return any(
        distance(other.points(), end) <= _MEET_PX for other in strokes if other is not stroke
    )
