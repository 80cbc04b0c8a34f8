"""A table of texts whose rows lead somewhere."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_ROW = 24
"""px of a row."""

_MOST_ROWS = 9
"""Rows that are seen without scrolling."""

_SWATCH = 12
"""px of a colour before a row."""


@dataclass(frozen=True)
class RowLook:
    """How a row looks besides its texts.

    Attributes:
        tip: shown while the pointer rests on it.
        colour: before the last text, red, green, blue, 0 to 1; None for none.
    """

    tip: str
    colour: tuple[float, float, float] | None = None


class RowTable(QtWidgets.QTableWidget):
    """Rows of texts, of which one can be chosen; the last column has what room there is.

    Args:
        name: of the widget.
        titles: of the columns.
        on_chosen: is told the number of the row, counted from 0.
    """

    def __init__(self, name: str, titles: Sequence[str], on_chosen: Callable[[int], None]) -> None:
        super().__init__(0, len(titles))
        self.setObjectName(name)
        self.setHorizontalHeaderLabels(list(titles))
        view = QtWidgets.QAbstractItemView
        self.setEditTriggers(view.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(view.SelectionBehavior.SelectRows)
        self.setSelectionMode(view.SelectionMode.SingleSelection)
        mode = QtWidgets.QHeaderView.ResizeMode.ResizeToContents
        for column in range(len(titles) - 1):
            self.horizontalHeader().setSectionResizeMode(column, mode)
        self.horizontalHeader().setStretchLastSection(True)
        self.horizontalHeader().setHighlightSections(False)
        # Task panels are narrow: a text that does not fit takes another line.
        self.setWordWrap(True)
        self.setTextElideMode(QtCore.Qt.TextElideMode.ElideNone)
        self.verticalHeader().setSectionResizeMode(mode)
        self.verticalHeader().setMinimumSectionSize(_ROW)
        self.setMinimumHeight(_ROW * _MOST_ROWS)
        self._on_chosen = on_chosen
        self.itemSelectionChanged.connect(self._choose)

    def show_rows(self, rows: Sequence[Sequence[str]] = (), looks: Sequence[RowLook] = ()) -> None:
        """Show other rows; none is chosen then.

        Args:
            rows: a text for each column.
            looks: of each of them.
        """
        self.blockSignals(True)
        self.clearSelection()
        self.setRowCount(len(rows))
        for row, (texts, look) in enumerate(zip(rows, looks, strict=True)):
            for column, text in enumerate(texts):
                item = QtWidgets.QTableWidgetItem(text)
                item.setToolTip(look.tip)
                self.setItem(row, column, item)
            if look.colour is not None:
                item.setIcon(_swatch(look.colour))
        self.blockSignals(False)

    def forget_choice(self) -> None:
        """Choose no row, and tell nobody."""
        self.blockSignals(True)
        self.clearSelection()
        self.blockSignals(False)

    def _choose(self) -> None:
        rows = self.selectionModel().selectedRows()
        if rows:
            self._on_chosen(rows[0].row())


def _swatch(colour: tuple[float, float, float]) -> QtGui.QIcon:
    picture = QtGui.QPixmap(_SWATCH, _SWATCH)
    picture.fill(QtGui.QColor.fromRgbF(*colour))
    return QtGui.QIcon(picture)
