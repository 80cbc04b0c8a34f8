"""Which buttons stand above the canvas: tools, choices and layers in one bar, runs in another."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from freecad.gaussiancad.canvas import corrections
from freecad.gaussiancad.canvas.canvas_view import CanvasView
from freecad.gaussiancad.canvas.kinds import KEYS, name_of
from freecad.gaussiancad.canvas.scene import LAYERS
from freecad.gaussiancad.canvas.sheet import Sheet
from freecad.gaussiancad.canvas.tools import DRAWING, TOOLS
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets


class ToolBar(QtWidgets.QToolBar):
    """What the mouse does, what strokes stand for, what the whole sheet is, and what is shown.

    Args:
        canvas_view: the canvas.
        correct: takes operations.
        parent: the window.
    """

    def __init__(
        self,
        canvas_view: CanvasView,
        correct: Callable[[list[dict]], None],
        parent: QtWidgets.QWidget,
    ) -> None:
        super().__init__("GaussianCAD", parent)
        self.setObjectName("GaussianCADCanvas")
        self._canvas_view, self._correct = canvas_view, correct
        draw, kinds = QtWidgets.QMenu(self), QtWidgets.QMenu(self)
        self._add_menu(translate("GaussianCAD", "Draw"), draw)
        for key, name in TOOLS.items():
            place = draw if name in DRAWING else self
            text = f"{name_of(name)} ({key})" if place is self else f"{name_of(name)}\t{key}"
            _add(place, text, partial(canvas_view.take_tool, name))
        for key, kind in KEYS.items():
            _add(kinds, f"{name_of(kind)}\t{key}", partial(canvas_view.set_kind, kind))
        self._add_menu(translate("GaussianCAD", "Kind"), kinds)
        whole = QtWidgets.QMenu(self)
        first = "first", translate("GaussianCAD", "First angle")
        third = "third", translate("GaussianCAD", "Third angle")
        projection, unit = translate("GaussianCAD", "Projection"), translate("GaussianCAD", "Unit")
        units = (("mm", "mm"), ("in", translate("GaussianCAD", "inch")))
        self._projections = self._choice(whole, "projection", projection, (first, third))
        self._units = self._choice(whole, "unit", unit, units)
        self._add_menu(translate("GaussianCAD", "Sheet"), whole)
        self._add_layers()

    def show_choices(self, sheet: Sheet) -> None:
        """Check what holds for a sheet."""
        for menu, value in ((self._projections, sheet.projection), (self._units, sheet.unit)):
            for action in menu.actions():
                action.setChecked(action.data() == value)

    def _choice(
        self, place: QtWidgets.QMenu, name: str, title: str, values: tuple[tuple[str, str], ...]
    ) -> QtWidgets.QMenu:
        """A menu in a menu, with values of which one holds."""
        menu = place.addMenu(title)
        for value, text in values:
            action = _add(
                menu, text, lambda item=value: self._correct(corrections.set_option(name, item))
            )
            action.setData(value)
            action.setCheckable(True)
        return menu

    def _add_layers(self) -> None:
        menu = QtWidgets.QMenu(self)
        for name in LAYERS:
            action = menu.addAction(name_of(name))
            action.setCheckable(True)
            action.setChecked(True)
            action.toggled.connect(partial(self._canvas_view.set_layer, name))
        menu.addSeparator()
        legend = menu.addAction(translate("GaussianCAD", "Legend"))
        legend.setCheckable(True)
        legend.setChecked(True)
        legend.toggled.connect(self._canvas_view.legend.set_wanted)
        self._add_menu(translate("GaussianCAD", "Show"), menu)

    def _add_menu(self, title: str, menu: QtWidgets.QMenu) -> None:
        button = QtWidgets.QToolButton()
        button.setText(title)
        button.setMenu(menu)
        button.setPopupMode(QtWidgets.QToolButton.ToolButtonPopupMode.InstantPopup)
        button.setFocusPolicy(QtCore.Qt.FocusPolicy.NoFocus)
        self.addWidget(button)


class RunBar(QtWidgets.QToolBar):
    """When the part is made, and what else a host adds.

    Args:
        solve: makes the part.
        stop: breaks that off.
        set_live: takes whether the part follows every correction.
        parent: the window.
    """

    def __init__(
        self,
        solve: Callable[[], None],
        stop: Callable[[], None],
        set_live: Callable[[bool], None],
        parent: QtWidgets.QWidget,
    ) -> None:
        super().__init__("GaussianCAD", parent)
        self.setObjectName("GaussianCADRuns")
        live = self.addAction(translate("GaussianCAD", "Solve as I Go"))
        live.setCheckable(True)
        live.setChecked(True)
        live.toggled.connect(set_live)
        made = self.add(translate("GaussianCAD", "Solve"), solve)
        made.setToolTip(translate("GaussianCAD", "Makes the part (Enter)"))
        self._stop = self.add(translate("GaussianCAD", "Stop"), stop)
        self._stop.setToolTip(translate("GaussianCAD", "Breaks off making the part"))
        self.show_work(False)

    def show_work(self, solving: bool) -> None:
        """Offer to break off while a part is made."""
        self._stop.setEnabled(solving)

    def add_steps(self, undo: Callable[[], None], redo: Callable[[], None]) -> None:
        """Offer steps back and forth, with their keys; in FreeCAD these are the document's."""
        keys = QtGui.QKeySequence.StandardKey
        self.add(translate("GaussianCAD", "Undo"), undo).setShortcut(keys.Undo)
        self.add(translate("GaussianCAD", "Redo"), redo).setShortcut(keys.Redo)

    def add(self, text: str, called: Callable[[], None]) -> QtGui.QAction:
        """Put a button at the end."""
        return _add(self, text, called)


def _add(
    place: QtWidgets.QToolBar | QtWidgets.QMenu, text: str, called: Callable[[], None]
) -> QtGui.QAction:
    action = place.addAction(text)
    action.triggered.connect(lambda _=False: called())
    return action
