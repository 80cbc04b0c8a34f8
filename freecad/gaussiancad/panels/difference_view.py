"""What a solution has more or less than the first one, marked in the 3D view."""

from pivy import coin

from freecad.gaussiancad.objects.solutions import Difference, Region
from freecad.gaussiancad.panels.view_mark import ViewMark, unpickable

MORE = (0.90, 0.62, 0.0)
"""Orange (Okabe and Ito): the colour of material that only the shown solution has."""

LESS = (0.80, 0.20, 0.60)
"""Magenta: the colour of material that only the first solution has."""

_CLEAR = 0.4
"""Transparency of the marks: edges are seen through them."""

_FINE = 0.005
"""Deviation of the marks, as a share of their largest extent."""


class DifferenceMark(ViewMark):
    """Marks in a document's 3D view."""

    def show(self, difference: Difference) -> None:
        """Mark a difference in place of the last one."""
        if self._cleared_view() is None:
            return
        node = unpickable(coin.SoSeparator())
        # In front of the solid's own faces, which they lie on.
        offset = coin.SoPolygonOffset()
        offset.factor, offset.units = -2.0, -2.0
        node.addChild(offset)
        for region, colour in ((difference.more, MORE), (difference.less, LESS)):
            if region.shape is not None:
                node.addChild(_body(region, colour))
        self._put_behind(node)


def _body(region: Region, colour: tuple[float, float, float]) -> coin.SoSeparator:
    box = region.shape.BoundBox
    points, triangles = region.shape.tessellate(_FINE * max(box.XLength, box.YLength, box.ZLength))
    body = coin.SoSeparator()
    material = coin.SoMaterial()
    material.diffuseColor = colour
    material.transparency = _CLEAR
    body.addChild(material)
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    body.addChild(hints)
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(points), [(p.x, p.y, p.z) for p in points])
    body.addChild(coordinates)
    faces = coin.SoIndexedFaceSet()
    indices = [index for triangle in triangles for index in (*triangle, -1)]
    faces.coordIndex.setValues(0, len(indices), indices)
    body.addChild(faces)
    return body
