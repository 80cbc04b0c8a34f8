"""The pages of a file, as small pictures to choose from."""

from __future__ import annotations

from collections.abc import Callable

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_EDGE = 120
"""px of the longer edge of a picture."""

_PAUSE_MS = 500

Ask = Callable[[int, int, Callable[[str], None]], None]
"""Asks for the picture of a page, so many px long; the answer is its path, empty where none is."""


class Pages(QtWidgets.QListWidget):
    """The strip; pictures of the pages in sight come one after another while nothing else is done.

    Args:
        ask: for a picture.
        may_ask: whether there is time for it.
        parent: its owner.

    Signals:
        chosen: number of a page that a person wants, from 1.
    """

    chosen = QtCore.Signal(int)

    def __init__(
        self, ask: Ask, may_ask: Callable[[], bool], parent: QtWidgets.QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._ask, self._may_ask = ask, may_ask
        self._waiting = False
        self._page = 1
        self.setIconSize(QtCore.QSize(_EDGE, _EDGE))
        self.setMaximumWidth(_EDGE + 100)
        self.setUniformItemSizes(True)
        self.itemClicked.connect(self._choose)
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(_PAUSE_MS)
        self._timer.timeout.connect(self._next)
        self.hide()

    def show_pages(self, count: int, page: int) -> None:
        """List so many pages, of which one is shown; a single page needs no list."""
        if count < 2 or self.count() == count:
            return
        self._page = page
        blank = QtGui.QPixmap(_EDGE, _EDGE)
        blank.fill(QtGui.QColor("white"))
        for number in range(1, count + 1):
            text = translate("GaussianCAD", "Page {0}").format(number)
            self.addItem(QtWidgets.QListWidgetItem(QtGui.QIcon(blank), text))
        self.setCurrentRow(page - 1)
        self.show()
        self._timer.start()

    def _choose(self, item: QtWidgets.QListWidgetItem) -> None:
        number = self.row(item) + 1
        if number != self._page:
            self.chosen.emit(number)

    def _next(self) -> None:
        """Ask for the next picture that is in sight and not there yet."""
        if self._waiting or not self._may_ask():
            return
        for row in range(self.count()):
            item = self.item(row)
            asked = item.data(QtCore.Qt.ItemDataRole.UserRole)
            if asked or not self.visualItemRect(item).intersects(self.viewport().rect()):
                continue
            item.setData(QtCore.Qt.ItemDataRole.UserRole, True)
            self._waiting = True
            self._ask(row + 1, _EDGE, lambda path, entry=row: self._take(entry, path))
            return

    def _take(self, row: int, path: str) -> None:
        self._waiting = False
        if path:
            self.item(row).setIcon(QtGui.QIcon(path))
