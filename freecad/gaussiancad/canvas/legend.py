"""What the colours of lines stand for, in a corner of the canvas."""

from __future__ import annotations

from dataclasses import dataclass

from freecad.gaussiancad.canvas.kinds import COLOURS, DOUBTFUL, DRAWN, OTHER, name_of
from freecad.gaussiancad.canvas.sheet import Sheet
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_SAMPLE = 26
"""px of a line that is shown as a sample."""

_GAP = 8
"""px between what the legend has in it, and to the edges of the canvas."""

_PAPER, _INK, _EDGE = "#ffffff", "#202020", "#b0b0b0"
"""Like the sheet under it, whatever the colours of the window."""


@dataclass(frozen=True)
class Entry:
    """A row: how lines look, and what they are.

    Attributes:
        text: what they are, in the user's language.
        colour: of the line.
        hidden: whether it is dashed.
        bold: whether it is as wide as the part's lines.
    """

    text: str
    colour: str
    hidden: bool = False
    bold: bool = False


def entries_of(sheet: Sheet) -> list[Entry]:
    """What a sheet has of lines, in the order of the colours; at the end those in doubt, and all
    that have no colour of their own."""
    sure = {stroke.kind for stroke in sheet.strokes if not stroke.doubtful}
    found = [
        Entry(name_of(kind), colour, kind == "hidden", kind in DRAWN)
        for kind, colour in COLOURS.items()
        if kind in sure
    ]
    if any(stroke.doubtful for stroke in sheet.strokes):
        found.append(Entry(translate("GaussianCAD", "in doubt"), DOUBTFUL, bold=True))
    if sure - set(COLOURS):
        found.append(Entry(translate("GaussianCAD", "other lines"), OTHER))
    return found


class Legend(QtWidgets.QWidget):
    """The legend; the mouse goes through it.

    It lies on the view, not on the sheet: however that is moved or zoomed, the legend stays.  Its
    corner is the one that front, top and side view leave free: the upper right one in third angle,
    the lower right one in first.

    Args:
        sheet_view: in whose corner it is.
    """

    def __init__(self, sheet_view: QtWidgets.QAbstractScrollArea) -> None:
        super().__init__(sheet_view)
        self.setObjectName("legend")
        self.setAttribute(QtCore.Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._view = sheet_view
        self._entries: tuple[Entry, ...] = ()
        self._wanted = True
        self._low = False
        self.hide()

    @property
    def entries(self) -> tuple[Entry, ...]:
        """The rows."""
        return self._entries

    def show_sheet(self, sheet: Sheet) -> None:
        """Show what a sheet has, in place of what was shown before."""
        self._entries, self._low = tuple(entries_of(sheet)), sheet.projection == "first"
        self._settle()
        self.update()

    def set_wanted(self, wanted: bool) -> None:
        """Show the legend, or not."""
        self._wanted = wanted
        self._settle()

    def stay(self) -> None:
        """Go to the corner, which may have moved."""
        area = self._view.viewport().geometry()
        low = area.bottom() + 1 - self.height() - _GAP
        self.move(area.right() + 1 - self.width() - _GAP, low if self._low else area.top() + _GAP)

    def paintEvent(self, _event: QtGui.QPaintEvent) -> None:
        """Draw it."""
        painter = QtGui.QPainter(self)
        painter.setPen(QtGui.QColor(_EDGE))
        painter.setBrush(QtGui.QColor(_PAPER))
        painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        line, styles = self._line_height(), QtCore.Qt.PenStyle
        for index, entry in enumerate(self._entries):
            middle = _GAP // 2 + index * line + line // 2
            style = styles.DashLine if entry.hidden else styles.SolidLine
            painter.setPen(
                QtGui.QPen(QtGui.QColor(entry.colour), 2.0 if entry.bold else 1.0, style)
            )
            painter.drawLine(_GAP, middle, _GAP + _SAMPLE, middle)
            painter.setPen(QtGui.QColor(_INK))
            rest = QtCore.QRect(2 * _GAP + _SAMPLE, middle - line // 2, self.width(), line)
            painter.drawText(rest, QtCore.Qt.AlignmentFlag.AlignVCenter, entry.text)
        painter.end()

    def _settle(self) -> None:
        metrics = self.fontMetrics()
        widths = [metrics.horizontalAdvance(entry.text) for entry in self._entries]
        height = len(self._entries) * self._line_height() + _GAP
        self.resize(3 * _GAP + _SAMPLE + max(widths, default=0), height)
        self.stay()
        self.setVisible(self._wanted and bool(self._entries))

    def _line_height(self) -> int:
        return self.fontMetrics().height() + 2
