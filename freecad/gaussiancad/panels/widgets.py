"""Small widgets that more than one panel uses."""

from collections.abc import Callable, Iterable
from enum import Enum
from typing import Generic, TypeVar

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_Mode = TypeVar("_Mode", bound=Enum)


class ModeBox(QtWidgets.QComboBox, Generic[_Mode]):
    """A combo box whose entries are the members of an enum.

    Args:
        entries: members and their texts, in order.
        name: of the widget.
    """

    def __init__(self, entries: Iterable[tuple[_Mode, str]], name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        # Never narrower than its longest entry: a form wraps the row instead.
        self.setSizeAdjustPolicy(QtWidgets.QComboBox.SizeAdjustPolicy.AdjustToContents)
        self._modes: list[_Mode] = []
        for mode, text in entries:
            self._modes.append(mode)
            self.addItem(text)

    @property
    def mode(self) -> _Mode:
        """The chosen member."""
        return self._modes[self.currentIndex()]

    def choose(self, mode: _Mode) -> None:
        """Choose a member."""
        self.setCurrentIndex(self._modes.index(mode))


class ColourButton(QtWidgets.QPushButton):
    """A button that shows a colour and lets the user choose another one.

    Args:
        colour: ``#RRGGBB`` to start with.
    """

    def __init__(self, colour: str) -> None:
        super().__init__()
        self.setObjectName("colour")
        self.set_colour(colour)
        self.clicked.connect(self._choose)

    @property
    def colour(self) -> str:
        """``#RRGGBB``."""
        return self._colour

    def set_colour(self, colour: str) -> None:
        """Show a colour."""
        self._colour = colour
        swatch = QtGui.QPixmap(32, 14)
        swatch.fill(QtGui.QColor(colour))
        self.setIcon(QtGui.QIcon(swatch))
        self.setIconSize(swatch.size())
        self.setText(colour)

    def _choose(self) -> None:
        dialog = QtWidgets.QColorDialog(QtGui.QColor(self._colour), self)
        dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.colorSelected.connect(lambda colour: self.set_colour(colour.name()))
        dialog.open()


class PathField(QtWidgets.QWidget):
    """A line for a path, with a button that browses.

    Args:
        name: of the line.
        browse: asks the user; returns the path, or an empty text.
    """

    def __init__(self, name: str, browse: Callable[[], str]) -> None:
        super().__init__()
        self.line = QtWidgets.QLineEdit()
        self.line.setObjectName(name)
        self.line.setMinimumWidth(40)
        self._browse = browse
        button = QtWidgets.QToolButton()
        button.setText("…")
        button.setToolTip(translate("GaussianCAD", "Opens a dialog to choose from"))
        button.clicked.connect(self._ask)
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.line)
        layout.addWidget(button)

    @property
    def path(self) -> str:
        """What the line says, without blanks around it."""
        return self.line.text().strip()

    def _ask(self) -> None:
        if path := self._browse():
            self.line.setText(path)


def bring_into_sight(widget: QtWidgets.QWidget) -> None:
    """Scroll to a task box that lies in a panel higher than the window."""
    ancestor = widget.parentWidget()
    while ancestor is not None and not isinstance(ancestor, QtWidgets.QScrollArea):
        ancestor = ancestor.parentWidget()
    if ancestor is not None:
        ancestor.ensureWidgetVisible(widget)


def standard_buttons(buttons: QtWidgets.QDialogButtonBox.StandardButton) -> object:
    """What ``getStandardButtons`` returns: FreeCAD wants a number from PySide2, else the enum."""
    return int(buttons) if QtCore.qVersion().startswith("5.") else buttons
