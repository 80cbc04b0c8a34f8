"""The numbers that drive a body: where each is, what it says, and how it is set."""

from dataclasses import dataclass

import FreeCAD

from freecad.gaussiancad.objects.body_model import ON_SHEET


@dataclass(frozen=True)
class DrivingNumber:
    """A number of a feature or of its sketch, as it was when the body was made.

    Attributes:
        feature: internal name of the feature.
        name: of a constraint of the feature's sketch, or of a property of the feature.
        value: mm.
        source: ``sheet`` of a number that the drawing tells, ``measured`` of others.
    """

    feature: str
    name: str
    value: float
    source: str

    @property
    def path(self) -> str:
        """By which a person finds it, such as ``Pad1.Length``."""
        return f"{self.feature}.{self.name}"

    @property
    def listed(self) -> str:
        """The same with the value, as it stands in lists."""
        return f"{self.path} = {self.value:g} mm"

    @property
    def on_sheet(self) -> bool:
        """Whether the drawing tells it."""
        return self.source == ON_SHEET


def value_of(feature: FreeCAD.DocumentObject, name: str) -> float | None:
    """The number of that name, mm; None where there is none any more.

    Args:
        feature: of a body.
        name: of a constraint of its sketch, else of a property of its own.
    """
    sketch = _sketch_with(feature, name)
    if sketch is not None:
        return float(sketch.getDatum(name).Value)
    found = getattr(feature, name, None)
    return float(found.Value) if hasattr(found, "Value") else None


def set_value(feature: FreeCAD.DocumentObject, name: str, value: float) -> None:
    """Give the number of that name another value, mm; it works with the next recompute.

    Raises:
        ValueError: the sketch has no solution then; or there is no such number.
    """
    sketch = _sketch_with(feature, name)
    if sketch is not None:
        sketch.setDatum(name, FreeCAD.Units.Quantity(value, FreeCAD.Units.Length))
    elif name in feature.PropertiesList:
        setattr(feature, name, value)
    else:
        raise ValueError(f"{feature.Name} has no {name}")


def _sketch_with(feature: FreeCAD.DocumentObject, name: str) -> FreeCAD.DocumentObject | None:
    """The sketch of a feature, where a constraint there has that name."""
    profile = getattr(feature, "Profile", None)
    sketch = profile[0] if isinstance(profile, tuple) else profile
    constraints = getattr(sketch, "Constraints", ())
    return sketch if any(each.Name == name for each in constraints) else None
