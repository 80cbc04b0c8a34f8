"""How a sheet is seen: its picture and layers, zoom and panning, and the keys for these."""

from __future__ import annotations

from collections.abc import Iterable

from freecad.gaussiancad.canvas.changes import Change
from freecad.gaussiancad.canvas.legend import Legend
from freecad.gaussiancad.canvas.scene import Mark, SheetScene
from freecad.gaussiancad.canvas.sheet import Box, Point, Sheet
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_ZOOM = 1.25
_MOST_ZOOM = 40.0


class SheetView(QtWidgets.QGraphicsView):
    """A sheet that can be looked at: the wheel zooms, the middle button pans.

    Single keys stay here: in FreeCAD they would delete objects and turn the 3D view.
    """

    def __init__(self, parent: QtWidgets.QWidget | None = None) -> None:
        super().__init__(parent)
        self._drawing = SheetScene(self)
        self.setScene(self._drawing)
        self.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        # Qt would zoom at where it last saw the mouse move, which is told to this class alone.
        self.setTransformationAnchor(QtWidgets.QGraphicsView.ViewportAnchor.NoAnchor)
        self.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(QtCore.Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self._panned: QtCore.QPoint | None = None
        self.legend = Legend(self)

    @property
    def zoom(self) -> float:
        """px of the screen per px of the sheet."""
        return max(self.transform().m11(), 1e-9)

    @property
    def panning(self) -> bool:
        """Whether the sheet is being pulled about."""
        return self._panned is not None

    def show_picture(self, path: str, size: tuple[int, int] | None) -> None:
        """Show the picture of a sheet that is ``size`` px large as stored."""
        self._drawing.show_picture(path, size)
        # Room around the sheet lets any place of it stand anywhere in the window.
        area = self._drawing.sceneRect()
        wide, high = area.width(), area.height()
        self.setSceneRect(area.adjusted(-wide, -high, wide, high))

    def show_marks(self, marks: Iterable[Mark]) -> None:
        """Show places of problems and disagreements."""
        self._drawing.show_marks(marks)

    def take_changes(self, changes: Iterable[Change]) -> None:
        """Show numbers that are others in the body, with the next sheet."""
        self._drawing.take_changes(changes)

    def set_layer(self, name: str, shown: bool) -> None:
        """Show a layer, or not."""
        self._drawing.set_layer(name, shown)

    def fit(self) -> None:
        """Show the whole sheet."""
        self.fitInView(self._drawing.sceneRect(), QtCore.Qt.AspectRatioMode.KeepAspectRatio)

    def show_box(self, box: Box) -> None:
        """Show a box of the sheet, as large as it can be."""
        x0, y0, x1, y1 = box
        rect = QtCore.QRectF(x0, y0, x1 - x0, y1 - y0)
        self.fitInView(rect, QtCore.Qt.AspectRatioMode.KeepAspectRatio)

    def place(self, pos: QtCore.QPoint) -> Point:
        """The place of the sheet, px, at a px of the widget."""
        found = self.mapToScene(pos)
        return found.x(), found.y()

    def event(self, event: QtCore.QEvent) -> bool:
        """Keep single keys."""
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
        """Space shows the bare ink, Home the whole sheet."""
        if event.modifiers() & QtCore.Qt.KeyboardModifier.ControlModifier:
            super().keyPressEvent(event)
            return
        if event.key() == QtCore.Qt.Key.Key_Space:
            self._drawing.show_bare(True)
        elif event.key() == QtCore.Qt.Key.Key_Home:
            self.fit()
        event.accept()

    def keyReleaseEvent(self, event: QtGui.QKeyEvent) -> None:
        """Everything comes back when Space is let go."""
        if event.key() == QtCore.Qt.Key.Key_Space and not event.isAutoRepeat():
            self._drawing.show_bare(False)
        event.accept()

    def wheelEvent(self, event: QtGui.QWheelEvent) -> None:
        """Zoom: the place under the cursor stays there."""
        factor = _ZOOM if event.angleDelta().y() > 0 else 1.0 / _ZOOM
        if factor * self.zoom <= _MOST_ZOOM:
            cursor = pos_of(event)
            before = self.mapToScene(cursor)
            self.scale(factor, factor)
            moved = self.mapToScene(cursor) - before
            self.translate(moved.x(), moved.y())
        event.accept()

    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:
        """Begin to pan."""
        if event.button() == QtCore.Qt.MouseButton.MiddleButton:
            self._panned = pos_of(event)
        event.accept()

    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:
        """The legend stays in its corner."""
        super().resizeEvent(event)
        self.legend.stay()

    def leaveEvent(self, event: QtCore.QEvent) -> None:
        """What was written at the mouse goes with it."""
        self._drawing.point_at(None)
        super().leaveEvent(event)

    def mouseMoveEvent(self, event: QtGui.QMouseEvent) -> None:
        """Pan; what is quiet is written where the mouse is."""
        self._drawing.point_at(self.place(pos_of(event)))
        if self._panned is not None:
            moved = pos_of(event) - self._panned
            self._panned = pos_of(event)
            for bar, step in (
                (self.horizontalScrollBar(), moved.x()),
                (self.verticalScrollBar(), moved.y()),
            ):
                bar.setValue(bar.value() - step)
        event.accept()

    def mouseReleaseEvent(self, event: QtGui.QMouseEvent) -> None:
        """Pan no more."""
        self._panned = None
        event.accept()


def pos_of(event: QtGui.QMouseEvent | QtGui.QWheelEvent) -> QtCore.QPoint:
    """Where the mouse is, px of the widget: Qt 6 and Qt 5 tell it differently."""
    return event.position().toPoint() if hasattr(event, "position") else event.pos()


def around(box: Box, sheet: Sheet | None) -> Box:
    """A box of a sheet and a little around it: half a view, without which a place says nothing."""
    x0, y0, x1, y1 = box
    long = max(x1 - x0, y1 - y0)
    view = sheet.view_at(((x0 + x1) / 2.0, (y0 + y1) / 2.0)) if sheet is not None else None
    wide = max(view.box[2] - view.box[0], view.box[3] - view.box[1]) if view is not None else 0.0
    margin = max(0.1 * long, 40.0, (wide / 2.0 - long) / 2.0)
    return x0 - margin, y0 - margin, x1 + margin, y1 + margin
