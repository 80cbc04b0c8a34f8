"""The list at the canvas: verdict, problems and assumptions, each with its place and a button."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from freecad.gaussiancad.canvas.sheet import Box
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets


@dataclass(frozen=True)
class Line:
    """One row.

    Attributes:
        text: a sentence.
        box: its place on the sheet, if it has one.
        buttons: what helps: text and what it does.
        colour: behind the text; empty for none.
    """

    text: str
    box: Box | None = None
    buttons: tuple[tuple[str, Callable[[], None]], ...] = field(default=(), compare=False)
    colour: str = ""


_LEAST_PX = 60
"""Height of a list of few rows."""

_SHARE = 0.45
"""Share of the window that a list takes by itself."""


class Rows(QtWidgets.QListWidget):
    """The list.

    Signals:
        place_asked: a box of the sheet that a person wants to see.
    """

    place_asked = QtCore.Signal(tuple)

    def __init__(self, parent: QtWidgets.QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("problems")
        self.setWordWrap(True)
        self.setVerticalScrollMode(QtWidgets.QAbstractItemView.ScrollMode.ScrollPerPixel)
        self._lines: list[Line] = []
        self.itemClicked.connect(self._show)

    @property
    def lines(self) -> list[Line]:
        """What is listed."""
        return list(self._lines)

    def show_lines(self, lines: list[Line]) -> None:
        """Show rows in place of those before."""
        self.clear()
        self._lines = []
        for line in lines:
            self.add(line)
        self._fit()

    def add(self, line: Line) -> None:
        """Put a row at the end."""
        self._lines.append(line)
        item = QtWidgets.QListWidgetItem()
        self.addItem(item)
        widget = _row(line, lambda: self._ask(line))
        item.setSizeHint(QtCore.QSize(0, widget.heightForWidth(max(self.viewport().width(), 200))))
        if line.box is not None:
            item.setToolTip(translate("GaussianCAD", "Click to see the place"))
        self.setItemWidget(item, widget)

    def show_next(self) -> None:
        """Select the next row that has a place, and ask for it."""
        count = len(self._lines)
        for step in range(1, count + 1):
            index = (self.currentRow() + step) % count
            if self._lines[index].box is not None:
                self.setCurrentRow(index)
                self._ask(self._lines[index])
                return

    def resizeEvent(self, event: object) -> None:
        """Rows are as high as their text needs in the width that there is."""
        super().resizeEvent(event)
        for index in range(self.count()):
            widget = self.itemWidget(self.item(index))
            if widget is not None:
                height = widget.heightForWidth(max(self.viewport().width(), 200))
                self.item(index).setSizeHint(QtCore.QSize(0, height))
        self._fit()

    def _fit(self) -> None:
        """Take no more height than the rows need: the sheet gets the rest."""
        rows = sum(self.item(index).sizeHint().height() for index in range(self.count()))
        most = max(_LEAST_PX, rows + 2 * self.frameWidth() + 2)
        if most == self.maximumHeight():
            return
        self.setMaximumHeight(most)
        # A splitter gives no room away by itself.
        splitter = self.parentWidget()
        if isinstance(splitter, QtWidgets.QSplitter) and sum(splitter.sizes()):
            whole = sum(splitter.sizes())
            item = min(most, round(_SHARE * whole))
            splitter.setSizes([whole - item, item])

    def _show(self, item: QtWidgets.QListWidgetItem) -> None:
        self._ask(self._lines[self.row(item)])

    def _ask(self, line: Line) -> None:
        if line.box is not None:
            self.place_asked.emit(line.box)


class _Sentence(QtWidgets.QLabel):
    """A text that may be clicked."""

    def __init__(self, text: str, clicked: Callable[[], None]) -> None:
        super().__init__(text)
        # It stands on the list's colour, not on that of the window.
        self.setForegroundRole(QtGui.QPalette.ColorRole.Text)
        self.setWordWrap(True)
        self._clicked = clicked

    def mouseReleaseEvent(self, event: object) -> None:
        """Ask for the place."""
        self._clicked()
        super().mouseReleaseEvent(event)


def _row(line: Line, clicked: Callable[[], None]) -> QtWidgets.QWidget:
    widget = QtWidgets.QWidget()
    layout = QtWidgets.QVBoxLayout(widget)
    layout.setContentsMargins(6, 4, 6, 4)
    layout.setSpacing(2)
    layout.addWidget(_Sentence(line.text, clicked))
    if line.buttons:
        neighbour = QtWidgets.QHBoxLayout()
        for text, action in line.buttons:
            button = QtWidgets.QToolButton()
            button.setText(text)
            button.setFocusPolicy(QtCore.Qt.FocusPolicy.NoFocus)
            button.clicked.connect(lambda _=False, item=action: item())
            neighbour.addWidget(button)
        neighbour.addStretch()
        layout.addLayout(neighbour)
    if line.colour:
        widget.setStyleSheet(
            f"QLabel {{ background: {line.colour}; color: white; font-weight: bold; padding: 4px }}"
        )
    return widget
