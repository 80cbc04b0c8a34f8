"""``python -m benchmarks``: lists the benchmarks, runs one, writes the page of figures.

python -m benchmarks --list
python -m benchmarks NAME [its options] [--record]
python -m benchmarks NAME --help
python -m benchmarks --write-figures
"""

import argparse
import sys
import textwrap
from collections.abc import Sequence
from pathlib import Path

from benchmarks.run.arguments import USAGE, OneLineParser, tell
from benchmarks.run.catalogue import Entry, entries, load
from benchmarks.run.figures_page import PAGE, figures_page
from benchmarks.run.results import record, result_now, results_of

INTERRUPTED = 130
"""Exit code of a command that was stopped by Ctrl-C, as shells have it."""

_PROGRAM = "python -m benchmarks"

_PLAIN = ("--record", "--resume")
_VALUED = ("--workers", "--json", "--keep", "--cache")
"""Options that tell how something is measured, the latter with a value."""


def main(arguments: Sequence[str]) -> int:
    """Do what is asked for; the exit code."""
    known = {entry.name: entry for entry in entries()}
    if arguments and not arguments[0].startswith("-"):
        name, *rest = arguments
        if name not in known:
            tell(f"{_PROGRAM}: there is no benchmark {name}; --list tells which there are")
            return USAGE
        return _run(known[name], rest)
    parser = OneLineParser(
        prog=_PROGRAM, description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--list", action="store_true", help="the benchmarks and their last figures")
    what.add_argument("--write-figures", action="store_true", help="docs/figures.md from results")
    options = parser.parse_args(arguments)
    if options.list:
        print("\n".join(map(_listed, known.values())))
    else:
        PAGE.write_text(figures_page(), encoding="utf-8")
    return 0


def _listed(entry: Entry) -> str:
    """A benchmark in two or three lines."""
    results = results_of(entry.name)
    lines = textwrap.wrap(entry.question, 76)
    lines.append(f"about {entry.minutes:g} min; {results[-1].headline if results else 'no figure'}")
    return "\n".join([entry.name, *(f"    {line}" for line in lines)])


def asked(arguments: Sequence[str]) -> str:
    """What of a command line tells what was measured: not how it was run, nor where folders are."""
    measured, left = [], iter(arguments)
    for argument in left:
        if argument in _VALUED:
            next(left, None)
        elif argument not in _PLAIN:
            measured.append("DIR" if Path(argument).is_dir() else argument)
    return " ".join(measured)


def _run(entry: Entry, arguments: Sequence[str]) -> int:
    benchmark = load(entry.name)
    parser = OneLineParser(
        prog=f"{_PROGRAM} {entry.name}",
        description=benchmark.__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    benchmark.add_arguments(parser)
    parser.add_argument("--record", action="store_true", help="add the figures to the results")
    options = parser.parse_args(arguments)
    from gaussiancad_core.errors import GaussianCadError

    try:
        outcome = benchmark.run(options)
    except KeyboardInterrupt:
        tell(f"{parser.prog}: stopped; with --resume the same command goes on where it was")
        return INTERRUPTED
    except (GaussianCadError, OSError) as error:
        tell(f"{parser.prog}: {' '.join(str(error).split())}")
        return USAGE
    if outcome.figures:
        print("; ".join(map(str, outcome.figures)))
    if options.record:
        path = record(entry.name, result_now(outcome, asked(arguments), entry.question))
        print(f"recorded in {path}", file=sys.stderr)
    return int(outcome.wrong)
