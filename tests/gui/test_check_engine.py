"""*Check Engine…* in a real window."""

from window import WindowCase, open_windows, spin

from freecad.gaussiancad.panels.check_engine import DIALOG_NAME
from freecad.gaussiancad.qt import QtWidgets


class Dialog(WindowCase):
    def texts(self) -> tuple[str, str]:
        dialog = self.dialog()
        headline = dialog.findChild(QtWidgets.QLabel, "headline").text()
        return headline, dialog.findChild(QtWidgets.QPlainTextEdit, "text").toPlainText()

    def dialog(self) -> QtWidgets.QDialog:
        dialog = open_windows(DIALOG_NAME)[0]
        self.addCleanup(spin, 50)
        return dialog

    def test_the_engines_own_diagnosis_is_shown(self) -> None:
        self.open_panel("GaussianCAD_CheckEngine")
        self.wait_for(lambda: "fake" in self.texts()[1])
        headline, text = self.texts()
        self.assertIn("fake_engine.py", headline)
        self.assertIn("GAUSSIANCAD_PYTHON", headline)
        self.assertIn("pip install torch", text)
        self.picture("check-engine")
        self.dialog().reject()

    def test_without_an_engine_it_says_where_it_looked_and_what_to_do(self) -> None:
        self.set_variable("GAUSSIANCAD_PYTHON", "/nowhere/python")
        self.open_panel("GaussianCAD_CheckEngine")
        headline, text = self.texts()
        self.assertIn("/nowhere/python", headline)
        self.assertIn("make -C", text)
        self.assertIn(".venv", text)
        self.picture("check-engine-missing")
        self.dialog().reject()
