"""The report, opened by a double click."""

import FreeCAD
from support import draw_sheet, run_fake
from window import WindowCase, spin

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.objects.loading import load_run
from freecad.gaussiancad.objects.reconstruction import add_reconstruction
from freecad.gaussiancad.panels.report import DIALOG_NAME
from freecad.gaussiancad.qt import QtWidgets


class Report(WindowCase):
    def test_a_double_click_shows_status_picture_and_figures(self) -> None:
        self.behave("ambiguous")
        job = ReconstructJob(str(self.sheet), str(self.folder / "out"))
        run_fake(job.arguments())
        draw_sheet(self.folder / "out" / "overlay.png")
        group = add_reconstruction(FreeCAD.newDocument("Test"), load_run(job, self.folder))
        self.assertTrue(group.ViewObject.Proxy.doubleClicked(group.ViewObject))
        spin(300)
        tops = QtWidgets.QApplication.topLevelWidgets()
        (dialog,) = (t for t in tops if t.objectName() == DIALOG_NAME and t.isVisible())
        headline = dialog.findChild(QtWidgets.QLabel, "headline").text()
        self.assertIn("Approximate", headline)
        text = dialog.findChild(QtWidgets.QPlainTextEdit, "text").toPlainText()
        self.assertIn("another solid fits the sheet", text)
        self.assertTrue(dialog.findChild(QtWidgets.QLabel, "preview").has_picture)
        self.picture("report")
        dialog.reject()
