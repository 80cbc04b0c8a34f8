"""``gaussiancad correct``: the window in which a person corrects what was read of a sheet."""

import argparse
import sys
from importlib.util import find_spec
from pathlib import Path

from gaussiancad_core.cli import values
from gaussiancad_core.errors import ExitCode, UsageError
from gaussiancad_core.events import Listener
from gaussiancad_core.job import corrections_beside
from gaussiancad_core.readings.opening import open_typed
from gaussiancad_core.readings.operations import Corrections
from gaussiancad_core.sheet.files.opening import head_of


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser(
        "correct", help="show what was read of a sheet in a window, and correct it"
    )
    parser.add_argument("sheet", type=Path, metavar="SHEET")
    parser.add_argument("--page", type=values.count, default=1, metavar="N")
    parser.set_defaults(run=run, events=False)


def run(options: argparse.Namespace, listener: Listener) -> ExitCode:
    """Open the window.

    Raises:
        UnreadableError: the sheet is missing, empty, or of a kind that is not read;
            ``corrections-not-read``, the corrections beside it are damaged.
        UsageError: ``window-missing``, Qt or the workbench is not there.
    """
    head_of(options.sheet)
    beside = corrections_beside(options.sheet, options.page)
    if beside is not None:
        open_typed(beside, Corrections, "corrections-not-read")
    root = Path(__file__).resolve().parents[3]
    if find_spec("PySide6") is None or not (root / "freecad" / "gaussiancad").is_dir():
        raise UsageError(
            "window-missing",
            "the window needs PySide6 and the workbench beside the engine: install PySide6 into "
            "the engine's environment (pip install 'PySide6-Essentials<6.12'), or correct it in "
            "FreeCAD",
        )
    sys.path.insert(0, str(root))
    from freecad.gaussiancad.canvas.window import show

    return ExitCode(show(options.sheet, options.page))
