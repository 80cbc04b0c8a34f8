"""The colours of a deviation, and a picture that explains them."""

from dataclasses import dataclass

from freecad.gaussiancad.qt import QtCore, QtGui

# The colours at -range, half of it, 0, half of it, +range in the engine's deviation.ply.
STOPS = ((33, 76, 178), (122, 160, 225), (225, 225, 225), (232, 139, 108), (175, 24, 38))

WIDTH, HEIGHT = 220, 520
_BAR = (20, 30, 50, 460)


@dataclass(frozen=True)
class DeviationRange:
    """What the colours mean.

    Attributes:
        limit: mm at the ends of the scale.
        signed: whether negative values (inside the reference) exist.
    """

    limit: float
    signed: bool

    @property
    def least(self) -> float:
        """mm at the lower end."""
        return -self.limit if self.signed else 0.0


def colour_at(share: float) -> tuple[int, int, int]:
    """RGB at a share of the range, -1 to 1."""
    place = (min(max(share, -1.0), 1.0) + 1.0) * (len(STOPS) - 1) / 2.0
    low = min(int(place), len(STOPS) - 2)
    rest = place - low
    red, green, blue = (
        round(a + (b - a) * rest) for a, b in zip(STOPS[low], STOPS[low + 1], strict=True)
    )
    return (red, green, blue)


def legend_image(scale: DeviationRange, with_text: bool) -> QtGui.QImage:
    """A vertical colour scale, the largest value on top.

    Args:
        scale: what the colours mean.
        with_text: whether to write values beside it; text needs a window system.
    """
    image = QtGui.QImage(WIDTH, HEIGHT, QtGui.QImage.Format.Format_RGB32)
    image.fill(QtGui.QColor(255, 255, 255))
    painter = QtGui.QPainter(image)
    left, top, width, height = _BAR
    for row in range(height):
        value = scale.limit + (scale.least - scale.limit) * row / (height - 1)
        painter.setPen(QtGui.QColor(*colour_at(value / scale.limit if scale.limit else 0.0)))
        painter.drawLine(left, top + row, left + width, top + row)
    painter.setPen(QtGui.QPen(QtGui.QColor(0, 0, 0), 2))
    painter.drawRect(left, top, width, height)
    if with_text:
        _write_values(painter, scale)
    painter.end()
    return image


def _write_values(painter: QtGui.QPainter, scale: DeviationRange) -> None:
    left, top, width, height = _BAR
    font = QtGui.QFont()
    font.setPixelSize(24)
    painter.setFont(font)
    ticks = 4
    for tick in range(ticks + 1):
        value = scale.limit + (scale.least - scale.limit) * tick / ticks
        y = top + round(height * tick / ticks)
        painter.drawLine(left + width, y, left + width + 8, y)
        sign = "+" if value > 0 and scale.signed else ""
        box = QtCore.QRect(left + width + 14, y - 16, WIDTH - left - width - 14, 32)
        left_middle = QtCore.Qt.AlignmentFlag.AlignLeft | QtCore.Qt.AlignmentFlag.AlignVCenter
        painter.drawText(box, int(left_middle), f"{sign}{value:g} mm")
