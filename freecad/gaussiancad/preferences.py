"""The addon's preferences, read from FreeCAD's parameters."""

from dataclasses import dataclass
from enum import Enum
from typing import TypeVar

import FreeCAD

from freecad.gaussiancad.engine.job import Projection
from freecad.gaussiancad.engine.protocol import Preset, ResultKind

GROUP = "User parameter:BaseApp/Preferences/Mod/GaussianCAD"

_Mode = TypeVar("_Mode", bound=Enum)


@dataclass(frozen=True)
class Preferences:
    """What the preferences page holds.

    There is no unit among them: the engine's parts are in millimetres, as FreeCAD's own are, and
    FreeCAD's unit system decides how their sizes are shown.

    Attributes:
        engine_python: the engine's interpreter, or empty.
        preset, projection, outcome: what the task panel starts with, until something else is
            chosen in it (:mod:`freecad.gaussiancad.remembered` tells the rule).
        output_folder: folder that receives a folder for each run, or empty for a temporary one.
        view_planes: whether the drawing's views are added as pictures around the part.
    """

    engine_python: str
    preset: Preset
    projection: Projection
    outcome: ResultKind
    output_folder: str
    view_planes: bool


def read_preferences() -> Preferences:
    """The preferences as they are now; a value out of range counts as the usual one."""
    group = FreeCAD.ParamGet(GROUP)
    return Preferences(
        group.GetString("EnginePython", ""),
        _mode(Preset, group.GetInt("Preset", 1), Preset.STANDARD),
        _mode(Projection, group.GetInt("Projection", 0), Projection.AUTO),
        _mode(ResultKind, group.GetInt("Outcome", 0), ResultKind.BOTH),
        group.GetString("OutputFolder", ""),
        group.GetBool("ViewPlanes", True),
    )


def _mode(modes: type[_Mode], index: int, default: _Mode) -> _Mode:
    """The preferences page stores the index of a combo box's entry."""
    members = list(modes)
    return members[index] if 0 <= index < len(members) else default
