"""How much of a surface deviates how far, as bars in the colours of the scale."""

from freecad.gaussiancad.engine.report import Histogram
from freecad.gaussiancad.objects.legend import colour_at
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_HEIGHT = 110
_FOOT = 18


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
        edges, shares = self._histogram.edges, self._histogram.shares
        most = max(*shares, 1e-9)
        width = self.width() / len(shares)
        high = self.height() - _FOOT
        painter.setPen(QtGui.QPen(QtGui.QColor(90, 90, 90), 0.5))
        for index, share in enumerate(shares):
            middle = (edges[index] + edges[index + 1]) / 2.0
            painter.setBrush(QtGui.QColor(*colour_at(middle / self._limit)))
            tall = high * share / most
            painter.drawRect(QtCore.QRectF(index * width, high - tall, width, tall))
        painter.setPen(self.palette().color(QtGui.QPalette.ColorRole.WindowText))
        foot = QtCore.QRect(0, int(high), self.width(), _FOOT)
        for value, side in (
            (edges[0], QtCore.Qt.AlignmentFlag.AlignLeft),
            ((edges[0] + edges[-1]) / 2.0, QtCore.Qt.AlignmentFlag.AlignHCenter),
            (edges[-1], QtCore.Qt.AlignmentFlag.AlignRight),
        ):
            painter.drawText(foot, int(side), f"{value + 0.0:.3g} mm")
        painter.end()
