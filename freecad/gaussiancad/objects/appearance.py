"""How the objects of a group look in a window.

Files made by ``freecadcmd`` hold no looks at all; they get theirs when a window opens them.
"""

import FreeCAD


def dress(group: FreeCAD.DocumentObject, colour: str | None = None) -> None:
    """Give a group's objects their looks; without a window nothing happens.

    Args:
        group: whose children are dressed.
        colour: ``#RRGGBB`` of the part and its surface, or None to leave theirs.
    """
    if not FreeCAD.GuiUp:
        return
    for child in group.Group:
        if child.TypeId == "Image::ImagePlane":
            _show_as_paper(child.ViewObject)
        elif child.TypeId == "Points::Feature":
            _set_quietly(child.ViewObject, "DisplayMode", "Color")
        elif hasattr(child, "VertexColors"):
            show_vertex_colours(child)
        elif colour is not None:
            _set_quietly(child.ViewObject, "ShapeColor", _channels(colour))


def dress_like(body: FreeCAD.DocumentObject, part: FreeCAD.DocumentObject) -> None:
    """Give a body and its features the colour of a part; without a window nothing happens."""
    if not FreeCAD.GuiUp or not hasattr(part.ViewObject, "ShapeColor"):
        return
    for each in (body, *body.Group):
        if hasattr(each.ViewObject, "ShapeColor"):
            each.ViewObject.ShapeColor = part.ViewObject.ShapeColor


def show_vertex_colours(feature: FreeCAD.DocumentObject) -> None:
    """Switch the colours of a mesh on; a switch that is on already must be moved."""
    view = feature.ViewObject
    if hasattr(feature, "VertexColors") and hasattr(view, "Coloring"):
        # A section shows the inner side, which is black under a light from outside.
        _set_quietly(view, "Lighting", "Two side")
        _set_quietly(view, "Coloring", False)
        _set_quietly(view, "Coloring", True)


def _show_as_paper(view: object) -> None:
    """Let the image shine, so that paper stays white whatever the light (FreeCAD 0.20)."""
    if hasattr(view, "ShapeMaterial"):
        material = view.ShapeMaterial
        material.EmissiveColor = (1.0, 1.0, 1.0, 0.0)
        _set_quietly(view, "ShapeMaterial", material)


def _set_quietly(view: object, name: str, value: object) -> None:
    """Set a property; a document that was just opened does not count as changed by that."""
    if name not in view.PropertiesList:
        setattr(view, name, value)
        return
    view.setPropertyStatus(name, "NoModify")
    setattr(view, name, value)
    view.setPropertyStatus(name, "-NoModify")


def _channels(colour: str) -> tuple[float, float, float]:
    red, green, blue = (int(colour[place : place + 2], 16) / 255.0 for place in (1, 3, 5))
    return (red, green, blue)
