"""What may be said of what is selected on the canvas, as a menu at the mouse."""

from __future__ import annotations

from freecad.gaussiancad.canvas.board import Board
from freecad.gaussiancad.canvas.kinds import KEYS, ROLES, name_of
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtWidgets


class SelectionMenu(QtCore.QObject):
    """Lists kinds for strokes, and roles for a view, where the canvas asks for it.

    Args:
        board: the canvas, its owner.
    """

    def __init__(self, board: Board) -> None:
        super().__init__(board)
        self._board = board
        board.asked_menu.connect(self.show_at)

    def show_at(self, place: QtCore.QPoint) -> None:
        """Open the menu at a px of the screen; there is none where nothing is selected."""
        menu = QtWidgets.QMenu(self._board)
        if self._board.selected:
            self._offer_kinds(menu)
        elif self._board.selected_view is not None:
            self._offer_roles(menu)
        if not menu.isEmpty():
            menu.popup(place)

    def _offer_kinds(self, menu: QtWidgets.QMenu) -> None:
        board = self._board
        for key, kind in KEYS.items():
            action = menu.addAction(f"{name_of(kind)}\t{key}")
            action.triggered.connect(lambda _=False, item=kind: board.give_kind(item))
        circles = [item.circle for item in board.selected if item.circle is not None]
        if len(board.selected) == 1 and circles:
            menu.addSeparator()
            through = menu.addAction(translate("GaussianCAD", "Hole Goes Through"))
            through.triggered.connect(lambda: board.tell_hole(circles[0], None))
            deep = menu.addAction(translate("GaussianCAD", "Depth of Hole\u2026"))
            deep.triggered.connect(lambda: board.asked_depth.emit(circles[0]))
        menu.addSeparator()
        like = menu.addAction(translate("GaussianCAD", "Select all like this"))
        like.triggered.connect(board.select_alike)
        gone = menu.addAction(translate("GaussianCAD", "Erase") + "\tDel")
        gone.triggered.connect(board.erase)

    def _offer_roles(self, menu: QtWidgets.QMenu) -> None:
        board = self._board
        for number, role in enumerate(ROLES, start=1):
            action = menu.addAction(f"{name_of(role)}\t{number}")
            action.triggered.connect(lambda _=False, item=role: board.give_role(item))
        for role in ("pictorial", "detail", "ignore"):
            action = menu.addAction(name_of(role))
            action.triggered.connect(lambda _=False, item=role: board.give_role(item))
