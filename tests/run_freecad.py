"""Run the tests that need FreeCAD: ``freecadcmd tests/run_freecad.py``.

Without a window the tests in ``tests/workbench`` run, with a window (``freecad
tests/run_freecad.py`` under xvfb) those in ``tests/gui``.  The exit status is 0 if all passed.
GAUSSIANCAD_TESTS names a pattern of test files, such as ``test_job*``; GAUSSIANCAD_SKIPPED a folder
for what was skipped.

FreeCAD imports this file instead of running it, and would run it a second time after an error.
"""

import faulthandler
import os
import sys
import unittest
from pathlib import Path

import FreeCAD

TESTS = Path(__file__).resolve().parent
ADDON = TESTS.parent


def make_importable() -> None:
    """Put the addon into the ``freecad`` namespace, installed or not."""
    import freecad

    for path in (str(TESTS / "workbench"), str(TESTS / "gui"), str(ADDON)):
        if path not in sys.path:
            sys.path.insert(0, path)
    if str(ADDON / "freecad") not in freecad.__path__:
        freecad.__path__.append(str(ADDON / "freecad"))


def run(folder: str) -> int:
    """Run the tests of a folder; the report goes to file descriptor 2, past FreeCAD's own."""
    make_importable()
    # A crash tells the line of Python that it came from, which FreeCAD's own trace does not.
    faulthandler.enable(2, all_threads=False)
    pattern = os.environ.get("GAUSSIANCAD_TESTS", "test_*") + ".py"
    suite = unittest.TestLoader().discover(str(TESTS / folder), pattern, str(TESTS / folder))
    with open(2, "w", encoding="utf-8", closefd=False) as stream:
        version = ".".join(FreeCAD.Version()[:3])
        stream.write(f"FreeCAD {version}, tests/{folder}\n")
        result = unittest.TextTestRunner(stream, verbosity=2).run(suite)
    tell_skipped(folder, result)
    return 0 if result.wasSuccessful() and result.testsRun > 0 else 1


def tell_skipped(suite: str, result: unittest.TestResult) -> None:
    """Leave what was skipped, and why, in a file of the folder GAUSSIANCAD_SKIPPED."""
    if folder := os.environ.get("GAUSSIANCAD_SKIPPED"):
        path = Path(folder) / f"{suite}.txt"
        path.parent.mkdir(parents=True, exist_ok=True)
        lines = (f"{test.id()}: {why}\n" for test, why in result.skipped)
        path.write_text("".join(lines), encoding="utf-8")


def finish(code: int) -> None:
    """End FreeCAD with the code, whatever windows and documents are open."""
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


def run_and_finish(folder: str) -> None:
    """Run, and see to it that FreeCAD ends with the right code."""
    code = 1
    try:
        code = run(folder)
    finally:
        finish(code)


if FreeCAD.GuiUp:
    from PySide import QtCore

    QtCore.QTimer.singleShot(1500, lambda: run_and_finish("gui"))
else:
    run_and_finish("workbench")
