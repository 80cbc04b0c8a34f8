"""What the engine and the workbench agree on, from the package that both of them use.

In the addon it lies in ``core/``; where the canvas is installed without FreeCAD, beside it.
"""

import sys
from importlib.util import find_spec
from pathlib import Path

if find_spec("gaussiancad_protocol") is None:
    # At the end, so that nothing of the engine hides what FreeCAD's Python has.
    sys.path.append(str(Path(__file__).resolve().parents[3] / "core"))

from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.event_lines import (
    Event,
    EventKind,
    LineBuffer,
    parse_event,
)
from gaussiancad_protocol.exit_codes import ExitCode
from gaussiancad_protocol.modes import Preset, Recipe, ResultKind, Status
from gaussiancad_protocol.reading_kinds import (
    DOUBT,
    DRAWN,
    KIND_COLOURS,
    OTHER_COLOUR,
)

__all__ = [
    "DOUBT",
    "DRAWN",
    "KIND_COLOURS",
    "OTHER_COLOUR",
    "Code",
    "Event",
    "EventKind",
    "ExitCode",
    "LineBuffer",
    "Preset",
    "Recipe",
    "ResultKind",
    "Status",
    "parse_event",
]
