"""Fly to a point of the 3D view, and mark it there."""

import FreeCAD
from pivy import coin

from freecad.gaussiancad.panels.camera_flight import CameraFlight, Goal, Point
from freecad.gaussiancad.panels.view_mark import ViewMark, unpickable

_CLOSE = 0.35
"""Of the part, the share that is seen around the point."""


class PointMark(ViewMark):
    """A mark in a document's 3D view.

    Args:
        document: whose view it is.
    """

    def __init__(self, document: FreeCAD.Document) -> None:
        super().__init__(document)
        self._flight = CameraFlight(self._is_open)

    def show(self, place: Point, text: str, size: float) -> None:
        """Mark a place, and bring it into the middle.

        Args:
            place: mm.
            text: written beside it.
            size: of the part, mm.
        """
        if self._cleared_view() is None:
            return
        node = unpickable(coin.SoAnnotation())
        colour = coin.SoBaseColor()
        colour.rgb = (1.0, 0.55, 0.0)
        node.addChild(colour)
        coordinate = coin.SoCoordinate3()
        coordinate.point.setValue(*place)
        node.addChild(coordinate)
        marker = coin.SoMarkerSet()
        marker.markerIndex = coin.SoMarkerSet.CIRCLE_LINE_9_9
        node.addChild(marker)
        there = coin.SoTranslation()
        there.translation = place
        node.addChild(there)
        font = coin.SoFont()
        font.size = 18.0
        node.addChild(font)
        words = coin.SoText2()
        words.string.setValues(0, 2, ["", f"  {text}"])
        node.addChild(words)
        self._put_behind(node)
        self._flight.start(self._view, Goal(place, _CLOSE * size, 2.0 * size))

    def clear(self) -> None:
        """Take the mark off; a view that was closed has none."""
        self._flight.stop()
        super().clear()
