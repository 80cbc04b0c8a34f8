"""*Reconstruct* goes on to the editable body where it can, and says why where it cannot."""

import FreeCAD
import FreeCADGui
from window import WindowCase, spin, widget

from freecad.gaussiancad.objects.bodies_of_parts import bodies_of
from freecad.gaussiancad.qt import QtWidgets
from freecad.gaussiancad.remembered import LAST

COMMAND = "GaussianCAD_Reconstruct"


class BodyOfReconstruction(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        # As it is where nobody has chosen anything.
        FreeCAD.ParamGet(LAST).RemBool("Body")
        self.document = FreeCAD.newDocument("Test")
        self.open_panel(COMMAND)
        self.choose_sheet(self.sheet)

    def finish(self) -> str:
        self.wait_for(self.start().isEnabled)
        self.assertEqual(self.boxes(), [])
        return widget(QtWidgets.QLabel, "stage").text()

    @property
    def part(self) -> FreeCAD.DocumentObject:
        return self.document.getObject("Part")

    def assert_part_alone(self) -> None:
        self.assertIsNone(self.document.getObject("Body"))
        self.assertTrue(self.part.Visibility)
        self.assertEqual(self.document.UndoNames, ["Reconstruct from Drawing"])

    def test_the_body_is_made_by_itself_and_is_a_step_of_its_own(self) -> None:
        said = self.finish()
        self.assertIn("Shape verified. ", said)
        self.assertIn("Features: 1. Numbers from the sheet: 3, measured: 2.", said)
        self.assertIn("Each number can be changed.", said)
        log = widget(QtWidgets.QPlainTextEdit, "log").toPlainText()
        self.assertIn("8 faces", log)
        self.assertIn("Not on the sheet:\nPad1.WallThickness = 15 mm", log)
        body = self.document.getObject("Body")
        self.assertEqual((body.Visibility, self.part.Visibility), (True, False))
        self.assertEqual(bodies_of(self.part), (body,))
        colours = [each.ViewObject.ShapeColor[:3] for each in (body.Tip, self.part)]
        self.assertEqual(colours[0], colours[1])
        self.picture("reconstruct-body")
        self.assertEqual(self.document.UndoNames, ["To Body", "Reconstruct from Drawing"])
        self.document.undo()
        self.assertEqual(len(self.document.Objects), 7)
        self.assertTrue(self.part.Visibility)
        self.document.undo()
        self.assertEqual(self.document.Objects, [])

    def test_the_part_is_shown_while_features_are_looked_for(self) -> None:
        self.behave("features-wait")
        start = self.start()
        self.wait_for(lambda: "Looking" in widget(QtWidgets.QLabel, "stage").text())
        self.assert_part_alone()
        self.assertFalse(start.isEnabled())
        self.assertIn("Shape verified.", widget(QtWidgets.QLabel, "stage").text())
        widget(QtWidgets.QPushButton, "cancel").click()
        self.wait_for(start.isEnabled)
        said = widget(QtWidgets.QLabel, "stage").text()
        self.assertEqual(said.count("Shape verified."), 1)
        self.assertIn("No body was made: it was cancelled.", said)
        self.assert_part_alone()

    def test_a_panel_that_is_closed_meanwhile_leaves_the_part(self) -> None:
        self.behave("features-wait")
        self.start()
        self.wait_for(lambda: "Looking" in widget(QtWidgets.QLabel, "stage").text())
        FreeCADGui.Control.closeDialog()
        spin(1500)
        self.assert_part_alone()

    def test_where_there_is_no_body_one_sentence_says_why(self) -> None:
        for behaviour, reason in (
            ("differs", "% of the volume differ"),
            ("no-features", "No body was made: "),
            ("surface", "No body was made: the part is no exact solid."),
            ("several", "several solids fit the sheet"),
        ):
            with self.subTest(behaviour):
                self.behave(behaviour)
                said = self.finish()
                self.assertEqual(said.count(reason), 1, said)
                self.assertIsNone(self.document.getObject("Body"))
                while self.document.UndoCount:
                    self.document.undo()

    def test_a_second_run_with_the_same_part_keeps_its_body(self) -> None:
        self.finish()
        body = self.document.getObject("Body")
        self.assertIn("its body stays as it is", self.finish())
        self.assertEqual(bodies_of(self.part), (body,))
        self.assertEqual((body.Visibility, self.part.Visibility), (True, False))

    def test_the_choice_is_remembered(self) -> None:
        box = widget(QtWidgets.QCheckBox, "body")
        self.assertTrue(box.isChecked())
        box.setChecked(False)
        self.finish()
        self.assert_part_alone()
        FreeCADGui.Control.closeDialog()
        self.open_panel(COMMAND)
        self.assertFalse(widget(QtWidgets.QCheckBox, "body").isChecked())
