"""``gaussiancad read``: what is understood of a sheet, as a file that a person can correct."""

import argparse

from gaussiancad_core.cli.pages import add_page_option, run_pages
from gaussiancad_core.cli.reconstruct import (
    add_events_option,
    add_overwrite_option,
    add_reading_files,
    add_reading_options,
    greet,
    reading_of,
)
from gaussiancad_core.cli.values import named_path
from gaussiancad_core.messages import on_one_line
from gaussiancad_core.processes.events import Listener
from gaussiancad_core.processes.garbage import uncollected
from gaussiancad_core.report.job import Job, corrections_file_of
from gaussiancad_core.storage.outputs import READ_FILES
from gaussiancad_protocol.exit_codes import ExitCode


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser("read", help="read a sheet into a file that can be corrected")
    parser.add_argument(
        "sheet",
        type=named_path,
        metavar="SHEET",
        help="PNG, JPEG, TIFF, BMP, WebP, PDF, SVG or DXF",
    )
    parser.add_argument("--output", type=named_path, required=True, metavar="DIR")
    add_page_option(parser)
    add_reading_options(parser)
    add_reading_files(parser)
    add_overwrite_option(parser)
    add_events_option(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, listener: Listener) -> ExitCode:
    """Read one sheet, or each page of a file."""
    greet(listener)
    return run_pages(options, listener, _run_page)


def _run_page(options: argparse.Namespace, listener: Listener) -> ExitCode:
    job = Job(
        sheet=options.sheet,
        output=options.output,
        reading=reading_of(options),
        page=options.page,
        given=options.reading,
        corrections=options.corrections or corrections_file_of(options.sheet, options.page),
        overwrite=options.overwrite,
    )
    job.check(READ_FILES)

    # Modules are kept: looking for garbage among what they make takes a seventh of their time.
    with uncollected():
        from gaussiancad_core.readings.views_to_reading import READING_FILE
        from gaussiancad_core.run.read_run import read_to_file

    reading = read_to_file(job, listener)
    path = (options.output / READING_FILE).resolve()
    refused = [problem for problem in reading.problems if problem.severity == "refused"]
    listener.send("result", path=str(path), refused=len(refused))
    if not options.events:
        views = ", ".join(view.role.value for view in reading.views if view.used) or "no view"
        print(f"read: {on_one_line(str(path))}")
        print(f"  {views}; {len(reading.strokes)} strokes")
        for problem in reading.problems:
            print(f"  {problem.severity}: {on_one_line(problem.message)} [{problem.code}]")
    return ExitCode.DONE
