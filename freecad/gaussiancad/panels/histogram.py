"""How much of a surface deviates how far, as bars in the colours of the scale."""

from freecad.gaussiancad.engine.report import Histogram
from freecad.gaussiancad.objects.legend import colour_at
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_HEIGHT = 120
_FOOT = 18
_HEAD = 16

_BESIDE = 0.2
"""Share of the width within which a bar counts as one at the border."""


class HistogramView(QtWidgets.QWidget):
    """The bars, with the ends of the scale written below."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("histogram")
        self.setMinimumHeight(_HEIGHT)
        self._histogram: Histogram | None = None
        self._limit = 1.0

    def show_histogram(self, histogram: Histogram | None, limit: float) -> None:
        """Show bars, coloured for a range in mm; None shows nothing."""
        self._histogram, self._limit = histogram, limit
        self.setToolTip("" if histogram is None else f"{100.0 * max(histogram.shares):.3g} %")
        self.update()

    def paintEvent(self, _event: QtGui.QPaintEvent) -> None:
        """Draw."""
        if self._histogram is None:
            return
        painter = QtGui.QPainter(self)
        painter.setPen(self.palette().color(QtGui.QPalette.ColorRole.WindowText))
        paint_histogram(painter, self.rect(), self._histogram, self._limit)
        painter.end()


def paint_histogram(
    painter: QtGui.QPainter, area: QtCore.QRect, histogram: Histogram, limit: float
) -> None:
    """Draw bars with the ends of the scale below and the largest share above.

    Args:
        painter: its pen writes.
        area: where.
        histogram: what.
        limit: mm at the ends of the colours.
    """
    ink = painter.pen()
    edges, shares = histogram.edges, histogram.shares
    most = max(*shares, 1e-9)
    width = area.width() / len(shares)
    top, high = area.top() + _HEAD, area.height() - _HEAD - _FOOT
    painter.setPen(QtGui.QPen(QtGui.QColor(90, 90, 90), 0.5))
    for index, share in enumerate(shares):
        middle = (edges[index] + edges[index + 1]) / 2.0
        painter.setBrush(QtGui.QColor(*colour_at(middle / limit)))
        tall = high * share / most
        left = area.left() + index * width
        painter.drawRect(QtCore.QRectF(left, top + high - tall, width, tall))
    painter.setPen(ink)
    centred = QtCore.Qt.AlignmentFlag.AlignHCenter
    left_end, right_end = QtCore.Qt.AlignmentFlag.AlignLeft, QtCore.Qt.AlignmentFlag.AlignRight
    foot = QtCore.QRect(area.left(), top + high, area.width(), _FOOT)
    for value, side in (
        (edges[0], left_end),
        ((edges[0] + edges[-1]) / 2.0, centred),
        (edges[-1], right_end),
    ):
        painter.drawText(foot, int(side), f"{value + 0.0:.3g} mm")
    # The share stands over its bar, or as near as the border lets it.
    highest = (shares.index(max(shares)) + 0.5) / len(shares)
    side = left_end if highest < _BESIDE else right_end if highest > 1.0 - _BESIDE else centred
    head = QtCore.QRect(area.left(), area.top(), area.width(), _HEAD)
    if side == centred:
        head.moveLeft(area.left() + round((highest - 0.5) * area.width()))
    painter.drawText(head, int(side), f"{100.0 * max(shares):.3g} %")
