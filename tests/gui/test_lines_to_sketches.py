"""*Lines to Sketches…* in a real window, with the fake engine and the real one."""

import os
import shutil
import unittest
from pathlib import Path
from unittest.mock import patch

import FreeCAD
import FreeCADGui
from test_real_engine import PLAIN, engine
from window import WindowCase, spin, widget

from freecad.gaussiancad.objects.corrected_sheet import open_in
from freecad.gaussiancad.panels import lines_to_sketches
from freecad.gaussiancad.panels.correct import open_docks
from freecad.gaussiancad.qt import QtWidgets

GIVEN = os.environ.get("GAUSSIANCAD_PYTHON")
COMMAND = "GaussianCAD_LinesToSketches"


class Sketches(WindowCase):
    def asked(self, sheet: Path | None) -> None:
        """Press the button, and choose a file in the dialog that it opens."""
        FreeCADGui.Selection.clearSelection()
        with patch.object(lines_to_sketches, "ask_sheet", return_value=sheet):
            self.open_panel(COMMAND)

    def finish(self, seconds: float = 60.0) -> None:
        self.wait_for(widget(QtWidgets.QPushButton, "start").isEnabled, seconds)

    def test_from_the_button_to_the_sketches_and_back_in_one_step(self) -> None:
        self.asked(self.sheet)
        self.finish()
        self.assertEqual(self.boxes(), [])
        document = FreeCAD.ActiveDocument
        self.assertEqual(document.Label, "bracket")
        group = document.getObject("Drawing")
        self.assertEqual([item.TypeId for item in group.Group], ["Sketcher::SketchObject"] * 3)
        headline = widget(QtWidgets.QLabel, "stage").text()
        self.assertIn("Sketches: 3, of 17 lines.", headline)
        log = widget(QtWidgets.QPlainTextEdit, "log").toPlainText()
        self.assertIn("Not used: enlarged detail.", log)
        self.assertEqual(document.UndoNames, ["Lines to Sketches"])
        document.undo()
        self.assertEqual(document.Objects, [])

    def test_the_drawing_of_what_is_selected_is_taken_into_its_document(self) -> None:
        document = FreeCAD.newDocument("Known")
        part = open_in(document, self.sheet, 1).Group[0]
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(part)
        self.open_panel(COMMAND)
        self.finish()
        self.assertIs(FreeCAD.ActiveDocument, document)
        self.assertEqual(document.getObject("Drawing").Label, "bracket")
        self.assertEqual(document.UndoNames, ["Lines to Sketches", "Open Drawing"])

    def test_a_run_is_cancelled_and_leaves_nothing(self) -> None:
        document = FreeCAD.newDocument("Empty")
        self.behave("slow")
        self.asked(self.sheet)
        self.wait_for(lambda: "Stage 2 of 4" in widget(QtWidgets.QLabel, "stage").text())
        widget(QtWidgets.QPushButton, "cancel").click()
        self.finish()
        self.assertEqual(self.boxes(), [])
        self.assertEqual((document.Objects, document.UndoCount), ([], 0))

    def test_a_drawing_without_views_is_told_and_the_canvas_offered(self) -> None:
        self.behave("no-views")
        self.asked(self.sheet)
        self.finish()
        (box,) = self.boxes()
        self.assertIn("No view of a part was found.", box.text())
        (correct,) = (
            button for button in box.buttons() if button.text().startswith("Correct Sheet")
        )
        correct.click()
        spin(200)
        (dock,) = open_docks()
        self.addCleanup(dock.close)
        self.assertEqual(dock.canvas.session.path, self.sheet)

    def test_no_drawing_and_a_missing_one(self) -> None:
        self.asked(None)
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.asked(self.folder / "gone.png")
        (box,) = self.boxes()
        self.assertIn("gone.png", box.text())
        self.assertEqual(FreeCAD.listDocuments(), {})

    @unittest.skipIf(engine() is None, "the engine is not installed")
    def test_the_sample_with_the_real_engine(self) -> None:
        self.set_variable("GAUSSIANCAD_PYTHON", GIVEN)
        self.asked(Path(shutil.copy(PLAIN, self.folder)))
        self.finish(120.0)
        self.assertEqual(self.boxes(), [])
        group = FreeCAD.ActiveDocument.getObject("Drawing")
        self.assertEqual(
            [item.Label for item in group.Group], ["Lines front", "Lines top", "Lines right"]
        )
        self.picture("sketches-finished")
        log = widget(QtWidgets.QPlainTextEdit, "log").toPlainText()
        self.assertIn("The size is not known", log)
        self.assertEqual(log.count("100 mm"), 1)
        box = group.Group[0].Shape.BoundBox
        self.assertAlmostEqual(box.XLength, 100.0, places=3)
