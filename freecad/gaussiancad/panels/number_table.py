"""A table of numbers in a narrow panel: a title is cut short sooner than a number."""

from collections.abc import Sequence

from freecad.gaussiancad.qt import QtCore, QtWidgets

_ROW = 24
"""px of a row."""

_LEAST_TITLE = 40
"""px that titles keep in any case."""


class NumberTable(QtWidgets.QTableWidget):
    """Rows of numbers under headings, as high as its rows and as wide as there is room.

    The numbers get the width that they need, and the titles of the rows what is left.

    Args:
        name: of the widget.
        columns: the headings.
        rows: title and explanation of each.
    """

    def __init__(self, name: str, columns: Sequence[str], rows: Sequence[tuple[str, str]]) -> None:
        super().__init__(len(rows), len(columns))
        self.setObjectName(name)
        self.setHorizontalHeaderLabels(list(columns))
        self.setEditTriggers(QtWidgets.QAbstractItemView.EditTrigger.NoEditTriggers)
        self.horizontalHeader().setSectionResizeMode(QtWidgets.QHeaderView.ResizeMode.Fixed)
        self.horizontalHeader().setStretchLastSection(True)
        self._titles = [title for title, _ in rows]
        for row, (title, tip) in enumerate(rows):
            header = QtWidgets.QTableWidgetItem(title)
            header.setToolTip(f"{title}: {tip}")
            self.setVerticalHeaderItem(row, header)
        self.verticalHeader().setDefaultSectionSize(_ROW)
        self.verticalHeader().setTextElideMode(QtCore.Qt.TextElideMode.ElideRight)
        off = QtCore.Qt.ScrollBarPolicy.ScrollBarAlwaysOff
        self.setHorizontalScrollBarPolicy(off)
        self.setVerticalScrollBarPolicy(off)
        head = self.horizontalHeader().sizeHint().height()
        self.setFixedHeight(_ROW * len(rows) + head + 2 * self.frameWidth())

    def show_numbers(self, rows: Sequence[Sequence[str]]) -> None:
        """Show the numbers of all rows, as texts."""
        for row, (title, texts) in enumerate(zip(self._titles, rows, strict=True)):
            for column, text in enumerate(texts):
                item = QtWidgets.QTableWidgetItem(text)
                item.setToolTip(f"{title}: {text}")
                item.setTextAlignment(
                    QtCore.Qt.AlignmentFlag.AlignRight | QtCore.Qt.AlignmentFlag.AlignVCenter
                )
                self.setItem(row, column, item)
        self._make_room()

    def resizeEvent(self, event: object) -> None:
        """Divide the width anew."""
        super().resizeEvent(event)
        self._make_room()

    def _make_room(self) -> None:
        head, titles = self.horizontalHeader(), self.verticalHeader()
        needed = [
            max(self.sizeHintForColumn(column), head.sectionSizeHint(column))
            for column in range(self.columnCount())
        ]
        width = self.width() - 2 * self.frameWidth()
        left = max(width - sum(needed), _LEAST_TITLE)
        if titles.maximumWidth() != left:
            titles.setMaximumWidth(left)
            self.updateGeometries()
        spare = max(left - titles.sizeHint().width(), 0)
        for column, wide in enumerate(needed):
            head.resizeSection(column, wide + spare // len(needed))
