#!/usr/bin/env python3
"""Convert drawings to FreeCAD documents, STEP and STL files, without a window.

    python3 gaussiancad_batch.py SHEETS... --output DIR [--preset fine] [--length x=60] ...

SHEETS are files and folders; ``--help`` lists the options.  The script starts FreeCAD's console
itself (``freecadcmd`` on the PATH, or what FREECADCMD names).  Where there is no other Python, the
console runs it directly; the arguments are then a JSON list in an environment variable::

    GAUSSIANCAD_ARGS='["sheets", "--output", "models"]' freecadcmd gaussiancad_batch.py
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

VARIABLE = "GAUSSIANCAD_ARGS"
USAGE, NO_FREECAD = 2, 6


def launch(arguments: list[str]) -> int:
    """Start FreeCAD's console on this script, and return its exit status."""
    names = [os.environ.get("FREECADCMD", ""), "freecadcmd", "FreeCADCmd", "freecad-cmd"]
    console = next((found for name in names if name and (found := shutil.which(name))), None)
    if console is None:
        print("freecadcmd was not found: name it in the environment variable FREECADCMD")
        return NO_FREECAD
    variables = {**os.environ, VARIABLE: json.dumps(arguments)}
    command = [console, str(Path(__file__).resolve())]
    if os.name == "posix":
        # The console takes this process's place, and with it the signals that are meant for it.
        os.execve(console, command, variables)
    return subprocess.call(command, env=variables)


def convert() -> int:
    """Inside FreeCAD: read the arguments and convert."""
    import freecad

    item = str(Path(__file__).resolve().parents[2] / "freecad")
    if item not in freecad.__path__:
        freecad.__path__.append(item)
    from freecad.gaussiancad import batch

    try:
        arguments = json.loads(os.environ.get(VARIABLE, "[]"))
    except ValueError as error:
        print(f"{VARIABLE} is no JSON: {error}")
        return USAGE
    if not isinstance(arguments, list) or not all(isinstance(a, str) for a in arguments):
        print(f"{VARIABLE} is no list of texts")
        return USAGE
    return batch.main(arguments)


def convert_and_exit() -> None:
    """FreeCAD runs a script that ends in an error a second time, and ends with 0: never let it."""
    code = NO_FREECAD
    try:
        code = int(convert())
    except Exception as error:
        print(f"the conversion failed: {error}")
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)


if "FreeCAD" in sys.modules:
    convert_and_exit()
elif __name__ == "__main__":
    sys.exit(launch(sys.argv[1:]))
