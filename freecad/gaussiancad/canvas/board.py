"""The canvas: a sheet that can be touched, and the gestures that correct it.

Every gesture ends in operations of ``corrections.json``, which :attr:`Board.said` sends; what is
shown changes only when whoever keeps them calls :meth:`Board.show_sheet`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import hypot, pi

from freecad.gaussiancad.canvas.handles import (
    box_between,
    corners_of,
    handles_of,
    with_corner,
    with_handle,
)
from freecad.gaussiancad.canvas.kinds import KEYS, ROLES, name_of
from freecad.gaussiancad.canvas.scene import Mark, SheetScene, frame_of, handle_places
from freecad.gaussiancad.canvas.sheet import (
    Box,
    Number,
    Point,
    Sheet,
    Stroke,
    View,
    arc_through,
    distance,
)
from freecad.gaussiancad.canvas.snapping import snapped
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_SNAP = 10.0
"""px of the screen within which a place snaps to another."""

_CLICK = 6.0
"""px of the screen by which a stroke, a frame or a handle may be missed."""

_ZOOM = 1.25
_LEAST = 4.0
"""px of the screen that a drag is long at least."""

_MOST_ZOOM = 40.0

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

_SQUARE = ("line", "plane")
"""Tools whose lines are level or upright, unless Alt frees them."""


class Board(QtWidgets.QGraphicsView):
    """A sheet that can be touched.

    Signals:
        said: operations that one gesture means.
        asked_length: two points of the sheet whose distance a person shall tell.
        asked_role: a box of the sheet whose role a person shall tell.
        asked_view: the role of a box of the sheet, which a person has told.
        asked_value: a :class:`.Number` that a person shall tell.
        asked_depth: a circle (centre, radius) of a hole whose depth a person shall tell.
        asked_section: a line in a view, and the view's id: which section cuts there.
        asked_trace: a place whose ink is to become a stroke.
        asked_next: the next problem is to be shown.
        asked_part: the part is to be made.
        chosen: what is selected has changed.
    """

    said = QtCore.Signal(list)
    asked_length = QtCore.Signal(tuple)
    asked_role = QtCore.Signal(tuple)
    asked_view = QtCore.Signal(str, tuple)
    asked_value = QtCore.Signal(object)
    asked_depth = QtCore.Signal(tuple)
    asked_section = QtCore.Signal(tuple, str)
    asked_trace = QtCore.Signal(tuple)
    asked_next = QtCore.Signal()
    asked_part = QtCore.Signal()
    chosen = QtCore.Signal()

    def __init__(self, parent: QtWidgets.QWidget | None = None) -> None:
        super().__init__(parent)
        self._drawing = SheetScene(self)
        self.setScene(self._drawing)
        self.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        self.setTransformationAnchor(QtWidgets.QGraphicsView.ViewportAnchor.AnchorUnderMouse)
        self.setFocusPolicy(QtCore.Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.tool = ""
        self._sheet: Sheet | None = None
        self._chosen: set[str] = set()
        self._pressed: Point | None = None
        self._held: int | None = None
        self._clicked: list[Point] = []
        self._panned: QtCore.QPoint | None = None

    @property
    def selected(self) -> list[Stroke]:
        """The strokes that are selected."""
        strokes = self._sheet.strokes if self._sheet is not None else ()
        return [own for own in strokes if own.id in self._chosen]

    @property
    def selected_view(self) -> View | None:
        """The view that is selected alone."""
        views = self._sheet.views if self._sheet is not None else ()
        return next((own for own in views if self._chosen == {own.id}), None)

    def show_picture(self, path: str, size: tuple[int, int] | None) -> None:
        """Show the picture of a sheet that is ``size`` px large as stored."""
        self._drawing.show_picture(path, size)

    def show_sheet(self, sheet: Sheet) -> None:
        """Show strokes and views; what was selected stays so where it is still there."""
        self._sheet = sheet
        known = {own.id for own in (*sheet.strokes, *sheet.views)}
        self._chosen &= known
        self._drawing.show_sheet(sheet, self._chosen)
        self._drawing.show_chosen(sheet, self._chosen)

    def show_marks(self, marks: Iterable[Mark]) -> None:
        """Show places of problems and disagreements."""
        self._drawing.show_marks(marks)

    def set_layer(self, name: str, shown: bool) -> None:
        """Show a layer, or not."""
        self._drawing.set_layer(name, shown)

    def fit(self) -> None:
        """Show the whole sheet."""
        self.fitInView(self.sceneRect(), QtCore.Qt.AspectRatioMode.KeepAspectRatio)

    def zoom_to(self, box: Box) -> None:
        """Show a box of the sheet and a little around it."""
        x0, y0, x1, y1 = box
        view = self._sheet.view_at(((x0 + x1) / 2.0, (y0 + y1) / 2.0)) if self._sheet else None
        wide = max(view.box[2] - view.box[0], view.box[3] - view.box[1]) if view else 0.0
        # Half a view stays in sight: without it a place says nothing.
        margin = max(0.1 * max(x1 - x0, y1 - y0), 40.0, (wide / 2.0 - max(x1 - x0, y1 - y0)) / 2.0)
        rect = QtCore.QRectF(x0, y0, x1 - x0, y1 - y0)
        rect = rect.adjusted(-margin, -margin, margin, margin)
        self.fitInView(rect, QtCore.Qt.AspectRatioMode.KeepAspectRatio)

    def take_tool(self, tool: str) -> None:
        """What the mouse does next; nothing but selecting where it is empty."""
        self.tool = tool
        self._clicked = []
        self._drawing.drop_rubber()
        cross = QtCore.Qt.CursorShape.CrossCursor
        self.viewport().setCursor(cross if tool else QtCore.Qt.CursorShape.ArrowCursor)

    def select(self, ids: set[str]) -> None:
        """Select strokes, or a view, by their ids, and no others."""
        before, self._chosen = self.selected_view, set(ids)
        if self._sheet is None:
            return
        if before is not None or self.selected_view is not None:
            self._drawing.show_sheet(self._sheet, self._chosen)
        self._drawing.show_chosen(self._sheet, self._chosen)
        self.chosen.emit()

    def give_kind(self, kind: str) -> None:
        """Say that what is selected stands for a kind."""
        chosen = [own for own in self.selected if own.kind != kind]
        self._say([{"op": "kind", "target": own.target(), "to": kind} for own in chosen])

    def give_role(self, role: str) -> None:
        """Say what the selected view shows; what was no view yet is boxed, so that it is read."""
        view = self.selected_view
        if view is None or view.role == role:
            return
        if role in ROLES and not view.shown:
            self.asked_view.emit(role, frame_of(view))
        else:
            self._say([{"op": "view", "id": view.id, "role": role}])

    def erase(self) -> None:
        """Say that what is selected is not there."""
        self._say([{"op": "erase", "target": own.target()} for own in self.selected])
        self.give_role("ignore")

    def event(self, event: QtCore.QEvent) -> bool:
        """Keep single keys: in FreeCAD they would delete objects and turn the 3D view."""
        if event.type() == QtCore.QEvent.Type.ShortcutOverride:
            control = QtCore.Qt.KeyboardModifier.ControlModifier
            if not event.modifiers() & control:
                event.accept()
                return True
        return super().event(event)

    def focusNextPrevChild(self, _forward: bool) -> bool:
        """Tab is a key of the canvas."""
        return False

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        """Kinds, roles, tools, Del, Esc, Tab, Enter; Space shows the bare ink."""
        key, keys = event.key(), QtCore.Qt.Key
        if event.modifiers() & QtCore.Qt.KeyboardModifier.ControlModifier:
            super().keyPressEvent(event)
            return
        name = chr(key) if keys.Key_A <= key <= keys.Key_Z else ""
        if name in KEYS:
            self.give_kind(KEYS[name])
        elif name in TOOLS:
            self.take_tool(TOOLS[name])
        elif keys.Key_1 <= key <= keys.Key_6:
            self.give_role(ROLES[key - keys.Key_1])
        elif key in self._plain_keys:
            self._plain_keys[key]()
        event.accept()

    @property
    def _plain_keys(self) -> dict[QtCore.Qt.Key, Callable[[], None]]:
        keys = QtCore.Qt.Key
        return {
            keys.Key_Delete: self.erase,
            keys.Key_Backspace: self.erase,
            keys.Key_Escape: self._leave,
            keys.Key_Return: self.asked_part.emit,
            keys.Key_Enter: self.asked_part.emit,
            keys.Key_Tab: self.asked_next.emit,
            keys.Key_Space: lambda: self._drawing.show_bare(True),
            keys.Key_Home: self.fit,
        }

    def keyReleaseEvent(self, event: QtGui.QKeyEvent) -> None:
        """Everything comes back when Space is let go."""
        if event.key() == QtCore.Qt.Key.Key_Space and not event.isAutoRepeat():
            self._drawing.show_bare(False)
        event.accept()

    def wheelEvent(self, event: QtGui.QWheelEvent) -> None:
        """Zoom at the cursor."""
        factor = _ZOOM if event.angleDelta().y() > 0 else 1.0 / _ZOOM
        if factor * self._zoom <= _MOST_ZOOM:
            self.scale(factor, factor)
        event.accept()

    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:
        """Begin to select, to draw, to move a handle or to pan."""
        if event.button() == QtCore.Qt.MouseButton.MiddleButton:
            self._panned = _pos(event)
        elif event.button() == QtCore.Qt.MouseButton.LeftButton and self._sheet is not None:
            self.setFocus()
            self._pressed = self._place(event)
            self._held = None if self.tool else self._handle_at(self._pressed)
        event.accept()

    def mouseMoveEvent(self, event: QtGui.QMouseEvent) -> None:
        """Pan, or show what would be made."""
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
            held, self._held, self._pressed = self._held, None, None
            self._drawing.drop_rubber()
            dragged = self._zoom * hypot(end[0] - start[0], end[1] - start[1]) >= _LEAST
            shift = bool(event.modifiers() & QtCore.Qt.KeyboardModifier.ShiftModifier)
            if held is not None and dragged:
                self._move(held, end)
            else:
                self._finish(start, end, dragged=dragged, shift=shift)
        event.accept()

    def mouseDoubleClickEvent(self, event: QtGui.QMouseEvent) -> None:
        """A number is told anew."""
        found = self._number_at(self._place(event))
        if found is not None:
            self.asked_value.emit(found)
        event.accept()

    def contextMenuEvent(self, event: QtGui.QContextMenuEvent) -> None:
        """What may be said of what is under the mouse, or selected."""
        at = self._scene_point(event.pos())
        found = self._stroke_at(at)
        view = self._view_at(at) if found is None else None
        name = found.id if found is not None else view.id if view is not None else None
        if name is not None and name not in self._chosen:
            self.select({name})
        menu = QtWidgets.QMenu(self)
        if self.selected:
            self._offer_kinds(menu)
        elif self.selected_view is not None:
            self._offer_roles(menu)
        if not menu.isEmpty():
            menu.popup(event.globalPos())

    def select_alike(self) -> None:
        """Select all strokes that are like those selected."""
        own = {other.id for each in self.selected for other in self._sheet.like(each)}
        self.select(own)

    def tell_hole(self, circle: tuple[float, float, float], depth_mm: float | None) -> None:
        """Say how deep the hole of a circle is; None for one that goes through."""
        told = {"through": True} if depth_mm is None else {"depth_mm": depth_mm}
        self._say([{"op": "note", "circle": list(circle), **told}])

    def draw(self, shape: tuple[str, tuple], at: Point, kind: str = "visible") -> bool:
        """Say that there is a stroke, in the view around a place; whether there is such a view.

        The stroke is selected then: a key gives it another kind.
        """
        view = self._sheet.view_at(at) if self._sheet is not None else None
        if view is None:
            return False
        name, numbers = shape
        self._say([{"op": "draw", "view": view.id, "kind": kind, name: numbers}])
        made = [own.id for own in self._sheet.strokes if own.given and own.shape == shape]
        self.select(set(made[-1:]))
        return True

    def _offer_kinds(self, menu: QtWidgets.QMenu) -> None:
        for key, kind in KEYS.items():
            action = menu.addAction(f"{name_of(kind)}\t{key}")
            action.triggered.connect(lambda _=False, own=kind: self.give_kind(own))
        circles = [own.circle for own in self.selected if own.circle is not None]
        if len(self.selected) == 1 and circles:
            menu.addSeparator()
            through = menu.addAction(translate("GaussianCAD", "Hole Goes Through"))
            through.triggered.connect(lambda: self.tell_hole(circles[0], None))
            deep = menu.addAction(translate("GaussianCAD", "Depth of Hole\u2026"))
            deep.triggered.connect(lambda: self.asked_depth.emit(circles[0]))
        menu.addSeparator()
        like = menu.addAction(translate("GaussianCAD", "Select all like this"))
        like.triggered.connect(self.select_alike)
        gone = menu.addAction(translate("GaussianCAD", "Erase") + "\tDel")
        gone.triggered.connect(self.erase)

    def _offer_roles(self, menu: QtWidgets.QMenu) -> None:
        for number, role in enumerate(ROLES, start=1):
            action = menu.addAction(f"{name_of(role)}\t{number}")
            action.triggered.connect(lambda _=False, own=role: self.give_role(own))
        for role in ("pictorial", "detail", "ignore"):
            action = menu.addAction(name_of(role))
            action.triggered.connect(lambda _=False, own=role: self.give_role(own))

    def _leave(self) -> None:
        self._pressed = self._held = None
        self.take_tool("")
        self.select(set())

    def _say(self, operations: list[dict]) -> None:
        if operations:
            self.said.emit(operations)

    def _finish(self, start: Point, end: Point, *, dragged: bool, shift: bool) -> None:
        """A press and a release, with the tool that is taken."""
        clicks = {"scale": self._click_scale, "arc": self._click_arc, "pick": self._click_ink}
        drags = {
            "line": self._drag_line,
            "circle": self._drag_circle,
            "view": self._drag_view,
            "plane": self._drag_plane,
            "ignore-area": self._drag_area,
        }
        if self.tool in clicks:
            clicks[self.tool](end)
        elif not dragged:
            self._click(end, shift=shift)
        elif self.tool in drags:
            drags[self.tool](start, end)
        else:
            self._band(start, end, shift=shift)

    def _click_scale(self, at: Point) -> None:
        self._clicked.append(self._snapped(at))
        if len(self._clicked) == 2:
            places = tuple(self._clicked)
            self.take_tool("")
            self.asked_length.emit(places)

    def _click_arc(self, at: Point) -> None:
        self._clicked.append(self._snapped(at))
        if len(self._clicked) == 3:
            shape, first = arc_through(*self._clicked), self._clicked[0]
            self._clicked = []
            if shape is not None:
                self.draw(("arc", shape), first)

    def _click_ink(self, at: Point) -> None:
        self.asked_trace.emit(at)

    def _drag_line(self, start: Point, end: Point) -> None:
        first = self._snapped(start)
        self.draw(("line", (first, self._snapped(end, first))), first)

    def _drag_circle(self, start: Point, end: Point) -> None:
        centre = self._snapped(start)
        radius = hypot(end[0] - centre[0], end[1] - centre[1])
        self.draw(("arc", (*centre, radius, 0.0, round(2.0 * pi, 6))), centre)

    def _drag_view(self, start: Point, end: Point) -> None:
        self.take_tool("")
        self.asked_role.emit(box_between(start, end))

    def _drag_plane(self, start: Point, end: Point) -> None:
        first = self._snapped(start)
        view = self._sheet.view_at(((start[0] + end[0]) / 2.0, (start[1] + end[1]) / 2.0))
        if view is not None:
            self.take_tool("")
            self.asked_section.emit((first, self._snapped(end)), view.id)

    def _drag_area(self, start: Point, end: Point) -> None:
        self.take_tool("")
        corners = corners_of(box_between(start, end))
        self._say([{"op": "region", "polygon": corners, "kind": "ignore"}])

    def _move(self, index: int, to: Point) -> None:
        """A handle of what is selected was moved."""
        view = self.selected_view
        if view is not None:
            box = list(with_corner(view.box, index, to))
            self._say([{"op": "view", "id": view.id, "role": view.role, "box": box}])
            return
        (own,) = self.selected
        name, numbers = with_handle(own.shape, index, self._snapped(to))
        drawn = {"op": "draw", "view": own.view, "kind": own.kind, name: numbers}
        self._say([{"op": "erase", "target": own.target()}, drawn])

    def _click(self, at: Point, *, shift: bool) -> None:
        found = self._stroke_at(at) or (None if shift else self._view_at(at))
        chosen = {found.id} if found is not None else set()
        self.select(self._chosen ^ chosen if shift else chosen)

    def _band(self, start: Point, end: Point, *, shift: bool) -> None:
        """Select what lies in a rubber band; drawn to the left, also what it touches."""
        x0, y0, x1, y1 = box_between(start, end)
        touching = end[0] < start[0]
        found = set()
        for own in self._sheet.strokes:
            inside = [x0 <= x <= x1 and y0 <= y <= y1 for x, y in own.points()]
            if all(inside) or (touching and any(inside)):
                found.add(own.id)
        self.select(self._chosen | found if shift else found)

    def _stroke_at(self, at: Point) -> Stroke | None:
        """The stroke nearest to a place, those of the part first."""
        return self._sheet.stroke_at(at, _CLICK / self._zoom) if self._sheet is not None else None

    def _view_at(self, at: Point) -> View | None:
        """The view whose frame is at a place."""
        reach = _CLICK / self._zoom
        for own in self._sheet.views if self._sheet is not None else ():
            corners = corners_of(frame_of(own))
            if distance([*corners, corners[0]], at) <= reach:
                return own
        return None

    def _number_at(self, at: Point) -> Number | None:
        for own in self._sheet.numbers if self._sheet is not None else ():
            x0, y0, x1, y1 = own.box
            if x0 <= at[0] <= x1 and y0 <= at[1] <= y1:
                return own
        return None

    def _handle_at(self, at: Point) -> int | None:
        reach = _CLICK / self._zoom
        for index, (x, y) in enumerate(handle_places(self._sheet, self._chosen)):
            if hypot(x - at[0], y - at[1]) <= reach:
                return index
        return None

    def _snapped(self, at: Point, start: Point | None = None) -> Point:
        return snapped(self._sheet, at, _SNAP / self._zoom, start)

    @property
    def _zoom(self) -> float:
        """px of the screen per px of the sheet."""
        return max(self.transform().m11(), 1e-9)

    def _place(self, event: QtGui.QMouseEvent) -> Point:
        return self._scene_point(_pos(event))

    def _scene_point(self, pos: QtCore.QPoint) -> Point:
        found = self.mapToScene(pos)
        return found.x(), found.y()

    def _end(self, event: QtGui.QMouseEvent) -> Point:
        """Where a drag is: level or upright for a line, unless Alt frees it."""
        x, y = self._place(event)
        alt = event.modifiers() & QtCore.Qt.KeyboardModifier.AltModifier
        if self.tool in _SQUARE and self._pressed is not None and not alt:
            a, b = self._snapped(self._pressed)
            return (x, b) if abs(x - a) >= abs(y - b) else (a, y)
        return x, y

    def _show_rubber(self, start: Point, end: Point) -> None:
        path = QtGui.QPainterPath()
        if self._held is not None and self.selected:
            start = handles_of(self.selected[0])[1 - self._held]
        if self.tool in _SQUARE or (self._held is not None and self.selected):
            path.moveTo(*start)
            path.lineTo(*end)
        elif self.tool == "circle":
            radius = hypot(end[0] - start[0], end[1] - start[1])
            path.addEllipse(QtCore.QPointF(*start), radius, radius)
        else:
            if self._held is not None:
                start = corners_of(self.selected_view.box)[(self._held + 2) % 4]
            x0, y0, x1, y1 = box_between(start, end)
            path.addRect(x0, y0, x1 - x0, y1 - y0)
        self._drawing.show_rubber(path)


def _pos(event: QtGui.QMouseEvent) -> QtCore.QPoint:
    """Where the mouse is, px of the widget: Qt 6 and Qt 5 tell it differently."""
    return event.position().toPoint() if hasattr(event, "position") else event.pos()
