"""The ``gaussiancad`` command as child processes run it.

The command starts processes, and they run the command: its function is looked up by name, once it
is needed, so that this package needs none of those that the command is made of.
"""

from collections.abc import Sequence
from importlib import import_module

from gaussiancad_core.processes.events import Listener

_COMMAND = "gaussiancad_core.cli"
"""The package whose function ``main`` is the command."""


def run_command(arguments: Sequence[str], heard: Listener | None = None) -> int:
    """Run a command line in this process and return its exit code.

    Args:
        arguments: of the command, without its name.
        heard: told each event besides whoever reads the command's output.
    """
    return int(import_module(_COMMAND).main(arguments, heard))
