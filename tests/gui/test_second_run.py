"""A second run from the panel, and what the tree's context menu offers for a reconstruction."""

from pathlib import Path

import FreeCAD
import FreeCADGui
from support import draw_sheet
from window import WindowCase, open_windows, spin, widget

from freecad.gaussiancad.engine.job import ScaleKind
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.panels.report import DIALOG_NAME
from freecad.gaussiancad.qt import QtWidgets
from freecad.gaussiancad.workbench import GaussianCADWorkbench


class SecondRun(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Test")
        self.open_panel("GaussianCAD_Reconstruct")
        self.choose_sheet(self.sheet)
        self.finish()
        self.group = self.document.getObject("Reconstruction")
        self.part = self.document.getObject("Part")

    def finish(self) -> None:
        button = self.start()
        self.wait_for(button.isEnabled)

    def select(self, document_object: FreeCAD.DocumentObject) -> None:
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(document_object)
        spin(100)

    def report(self) -> QtWidgets.QDialog:
        return open_windows(DIALOG_NAME)[0]

    def camera(self) -> list[str]:
        """Where the view's camera stands; how deep it sees follows from what is shown."""
        lines = FreeCADGui.ActiveDocument.ActiveView.getCamera().splitlines()
        return [line for line in lines if "nearDistance" not in line and "farDistance" not in line]

    def test_the_view_stays_where_the_user_turned_it(self) -> None:
        view = FreeCADGui.ActiveDocument.ActiveView
        view.setAnimationEnabled(False)
        view.viewTop()
        spin(100)
        placed = self.camera()
        self.finish()
        self.assertEqual(self.camera(), placed)

    def test_another_sheet_clears_the_verdict(self) -> None:
        stage = widget(QtWidgets.QLabel, "stage")
        self.assertIn("verified", stage.text())
        self.choose_sheet(draw_sheet(self.folder / "other.png"))
        self.assertEqual(stage.text(), "Ready")
        self.assertEqual(widget(QtWidgets.QPlainTextEdit, "log").toPlainText(), "")
        self.assertEqual(widget(QtWidgets.QProgressBar, "overall").value(), 0)
        self.finish()
        # It goes into a document of its own: here it would lie over the first part.
        self.assertEqual(len(self.document.Objects), 7)
        self.assertEqual(len(FreeCAD.getDocument("other").Objects), 7)

    def test_run_again_takes_the_settings_of_then(self) -> None:
        widget(QtWidgets.QComboBox, "outcome").setCurrentIndex(1)
        scale = widget(QtWidgets.QComboBox, "scale")
        scale.setCurrentIndex(list(ScaleKind).index(ScaleKind.LENGTH_Y))
        widget(QtWidgets.QAbstractSpinBox, "length").setProperty("rawValue", 42.5)
        self.finish()
        settings = texts_of(self.group, "Settings")
        FreeCADGui.Control.closeDialog()
        spin(100)
        self.sheet.unlink()
        self.select(self.part)
        FreeCADGui.runCommand("GaussianCAD_RunAgain")
        button = widget(QtWidgets.QPushButton, "start")
        self.assertFalse(button.isEnabled())
        self.wait_for(button.isEnabled)
        self.picture("run-again")
        self.assertEqual(self.boxes(), [])
        self.assertEqual(texts_of(self.group, "Settings"), settings)
        self.assertEqual((settings["result"], settings["scale"]), ("solid", "y = 42.5"))
        self.assertEqual(self.group.SheetPath, str(self.sheet))
        self.assertEqual(len(self.document.Objects), 7)

    def test_a_drawing_that_is_gone_is_told_in_a_sentence(self) -> None:
        FreeCADGui.Control.closeDialog()
        spin(100)
        self.sheet.unlink()
        Path(self.group.Sheet).unlink()
        self.select(self.group)
        FreeCADGui.runCommand("GaussianCAD_RunAgain")
        (box,) = self.boxes()
        self.assertIn("is gone", box.text())
        self.assertFalse(FreeCADGui.Control.activeDialog())
        box.close()
        FreeCADGui.runCommand("GaussianCAD_Report")
        report = self.report()
        preview = report.findChild(QtWidgets.QLabel, "preview")
        self.assertIn("is gone", preview.text())
        report.reject()

    def test_the_report_opens_from_the_part(self) -> None:
        self.select(self.part)
        FreeCADGui.runCommand("GaussianCAD_Report")
        dialog = self.report()
        self.assertEqual(dialog.windowTitle(), self.group.Label)
        self.picture("report-of-part")
        dialog.reject()

    def test_the_property_editor_shows_lists_and_lengths(self) -> None:
        FreeCADGui.Control.closeDialog()
        spin(200)
        self.select(self.group)
        spin(500)
        shown: set[str] = set()
        for tree in self.window.findChildren(QtWidgets.QTreeView):
            model = tree.model()
            if "PropertyEditor" not in tree.metaObject().className() or model is None:
                continue
            for row in range(model.rowCount()):
                heading = model.index(row, 0)
                for inner in range(model.rowCount(heading)):
                    shown.add(str(model.index(inner, 0, heading).data()).replace(" ", ""))
        self.picture("properties")
        self.assertTrue({"Settings", "ViewBoxes", "Seconds", "MeasuresWithin"} <= shown, shown)

    def test_the_context_menu_offers_it_for_group_and_part_alone(self) -> None:
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        for item, offered in ((self.group, True), (self.part, True), (box, False)):
            self.select(item)
            stated: list[str] = []
            menu = GaussianCADWorkbench()
            menu.appendContextMenu = lambda _, names, given=stated: given.extend(names)
            menu.ContextMenu("Tree")
            self.assertEqual("GaussianCAD_RunAgain" in stated, offered)
            self.assertEqual("GaussianCAD_Report" in stated, offered)
            self.assertIn("GaussianCAD_Compare", stated)
