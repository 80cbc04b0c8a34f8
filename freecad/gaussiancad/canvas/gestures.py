"""What a press, a move and a release of the mouse come to, with the tool that is taken."""

from __future__ import annotations

from math import hypot

from freecad.gaussiancad.canvas.corrections import move_stroke, set_box
from freecad.gaussiancad.canvas.handles import (
    box_between,
    corners_of,
    handles_of,
    with_corner,
    with_handle,
)
from freecad.gaussiancad.canvas.hit_test import HitTest
from freecad.gaussiancad.canvas.sheet import Point
from freecad.gaussiancad.canvas.tools import (
    CLICKS,
    DRAGS,
    ONCE,
    SQUARE,
    Chosen,
    Meaning,
    Operations,
)
from freecad.gaussiancad.qt import QtCore, QtGui

_LEAST = 4.0
"""px of the screen that a drag is long at least."""


class GestureController:
    """The tool that is taken, and what was begun with it.

    Nothing is changed here: whoever has the events does what a release means.
    """

    def __init__(self) -> None:
        self._tool = ""
        self._pressed: Point | None = None
        self._held: int | None = None
        self._clicked: tuple[Point, ...] = ()

    @property
    def tool(self) -> str:
        """What is done next, a value of :data:`.TOOLS`; empty for selecting and moving handles."""
        return self._tool

    @property
    def began(self) -> bool:
        """Whether a click or a drag was begun."""
        return self._pressed is not None

    def take(self, tool: str) -> None:
        """Take a tool, or none; clicks of the one before are forgotten."""
        self._tool, self._clicked = tool, ()

    def drop(self) -> None:
        """Forget the click or the drag that was begun."""
        self._pressed = self._held = None

    def press(self, at: Point, hits: HitTest) -> None:
        """Begin a click or a drag; with no tool it may hold a handle."""
        self._pressed = at
        self._held = None if self._tool else hits.handle_at(at)

    def rubber(self, at: Point, hits: HitTest, *, free: bool) -> QtGui.QPainterPath | None:
        """What would be made if the mouse were released; None where nothing was begun.

        Args:
            at: where the mouse is.
            hits: under it.
            free: whether lines may be slanted.
        """
        if self._pressed is None:
            return None
        start, end = self._pressed, self._end(at, hits, free)
        path = QtGui.QPainterPath()
        moving = self._held is not None and bool(hits.selected)
        if moving:
            start = handles_of(hits.selected[0])[1 - self._held]
        if moving or self._tool in SQUARE:
            path.moveTo(*start)
            path.lineTo(*end)
        elif self._tool == "circle":
            radius = hypot(end[0] - start[0], end[1] - start[1])
            path.addEllipse(QtCore.QPointF(*start), radius, radius)
        else:
            if self._held is not None:
                start = corners_of(hits.selected_view.box)[(self._held + 2) % 4]
            x0, y0, x1, y1 = box_between(start, end)
            path.addRect(x0, y0, x1 - x0, y1 - y0)
        return path

    def release(self, at: Point, hits: HitTest, *, free: bool, more: bool) -> Meaning | None:
        """End what was begun; a tool that is used once is put away.

        Args:
            at: where the mouse is.
            hits: under it.
            free: whether lines may be slanted.
            more: whether something is selected besides what is.

        Returns:
            What it means; None for nothing, or where more clicks are to follow.
        """
        if self._pressed is None:
            return None
        start, end = self._pressed, self._end(at, hits, free)
        held, self._held, self._pressed = self._held, None, None
        dragged = hits.zoom * hypot(end[0] - start[0], end[1] - start[1]) >= _LEAST
        if held is not None and dragged:
            return Operations(_moved(held, end, hits))
        if self._tool in CLICKS:
            made = self._click(end, hits)
        elif not dragged:
            return _clicked(end, hits, more)
        elif self._tool in DRAGS:
            made = DRAGS[self._tool](hits, start, end)
        else:
            found = hits.strokes_in(start, end)
            return Chosen(hits.chosen | found if more else found)
        if made is not None and self._tool in ONCE:
            self.take("")
        return made

    def _click(self, at: Point, hits: HitTest) -> Meaning | None:
        tool = CLICKS[self._tool]
        places = (*self._clicked, hits.snapped(at) if tool.snaps else at)
        done = len(places) == tool.count
        self._clicked = () if done else places
        return tool.made(places) if done else None

    def _end(self, at: Point, hits: HitTest, free: bool) -> Point:
        """Where a drag is: level or upright for a line, unless it is free."""
        x, y = at
        if self._tool in SQUARE and self._pressed is not None and not free:
            a, b = hits.snapped(self._pressed)
            return (x, b) if abs(x - a) >= abs(y - b) else (a, y)
        return x, y


def _moved(index: int, to: Point, hits: HitTest) -> list[dict]:
    """A handle of what is selected was moved."""
    view = hits.selected_view
    if view is not None:
        return set_box(view, with_corner(view.box, index, to))
    (item,) = hits.selected
    return move_stroke(item, with_handle(item.shape, index, hits.snapped(to)))


def _clicked(at: Point, hits: HitTest, more: bool) -> Chosen:
    """Select what is at a place; with others, only strokes, and what is selected no more."""
    found = hits.stroke_at(at) or (None if more else hits.view_at(at))
    chosen = frozenset({found.id} if found is not None else ())
    return Chosen(hits.chosen ^ chosen if more else chosen)
