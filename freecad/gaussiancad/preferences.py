"""The addon's preferences, read from FreeCAD's parameters."""

from dataclasses import dataclass
from enum import Enum
from typing import TypeVar

import FreeCAD

from freecad.gaussiancad.engine.job import Preset, Projection

GROUP = "User parameter:BaseApp/Preferences/Mod/GaussianCAD"

_Mode = TypeVar("_Mode", bound=Enum)


@dataclass(frozen=True)
class Preferences:
    """What the preferences page holds.

    Attributes:
        engine_python: the engine's interpreter, or empty.
        preset, projection: what the task panel starts with.
        output_folder: folder that receives a folder for each run, or empty for a temporary one.
    """

    engine_python: str
    preset: Preset
    projection: Projection
    output_folder: str


def read_preferences() -> Preferences:
    """The preferences as they are now."""
    group = FreeCAD.ParamGet(GROUP)
    return Preferences(
        group.GetString("EnginePython", ""),
        _mode(Preset, group.GetInt("Preset", 1), Preset.STANDARD),
        _mode(Projection, group.GetInt("Projection", 0), Projection.AUTO),
        group.GetString("OutputFolder", ""),
    )


def _mode(modes: type[_Mode], index: int, default: _Mode) -> _Mode:
    """The preferences page stores the index of a combo box's entry."""
    members = list(modes)
    return members[index] if 0 <= index < len(members) else default
