"""*To Body…* in a real window, with the fake engine."""

import FreeCAD
import FreeCADGui
import Part
from fake_part import STEP_FILE
from window import WindowCase, spin, widget

from freecad.gaussiancad.qt import QtWidgets
from freecad.gaussiancad.workbench import GaussianCADWorkbench

COMMAND = "GaussianCAD_ToBody"


class ToBody(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Body")
        self.document.UndoMode = 0
        self.part = self.document.addObject("Part::Feature", "Part")
        self.part.Shape = Part.read(str(STEP_FILE))
        self.document.recompute()
        self.document.UndoMode = 1
        FreeCADGui.SendMsgToActiveView("ViewFit")

    def select(self, *chosen: FreeCAD.DocumentObject) -> None:
        FreeCADGui.Selection.clearSelection()
        for each in chosen:
            FreeCADGui.Selection.addSelection(each)

    def finish(self) -> None:
        self.wait_for(widget(QtWidgets.QPushButton, "start").isEnabled)

    def test_from_the_button_to_the_body_and_back_in_one_step(self) -> None:
        self.select(self.part)
        self.open_panel(COMMAND)
        self.finish()
        self.assertEqual(self.boxes(), [])
        headline = widget(QtWidgets.QLabel, "stage").text()
        self.assertIn("Features: 1. Numbers from the sheet: 3, measured: 2.", headline)
        log = widget(QtWidgets.QPlainTextEdit, "log").toPlainText()
        self.assertIn("Not on the sheet:\nPad1.WallThickness = 15 mm\nPad1.Length = 40 mm", log)
        body = self.document.getObject("Body")
        self.assertAlmostEqual(body.Shape.Volume, self.part.Shape.Volume, places=3)
        self.assertTrue(body.ViewObject.Visibility)
        self.assertFalse(self.part.ViewObject.Visibility)
        self.assertFalse(self.document.getObject("Pad1Sketch").ViewObject.Visibility)
        self.picture("to-body")
        self.assertEqual(self.document.UndoNames, ["To Body"])
        self.document.undo()
        self.assertEqual(self.document.Objects, [self.part])
        self.assertTrue(self.part.ViewObject.Visibility)

    def test_another_solid_is_told_and_leaves_nothing(self) -> None:
        self.behave("differs")
        self.select(self.part)
        self.open_panel(COMMAND)
        self.finish()
        (box,) = self.boxes()
        self.assertIn("% of the volume differ", box.text())
        self.assertEqual((self.document.Objects, self.document.UndoCount), ([self.part], 0))
        self.assertTrue(self.part.ViewObject.Visibility)

    def test_a_run_is_cancelled_and_leaves_nothing(self) -> None:
        self.behave("slow")
        self.select(self.part)
        self.open_panel(COMMAND)
        spin(300)
        widget(QtWidgets.QPushButton, "cancel").click()
        self.finish()
        self.assertEqual(self.boxes(), [])
        self.assertEqual((self.document.Objects, self.document.UndoCount), ([self.part], 0))

    def test_what_to_select_is_told(self) -> None:
        self.select()
        self.open_panel(COMMAND)
        (box,) = self.boxes()
        self.assertIn("Select a reconstruction", box.text())
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_the_context_menu_offers_it_for_what_has_a_solid(self) -> None:
        mesh = self.document.addObject("Mesh::Feature", "Mesh")
        for chosen, offered in ((self.part, True), (mesh, False)):
            self.select(chosen)
            offers: list[str] = []
            menu = GaussianCADWorkbench()
            menu.appendContextMenu = lambda _, names, offers=offers: offers.extend(names)
            menu.ContextMenu("Tree")
            self.assertEqual(COMMAND in offers, offered)
