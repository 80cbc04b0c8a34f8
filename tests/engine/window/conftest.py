"""A window with a sheet that was read, for the tests of what is done in it."""

import json
import os
import sys
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
sys.path.insert(0, str(Path(__file__).resolve().parents[3]))

from freecad.gaussiancad.canvas.engine_server import Engines, Program
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.qt import QtGui, QtWidgets


@pytest.fixture
def reading() -> dict:
    """A front view: a square with a hidden line that was taken for a centre line."""
    path = Path(__file__).with_name("reading.json")
    return json.loads(path.read_text(encoding="utf-8"))


@pytest.fixture(scope="session")
def application() -> QtWidgets.QApplication:
    return QtWidgets.QApplication.instance() or QtWidgets.QApplication([])


@pytest.fixture
def window(application: QtWidgets.QApplication, reading: dict, tmp_path: Path):  # noqa: ANN201
    """A window whose sheet was read; no engine is at work."""
    sheet = tmp_path / "sheet.png"
    picture = QtGui.QImage(640, 480, QtGui.QImage.Format.Format_Grayscale8)
    picture.fill(255)
    assert picture.save(str(sheet))
    sheet_window = SheetWindow(sheet, engines=Engines.of(Program((str(tmp_path / "none"),))))
    sheet_window.resize(900, 900)
    sheet_window.show()
    sheet_window.session.live = False
    sheet_window.session.pictured.emit(str(sheet), (640, 480), 1)
    written = tmp_path / "reading.json"
    written.write_text(json.dumps(reading), encoding="utf-8")
    sheet_window.session._was_read({"reading": str(written)}, [])
    application.processEvents()
    sheet_window.canvas_view.fit()
    yield sheet_window
    sheet_window.close()
    sheet_window.deleteLater()
    application.processEvents()
