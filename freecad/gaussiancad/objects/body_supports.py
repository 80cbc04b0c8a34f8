"""Sketches and far ends that follow the faces they lie in, by expressions of the numbers that put
those faces where they are.  Nothing refers to a face itself, whose number changes with the shape.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import FreeCAD

from freecad.gaussiancad.objects.body_model import (
    Extrusion,
    Feature,
    Holes,
    Plane,
    Support,
    Turning,
)

_Terms = tuple[tuple[int, str], ...]
"""Paths of properties, each with 1 or -1: a sum in mm."""

_AXES = "xyz"


@dataclass(frozen=True)
class MadeFeature:
    """A feature that is in the document.

    Attributes:
        feature: what it was made from.
        made: the document's object.
    """

    feature: Feature
    made: FreeCAD.DocumentObject


Earlier = Mapping[str, MadeFeature]
"""What was made before, by the names that the features have in the engine's file."""


def bind_offset(
    sketch: FreeCAD.DocumentObject, plane: Plane, support: Support | None, earlier: Earlier
) -> None:
    """Let a sketch's offset follow the face that it lies in, where its place is told by numbers.

    Args:
        sketch: attached to its plane.
        plane: where it is.
        support: the face, or None.
        earlier: the features that are made.
    """
    terms = _place(support, plane, earlier)
    if not terms:
        return
    if plane.name:
        sketch.setExpression("AttachmentOffset.Base.z", _sum(terms))
        return
    for axis, part in zip(_AXES, plane.normal, strict=True):
        if part:
            sketch.setExpression(f"AttachmentOffset.Base.{axis}", f"({_sum(terms)}) * {part!r}")


def bind_length(
    made: FreeCAD.DocumentObject, name: str, feature: Extrusion | Holes, earlier: Earlier
) -> None:
    """Let a feature's length follow the face that it ends at, where its place is told by numbers.

    Args:
        made: the feature in the document, with its sketch.
        name: of the length, ``Length`` or ``Depth``.
        feature: what it is made from.
        earlier: the features that were made before.
    """
    plane = feature.sketch.plane
    end = _place(feature.ends_at, plane, earlier)
    if end is None:
        return
    sides = _sides_between(feature.stands_on, feature.ends_at)
    if sides is not None:
        made.setExpression(name, f"{earlier[sides].made.Name}.Length")
        return
    start = _offset(sketch_of(made), plane)
    goes_along = feature.length > 0.0 if isinstance(feature, Extrusion) else not feature.downward
    low, high = (start, end) if goes_along else (end, start)
    made.setExpression(name, _sum((*high, *((-sign, path) for sign, path in low))))


def sketch_of(made: FreeCAD.DocumentObject) -> FreeCAD.DocumentObject:
    """The sketch of a feature; the type of ``Profile`` differs between versions."""
    profile = made.Profile
    return profile[0] if isinstance(profile, tuple) else profile


def has_expression(made: FreeCAD.DocumentObject, name: str) -> bool:
    """Whether a property follows from others: it is no number of its own."""
    return any(path.lstrip(".") == name for path, _ in made.ExpressionEngine)


def _sides_between(begins: Support | None, ends: Support | None) -> str | None:
    """The name of the feature that lies between both faces: its own two."""
    if begins is None or ends is None or begins.feature != ends.feature:
        return None
    return begins.feature if {begins.side, ends.side} == {"start", "end"} else None


def _place(support: Support | None, plane: Plane, earlier: Earlier) -> _Terms | None:
    """What tells where a face is along a plane's normal; None where no numbers do."""
    found = None if support is None else earlier.get(support.feature)
    if support is None or found is None or not isinstance(found.feature, Extrusion | Turning):
        return None
    sketch = sketch_of(found.made)
    if support.side == "wall":
        return _dimensions(support, sketch)
    start = _offset(sketch, plane)
    if support.side == "start" or not isinstance(found.feature, Extrusion):
        return start
    way = 1 if found.feature.length > 0.0 else -1
    return (*start, (way, f"{found.made.Name}.Length"))


def _dimensions(support: Support, sketch: FreeCAD.DocumentObject) -> _Terms | None:
    known = {each.Name for each in sketch.Constraints}
    if support.dimensions is None or any(name not in known for name, _ in support.dimensions):
        return None
    return tuple((way, f"{sketch.Name}.Constraints.{name}") for name, way in support.dimensions)


def _offset(sketch: FreeCAD.DocumentObject, plane: Plane) -> _Terms:
    """Where a sketch is along the normal of its plane."""
    base = f"{sketch.Name}.AttachmentOffset.Base"
    if plane.name:
        return ((1, f"{base}.z"),)
    largest = max(range(3), key=lambda k: abs(plane.normal[k]))
    return ((1, f"{base}.{_AXES[largest]} / ({plane.normal[largest]!r})"),)


def _sum(terms: Sequence[tuple[int, str]]) -> str:
    ordered = sorted(terms, key=lambda term: -term[0])
    text = " ".join(f"{'+' if sign > 0 else '-'} {path}" for sign, path in ordered)
    return f"-{text[2:]}" if text.startswith("-") else text.removeprefix("+ ")
