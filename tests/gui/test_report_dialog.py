"""The report, opened by a double click."""

import FreeCAD
from support import draw_sheet, run_fake
from window import WindowCase, open_windows, spin, widget

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.objects.loading import load_run
from freecad.gaussiancad.objects.reconstruction import add_reconstruction
from freecad.gaussiancad.panels.report import DIALOG_NAME
from freecad.gaussiancad.qt import QtWidgets


class Report(WindowCase):
    def open_report(self, behaviour: str) -> QtWidgets.QDialog:
        self.behave(behaviour)
        job = ReconstructJob(str(self.sheet), str(self.folder / "out"))
        run_fake(job.arguments())
        draw_sheet(self.folder / "out" / "overlay.png")
        group = add_reconstruction(FreeCAD.newDocument("Test"), load_run(job, self.folder))
        self.assertTrue(group.ViewObject.Proxy.doubleClicked(group.ViewObject))
        spin(300)
        (dialog,) = open_windows(DIALOG_NAME)
        return dialog

    def test_a_double_click_shows_status_picture_and_figures(self) -> None:
        dialog = self.open_report("ambiguous")
        headline = dialog.findChild(QtWidgets.QLabel, "headline").text()
        self.assertIn("Shape not certain", headline)
        text = dialog.findChild(QtWidgets.QPlainTextEdit, "text").toPlainText()
        self.assertIn("another solid fits the sheet", text)
        why = dialog.findChild(QtWidgets.QPlainTextEdit, "why").toPlainText()
        self.assertEqual(
            why.splitlines(), ["Why the shape is not certain:", "• another solid fits the sheet"]
        )
        self.assertTrue(dialog.findChild(QtWidgets.QLabel, "preview").has_picture)
        self.picture("report")
        dialog.reject()

    def test_a_choice_among_solutions_is_offered(self) -> None:
        dialog = self.open_report("several")
        button = dialog.findChild(QtWidgets.QPushButton, "choose")
        self.assertEqual(button.text(), "Choose among 3 Solutions…")
        button.click()
        self.wait_for(lambda: self.window.findChild(QtWidgets.QPushButton, "keep"))
        self.assertEqual(widget(QtWidgets.QLabel, "position").text(), "1 of 3")

    def test_nothing_is_offered_where_there_is_no_choice(self) -> None:
        dialog = self.open_report("ok")
        self.assertIsNone(dialog.findChild(QtWidgets.QPushButton, "choose"))
        dialog.reject()
