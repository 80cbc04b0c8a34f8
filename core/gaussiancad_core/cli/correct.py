"""``gaussiancad correct``: the window in which a person corrects what was read of a sheet."""

import argparse

from gaussiancad_core.cli import values
from gaussiancad_core.cli.values import named_path
from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.files.file_opening import head_of
from gaussiancad_core.processes.events import Listener
from gaussiancad_core.readings.reading_files import open_corrections
from gaussiancad_core.report.job import corrections_file_of
from gaussiancad_core.storage.extras import Extra, demand
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

_REPORTS = (".csv", ".json")
"""How the names of a batch's reports end."""


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser(
        "correct", help="show what was read of a sheet in a window, and correct it"
    )
    parser.add_argument(
        "sheet",
        type=named_path,
        metavar="SHEET",
        help="or the report of a batch, report.csv or report.json: those of its sheets that are "
        "not verified, to step through",
    )
    parser.add_argument("--page", type=values.count, default=1, metavar="N")
    parser.set_defaults(run=run, events=False)


def run(options: argparse.Namespace, listener: Listener) -> ExitCode:
    """Open the window.

    Raises:
        UnreadableError: the sheet is missing, empty, or of a kind that is not read;
            ``corrections-not-read``, the corrections beside it are damaged; ``batch-not-read``, a
            report is none of a batch.
        EngineError: ``extra-missing``, Qt is not there.
    """
    of_batch = options.sheet.suffix.lower() in _REPORTS
    if not of_batch:
        head_of(options.sheet)
        path = corrections_file_of(options.sheet, options.page)
        if path is not None:
            open_corrections(path)
    demand(Extra.WINDOW, "the window")
    from freecad.gaussiancad.canvas.failed import failed_sheets
    from freecad.gaussiancad.canvas.standalone import show

    if not of_batch:
        return ExitCode(show(options.sheet, options.page))
    try:
        failed = failed_sheets(options.sheet)
    except FileNotFoundError as error:
        text = f"{options.sheet} does not exist: check the name of the report"
        raise UnreadableError(Code.FILE_MISSING, text) from error
    except (OSError, ValueError) as error:
        raise UnreadableError(Code.BATCH_NOT_READ, str(error)) from error
    if not failed:
        print("every sheet of this batch is verified")
        return ExitCode.DONE
    return ExitCode(show(failed[0].sheet, failed[0].page, failed))
