"""Properties that an older version made, as this one makes them; nothing that they hold is lost.

Earlier versions kept texts by name in an ``App::PropertyMap``, which not every FreeCAD shows in its
property editor, and lengths as plain numbers.
"""

import FreeCAD

from freecad.gaussiancad.objects.properties import text_lines

_LENGTHS = {"MeasuresToMillimetres": "MeasuresWithin", "RangeMillimetres": "ColourRange"}
"""What was a number of millimetres, and the length that it is now."""


def migrate(target: FreeCAD.DocumentObject, schema: int) -> None:
    """Replace the older properties of a group; a group without any is left alone.

    Args:
        target: the group.
        schema: version of the properties that a group of its kind has now.
    """
    replaced = False
    for name in target.PropertiesList:
        if target.getTypeIdOfProperty(name) == "App::PropertyMap":
            replaced = True
            lines = text_lines(dict(getattr(target, name)))
            _replace(target, name, name, "App::PropertyStringList", lines)
        elif name in _LENGTHS:
            replaced = True
            length = getattr(target, name)
            _replace(target, name, _LENGTHS[name], "App::PropertyLength", length)
    # An older one still lacks what came in between.
    if replaced and getattr(target, "SchemaVersion", 0) == schema - 1:
        target.SchemaVersion = schema


def _replace(
    target: FreeCAD.DocumentObject, old: str, new: str, kind: str, value: list[str] | float
) -> None:
    heading, tip = target.getGroupOfProperty(old), target.getDocumentationOfProperty(old)
    mode = target.getEditorMode(old)
    target.removeProperty(old)
    target.addProperty(kind, new, heading, tip)
    setattr(target, new, value)
    target.setEditorMode(new, mode)
