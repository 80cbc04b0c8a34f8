"""``gaussiancad mcp``: a server by which an agent reads, corrects and reconstructs drawings."""

import argparse
from importlib import import_module
from pathlib import Path

from gaussiancad_core.cli.values import named_path
from gaussiancad_core.processes.events import Listener
from gaussiancad_core.storage.extras import Extra, demand
from gaussiancad_protocol.exit_codes import ExitCode

_SERVER = "gaussiancad.agent.agent_server"
"""It is built on the public package, which the engine must not need: so it is found by its name."""


def add_command(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand ``mcp``."""
    parser = commands.add_parser(
        "mcp", help="serve an agent over stdin and stdout (Model Context Protocol)"
    )
    parser.add_argument(
        "--folder",
        type=named_path,
        default=Path(),
        metavar="DIR",
        help="outside of which nothing is read or written; the current one",
    )
    parser.set_defaults(run=run)


def run(options: argparse.Namespace, _listener: Listener) -> ExitCode:
    """Serve until the client goes away.

    Raises:
        EngineError: ``extra-missing``.
        UsageError: ``path-not-usable``, there is no such folder.
    """
    demand(Extra.MCP, "the server for agents")
    return ExitCode(import_module(_SERVER).serve(options.folder))
