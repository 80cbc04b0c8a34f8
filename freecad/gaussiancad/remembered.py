"""What was chosen for the last reconstruction, kept in FreeCAD's parameters for the next one.

One rule says what a panel starts with.  Each setting starts as it was chosen last.  A setting that
the preferences page has as well starts from the page again once the page says something else than
it did when the choice was made: who changes the page wants its effect.  What belongs to one sheet,
its page and its scale, is not remembered.
"""

import re
from dataclasses import dataclass
from enum import Enum
from typing import TypeVar

import FreeCAD

from freecad.gaussiancad.engine.job import Projection, ReconstructJob
from freecad.gaussiancad.engine.paper_effort import LARGEST_SCALE_DOWN
from freecad.gaussiancad.engine.protocol import Preset, Recipe, ResultKind
from freecad.gaussiancad.preferences import GROUP, Preferences

LAST = f"{GROUP}/LastReconstruction"
"""The group of FreeCAD's parameters."""

_Mode = TypeVar("_Mode", bound=Enum)


@dataclass(frozen=True)
class Choices:
    """The settings that are the same for every sheet.

    Attributes:
        projection, preset, outcome, recipe: see their types.
        scale_down: by which the images' edges are divided; None where it follows the preset.
        colour: of the part, ``#RRGGBB``.
        output_folder: receives a folder for each run; empty for a temporary one.
        body: whether an exact solid becomes an editable body as well.
    """

    projection: Projection
    preset: Preset
    outcome: ResultKind
    recipe: Recipe = Recipe.ORTHOGRAPHIC
    scale_down: int | None = None
    colour: str = ReconstructJob.colour
    output_folder: str = ""
    body: bool = True


def starting_choices(preferences: Preferences) -> Choices:
    """What a panel starts with, by the rule above; a value out of range counts as never chosen."""
    group = FreeCAD.ParamGet(LAST)
    scale_down = group.GetInt("ScaleDown", 0)
    colour = group.GetString("Colour", "")
    return Choices(
        _mode(_word("Projection", preferences.projection.value), preferences.projection),
        _mode(_word("Preset", preferences.preset.value), preferences.preset),
        _mode(_word("Outcome", preferences.outcome.value), preferences.outcome),
        _mode(group.GetString("Recipe", ""), Recipe.ORTHOGRAPHIC),
        scale_down if 1 <= scale_down <= LARGEST_SCALE_DOWN else None,
        colour if _is_colour(colour) else ReconstructJob.colour,
        _word("OutputFolder", preferences.output_folder),
        group.GetBool("Body", True),
    )


def remember(choices: Choices, preferences: Preferences) -> None:
    """Keep what was chosen, and what the preferences page said then."""
    group = FreeCAD.ParamGet(LAST)
    for name, chosen, preferred in (
        ("Projection", choices.projection.value, preferences.projection.value),
        ("Preset", choices.preset.value, preferences.preset.value),
        ("Outcome", choices.outcome.value, preferences.outcome.value),
        ("OutputFolder", choices.output_folder, preferences.output_folder),
    ):
        group.SetString(name, chosen)
        group.SetString(_preferred(name), preferred)
    group.SetString("Recipe", choices.recipe.value)
    group.SetInt("ScaleDown", choices.scale_down or 0)
    group.SetString("Colour", choices.colour)
    group.SetBool("Body", choices.body)


def is_more_open() -> bool:
    """Whether *More settings* stood open last."""
    return FreeCAD.ParamGet(LAST).GetBool("MoreOpen", False)


def remember_more_open(opened: bool) -> None:
    """Keep whether *More settings* stands open."""
    FreeCAD.ParamGet(LAST).SetBool("MoreOpen", opened)


def _preferred(name: str) -> str:
    return f"{name}Preferred"


def _word(name: str, preferred: str) -> str:
    """What was chosen, or the preference where it has changed since, or nothing was chosen."""
    group = FreeCAD.ParamGet(LAST)
    unset = "\n"
    if group.GetString(_preferred(name), unset) != preferred:
        return preferred
    return group.GetString(name, preferred)


def _mode(word: str, default: _Mode) -> _Mode:
    return next((mode for mode in type(default) if mode.value == word), default)


def _is_colour(text: str) -> bool:
    return re.fullmatch("#[0-9a-fA-F]{6}", text) is not None
