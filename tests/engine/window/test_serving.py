"""Engines end with the application, before Qt takes their processes away."""

from pathlib import Path

from freecad.gaussiancad.canvas.serving import Program, Server
from freecad.gaussiancad.qt import QtCore, QtWidgets

_SILENT = """\
import sys, time
print("warming up", file=sys.stderr, flush=True)
time.sleep(60)
"""


def test_an_engine_ends_when_the_application_quits(tmp_path: Path) -> None:
    application = QtWidgets.QApplication.instance() or QtWidgets.QApplication([])
    script = tmp_path / "engine.py"
    script.write_text(_SILENT, encoding="utf-8")
    parent = QtCore.QObject()
    server = Server(Program(("python3", str(script))), parent)
    answers = []
    server.ask("read", answers.append)
    assert server.busy
    application.aboutToQuit.emit()
    assert not server.busy and not answers
    application.processEvents()
    server.stop()
