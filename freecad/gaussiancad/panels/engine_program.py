"""How this machine's engine is started to stay beside a window."""

import os

from freecad.gaussiancad.canvas.engine_server import Program
from freecad.gaussiancad.engine.environment import clean_environment
from freecad.gaussiancad.engine.job import MODULE_ARGUMENTS
from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.preferences import read_preferences


def engine_program() -> Program:
    """The engine that the preferences name, or that is found.

    Raises:
        WorkbenchError: there is none.
    """
    preference = read_preferences().engine_python
    engine = find_engine(SearchPlaces.of_this_machine(preference, os.environ))
    return Program((engine.python, *MODULE_ARGUMENTS), clean_environment(os.environ))
