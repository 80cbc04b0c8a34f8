"""What the canvas draws: the pale sheet, views, strokes by kind, numbers, planes, marks, handles.

Everything is in px of the sheet as stored; lines and texts keep their width on the screen.
"""

from __future__ import annotations

from collections.abc import Iterable, Set

from freecad.gaussiancad.canvas.changes import Change
from freecad.gaussiancad.canvas.doubts import doubt_in_words
from freecad.gaussiancad.canvas.handles import corners_of, handles_of
from freecad.gaussiancad.canvas.kinds import (
    CHOSEN,
    COLOURS,
    DOUBTFUL,
    DRAWN,
    MARK,
    OTHER,
    PLANE,
    ROLES,
    UNUSED,
    VIEW,
    name_of,
)
from freecad.gaussiancad.canvas.labels import Label, labels_of
from freecad.gaussiancad.canvas.legible import ink_on
from freecad.gaussiancad.canvas.sheet import Box, Point, Sheet, Stroke, View
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

LAYERS = ("sheet", "views", "strokes", "annotation", "numbers", "planes", "marks")
"""What can be shown or not, from the bottom up."""

PALE = 0.45
"""Opacity of the sheet under its strokes."""

_LABEL = 16.0
"""px of the screen that a view's name stands above its frame."""

_HANDLE = 4.0
"""px of the screen, half a handle."""

_PAPER = "#ffffff"
"""Under the pale sheet and under words, whatever the colour of the window."""

Mark = tuple[Box, str]
"""A place, and what is said of it."""


