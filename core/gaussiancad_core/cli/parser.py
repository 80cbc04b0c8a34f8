"""Options of the ``gaussiancad`` command."""

import argparse
from typing import NoReturn

from gaussiancad_core import __version__
from gaussiancad_core.cli import (
    agent,
    batch,
    check,
    compare,
    correct,
    doctor,
    draw,
    explain,
    features,
    read,
    reconstruct,
    serve,
)
from gaussiancad_core.cli.streams import say
from gaussiancad_protocol.exit_codes import ExitCode


class OneLineParser(argparse.ArgumentParser):
    """A parser whose errors are one line; argparse itself prints the whole usage before them."""

    def error(self, message: str) -> NoReturn:
        """Say what is wrong and how to see the usage, and exit with 2."""
        say(f"gaussiancad: {message}; see {self.prog} --help [wrong-usage]")
        self.exit(int(ExitCode.USAGE))


def build_parser() -> argparse.ArgumentParser:
    """The parser of all subcommands; each sets ``run`` to its function."""
    parser = OneLineParser(
        prog="gaussiancad",
        description="From a three-view engineering drawing to a measured 3D model.",
    )
    parser.add_argument("--version", action="version", version=f"gaussiancad {__version__}")
    parser.set_defaults(events=False, serves=False, verbose=False)
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for module in (
        reconstruct,
        read,
        correct,
        explain,
        features,
        check,
        compare,
        draw,
        batch,
        serve,
        agent,
        doctor,
    ):
        module.add_command(commands)
    return parser
