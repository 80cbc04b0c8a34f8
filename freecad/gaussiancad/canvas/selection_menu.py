"""What may be said of what is selected on the canvas, as a menu at the mouse."""

from __future__ import annotations

from freecad.gaussiancad.canvas.canvas_view import CanvasView
from freecad.gaussiancad.canvas.kinds import KEYS, ROLES, name_of
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtWidgets


class SelectionMenu(QtCore.QObject):
    """Lists kinds for strokes, and roles for a view, where the canvas asks for it.

    Args:
        canvas_view: the canvas, its owner.
    """

    def __init__(self, canvas_view: CanvasView) -> None:
        super().__init__(canvas_view)
        self._canvas_view = canvas_view
        canvas_view.asked_menu.connect(self.show_at)

    def show_at(self, place: QtCore.QPoint) -> None:
        """Open the menu at a px of the screen; there is none where nothing is selected."""
        menu = QtWidgets.QMenu(self._canvas_view)
        if self._canvas_view.selected:
            self._offer_kinds(menu)
        elif self._canvas_view.selected_view is not None:
            self._offer_roles(menu)
        if not menu.isEmpty():
            menu.popup(place)

    def _offer_kinds(self, menu: QtWidgets.QMenu) -> None:
        canvas_view = self._canvas_view
        for key, kind in KEYS.items():
            action = menu.addAction(f"{name_of(kind)}\t{key}")
            action.triggered.connect(lambda _=False, item=kind: canvas_view.set_kind(item))
        circles = [item.circle for item in canvas_view.selected if item.circle is not None]
        if len(canvas_view.selected) == 1 and circles:
            menu.addSeparator()
            through = menu.addAction(translate("GaussianCAD", "Hole Goes Through"))
            through.triggered.connect(lambda: canvas_view.set_hole_depth(circles[0], None))
            deep = menu.addAction(translate("GaussianCAD", "Depth of Hole\u2026"))
            deep.triggered.connect(lambda: canvas_view.asked_depth.emit(circles[0]))
        menu.addSeparator()
        like = menu.addAction(translate("GaussianCAD", "Select all like this"))
        like.triggered.connect(canvas_view.select_alike)
        gone = menu.addAction(translate("GaussianCAD", "Erase") + "\tDel")
        gone.triggered.connect(canvas_view.erase)

    def _offer_roles(self, menu: QtWidgets.QMenu) -> None:
        canvas_view = self._canvas_view
        for number, role in enumerate(ROLES, start=1):
            action = menu.addAction(f"{name_of(role)}\t{number}")
            action.triggered.connect(lambda _=False, item=role: canvas_view.set_role(item))
        for role in ("pictorial", "detail", "ignore"):
            action = menu.addAction(name_of(role))
            action.triggered.connect(lambda _=False, item=role: canvas_view.set_role(item))