class SheetScene(QtWidgets.QGraphicsScene):
    """The drawing; what is selected is told by :class:`.CanvasView`."""

    def __init__(self, parent: QtCore.QObject | None = None) -> None:
        super().__init__(parent)
        self._picture: QtWidgets.QGraphicsPixmapItem | None = None
        self._layers: dict[str, list[QtWidgets.QGraphicsItem]] = {name: [] for name in LAYERS}
        self._strokes: dict[str, QtWidgets.QGraphicsPathItem] = {}
        self._handles: list[QtWidgets.QGraphicsItem] = []
        self._rubber: QtWidgets.QGraphicsPathItem | None = None
        self._hidden: set[str] = set()
        self._paper: QtWidgets.QGraphicsRectItem | None = None
        self._bare = False
        self._quiet: dict[Label, QtWidgets.QGraphicsSimpleTextItem] = {}
        self._pointed: Point | None = None
        self._changes: tuple[Change, ...] = ()

    def take_changes(self, changes: Iterable[Change]) -> None:
        """Numbers that are others in the body; they show with the next sheet."""
        self._changes = tuple(changes)

    def show_picture(self, path: str, size: tuple[int, int] | None) -> None:
        """Show the picture of a sheet that is ``size`` px large as stored."""
        pixmap = QtGui.QPixmap(path)
        if self._picture is not None:
            self.removeItem(self._picture)
            self.removeItem(self._paper)
        self._picture = self.addPixmap(pixmap)
        self._picture.setTransformationMode(QtCore.Qt.TransformationMode.SmoothTransformation)
        self._picture.setZValue(-2.0)
        if size is not None and pixmap.width():
            self._picture.setScale(size[0] / pixmap.width())
        area = self._picture.sceneBoundingRect()
        self._paper = self.addRect(area, QtGui.QPen(QtCore.Qt.PenStyle.NoPen), QtGui.QColor(_PAPER))
        self._paper.setZValue(-3.0)
        self.setSceneRect(area)
        self._show_layers()

    def show_sheet(self, sheet: Sheet, chosen: Set[str]) -> None:
        """Show what was read, with what is selected."""
        for name in LAYERS[:-1]:
            self._clear(name)
        self._strokes = {}
        for view in sheet.views:
            self._add_view(view, chosen=view.id in chosen)
        for stroke in sheet.strokes:
            self._add_stroke(stroke, chosen=stroke.id in chosen)
        self._quiet = {}
        for label in labels_of(sheet, self._changes):
            self._add_label(label)
        for plane in sheet.planes:
            self._add_plane(plane.label, plane.line)
        self._show_layers()

    def show_marks(self, marks: Iterable[Mark]) -> None:
        """Show places that something is said of, in place of those before."""
        self._clear("marks")
        for (x0, y0, x1, y1), text in marks:
            item = self.addEllipse(x0, y0, x1 - x0, y1 - y0, _pen(MARK, 1.5))
            item.setToolTip(text)
            item.setZValue(2.0)
            self._layers["marks"].append(item)
        self._show_layers()

    def show_chosen(self, sheet: Sheet, chosen: Set[str]) -> None:
        """Show what is selected, and the handles of what is selected alone."""
        for stroke in sheet.strokes:
            self._strokes[stroke.id].setPen(_stroke_pen(stroke, chosen=stroke.id in chosen))
        for item in self._handles:
            self.removeItem(item)
        self._handles = []
        for place in handle_places(sheet, chosen):
            half = QtCore.QRectF(-_HANDLE, -_HANDLE, 2.0 * _HANDLE, 2.0 * _HANDLE)
            item = self.addRect(half, _pen(CHOSEN, 1.5), QtGui.QColor("white"))
            item.setPos(*place)
            item.setFlag(QtWidgets.QGraphicsItem.GraphicsItemFlag.ItemIgnoresTransformations)
            item.setZValue(4.0)
            self._handles.append(item)

    def set_layer(self, name: str, shown: bool) -> None:
        """Show a layer, or not."""
        self._hidden = self._hidden - {name} if shown else self._hidden | {name}
        self._show_layers()

    def point_at(self, place: Point | None) -> None:
        """Write what was read at a place, where it is not written anyway; None for no place."""
        self._pointed = place
        self._show_quiet()

    def show_bare(self, bare: bool) -> None:
        """Show the ink alone, or everything again."""
        self._bare = bare
        self._show_layers()

    def show_rubber(self, path: QtGui.QPainterPath) -> None:
        """Show what a gesture would make."""
        self.drop_rubber()
        self._rubber = self.addPath(path, _pen(VIEW, 1.5, QtCore.Qt.PenStyle.DashLine))
        self._rubber.setZValue(3.0)

    def drop_rubber(self) -> None:
        """Show it no more."""
        if self._rubber is not None:
            self.removeItem(self._rubber)
            self._rubber = None

    def _clear(self, layer: str) -> None:
        for item in self._layers[layer]:
            self.removeItem(item)
        self._layers[layer] = []

    def _show_layers(self) -> None:
        for name, items in self._layers.items():
            for item in items:
                item.setVisible(not self._bare and name not in self._hidden)
        self._show_quiet()
        if self._picture is not None:
            self._picture.setVisible(self._bare or "sheet" not in self._hidden)
            self._picture.setOpacity(1.0 if self._bare else PALE)

    def _show_quiet(self) -> None:
        hidden = self._bare or "numbers" in self._hidden or self._pointed is None
        for label, item in self._quiet.items():
            item.setVisible(not hidden and label.holds(self._pointed))

    def _add_stroke(self, stroke: Stroke, chosen: bool) -> None:
        item = self.addPath(_path(stroke.points()), _stroke_pen(stroke, chosen=chosen))
        item.setZValue(1.0 if stroke.kind in DRAWN else 0.5 if stroke.doubtful else 0.0)
        if stroke.doubtful:
            item.setToolTip(doubt_in_words(stroke))
        self._strokes[stroke.id] = item
        self._layers["strokes" if stroke.kind in DRAWN else "annotation"].append(item)

    def _add_view(self, view: View, chosen: bool) -> None:
        colour = CHOSEN if chosen else VIEW if view.shown else UNUSED
        x0, y0, x1, y1 = view.frame
        pen = _pen(colour, 1.0, QtCore.Qt.PenStyle.DotLine)
        frame = self.addRect(x0, y0, x1 - x0, y1 - y0, pen)
        name = name_of(view.role if view.role in ROLES else view.id)
        label = self._caption(name, colour, (x0, y0), -_LABEL)
        for item in (frame, label):
            item.setZValue(-1.0)
            self._layers["views"].append(item)

    def _add_label(self, label: Label) -> None:
        x0, y0, x1, y1 = label.box
        frame = self.addRect(x0, y0, x1 - x0, y1 - y0, _pen(label.colour, 1.0))
        text = self._caption(label.text, label.colour, (x0, y1))
        text.setZValue(2.5)
        self._layers["numbers"] += [frame, text]
        if label.quiet:
            self._quiet[label] = text

    def _add_plane(self, label: str, line: Iterable[Point]) -> None:
        points = list(line)
        item = self.addPath(_path(points), _pen(PLANE, 2.0, QtCore.Qt.PenStyle.DashDotLine))
        text = self._caption(label, PLANE, points[0])
        for entry in (item, text):
            entry.setZValue(1.5)
            self._layers["planes"].append(entry)

    def _caption(
        self, text: str, colour: str, place: Point, above: float = 0.0
    ) -> QtWidgets.QGraphicsSimpleTextItem:
        """Words at a place, so many px of the screen above or below it.

        They lie on a piece of paper: what is under them does not run through their letters, be it
        lines or the colour of the window.
        """
        item = self.addSimpleText(text)
        item.setBrush(QtGui.QColor(ink_on(_PAPER, colour)))
        item.setPos(*place)
        item.setTransform(QtGui.QTransform.fromTranslate(0.0, above))
        item.setFlag(QtWidgets.QGraphicsItem.GraphicsItemFlag.ItemIgnoresTransformations)
        plate = QtWidgets.QGraphicsRectItem(item.boundingRect(), item)
        plate.setFlag(QtWidgets.QGraphicsItem.GraphicsItemFlag.ItemStacksBehindParent)
        plate.setPen(QtGui.QPen(QtCore.Qt.PenStyle.NoPen))
        plate.setBrush(QtGui.QColor(_PAPER))
        return item


