"""``gaussiancad explain``: why a result is what it is, in sentences."""

import argparse
import json
import tempfile
from pathlib import Path
from typing import Any

from gaussiancad_core.cli.values import named_path
from gaussiancad_core.errors import UnreadableError, UsageError
from gaussiancad_core.processes.events import Listener
from gaussiancad_core.storage.plain_files import plain_bytes
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

_SCHEMAS = (2, "gaussiancad-reading/1", "gaussiancad-construction/1", "gaussiancad-construction/2")
"""Of the files that are read: the report, the reading, the construction."""


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand ``explain``."""
    parser = commands.add_parser(
        "explain", help="say what was tried for a sheet, and why its solid is not certain"
    )
    parser.add_argument(
        "folder",
        metavar="DIR|SHEET",
        type=named_path,
        help="output folder of a run, or a sheet to read",
    )
    place = parser.add_mutually_exclusive_group()
    place.add_argument("--at", metavar="X,Y", help="what is known of a place, px of the sheet")
    place.add_argument("--view", metavar="ROLE", help="what is known of a view: front, top, ...")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, _listener: Listener) -> ExitCode:
    """Print the explanation."""
    if options.folder.is_file():
        lines = _of_sheet(options)
    else:
        try:
            lines = _of_run(options)
        except (KeyError, TypeError) as error:
            raise UnreadableError(
                Code.DAMAGED_REPORT,
                "{path} cannot be read: {reason}",
                path=options.folder,
                reason=error,
            ) from error
    print("\n".join(lines))
    return ExitCode.DONE


def _of_run(options: argparse.Namespace) -> list[str]:
    """What a run left in its folder, in all, of a view, or at a place."""
    from gaussiancad_core.report.explanation import explained, explained_place, explained_view

    report = _values(options.folder / "report.json")
    if options.at is not None:
        lines = explained_place(report, _reading(options.folder), _place(options.at))
    elif options.view is not None:
        if options.view not in report["views"]:
            known = ", ".join(report["views"]) or "none"
            raise UsageError(
                Code.UNKNOWN_VIEW,
                "the sheet has no view {view}; it has: {known}",
                view=options.view,
                known=known,
            )
        lines = explained_view(report, _reading(options.folder), options.view)
    else:
        lines = explained(report)
        construction = options.folder / "construction.json"
        if construction.is_file():
            from gaussiancad_core.report.construction_sentences import construction_in_words

            lines += ["", "How it was put together:"]
            lines += construction_in_words(_values(construction))
    return lines


def _of_sheet(options: argparse.Namespace) -> list[str]:
    """What is read on a sheet, in all or at a place."""
    from gaussiancad_core.processes.events import Silence
    from gaussiancad_core.report.explanation import read_place, read_sheet_in_words
    from gaussiancad_core.report.job import Job, corrections_file_of
    from gaussiancad_core.run.read_run import read_to_file

    if options.view is not None:
        raise UsageError(Code.WRONG_USAGE, "--view needs the output folder of a run, not a sheet")
    with tempfile.TemporaryDirectory() as folder:
        job = Job(options.folder, Path(folder), corrections=corrections_file_of(options.folder))
        job.check()
        values = read_to_file(job, Silence()).values()
    if options.at is None:
        return read_sheet_in_words(values)
    return read_place(values, _place(options.at))


def _reading(folder: Path) -> dict[str, Any]:
    return _values(folder / "reading.json")


def _values(path: Path) -> dict[str, Any]:
    """The JSON object of a file that a run wrote."""
    try:
        values = json.loads(plain_bytes(path))
    except FileNotFoundError:
        raise UnreadableError(
            Code.NO_REPORT, "{path} does not exist: give the output folder of a run", path=path
        ) from None
    except (OSError, ValueError, RecursionError) as error:
        raise UnreadableError(
            Code.DAMAGED_REPORT, "{path} cannot be read: {reason}", path=path, reason=error
        ) from error
    if not isinstance(values, dict) or values.get("schema") not in _SCHEMAS:
        raise UnreadableError(
            Code.OLD_REPORT, "{path} was written by another version: run the sheet again", path=path
        )
    return values


def _place(text: str) -> tuple[float, float]:
    try:
        x, y = (float(part) for part in text.split(","))
    except ValueError:
        raise UsageError(Code.WRONG_USAGE, f"--at {text}: give X,Y in px of the sheet") from None
    return x, y
