"""Fly to a point of the 3D view, and mark it there."""

import FreeCAD
from pivy import coin

from freecad.gaussiancad.panels.view_mark import ViewMark, unpickable
from freecad.gaussiancad.qt import QtCore

_STEPS = 12
_STEP_MILLISECONDS = 25
_CLOSE = 0.35
"""Of the part, the share that is seen around the point."""

Point = tuple[float, float, float]


class PointMark(ViewMark):
    """A mark in a document's 3D view.

    Args:
        document: whose view it is.
    """

    def __init__(self, document: FreeCAD.Document) -> None:
        super().__init__(document)
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._step)
        self._flight: list[tuple[coin.SbVec3f, float]] = []

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
        self._fly(place, size)

    def clear(self) -> None:
        """Take the mark off; a view that was closed has none."""
        self._timer.stop()
        super().clear()

    def _fly(self, place: Point, size: float) -> None:
        camera = self._view.getCameraNode()
        looks = coin.SbVec3f(0.0, 0.0, -1.0)
        looks = camera.orientation.getValue().multVec(looks)
        goal = coin.SbVec3f(*place) - looks * (2.0 * size)
        start = coin.SbVec3f(camera.position.getValue())
        tall = camera.height.getValue() if hasattr(camera, "height") else 0.0
        self._flight = []
        for number in range(1, _STEPS + 1):
            time = number / _STEPS
            share = time * time * (3.0 - 2.0 * time)
            height = tall * ((_CLOSE * size) / tall) ** share if tall > 0.0 else 0.0
            self._flight.append((start + (goal - start) * share, height))
        camera.focalDistance = 2.0 * size
        self._timer.start(_STEP_MILLISECONDS)

    def _step(self) -> None:
        if not self._flight or not self._is_open():
            self._timer.stop()
            return
        position, height = self._flight.pop(0)
        camera = self._view.getCameraNode()
        camera.position.setValue(position)
        if height > 0.0:
            camera.height = height
        camera.nearDistance, camera.farDistance = 0.001, 1e6
        self._view.redraw()
