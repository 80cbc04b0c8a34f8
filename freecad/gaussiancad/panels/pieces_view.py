"""Pieces of line at which a model differs from its drawing, marked in the 3D view."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import FreeCAD
from pivy import coin

from freecad.gaussiancad.engine.check_file import Piece
from freecad.gaussiancad.panels.camera_flight import CameraFlight, Goal
from freecad.gaussiancad.panels.view_mark import ViewMark, unpickable

Colour = tuple[float, float, float]

_THIN, _THICK = 2.0, 5.0
"""px of lines, and of those that are chosen."""

_AROUND = 2.5
"""How much more than the chosen pieces is seen, as a factor of their extent."""

_LEAST = 0.25
"""Share of the whole that is seen at least."""


@dataclass(frozen=True)
class MarkedPieces:
    """Pieces of one colour.

    Attributes:
        pieces: mm.
        colour: red, green, blue, 0 to 1.
    """

    pieces: tuple[Piece, ...]
    colour: Colour


class PiecesMark(ViewMark):
    """Pieces in a document's 3D view, drawn over everything.

    Args:
        document: whose view it is.
    """

    def __init__(self, document: FreeCAD.Document) -> None:
        super().__init__(document)
        self._flight = CameraFlight(self._is_open)

    def show(self, marked: Sequence[MarkedPieces], chosen: int | None = None) -> None:
        """Mark pieces in place of the last ones.

        Args:
            marked: all of them.
            chosen: number of those that are drawn thick, on top.
        """
        if self._cleared_view() is None:
            return
        node = unpickable(coin.SoAnnotation())
        for number, each in enumerate(marked):
            if number != chosen:
                node.addChild(_lines(each, _THIN))
        if chosen is not None:
            node.addChild(_lines(marked[chosen], _THICK))
        self._put_behind(node)

    def fly_to(
        self, places: Iterable[Sequence[float]], size: float, turn: coin.SbRotation | None = None
    ) -> None:
        """Bring places into the middle of the view.

        Args:
            places: mm, of what is to be seen.
            size: of the part, mm.
            turn: of the camera; None to look as before.
        """
        box = FreeCAD.BoundBox()
        for place in places:
            box.add(FreeCAD.Vector(*place))
        if self._view is None or not self._is_open() or not box.isValid():
            return
        height = min(max(_AROUND * box.DiagonalLength, _LEAST * size), 1.2 * size)
        self._flight.start(self._view, Goal(tuple(box.Center), height, 2.0 * size, turn))

    def clear(self) -> None:
        """Take the marks off; a view that was closed has none."""
        self._flight.stop()
        super().clear()


def _lines(marked: MarkedPieces, width: float) -> coin.SoSeparator:
    """The pieces, and a dot where a piece is but a spot."""
    node = coin.SoSeparator()
    colour = coin.SoBaseColor()
    colour.rgb = marked.colour
    node.addChild(colour)
    style = coin.SoDrawStyle()
    style.lineWidth, style.pointSize = width, 2.0 * width
    node.addChild(style)
    spots = [one for one, other in marked.pieces if one == other]
    ends = [end for one, other in marked.pieces if one != other for end in (one, other)]
    for points, kind in ((ends, coin.SoLineSet), (spots, coin.SoPointSet)):
        if not points:
            continue
        coordinates = coin.SoCoordinate3()
        coordinates.point.setValues(0, len(points), points)
        node.addChild(coordinates)
        shape = kind()
        if kind is coin.SoLineSet:
            shape.numVertices.setValues(0, len(points) // 2, [2] * (len(points) // 2))
        else:
            shape.numPoints = len(points)
        node.addChild(shape)
    return node
