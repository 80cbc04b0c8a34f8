"""``gaussiancad batch``: many sheets, each in a process of its own."""

import argparse
from pathlib import Path

from gaussiancad_core.cli import values
from gaussiancad_core.cli.reconstruct import add_job_options, job_of
from gaussiancad_core.errors import ExitCode, UsageError
from gaussiancad_core.events import Listener


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser("batch", help="make models from many sheets")
    parser.add_argument("sheets", type=Path, nargs="+", metavar="SHEET")
    parser.add_argument("--output", type=Path, required=True, metavar="DIR")
    parser.add_argument("--workers", type=values.count, default=1, metavar="N")
    parser.add_argument("--scheduler", metavar="ADDRESS", help=argparse.SUPPRESS)
    add_job_options(parser)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, _listener: Listener) -> ExitCode:
    """Reconstruct the sheets one by one or ``--workers`` at a time."""
    from gaussiancad_core.batch import run_batch

    if options.scheduler:
        raise UsageError(
            "scheduler-unsupported",
            "this version works on one machine only: leave --scheduler out, use --workers",
        )
    job = job_of(options, options.sheets[0], options.output)
    rows = run_batch(options.sheets, job, options.workers)
    failed = [row for row in rows if row.exit_code]
    for row in rows:
        print(f"{row.status:12} {row.name}: {row.message or row.folder}")
    return ExitCode.SOME_SHEETS_FAILED if failed else ExitCode.DONE
