"""A section through a comparison: the outlines of both models in one plane, in the 3D view.

Orange is the result, green the reference.  What lies in front of the plane is hidden meanwhile.
"""

from collections.abc import Sequence

import FreeCAD
import Mesh
import Part
from pivy import coin

from freecad.gaussiancad.objects.comparable import global_shape
from freecad.gaussiancad.objects.sources import Source
from freecad.gaussiancad.panels.view_mark import ViewMark, unpickable

RESULT = (0.90, 0.62, 0.0)
"""Orange (Okabe and Ito)."""

REFERENCE = (0.0, 0.62, 0.45)
"""Green of the same set."""

AXES = {
    "x": FreeCAD.Vector(1, 0, 0),
    "y": FreeCAD.Vector(0, 1, 0),
    "z": FreeCAD.Vector(0, 0, 1),
}

Line = Sequence[tuple[float, float, float]]


class SectionMark(ViewMark):
    """The outlines in a document's 3D view."""

    def show(self, axis: str, at: float, models: tuple[Mesh.Mesh, Mesh.Mesh]) -> None:
        """Cut the result and the reference.

        Args:
            axis: x, y or z.
            at: mm along it.
            models: result and reference, in global coordinates.
        """
        view = self._cleared_view()
        if view is None:
            return
        normal = AXES[axis]
        # The half towards the eye is taken off.
        towards = -1.0 if view.getViewDirection() * normal > 0.0 else 1.0
        clip = coin.SoClipPlane()
        kept = normal * -towards
        clip.plane = coin.SbPlane(coin.SbVec3f(*kept), -towards * at)
        lines = unpickable(coin.SoAnnotation())
        style = coin.SoDrawStyle()
        style.lineWidth = 3.0
        lines.addChild(style)
        for mesh, colour in zip(models, (RESULT, REFERENCE), strict=True):
            lines.addChild(_polylines(outlines(mesh, axis, at), colour))
        # The lines lie in the plane: they come before it, so that it does not cut them.
        self._put_before(lines, clip)


def outlines(mesh: Mesh.Mesh, axis: str, at: float) -> list[Line]:
    """The lines in which a plane cuts a mesh."""
    normal = AXES[axis]
    found = mesh.crossSections([(normal * at, normal)], 1e-4)
    return [[tuple(point) for point in line] for lines in found for line in lines]


def mesh_of(source: Source, fineness: float) -> Mesh.Mesh:
    """The geometry of a source in global coordinates, as triangles.

    Args:
        source: an object or a file.
        fineness: mm by which triangles may leave curved faces.
    """
    feature = source.feature
    if feature is not None and feature.isDerivedFrom("Mesh::Feature"):
        mesh = feature.Mesh.copy()
        mesh.Placement = feature.getGlobalPlacement()
        return mesh
    if feature is not None:
        return _triangles(global_shape(feature), fineness)
    if source.path.lower().rsplit(".", 1)[-1] in ("stl", "ply", "obj"):
        return Mesh.Mesh(source.path)
    return _triangles(Part.read(source.path), fineness)


def _triangles(shape: Part.Shape, fineness: float) -> Mesh.Mesh:
    points, triangles = shape.tessellate(fineness)
    return Mesh.Mesh([points[corner] for triangle in triangles for corner in triangle])


def _polylines(lines: list[Line], colour: tuple[float, float, float]) -> coin.SoSeparator:
    node = coin.SoSeparator()
    paint = coin.SoBaseColor()
    paint.rgb = colour
    node.addChild(paint)
    points = [point for line in lines for point in line]
    if points:
        coordinates = coin.SoCoordinate3()
        coordinates.point.setValues(0, len(points), points)
        node.addChild(coordinates)
        drawn = coin.SoLineSet()
        drawn.numVertices.setValues(0, len(lines), [len(line) for line in lines])
        node.addChild(drawn)
    return node
