"""Options of the ``gaussiancad`` command."""

import argparse

from gaussiancad_core import __version__
from gaussiancad_core.cli import (
    batch,
    compare,
    doctor,
    draw,
    reconstruct,
)


def build_parser() -> argparse.ArgumentParser:
    """The parser of all subcommands; each sets ``run`` to its function."""
    parser = argparse.ArgumentParser(
        prog="gaussiancad",
        description="From a three-view engineering drawing to a measured 3D model.",
    )
    parser.add_argument("--version", action="version", version=f"gaussiancad {__version__}")
    parser.set_defaults(events=False)
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for module in (reconstruct, compare, draw, batch, doctor):
        module.add_command(commands)
    return parser
