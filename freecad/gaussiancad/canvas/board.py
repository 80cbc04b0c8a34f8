"""The canvas: a sheet with its strokes and views, and the gestures that correct them.

Every gesture ends in operations of ``corrections.json``, which :attr:`Board.said` sends; what is
shown changes only when whoever keeps them calls :meth:`Board.show_sheet`.
"""

from __future__ import annotations

from itertools import pairwise
from math import hypot

from freecad.gaussiancad.canvas.kinds import (
    COLOURS,
    DOUBT,
    DOUBTFUL,
    DRAWN,
    KEYS,
    OTHER,
    ROLES,
    name_of,
)
from freecad.gaussiancad.canvas.sheet import Point, Sheet, Stroke, arc_through
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_SNAP = 10.0
"""px of the screen within which a place snaps to an end or a centre."""

_CLICK = 6.0
"""px of the screen by which a stroke may be missed."""

_ZOOM = 1.25
_LEAST = 4.0
"""px of the screen that a drag is long at least."""

_PALE = 0.45
"""Opacity of the sheet under its strokes."""

TOOLS = {"L": "line", "A": "arc", "O": "circle", "B": "view", "M": "scale", "R": "ignore-area"}
"""What a key lets the mouse do next; Esc takes it back."""


class Board(QtWidgets.QGraphicsView):
    """A sheet that can be touched.

    Signals:
        said: operations that one gesture means.
        asked_length: two points of the sheet whose distance a person shall tell.
        asked_role: a box of the sheet whose role a person shall tell.
        asked_part: the part is to be made.
    """

    said = QtCore.Signal(list)
    asked_length = QtCore.Signal(tuple)
    asked_role = QtCore.Signal(tuple)
    asked_part = QtCore.Signal()

    def __init__(self, parent: QtWidgets.QWidget | None = None) -> None:
        super().__init__(parent)
        self.setScene(QtWidgets.QGraphicsScene(self))
        self.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        self.setTransformationAnchor(QtWidgets.QGraphicsView.ViewportAnchor.AnchorUnderMouse)
        self.setFocusPolicy(QtCore.Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.tool = ""
        self._sheet: Sheet | None = None
        self._picture: QtWidgets.QGraphicsPixmapItem | None = None
        self._items: dict[str, QtWidgets.QGraphicsPathItem] = {}
        self._over: list[QtWidgets.QGraphicsItem] = []
        self._chosen: set[str] = set()
        self._pressed: Point | None = None
        self._clicked: list[Point] = []
        self._rubber: QtWidgets.QGraphicsPathItem | None = None
        self._panned: QtCore.QPoint | None = None

    @property
    def selected(self) -> list[Stroke]:
        """The strokes that are selected."""
        strokes = self._sheet.strokes if self._sheet is not None else ()
        return [own for own in strokes if own.id in self._chosen]

    def show_picture(self, path: str, size: tuple[int, int] | None) -> None:
        """Show the picture of a sheet that is ``size`` px large as stored."""
        pixmap = QtGui.QPixmap(path)
        if self._picture is not None:
            self.scene().removeItem(self._picture)
        self._picture = self.scene().addPixmap(pixmap)
        self._picture.setZValue(-2.0)
        self._picture.setOpacity(_PALE)
        if size is not None and pixmap.width():
            self._picture.setScale(size[0] / pixmap.width())
        self.setSceneRect(self._picture.sceneBoundingRect())

    def show_sheet(self, sheet: Sheet) -> None:
        """Show strokes and views; what was selected stays so where it is still there."""
        for item in (*self._items.values(), *self._over):
            self.scene().removeItem(item)
        self._items, self._over = {}, []
        self._sheet = sheet
        self._chosen &= {own.id for own in sheet.strokes}
        for own in sheet.views:
            self._add_view(own.id, own.role, own.box, own.used)
        for own in sheet.strokes:
            path = QtGui.QPainterPath()
            first, *rest = own.points()
            path.moveTo(*first)
            for point in rest:
                path.lineTo(*point)
            item = self.scene().addPath(path)
            item.setPen(self._pen(own))
            item.setZValue(1.0 if own.kind in DRAWN else 0.0)
            self._items[own.id] = item

    def fit(self) -> None:
        """Show the whole sheet."""
        self.fitInView(self.sceneRect(), QtCore.Qt.AspectRatioMode.KeepAspectRatio)

    def zoom_to(self, box: tuple[float, float, float, float]) -> None:
        """Show a box of the sheet and a little around it."""
        x0, y0, x1, y1 = box
        margin = 0.5 * max(x1 - x0, y1 - y0, 40.0)
        rect = QtCore.QRectF(x0, y0, x1 - x0, y1 - y0)
        rect = rect.adjusted(-margin, -margin, margin, margin)
        self.fitInView(rect, QtCore.Qt.AspectRatioMode.KeepAspectRatio)

    def take_tool(self, tool: str) -> None:
        """What the mouse does next; nothing but selecting where it is empty."""
        self.tool = tool
        self._clicked = []
        self._drop_rubber()
        cross = QtCore.Qt.CursorShape.CrossCursor
        self.viewport().setCursor(cross if tool else QtCore.Qt.CursorShape.ArrowCursor)

    def select(self, ids: set[str]) -> None:
        """Select strokes by their ids, and no others."""
        self._chosen = set(ids)
        for own in self._sheet.strokes if self._sheet is not None else ():
            self._items[own.id].setPen(self._pen(own))

    def give_kind(self, kind: str) -> None:
        """Say that what is selected stands for a kind."""
        chosen = [own for own in self.selected if own.kind != kind]
        self._say([{"op": "kind", "target": own.target(), "to": kind} for own in chosen])

    def erase(self) -> None:
        """Say that what is selected is not there."""
        self._say([{"op": "erase", "target": own.target()} for own in self.selected])

    def event(self, event: QtCore.QEvent) -> bool:
        """Keep single keys: in FreeCAD they would delete objects and turn the 3D view."""
        if event.type() == QtCore.QEvent.Type.ShortcutOverride:
            control = QtCore.Qt.KeyboardModifier.ControlModifier
            if not event.modifiers() & control:
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        """Kinds, tools, Del, Esc, Enter; Space shows the bare ink."""
        key = event.key()
        if event.modifiers() & QtCore.Qt.KeyboardModifier.ControlModifier:
            super().keyPressEvent(event)
            return
        name = chr(key) if QtCore.Qt.Key.Key_A <= key <= QtCore.Qt.Key.Key_Z else ""
        if name in KEYS:
            self.give_kind(KEYS[name])
        elif name in TOOLS:
            self.take_tool(TOOLS[name])
        elif key in (QtCore.Qt.Key.Key_Delete, QtCore.Qt.Key.Key_Backspace):
            self.erase()
        elif key == QtCore.Qt.Key.Key_Escape:
            self.take_tool("")
            self.select(set())
        elif key in (QtCore.Qt.Key.Key_Return, QtCore.Qt.Key.Key_Enter):
            self.asked_part.emit()
        elif key == QtCore.Qt.Key.Key_Space:
            self._show_strokes(False)
        event.accept()

    def keyReleaseEvent(self, event: QtGui.QKeyEvent) -> None:
        """The strokes come back when Space is let go."""
        if event.key() == QtCore.Qt.Key.Key_Space and not event.isAutoRepeat():
            self._show_strokes(True)
        event.accept()

    def wheelEvent(self, event: QtGui.QWheelEvent) -> None:
        """Zoom at the cursor."""
        factor = _ZOOM if event.angleDelta().y() > 0 else 1.0 / _ZOOM
        self.scale(factor, factor)
        event.accept()

    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:
        """Begin to select, to draw or to pan."""
        if event.button() == QtCore.Qt.MouseButton.MiddleButton:
            self._panned = _pos(event)
        elif event.button() == QtCore.Qt.MouseButton.LeftButton and self._sheet is not None:
            self.setFocus()
            self._pressed = self._place(event)
        event.accept()

    def mouseMoveEvent(self, event: QtGui.QMouseEvent) -> None:
        """Pan, or show what would be drawn."""
        if self._panned is not None:
            moved = _pos(event) - self._panned
            self._panned = _pos(event)
            for bar, step in (
                (self.horizontalScrollBar(), moved.x()),
                (self.verticalScrollBar(), moved.y()),
            ):
                bar.setValue(bar.value() - step)
        elif self._pressed is not None:
            self._show_rubber(self._pressed, self._end(event))
        event.accept()

    def mouseReleaseEvent(self, event: QtGui.QMouseEvent) -> None:
        """End what was begun."""
        self._panned = None
        if self._pressed is not None and event.button() == QtCore.Qt.MouseButton.LeftButton:
            start, end = self._pressed, self._end(event)
            self._pressed = None
            self._drop_rubber()
            dragged = self._on_screen(hypot(end[0] - start[0], end[1] - start[1])) >= _LEAST
            shift = bool(event.modifiers() & QtCore.Qt.KeyboardModifier.ShiftModifier)
            self._finish(start, end, dragged=dragged, shift=shift)
        event.accept()

    def contextMenuEvent(self, event: QtGui.QContextMenuEvent) -> None:
        """Kinds for what is under the mouse or selected, and all that is like it."""
        found = self._stroke_at(self._scene_point(event.pos()))
        if found is not None and found.id not in self._chosen:
            self.select({found.id})
        if not self.selected:
            return
        menu = QtWidgets.QMenu(self)
        for key, kind in KEYS.items():
            action = menu.addAction(f"{name_of(kind)}\t{key}")
            action.triggered.connect(lambda _=False, own=kind: self.give_kind(own))
        menu.addSeparator()
        like = menu.addAction(translate("GaussianCAD", "Select all like this"))
        like.triggered.connect(self.select_alike)
        gone = menu.addAction(translate("GaussianCAD", "Erase") + "\tDel")
        gone.triggered.connect(self.erase)
        menu.popup(event.globalPos())

    def select_alike(self) -> None:
        """Select all strokes that are like those selected."""
        own = {other.id for each in self.selected for other in self._sheet.like(each)}
        self.select(own)

    def _say(self, operations: list[dict]) -> None:
        if operations:
            self.said.emit(operations)

    def _finish(self, start: Point, end: Point, *, dragged: bool, shift: bool) -> None:
        """A press and a release, with the tool that is taken."""
        if self.tool == "scale":
            self._clicked.append(end)
            if len(self._clicked) == 2:
                self.asked_length.emit(tuple(self._clicked))
                self.take_tool("")
            return
        if self.tool == "arc":
            self._clicked.append(self._snapped(end))
            if len(self._clicked) == 3:
                shape = arc_through(*self._clicked)
                self._draw("arc", shape, self._clicked[0])
            return
        if not dragged:
            self._click(end, shift=shift)
            return
        if self.tool == "line":
            a, b = self._snapped(start), self._snapped(end)
            self._draw("line", (a, b), a)
        elif self.tool == "circle":
            centre = self._snapped(start)
            radius = hypot(end[0] - centre[0], end[1] - centre[1])
            self._draw("arc", (*centre, radius, 0.0, 6.2831853), centre)
        elif self.tool == "view":
            self.asked_role.emit(_box(start, end))
            self.take_tool("")
        elif self.tool == "ignore-area":
            x0, y0, x1, y1 = _box(start, end)
            corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
            self.take_tool("")
            self._say([{"op": "region", "polygon": corners, "kind": "ignore"}])
        else:
            self._band(start, end, shift=shift)

    def _draw(self, name: str, shape: tuple | None, at: Point) -> None:
        """Say that there is a stroke, in the view where it begins."""
        self._clicked = []
        view = self._sheet.view_at(at)
        if shape is not None and view is not None:
            self._say([{"op": "draw", "view": view.id, "kind": "visible", name: shape}])

    def _click(self, at: Point, *, shift: bool) -> None:
        found = self._stroke_at(at)
        chosen = {found.id} if found is not None else set()
        self.select(self._chosen ^ chosen if shift else chosen)

    def _band(self, start: Point, end: Point, *, shift: bool) -> None:
        """Select what lies in a rubber band; drawn to the left, also what it touches."""
        x0, y0, x1, y1 = _box(start, end)
        touching = end[0] < start[0]
        found = set()
        for own in self._sheet.strokes:
            inside = [x0 <= x <= x1 and y0 <= y <= y1 for x, y in own.points()]
            if all(inside) or (touching and any(inside)):
                found.add(own.id)
        self.select(self._chosen | found if shift else found)

    def _stroke_at(self, at: Point) -> Stroke | None:
        """The stroke nearest to a place, those of the part first."""
        reach = _CLICK / max(self.transform().m11(), 1e-9)
        best: tuple[tuple[bool, float], Stroke] | None = None
        for own in self._sheet.strokes if self._sheet is not None else ():
            away = _distance(own.points(), at)
            key = (own.kind not in DRAWN, away)
            if away <= reach and (best is None or key < best[0]):
                best = key, own
        return None if best is None else best[1]

    def _snapped(self, at: Point) -> Point:
        """The end or centre near a place, or its row and column of other views; else the place."""
        reach = _SNAP / max(self.transform().m11(), 1e-9)
        ends = self._sheet.ends()
        near = min(ends, key=lambda own: hypot(own[0] - at[0], own[1] - at[1]), default=None)
        if near is not None and hypot(near[0] - at[0], near[1] - at[1]) <= reach:
            return near
        found = list(at)
        for index in (0, 1):
            places = [own[index] for own in ends]
            away = [abs(own - at[index]) for own in places]
            if away and min(away) <= reach:
                found[index] = places[away.index(min(away))]
        return found[0], found[1]

    def _place(self, event: QtGui.QMouseEvent) -> Point:
        return self._scene_point(_pos(event))

    def _scene_point(self, pos: QtCore.QPoint) -> Point:
        found = self.mapToScene(pos)
        return found.x(), found.y()

    def _end(self, event: QtGui.QMouseEvent) -> Point:
        """Where a drag is: level or upright for a line, unless Alt frees it."""
        x, y = self._place(event)
        alt = event.modifiers() & QtCore.Qt.KeyboardModifier.AltModifier
        if self.tool == "line" and self._pressed is not None and not alt:
            a, b = self._snapped(self._pressed)
            return (x, b) if abs(x - a) >= abs(y - b) else (a, y)
        return x, y

    def _on_screen(self, length: float) -> float:
        return length * self.transform().m11()

    def _show_rubber(self, start: Point, end: Point) -> None:
        self._drop_rubber()
        path = QtGui.QPainterPath()
        if self.tool == "line":
            path.moveTo(*start)
            path.lineTo(*end)
        elif self.tool == "circle":
            radius = hypot(end[0] - start[0], end[1] - start[1])
            path.addEllipse(QtCore.QPointF(*start), radius, radius)
        else:
            x0, y0, x1, y1 = _box(start, end)
            path.addRect(x0, y0, x1 - x0, y1 - y0)
        pen = QtGui.QPen(QtGui.QColor("#28a0dc"), 1.5, QtCore.Qt.PenStyle.DashLine)
        pen.setCosmetic(True)
        self._rubber = self.scene().addPath(path, pen)
        self._rubber.setZValue(3.0)

    def _drop_rubber(self) -> None:
        if self._rubber is not None:
            self.scene().removeItem(self._rubber)
            self._rubber = None

    def _show_strokes(self, shown: bool) -> None:
        for item in (*self._items.values(), *self._over):
            item.setVisible(shown)
        if self._picture is not None:
            self._picture.setOpacity(_PALE if shown else 1.0)

    def _add_view(
        self, name: str, role: str, box: tuple[float, float, float, float], used: bool
    ) -> None:
        colour = QtGui.QColor("#28a0dc" if used and role != "ignore" else "#bebebe")
        pen = QtGui.QPen(colour, 1.0, QtCore.Qt.PenStyle.DotLine)
        pen.setCosmetic(True)
        x0, y0, x1, y1 = box
        frame = self.scene().addRect(x0 - 4.0, y0 - 4.0, x1 - x0 + 8.0, y1 - y0 + 8.0, pen)
        label = self.scene().addSimpleText(name_of(role if role in ROLES else name))
        label.setBrush(colour)
        label.setPos(x0 - 4.0, y0 - 4.0)
        label.setFlag(QtWidgets.QGraphicsItem.GraphicsItemFlag.ItemIgnoresTransformations)
        for item in (frame, label):
            item.setZValue(-1.0)
            self._over.append(item)

    def _pen(self, own: Stroke) -> QtGui.QPen:
        doubtful = own.kind in DRAWN and own.confidence < DOUBT and not own.given
        colour = QtGui.QColor(DOUBTFUL if doubtful else COLOURS.get(own.kind, OTHER))
        width = 2.0 if own.kind in DRAWN else 1.0
        if own.id in self._chosen:
            colour, width = QtGui.QColor("#dc1e1e"), width + 2.0
        styles = QtCore.Qt.PenStyle
        dashed = own.kind == "hidden"
        pen = QtGui.QPen(colour, width, styles.DashLine if dashed else styles.SolidLine)
        pen.setCosmetic(True)
        return pen


def _box(one: Point, other: Point) -> tuple[float, float, float, float]:
    (a, b), (c, d) = one, other
    return min(a, c), min(b, d), max(a, c), max(b, d)


def _distance(points: list[Point], at: Point) -> float:
    """Distance of a place from a chain of points."""
    best = float("inf")
    for (x0, y0), (x1, y1) in pairwise(points):
        dx, dy = x1 - x0, y1 - y0
        length = dx * dx + dy * dy
        share = 0.0
        if length:
            share = min(1.0, max(0.0, ((at[0] - x0) * dx + (at[1] - y0) * dy) / length))
        away = hypot(at[0] - x0 - share * dx, at[1] - y0 - share * dy)
        best = min(best, away)
    return best


def _pos(event: QtGui.QMouseEvent) -> QtCore.QPoint:
    """Where the mouse is, px of the widget: Qt 6 and Qt 5 tell it differently."""
    return event.position().toPoint() if hasattr(event, "position") else event.pos()
