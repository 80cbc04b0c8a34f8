"""A Python of the system on which an environment can be made."""

import shutil
import subprocess
from collections.abc import Mapping

from freecad.gaussiancad.engine.environment import clean_environment
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate

PYTHON_NAMES = ("python3.13", "python3.12", "python3.11", "python3.14", "python3", "python")

_USABLE = "import ensurepip, sys, venv; sys.exit(not (3, 11) <= sys.version_info < (3, 15))"


def find_base_python(variables: Mapping[str, str]) -> str:
    """A Python of the system that can make environments, 3.11 to 3.14.

    Args:
        variables: the environment variables.

    Raises:
        WorkbenchError: there is none.
    """
    clean = clean_environment(variables)
    for name in PYTHON_NAMES:
        found = shutil.which(name, path=clean.get("PATH"))
        if found and _is_usable(found, clean):
            return found
    raise WorkbenchError(
        ErrorCode.ENGINE_NOT_FOUND,
        translate(
            "GaussianCAD",
            "No Python from 3.11 to 3.14 with its venv module was found. Install one (on Debian: "
            "apt-get install python3-venv), then try again.",
        ),
    )


def _is_usable(python: str, variables: Mapping[str, str]) -> bool:
    try:
        ended = subprocess.run(
            [python, "-I", "-c", _USABLE],
            env=dict(variables),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=20,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return False
    return ended.returncode == 0
