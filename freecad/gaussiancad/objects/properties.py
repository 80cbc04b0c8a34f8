"""Properties of document objects from a table."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import IntFlag

import FreeCAD

PropertyValue = str | float | int | bool | list[str] | list[float]


class Access(IntFlag):
    """How the property editor treats a property (FreeCAD's own numbers)."""

    OPEN = 0
    READ_ONLY = 1
    HIDDEN = 2


@dataclass(frozen=True)
class PropertySpec:
    """A property to be added.

    Attributes:
        type_name: FreeCAD's type without ``App::Property``, such as ``String``.
        name: in CamelCase.
        group: heading in the property editor.
        tip: what it means; marked for translation in the context ``App::Property``.
        value: what it is set to.
        access: what the property editor allows.
    """

    type_name: str
    name: str
    group: str
    tip: str
    value: PropertyValue
    access: Access = Access.READ_ONLY


def add_properties(target: FreeCAD.DocumentObject, specs: Iterable[PropertySpec]) -> None:
    """Add the properties that are not there yet, and set all of them, in order."""
    for spec in specs:
        if spec.name not in target.PropertiesList:
            target.addProperty(f"App::Property{spec.type_name}", spec.name, spec.group, spec.tip)
        setattr(target, spec.name, spec.value)
        target.setEditorMode(spec.name, int(spec.access))


def text_map(values: Mapping[str, object], prefix: str = "") -> dict[str, str]:
    """Nested JSON values as one level of texts, with dotted keys."""
    flat: dict[str, str] = {}
    for key, value in values.items():
        if isinstance(value, Mapping):
            flat.update(text_map(value, f"{prefix}{key}."))
        elif value is not None:
            flat[f"{prefix}{key}"] = f"{value:.6g}" if isinstance(value, float) else str(value)
    return flat


_BETWEEN = ": "


def text_lines(values: Mapping[str, str]) -> list[str]:
    """Texts by name as lines: a list of these is shown by every FreeCAD, a PropertyMap is not."""
    return [f"{name}{_BETWEEN}{value}" for name, value in values.items()]


def texts_of(target: FreeCAD.DocumentObject, name: str) -> dict[str, str]:
    """The texts by name that :func:`text_lines` put into a property; none where it is not there."""
    parted = (line.partition(_BETWEEN) for line in getattr(target, name, []))
    return {item: value for item, _, value in parted}
