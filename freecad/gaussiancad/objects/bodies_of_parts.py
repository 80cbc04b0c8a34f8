"""Which bodies were made of a part, and which of them is seen: the part or its body."""

import FreeCAD
import Part

from freecad.gaussiancad.objects.body_properties import MADE_OF

_SAME = 1e-6
"""Share by which volume and area of two equal shapes differ."""


def bodies_of(part: FreeCAD.DocumentObject) -> tuple[FreeCAD.DocumentObject, ...]:
    """The bodies of the same document that were made of a part, the oldest first."""
    return tuple(each for each in part.Document.Objects if getattr(each, MADE_OF, "") == part.Name)


def is_seen_as_body(part: FreeCAD.DocumentObject) -> bool:
    """Whether a body is shown in place of a part."""
    return any(body.Visibility for body in bodies_of(part))


def hide_bodies(part: FreeCAD.DocumentObject) -> None:
    """Hide the bodies of a part; somebody may have changed them, so none is removed."""
    for body in bodies_of(part):
        body.Visibility = False


def set_shape(part: FreeCAD.DocumentObject, shape: Part.Shape) -> None:
    """Give a part a shape.  Where it is another than before, its bodies are out of date: the part
    is shown again in their place."""
    is_other = not _are_alike(part.Shape, shape)
    part.Shape = shape
    if is_other and is_seen_as_body(part):
        hide_bodies(part)
        part.Visibility = True


def _are_alike(first: Part.Shape, second: Part.Shape) -> bool:
    if first.isNull() or second.isNull():
        return first.isNull() and second.isNull()
    if len(first.Faces) != len(second.Faces):
        return False
    pairs = (first.Volume, second.Volume), (first.Area, second.Area)
    if any(abs(a - b) > _SAME * abs(b) for a, b in pairs):
        return False
    corners = [
        (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax)
        for box in (first.BoundBox, second.BoundBox)
    ]
    near = _SAME * second.BoundBox.DiagonalLength
    return all(abs(a - b) <= near for a, b in zip(*corners, strict=True))