def handle_places(sheet: Sheet, chosen: Set[str]) -> list[Point]:
    """Where handles are: of the one stroke, or the one view, that is selected."""
    if len(chosen) != 1:
        return []
    (name,) = chosen
    stroke = next((this_stroke for this_stroke in sheet.strokes if this_stroke.id == name), None)
    if stroke is not None:
        return handles_of(stroke) if stroke.kind in DRAWN else []
    view = next((this_view for this_view in sheet.views if this_view.id == name), None)
    return corners_of(view.box) if view is not None else []


def _path(points: list[Point]) -> QtGui.QPainterPath:
    path = QtGui.QPainterPath()
    first, *rest = points
    path.moveTo(*first)
    for point in rest:
        path.lineTo(*point)
    return path


def _pen(
    colour: str, width: float, style: QtCore.Qt.PenStyle = QtCore.Qt.PenStyle.SolidLine
) -> QtGui.QPen:
    pen = QtGui.QPen(QtGui.QColor(colour), width, style)
    pen.setCosmetic(True)
    return pen


def _stroke_pen(stroke: Stroke, *, chosen: bool) -> QtGui.QPen:
    colour = DOUBTFUL if stroke.doubtful else COLOURS.get(stroke.kind, OTHER)
    width = 2.0 if stroke.kind in DRAWN or stroke.doubtful else 1.0
    styles = QtCore.Qt.PenStyle
    style = styles.DashLine if stroke.kind == "hidden" else styles.SolidLine
    return _pen(CHOSEN if chosen else colour, width + (2.0 if chosen else 0.0), style)
