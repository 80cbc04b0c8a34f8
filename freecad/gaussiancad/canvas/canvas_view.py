"""The canvas: what of a sheet is selected, and what touching it with mouse and keys corrects.

Every gesture ends in operations of ``corrections.json``, which :attr:`CanvasView.corrected` sends;
what is shown changes only when the window calls :meth:`CanvasView.show_sheet`.
"""

from __future__ import annotations

from collections.abc import Callable, Set

from freecad.gaussiancad.canvas import corrections
from freecad.gaussiancad.canvas.gestures import GestureController
from freecad.gaussiancad.canvas.hit_test import HitTest
from freecad.gaussiancad.canvas.kinds import KEYS, ROLES
from freecad.gaussiancad.canvas.sheet import Box, Point, Shape, Sheet, Stroke, View
from freecad.gaussiancad.canvas.sheet_view import SheetView, around, pos_of
from freecad.gaussiancad.canvas.tools import (
    TOOLS,
    Boxed,
    Chosen,
    Cut,
    Drawn,
    Meaning,
    Measured,
    Operations,
    Traced,
)
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_KEY = QtCore.Qt.KeyboardModifier

_EMPTY = Sheet((), (), (), "", None)


class CanvasView(SheetView):
    """A sheet that can be touched.

    Signals:
        corrected: operations that one gesture means.
        asked_more: a sentence: what is missing for what a person wants.
        asked_length: two points of the sheet whose distance a person shall tell.
        asked_role: a box of the sheet whose role a person shall tell.
        asked_view: the role of a box of the sheet, which a person has told.
        asked_value: a :class:`.Number` that a person shall tell.
        asked_depth: a circle (centre, radius) of a hole whose depth a person shall tell.
        asked_section: a line in a view, and the view's id: which section cuts there.
        asked_trace: a place whose ink is to become a stroke.
        asked_menu: what may be said of what is selected is to be listed, at a px of the screen.
        asked_next: the next problem is to be shown.
        asked_part: the part is to be made.
        chosen: what is selected has changed.
    """

    corrected = QtCore.Signal(list)
    asked_more = QtCore.Signal(str)
    asked_length = QtCore.Signal(tuple)
    asked_role = QtCore.Signal(tuple)
    asked_view = QtCore.Signal(str, tuple)
    asked_value = QtCore.Signal(object)
    asked_depth = QtCore.Signal(tuple)
    asked_section = QtCore.Signal(tuple, str)
    asked_trace = QtCore.Signal(tuple)
    asked_menu = QtCore.Signal(QtCore.QPoint)
    asked_next = QtCore.Signal()
    asked_part = QtCore.Signal()
    chosen = QtCore.Signal()

    def __init__(self, parent: QtWidgets.QWidget | None = None) -> None:
        super().__init__(parent)
        self._gestures = GestureController()
        self._sheet: Sheet | None = None
        self._chosen: frozenset[str] = frozenset()
        self._awaited: str | None = None

    @property
    def tool(self) -> str:
        """What the mouse does next, a value of :data:`.TOOLS`; empty for selecting."""
        return self._gestures.tool

    @property
    def selected(self) -> list[Stroke]:
        """The strokes that are selected."""
        return self._hits.selected

    @property
    def selected_view(self) -> View | None:
        """The view that is selected alone."""
        return self._hits.selected_view

    def show_sheet(self, sheet: Sheet) -> None:
        """Show strokes and views; what was selected stays so where it is still there."""
        self._sheet = sheet
        self._chosen &= {stroke.id for stroke in (*sheet.strokes, *sheet.views)}
        self._drawing.show_sheet(sheet, self._chosen)
        self._drawing.show_chosen(sheet, self._chosen)
        self.legend.show_sheet(sheet)

    def zoom_to(self, box: Box) -> None:
        """Show a box of the sheet and a little around it."""
        self.show_box(around(box, self._sheet))

    def take_tool(self, tool: str) -> None:
        """What the mouse does next; nothing but selecting where it is empty."""
        self._gestures.take(tool)
        self._drawing.drop_rubber()
        self._show_cursor()

    def select(self, ids: Set[str]) -> None:
        """Select strokes, or a view, by their ids, and no others."""
        before, self._chosen = self.selected_view, frozenset(ids)
        if self._sheet is None:
            return
        if before is not None or self.selected_view is not None:
            self._drawing.show_sheet(self._sheet, self._chosen)
        self._drawing.show_chosen(self._sheet, self._chosen)
        self.chosen.emit()

    def select_alike(self) -> None:
        """Select all strokes that are like those selected."""
        self.select({other.id for item in self.selected for other in self._sheet.like(item)})

    def set_kind(self, kind: str) -> None:
        """Say that what is selected stands for a kind; of what is in doubt, that it does indeed.

        Ink that is being traced becomes a stroke of that kind.
        """
        if self._awaited is not None:
            self._awaited = kind
            return
        meant = [item for item in self.selected if item.kind != kind or item.doubtful]
        self._correct(corrections.set_kind(meant, kind))

    def set_role(self, role: str) -> None:
        """Say what a view shows: the one that is selected, or whose strokes are."""
        view = self._hits.view_meant
        if view is None:
            self.asked_more.emit(
                translate("GaussianCAD", "Select a view first: click its frame, or a line in it")
            )
            return
        self._set_role(view, role)

    def erase(self) -> None:
        """Say that what is selected is not there."""
        self._correct(corrections.erase_strokes(self.selected))
        if self.selected_view is not None:
            self._set_role(self.selected_view, "ignore")

    def _set_role(self, view: View, role: str) -> None:
        """Say what a view shows; what was no view yet is boxed, so that it is read."""
        if view.role == role:
            return
        if role in ROLES and not view.shown:
            self.asked_view.emit(role, view.frame)
        else:
            self._correct(corrections.set_role(view, role))

    def set_hole_depth(self, circle: corrections.Circle, depth_mm: float | None) -> None:
        """Say how deep the hole of a circle is; None for one that goes through."""
        self._correct(corrections.set_hole(circle, depth_mm))

    def draw(self, shape: Shape, at: Point, kind: str = "visible") -> bool:
        """Say that there is a stroke, in the view around a place; whether there is such a view.

        The stroke is selected then: a key gives it another kind.
        """
        view = self._sheet.view_at(at) if self._sheet is not None else None
        if view is None:
            return False
        self._correct(corrections.draw_stroke(view.id, kind, shape))
        made = [
            stroke.id for stroke in self._sheet.strokes if stroke.given and stroke.shape == shape
        ]
        self.select(set(made[-1:]))
        return True

    def take_trace(self, shape: Shape | None, at: Point) -> bool:
        """Take the stroke that was found at a place; whether there is one, in a view.

        Args:
            shape: of the ink there; None where there is none.
            at: the place.
        """
        kind, self._awaited = self._awaited or "visible", None
        return shape is not None and self.draw(shape, at, kind)

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        """Kinds, roles, tools, Del, Esc, Tab, Enter."""
        control = event.modifiers() & _KEY.ControlModifier
        called = None if control else self._called_by(event.key())
        if called is None:
            super().keyPressEvent(event)
        else:
            called()
            event.accept()

    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:
        """Begin to select, to draw, to move a handle or to pan."""
        if event.button() == QtCore.Qt.MouseButton.LeftButton and self._sheet is not None:
            self.setFocus()
            self._gestures.press(self.place(pos_of(event)), self._hits)
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QtGui.QMouseEvent) -> None:
        """Pan, or show what would be made."""
        if self._gestures.began and not self.panning:
            at = self.place(pos_of(event))
            path = self._gestures.rubber(at, self._hits, free=_held(event, _KEY.AltModifier))
            if path is not None:
                self._drawing.show_rubber(path)
        super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QtGui.QMouseEvent) -> None:
        """End what was begun."""
        super().mouseReleaseEvent(event)
        if event.button() == QtCore.Qt.MouseButton.LeftButton and self._gestures.began:
            self._drawing.drop_rubber()
            at = self.place(pos_of(event))
            free, more = _held(event, _KEY.AltModifier), _held(event, _KEY.ShiftModifier)
            meaning = self._gestures.release(at, self._hits, free=free, more=more)
            self._show_cursor()
            if meaning is not None:
                self._do(meaning)

    def mouseDoubleClickEvent(self, event: QtGui.QMouseEvent) -> None:
        """A number is told anew."""
        found = self._hits.number_at(self.place(pos_of(event)))
        if found is not None:
            self.asked_value.emit(found)
        event.accept()

    def contextMenuEvent(self, event: QtGui.QContextMenuEvent) -> None:
        """Select what is under the mouse, and ask for a menu."""
        at, hits = self.place(event.pos()), self._hits
        found = hits.stroke_at(at) or hits.view_at(at)
        if found is not None and found.id not in self._chosen:
            self.select({found.id})
        self.asked_menu.emit(event.globalPos())

    @property
    def _hits(self) -> HitTest:
        return HitTest(self._sheet or _EMPTY, self._chosen, self.zoom)

    def _called_by(self, key: int) -> Callable[[], None] | None:
        """What a key does; None where it does nothing here."""
        keys = QtCore.Qt.Key
        name = chr(key) if keys.Key_A <= key <= keys.Key_Z else ""
        if name in KEYS:
            return lambda: self.set_kind(KEYS[name])
        if name in TOOLS:
            return lambda: self.take_tool(TOOLS[name])
        if keys.Key_1 <= key <= keys.Key_6:
            return lambda: self.set_role(ROLES[key - keys.Key_1])
        return {
            keys.Key_Delete: self.erase,
            keys.Key_Backspace: self.erase,
            keys.Key_Escape: self._leave,
            keys.Key_Return: self.asked_part.emit,
            keys.Key_Enter: self.asked_part.emit,
            keys.Key_Tab: self.asked_next.emit,
        }.get(key)

    def _leave(self) -> None:
        self._gestures.drop()
        self.take_tool("")
        self.select(set())

    def _show_cursor(self) -> None:
        shapes = QtCore.Qt.CursorShape
        self.viewport().setCursor(shapes.CrossCursor if self.tool else shapes.ArrowCursor)

    def _correct(self, operations: list[dict]) -> None:
        if operations:
            self.corrected.emit(operations)

    def _do(self, meaning: Meaning) -> None:
        match meaning:
            case Operations(operations):
                self._correct(operations)
            case Chosen(ids):
                self.select(ids)
            case Drawn(shape, at):
                if not self.draw(shape, at):
                    text = translate("GaussianCAD", "There is no view at this place")
                    self.asked_more.emit(text)
            case Traced(at):
                self._awaited = "visible"
                self.asked_trace.emit(at)
            case Measured(points):
                self.asked_length.emit(points)
            case Boxed(box):
                self.asked_role.emit(box)
            case Cut(line, in_view):
                self.asked_section.emit(line, in_view)


def _held(event: QtGui.QMouseEvent, key: QtCore.Qt.KeyboardModifier) -> bool:
    """Whether a key was held while the mouse did something."""
    return bool(event.modifiers() & key)
