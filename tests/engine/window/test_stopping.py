"""The window without FreeCAD ends where the command is stopped, and not only by its own button."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]

PROGRAM = """
import os, sys
from gaussiancad_core.cli import main
from freecad.gaussiancad.qt import QtCore, QtWidgets
application = QtWidgets.QApplication([])
timer = QtCore.QTimer()
timer.setSingleShot(True)
timer.timeout.connect(lambda: os.kill(os.getpid(), int(sys.argv[2])))
timer.start(500)
sys.exit(main(["correct", sys.argv[1]]))
"""


@pytest.mark.skipif(os.name != "posix", reason="there are no such signals")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_closes_the_window(number: signal.Signals) -> None:
    sheet = ROOT / "resources" / "samples" / "l-bracket.png"
    paths = os.pathsep.join([str(ROOT), *(path for path in sys.path if path)])
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": paths}
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, str(sheet), str(int(number))],
        capture_output=True,
        encoding="utf-8",
        check=False,
        env=environment,
        timeout=120,
    )
    assert done.returncode == 130, done.stderr
    assert "Traceback" not in done.stderr
