"""``gaussiancad compare``: a result against a reference."""

import argparse
from pathlib import Path

from gaussiancad_core.cli import values
from gaussiancad_core.errors import ExitCode
from gaussiancad_core.events import Listener


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser("compare", help="measure a model against a reference")
    parser.add_argument("result", type=Path, metavar="RESULT", help="STEP, BREP, STL, PLY or OBJ")
    parser.add_argument("reference", type=Path, metavar="REFERENCE")
    parser.add_argument("--output", type=Path, metavar="DIR")
    parser.add_argument("--points", type=values.count, default=10_000, metavar="N")
    parser.add_argument("--seed", type=values.whole, default=0, metavar="N")
    parser.add_argument("--json", action="store_true", help="print comparison.json")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, _listener: Listener) -> ExitCode:
    """Compare two files and print the figures."""
    from gaussiancad_core.cli.libraries import silence_opencascade
    from gaussiancad_core.comparison.command import compare_files
    from gaussiancad_core.comparison.report import comparison_json, comparison_text

    silence_opencascade()
    comparison = compare_files(
        options.result, options.reference, options.output, options.points, options.seed
    )
    if options.json:
        print(comparison_json(comparison).decode("utf-8"))
    else:
        print(comparison_text(comparison))
    return ExitCode.DONE
