"""``gaussiancad batch``: many sheets, each in a process of its own."""

import argparse
import os
from collections.abc import Sequence
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from gaussiancad_core.cli import values
from gaussiancad_core.cli.reconstruct import add_events_option, add_job_options, greet, job_of
from gaussiancad_core.cli.values import named_path
from gaussiancad_core.errors import UsageError
from gaussiancad_core.processes.events import Listener
from gaussiancad_core.report.job import Job
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

if TYPE_CHECKING:
    from gaussiancad_core.batches.batch_run import SheetDone

_USUAL_MEMORY = 4.0
"""GB that a sheet may take; few take more than 2."""

_USUAL_SECONDS = 1800.0
"""s that a sheet may take; most take less than a minute, the search for a solid 900 at most."""

_BUDGET = 0.8
"""Share of the machine's memory that all workers together take at most."""

_EXPECTED = 2.0
"""GB that workers are reckoned with."""


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser("batch", help="make models from many sheets")
    parser.add_argument(
        "sheets",
        nargs="+",
        metavar="SHEET|FOLDER|TABLE.csv",
        help="files, folders of drawings, patterns, tables with a column 'sheet' and options",
    )
    parser.add_argument("--output", type=named_path, required=True, metavar="DIR")
    parser.add_argument(
        "--workers",
        type=values.count,
        metavar="N",
        help="sheets at a time; as many as there are cores, and memory for",
    )
    parser.add_argument(
        "--memory",
        type=values.positive,
        default=_USUAL_MEMORY,
        metavar="GB",
        help="that a sheet may take",
    )
    parser.add_argument(
        "--seconds",
        type=values.positive,
        default=_USUAL_SECONDS,
        metavar="S",
        help="that a sheet may take",
    )
    parser.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="of a Dask cluster that does the work, as tcp://host:8786; its machines share folders",
    )
    parser.add_argument("--page", type=values.count, default=1, metavar="N")
    add_job_options(parser)
    add_events_option(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, listener: Listener) -> ExitCode:
    """Reconstruct the sheets, some at a time."""
    greet(listener)
    from gaussiancad_core.batches.batch_inputs import collect_sheets
    from gaussiancad_core.batches.batch_page import PAGE_FILE
    from gaussiancad_core.batches.batch_run import BatchSettings, run_batch
    from gaussiancad_core.batches.batch_table import REPORT_FILE
    from gaussiancad_core.batches.manifest import MANIFEST_FILE
    from gaussiancad_core.processes.supervisor import ProcessLimits
    from gaussiancad_core.storage.foreign_files import check_no_foreign

    made_before = (options.output / MANIFEST_FILE).is_file()
    if not options.overwrite and not made_before:
        check_no_foreign(options.output, (REPORT_FILE, PAGE_FILE))
    job = job_of(options, Path(), options.output)
    sheets = collect_sheets(options.sheets, job, lambda items: _job_with(options, items))
    limits = ProcessLimits(int(options.memory * 2**30), options.seconds)
    workers = min(options.workers or _usual_workers(), len(sheets))
    settings = BatchSettings(options.output, workers, limits, options.resume, options.scheduler)
    tell = partial(_send, listener) if options.events else _print_sheet
    rows = run_batch(sheets, settings, tell)
    failed = [row for row in rows if row.exit_code]
    report = os.path.abspath(options.output / REPORT_FILE)
    listener.send("result", path=report, sheets=len(rows), failed=len(failed))
    return ExitCode.SOME_SHEETS_FAILED if failed else ExitCode.DONE


def _send(listener: Listener, sheet: "SheetDone") -> None:
    """The event of a sheet: what the report has of it, and which files its folder has."""
    from gaussiancad_core.batches.manifest import files_under

    folder = Path(sheet.row.folder)
    files = [] if folder.is_symlink() else sorted(files_under(folder))
    listener.send(
        "sheet",
        **asdict(sheet.row),
        files=files,
        kept=sheet.kept,
        done=sheet.done,
        count=sheet.count,
        rate=round(sheet.rate, 2),
        eta_s=sheet.left_s if sheet.left_s is None else round(sheet.left_s, 1),
    )


def _print_sheet(sheet: "SheetDone") -> None:
    row = sheet.row
    message = f"{row.message} [{row.code}]" if row.code else row.message
    pace = (
        "" if sheet.left_s is None else f" ({sheet.rate:.1f} a minute, {_span(sheet.left_s)} left)"
    )
    line = f"{sheet.done}/{sheet.count} {row.status:12} {row.name}: {message or row.folder}{pace}"
    print(line.encode("utf-8", "backslashreplace").decode(), flush=True)


def _span(seconds: float) -> str:
    """Hours and minutes, or seconds."""
    minutes = round(seconds / 60.0)
    return f"{minutes // 60} h {minutes % 60:02} min" if minutes else f"{seconds:.0f} s"


def _usual_workers() -> int:
    import psutil

    most = int(_BUDGET * psutil.virtual_memory().total / (_EXPECTED * 2**30))
    return max(1, min(os.cpu_count() or 1, most))


def _job_with(options: argparse.Namespace, items: Sequence[str]) -> Job:
    """The job that options of a line of a table describe, beside those of the batch."""
    parser = _LineParser(prog="gaussiancad batch", add_help=False)
    parser.add_argument("--page", type=values.count, default=1, metavar="N")
    add_job_options(parser)
    # What the line says replaces what was said for all: of a length and a scale one counts.
    names = {name for name in ("length", "mm_per_pixel") if _names(items, name)}
    base = {**vars(options), **({"length": None, "mm_per_pixel": None} if names else {})}
    found = parser.parse_args(list(items), argparse.Namespace(**base))
    return job_of(found, Path(), options.output)


def _names(items: Sequence[str], name: str) -> bool:
    return any(each.startswith(f"--{name.replace('_', '-')}=") for each in items)


class _LineParser(argparse.ArgumentParser):
    """A parser whose errors are the engine's."""

    def error(self, message: str) -> None:  # type: ignore[override]
        """Raise a usage error."""
        raise UsageError(Code.WRONG_USAGE, message)
