"""*Install Engine…* in a real window, with a fake Python."""

import os
from pathlib import Path

import support
from window import WindowCase, spin

from freecad.gaussiancad.engine.locate import MARKER, SearchPlaces, find_engine
from freecad.gaussiancad.panels.check_engine import DIALOG_NAME as CHECK_NAME
from freecad.gaussiancad.panels.install_engine import DIALOG_NAME
from freecad.gaussiancad.qt import QtWidgets

FAKE_PYTHON = Path(support.__file__).parent / "fake_python.py"


class Dialog(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.asked = self.folder / "asked"
        self.set_variable("XDG_DATA_HOME", str(self.folder / "data"))
        self.set_variable("GAUSSIANCAD_FAKE_LOG", str(self.asked))
        (self.folder / "python3.13").symlink_to(FAKE_PYTHON)
        self.set_variable("PATH", os.pathsep.join([str(self.folder), "/usr/bin", "/bin"]))
        self.set_variable("GAUSSIANCAD_PYTHON", "/nowhere/python")

    def dialog(self) -> QtWidgets.QDialog:
        tops = QtWidgets.QApplication.topLevelWidgets()
        return next(top for top in tops if top.objectName() == DIALOG_NAME and top.isVisible())

    def open(self) -> tuple[QtWidgets.QDialog, QtWidgets.QLabel, QtWidgets.QPushButton]:
        """From *Check Engine…*, where a user comes from."""
        self.open_panel("GaussianCAD_CheckEngine")
        tops = QtWidgets.QApplication.topLevelWidgets()
        check = next(t for t in tops if t.objectName() == CHECK_NAME and t.isVisible())
        check.findChild(QtWidgets.QPushButton, "install").click()
        spin(200)
        dialog = self.dialog()
        headline = dialog.findChild(QtWidgets.QLabel, "headline")
        return dialog, headline, dialog.findChild(QtWidgets.QPushButton, "install")

    def test_nothing_happens_before_consent_and_then_everything(self) -> None:
        dialog, headline, button = self.open()
        self.picture("install-engine")
        self.assertIn(str(self.folder / "data"), headline.text())
        self.assertFalse(self.asked.exists())
        button.click()
        self.wait_for(lambda: "installed" in headline.text())
        root = self.folder / "data" / "GaussianCAD" / "engine"
        self.assertTrue((root / MARKER).is_file())
        engine = find_engine(SearchPlaces.of_this_machine("", {}))
        self.assertEqual(engine.python, str(root / "bin" / "python"))
        dialog.reject()
        self.wait_for(lambda: not dialog_is_open())

    def test_closing_stops_first(self) -> None:
        self.behave("slow")
        dialog, headline, button = self.open()
        button.click()
        self.wait_for(lambda: "small build" in headline.text())
        dialog.reject()
        self.wait_for(lambda: "cancelled" in headline.text())
        self.assertFalse((self.folder / "data" / "GaussianCAD" / "engine").exists())
        dialog.reject()

    def test_a_failure_is_told_and_can_be_tried_again(self) -> None:
        self.set_variable("GAUSSIANCAD_FAKE_FAILS", "engine-cpu.txt")
        dialog, headline, button = self.open()
        button.click()
        self.wait_for(lambda: "failed" in headline.text())
        self.assertIn("ERROR: no engine-cpu.txt here", headline.text())
        self.assertTrue(button.isEnabled())
        dialog.reject()


def dialog_is_open() -> bool:
    tops = QtWidgets.QApplication.topLevelWidgets()
    return any(top.objectName() == DIALOG_NAME and top.isVisible() for top in tops)
