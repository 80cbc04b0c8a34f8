"""Where the engine is: what the user named, what the addon manages, what lies beside the addon.

The first of these that is set counts.  A place that the user named and that does not work is an
error: a silent fallback would run another engine than the one asked for.
"""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.paths import ADDON_ROOT
from freecad.gaussiancad.qt import QtCore

VARIABLE = "GAUSSIANCAD_PYTHON"

MARKER = "engine.json"
"""File in the managed environment that is written once it is complete."""


class EngineSource(Enum):
    """How the engine was found."""

    VARIABLE = "variable"
    PREFERENCE = "preference"
    MANAGED = "managed"
    BESIDE_ADDON = "beside-addon"


@dataclass(frozen=True)
class Engine:
    """An interpreter in whose environment the engine is installed.

    Attributes:
        python: path of the interpreter.
        source: how it was found.
    """

    python: str
    source: EngineSource

    def describe(self) -> str:
        """One sentence for the user: which interpreter, and why this one."""
        reasons = {
            EngineSource.VARIABLE: translate(
                "GaussianCAD", "named by the environment variable GAUSSIANCAD_PYTHON"
            ),
            EngineSource.PREFERENCE: translate("GaussianCAD", "named in the preferences"),
            EngineSource.MANAGED: translate("GaussianCAD", "installed by GaussianCAD"),
            EngineSource.BESIDE_ADDON: translate("GaussianCAD", "found beside the addon"),
        }
        return f"{self.python} ({reasons[self.source]})"


@dataclass(frozen=True)
class SearchPlaces:
    """Where to look, in order.

    Attributes:
        variable: value of GAUSSIANCAD_PYTHON, or empty.
        preference: value of the preference, or empty.
        managed: root of the environment that the addon manages.
        checkout: root of the environment beside the addon.
    """

    variable: str
    preference: str
    managed: Path
    checkout: Path

    @classmethod
    def of_this_machine(cls, preference: str, variables: Mapping[str, str]) -> "SearchPlaces":
        """The places on this machine.

        Args:
            preference: value of the preference.
            variables: the environment variables.
        """
        return cls(
            variables.get(VARIABLE, "").strip(),
            preference.strip(),
            managed_environment(),
            ADDON_ROOT / ".venv",
        )


def managed_environment() -> Path:
    """Root of the environment that the addon manages, outside of FreeCAD's versioned folders."""
    location = QtCore.QStandardPaths.StandardLocation.GenericDataLocation
    data = QtCore.QStandardPaths.writableLocation(location)
    return Path(data) / "GaussianCAD" / "engine"


def find_engine(places: SearchPlaces) -> Engine:
    """The engine to use.

    Raises:
        WorkbenchError: a named interpreter does not exist, or no engine is there at all.
    """
    named = (
        (places.variable, EngineSource.VARIABLE),
        (places.preference, EngineSource.PREFERENCE),
    )
    for path, source in named:
        if path:
            return _named_engine(path, source)
    if (places.managed / MARKER).is_file() and (python := interpreter_of(places.managed)):
        return Engine(str(python), EngineSource.MANAGED)
    if python := interpreter_of(places.checkout):
        return Engine(str(python), EngineSource.BESIDE_ADDON)
    raise WorkbenchError(
        ErrorCode.ENGINE_NOT_FOUND,
        translate(
            "GaussianCAD",
            "The GaussianCAD engine is not installed. Choose GaussianCAD > Install Engine, or name "
            "the engine's Python in Edit > Preferences > GaussianCAD.",
        ),
    )


def interpreter_of(root: Path) -> Path | None:
    """The interpreter of the virtual environment at ``root``, or None."""
    for relative in ("bin/python", "bin/python3", "Scripts/python.exe"):
        candidate = root / relative
        if _is_program(candidate):
            return candidate
    return None


def _named_engine(path: str, source: EngineSource) -> Engine:
    expanded = Path(os.path.expanduser(path))
    if _is_program(expanded):
        return Engine(str(expanded), source)
    if source is EngineSource.VARIABLE:
        message = translate(
            "GaussianCAD",
            "GAUSSIANCAD_PYTHON names {path}, which is not a program that can be run. Correct the "
            "variable or unset it.",
        )
    else:
        message = translate(
            "GaussianCAD",
            "The preferences name {path} as the engine's Python, which is not a program that can "
            "be run. Correct it in Edit > Preferences > GaussianCAD.",
        )
    raise WorkbenchError(ErrorCode.ENGINE_NOT_FOUND, message.format(path=path))


def _is_program(path: Path) -> bool:
    return path.is_file() and os.access(path, os.X_OK)
