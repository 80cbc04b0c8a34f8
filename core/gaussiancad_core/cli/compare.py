"""``gaussiancad compare``: a result against a reference."""

import argparse
import re
import sys
from functools import partial

from gaussiancad_core.cli import values
from gaussiancad_core.cli.values import named_path
from gaussiancad_core.comparison.comparison_options import (
    Alignment,
    CompareOptions,
    Protocol,
    ScaleRule,
)
from gaussiancad_core.errors import GaussianCadError, UnreadableError
from gaussiancad_core.processes.events import Listener
from gaussiancad_core.storage.extras import Extra, demand
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

_ALL = "all"

_USUAL_MEMORY = 8.0
"""GB."""

_USUAL_SECONDS = 600.0

_TOLD = re.compile(r"(gaussiancad: )?(?P<message>.*) \[(?P<code>[a-z0-9-]+)\]")
"""A line by which the command, or who watches it, tells an error."""


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = commands.add_parser("compare", help="measure a model against a reference")
    parser.add_argument(
        "result", type=named_path, metavar="RESULT", help="STEP, BREP, STL, PLY or OBJ"
    )
    parser.add_argument("reference", type=named_path, metavar="REFERENCE")
    parser.add_argument("--output", type=named_path, metavar="DIR")
    parser.add_argument("--points", type=values.count, default=10_000, metavar="N")
    parser.add_argument("--seed", type=values.whole, default=0, metavar="N")
    parser.add_argument(
        "--protocol",
        type=_protocols,
        default=(Protocol.GAUSSIANCAD,),
        metavar="NAME",
        help="gaussiancad (default), deepcad, engineering, all, or several between commas; "
        "the paper's numbers are always there",
    )
    parser.add_argument(
        "--register",
        type=partial(values.choice, Alignment),
        metavar="HOW",
        help="none, axes (24 turns), icp (axes, then ICP; default), global (any turn)",
    )
    parser.add_argument(
        "--scale",
        type=partial(values.choice, ScaleRule),
        metavar="RULE",
        help="fixed or free; by default gaussiancad is free and engineering fixed",
    )
    parser.add_argument(
        "--tolerance",
        type=values.positive,
        metavar="MM",
        help="of the share of surface that agrees (default: 1/1000 of the longest edge)",
    )
    parser.add_argument(
        "--factor",
        type=values.positive,
        default=1.0,
        metavar="F",
        help="multiply the result's coordinates first, e.g. 25.4 for inches",
    )
    parser.add_argument("--json", action="store_true", help="print comparison.json")
    parser.add_argument(
        "--memory", type=values.positive, default=_USUAL_MEMORY, metavar="GB", help="at most"
    )
    parser.add_argument(
        "--seconds", type=values.positive, default=_USUAL_SECONDS, metavar="S", help="at most"
    )
    parser.add_argument("--unlimited", action="store_true", help=argparse.SUPPRESS)
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, _listener: Listener) -> ExitCode:
    """Compare two files in a limited process, as nobody knows who made them.

    Raises:
        EngineError: ``extra-missing``, or what ended that process.
    """
    demand(Extra.COMPARE, "a comparison")
    if options.unlimited:
        return _compare(options)
    from gaussiancad_core.processes.supervisor import ProcessLimits, run_limited

    limits = ProcessLimits(int(options.memory * 2**30), options.seconds)
    command, *rest = options.arguments
    ended = run_limited([command, "--unlimited", *rest], limits)
    sys.stdout.write(ended.output.decode("utf-8", "replace"))
    sys.stdout.flush()
    if ended.exit_code == 0:
        return ExitCode.DONE
    raise _failure(ended.exit_code, ended.message)


def _failure(exit_code: int, line: str) -> GaussianCadError:
    """The error that the last line of a process tells of."""
    fullmatch = _TOLD.fullmatch(line)
    if fullmatch is not None:
        error = GaussianCadError(fullmatch["code"], fullmatch["message"])
        error.exit_code = ExitCode(exit_code)
        return error
    return UnreadableError(
        Code.DAMAGED_MODEL,
        "the models cannot be compared ({reason}): one is damaged; export it again",
        reason=line,
    )


def _compare(options: argparse.Namespace) -> ExitCode:
    """Compare two files and print the figures."""
    from gaussiancad_core.comparison.compare_command import compare_files
    from gaussiancad_core.comparison.comparison_report import comparison_json
    from gaussiancad_core.comparison.comparison_text import comparison_text
    from gaussiancad_core.processes.library_behaviour import silence_opencascade

    silence_opencascade()
    asked = CompareOptions(
        options.points,
        options.seed,
        options.protocol,
        options.register,
        options.scale,
        options.tolerance,
        options.factor,
    )
    comparison = compare_files(options.result, options.reference, options.output, asked)
    if options.json:
        print(comparison_json(comparison).decode("utf-8"))
    else:
        print(comparison_text(comparison))
    return ExitCode.DONE


def _protocols(text: str) -> tuple[Protocol, ...]:
    """Names between commas, or ``all``."""
    if text == _ALL:
        return tuple(Protocol)
    asked = {values.choice(Protocol, name.strip()) for name in text.split(",")}
    return tuple(protocol for protocol in Protocol if protocol in asked)
