"""Kinds of strokes and roles of views: their keys, and the colours in which they are shown."""

from freecad.gaussiancad import language
from freecad.gaussiancad.engine import protocol
from freecad.gaussiancad.engine.wording import drawing_name
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP

KEYS = {
    "V": "visible",
    "H": "hidden",
    "C": "centre",
    "T": "tangent",
    "D": "dimension",
    "I": "ignore",
}
"""The kind that a key gives to what is selected."""

ROLES = ("front", "top", "right", "left", "bottom", "rear")
"""The principal views, in the order of the keys 1 to 6."""

DRAWN = tuple(kind.value for kind in protocol.DRAWN)
"""Kinds that the part is made of."""

COLOURS = {kind.value: colour for kind, colour in protocol.KIND_COLOURS.items()}
"""The same as in ``reading.png``."""

VIEW, UNUSED = "#28a0dc", "#bebebe"
"""Frames of views, and of what is no view."""

NUMBER, PLANE, MARK, CHOSEN = "#2e8b2e", "#aa3c00", "#dc1e1e", "#dc1e1e"
"""Numbers and notes; cutting planes; places of problems; what is selected."""

OTHER = protocol.OTHER_COLOUR

DOUBTFUL, DOUBT = "#ff8c00", protocol.DOUBT
"""Colour of strokes whose kind is less sure than this."""

_NAMES = {
    "visible": QT_TRANSLATE_NOOP("GaussianCAD", "visible"),
    "hidden": QT_TRANSLATE_NOOP("GaussianCAD", "hidden"),
    "centre": QT_TRANSLATE_NOOP("GaussianCAD", "centre line"),
    "tangent": QT_TRANSLATE_NOOP("GaussianCAD", "tangent edge"),
    "dimension": QT_TRANSLATE_NOOP("GaussianCAD", "dimension"),
    "ignore": QT_TRANSLATE_NOOP("GaussianCAD", "ignore"),
    "cut": QT_TRANSLATE_NOOP("GaussianCAD", "cutting line"),
    "hatch": QT_TRANSLATE_NOOP("GaussianCAD", "hatching"),
    "extension": QT_TRANSLATE_NOOP("GaussianCAD", "extension line"),
    "leader": QT_TRANSLATE_NOOP("GaussianCAD", "leader"),
    "frame": QT_TRANSLATE_NOOP("GaussianCAD", "frame"),
    "text": QT_TRANSLATE_NOOP("GaussianCAD", "writing"),
    "thread": QT_TRANSLATE_NOOP("GaussianCAD", "thread"),
    "symbol": QT_TRANSLATE_NOOP("GaussianCAD", "symbol"),
    "picture": QT_TRANSLATE_NOOP("GaussianCAD", "line of a pictorial view"),
    "line": QT_TRANSLATE_NOOP("GaussianCAD", "Line"),
    "arc": QT_TRANSLATE_NOOP("GaussianCAD", "Arc"),
    "circle": QT_TRANSLATE_NOOP("GaussianCAD", "Circle"),
    "view": QT_TRANSLATE_NOOP("GaussianCAD", "View"),
    "scale": QT_TRANSLATE_NOOP("GaussianCAD", "Scale"),
    "ignore-area": QT_TRANSLATE_NOOP("GaussianCAD", "Ignore Area"),
    "pick": QT_TRANSLATE_NOOP("GaussianCAD", "Pick from Ink"),
    "plane": QT_TRANSLATE_NOOP("GaussianCAD", "Cutting Plane"),
    "section": QT_TRANSLATE_NOOP("GaussianCAD", "section"),
    "detail": QT_TRANSLATE_NOOP("GaussianCAD", "detail"),
    "auxiliary": QT_TRANSLATE_NOOP("GaussianCAD", "auxiliary view"),
    "pictorial": QT_TRANSLATE_NOOP("GaussianCAD", "pictorial"),
    "sheet": QT_TRANSLATE_NOOP("GaussianCAD", "Sheet"),
    "views": QT_TRANSLATE_NOOP("GaussianCAD", "Views"),
    "strokes": QT_TRANSLATE_NOOP("GaussianCAD", "Lines of the Part"),
    "annotation": QT_TRANSLATE_NOOP("GaussianCAD", "Other Lines"),
    "numbers": QT_TRANSLATE_NOOP("GaussianCAD", "Numbers and Notes"),
    "planes": QT_TRANSLATE_NOOP("GaussianCAD", "Cutting Planes"),
    "marks": QT_TRANSLATE_NOOP("GaussianCAD", "Problems and Disagreements"),
    "front": QT_TRANSLATE_NOOP("GaussianCAD", "front"),
    "top": QT_TRANSLATE_NOOP("GaussianCAD", "top"),
    "right": QT_TRANSLATE_NOOP("GaussianCAD", "right"),
    "left": QT_TRANSLATE_NOOP("GaussianCAD", "left"),
    "bottom": QT_TRANSLATE_NOOP("GaussianCAD", "bottom"),
    "rear": QT_TRANSLATE_NOOP("GaussianCAD", "rear"),
}


def name_of(word: str) -> str:
    """A kind, a role or a tool as a person reads it; ids of what is no view by their kind."""
    if word in _NAMES:
        return language.translate("GaussianCAD", _NAMES[word])
    kind, _, number = word.rpartition("-")
    return f"{drawing_name(kind)} {number}" if number.isdigit() else word
