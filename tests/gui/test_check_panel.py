"""*Check Against Drawing…* in a real window, with the fake engine."""

import fake_part
import FreeCAD
import FreeCADGui
import Part
from window import WindowCase, spin, widget

from freecad.gaussiancad.objects.properties import text_lines
from freecad.gaussiancad.qt import QtWidgets


class Panel(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Test")
        self.document.UndoMode = 1
        self.part = self.document.addObject("Part::Feature", "Model")
        self.part.Shape = Part.read(str(fake_part.STEP_FILE))
        other = self.document.addObject("Part::Box", "Other")
        other.Placement.Base = FreeCAD.Vector(100, 0, 0)
        self.document.recompute()
        other.Visibility = False
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.part)
        self.view = FreeCADGui.getDocument("Test").ActiveView
        self.view.viewIsometric()
        self.view.fitAll()
        self.graph = self.view.getSceneGraph()
        self.children = self.graph.getNumChildren()
        self.open_panel("GaussianCAD_Check")
        self.choose_sheet(self.sheet)

    def check(self) -> None:
        button = self.start()
        self.wait_for(button.isEnabled)

    def text(self, name: str) -> str:
        return widget(QtWidgets.QLabel, name).text()

    def rows(self, name: str) -> list[list[str]]:
        table = widget(QtWidgets.QTableWidget, name)
        columns = range(table.columnCount())
        return [[table.item(row, k).text() for k in columns] for row in range(table.rowCount())]

    def test_the_selected_object_is_offered(self) -> None:
        box = widget(QtWidgets.QComboBox, "model")
        self.assertEqual(box.currentText(), "Model")
        self.assertEqual([box.itemText(k) for k in range(box.count())], ["Model", "Other", "File…"])

    def test_a_model_that_agrees(self) -> None:
        self.check()
        self.assertEqual(self.boxes(), [])
        self.assertEqual(self.text("verdict"), "The model agrees with the drawing.")
        self.assertEqual((self.rows("differences"), self.rows("edits")), ([], []))
        self.picture("check-agrees")

    def test_a_model_that_differs_tells_why_where_and_what_to_change(self) -> None:
        self.behave("differs")
        steps = self.document.UndoCount
        self.check()
        self.assertEqual(self.boxes(), [])
        self.assertEqual(self.text("verdict"), "The model differs from the drawing.")
        reasons = self.text("reasons").split("\n")
        self.assertEqual(len(reasons), 3)
        self.assertIn("has a circle of 9.999 mm that the model does not show", reasons[0])
        self.assertIn("2x Ø4”: the drawing says 2, the model has 0.", reasons[2])
        rows = self.rows("differences")
        self.assertEqual(len(rows), 7)
        self.assertEqual(rows[0], ["top", "0", "Note"])
        self.assertEqual(rows[1], ["top", "31.4", "Missing"])
        self.assertEqual(rows[-1], ["front", "4", "Extra"])
        self.assertEqual(
            [row[1] for row in self.rows("edits")],
            [
                "Drill a hole of 9.999 mm at (40, 15, 15)",
                "Move the flat face at (37.5, 20, 10) to (37.5, 20, 15)",
            ],
        )
        self.picture("check-differs")
        self.assertEqual(self.document.UndoCount, steps)
        self.assertEqual(len(self.document.Objects), 2)

    def test_a_difference_is_shown_from_where_its_view_looks(self) -> None:
        self.behave("differs")
        self.check()
        self.assertEqual(self.graph.getNumChildren(), self.children + 1)
        table = widget(QtWidgets.QTableWidget, "differences")
        # A note is shown at its hole.
        table.selectRow(0)

        def seen(place: FreeCAD.Vector) -> bool:
            across, up = self.view.getPointOnScreen(place)
            width, tall = self.view.getSize()
            return abs(across / width - 0.5) < 0.02 and abs(up / tall - 0.5) < 0.02

        self.wait_for(lambda: seen(FreeCAD.Vector(50, 30, 30)))
        table.selectRow(1)
        self.wait_for(lambda: seen(FreeCAD.Vector(40, 15, 30)))
        self.wait_for(lambda: self.view.getViewDirection().z < -0.999)
        self.picture("check-difference")
        table.selectRow(6)
        self.wait_for(lambda: seen(FreeCAD.Vector(22, 0, 10)))
        self.wait_for(lambda: self.view.getViewDirection().y > 0.999)
        widget(QtWidgets.QTabWidget, "checkTabs").setCurrentIndex(1)
        widget(QtWidgets.QTableWidget, "edits").selectRow(1)
        self.wait_for(lambda: seen(FreeCAD.Vector(37.5, 20, 12.5)))
        self.assertEqual(table.selectedItems(), [])
        self.picture("check-change")
        self.assertEqual(self.graph.getNumChildren(), self.children + 1)
        FreeCADGui.Control.closeDialog()
        spin(200)
        self.assertEqual(self.graph.getNumChildren(), self.children)

    def test_the_drawing_is_shown_with_the_differences_over_it(self) -> None:
        self.behave("differs")
        self.check()
        tabs = widget(QtWidgets.QTabWidget, "checkTabs")
        self.assertEqual(
            [tabs.tabText(k) for k in range(tabs.count())], ["Differences", "Changes", "Drawing"]
        )
        tabs.setCurrentIndex(2)
        spin(200)
        self.assertFalse(widget(QtWidgets.QLabel, "sheetPicture").pixmap().isNull())
        self.picture("check-drawing")

    def test_a_changed_model_is_told_and_checked_again(self) -> None:
        self.behave("differs")
        self.check()
        button = widget(QtWidgets.QPushButton, "start")
        self.assertEqual(button.text(), "Check Again")
        self.assertFalse(widget(QtWidgets.QLabel, "stale").isVisible())
        self.part.Shape = Part.makeBox(60, 40, 30)
        self.document.recompute()
        self.wait_for(widget(QtWidgets.QLabel, "stale").isVisible)
        self.assertIn("check again", self.text("stale"))
        self.picture("check-stale")
        self.behave("ok")
        self.check()
        self.assertEqual(self.text("verdict"), "The model agrees with the drawing.")
        self.assertFalse(widget(QtWidgets.QLabel, "stale").isVisible())
        self.assertEqual(self.rows("differences"), [])

    def test_another_object_that_changes_is_no_reason_to_check_again(self) -> None:
        self.check()
        self.document.getObject("Other").Length = 25
        self.document.recompute()
        spin(1000)
        self.assertFalse(widget(QtWidgets.QLabel, "stale").isVisible())

    def test_the_place_of_a_model_counts_and_its_name_does_not(self) -> None:
        self.check()
        self.part.Label = "Another name"
        self.document.recompute()
        spin(1000)
        stale = widget(QtWidgets.QLabel, "stale")
        self.assertFalse(stale.isVisible())
        self.part.Placement.Base = FreeCAD.Vector(0, 0, 3)
        self.document.recompute()
        self.wait_for(stale.isVisible)

    def test_a_model_that_is_changed_while_the_engine_works_is_told(self) -> None:
        self.behave("takes-long")
        button = self.start()
        spin(300)
        self.part.Shape = Part.makeBox(60, 40, 30)
        self.document.recompute()
        self.wait_for(button.isEnabled)
        self.assertEqual(self.boxes(), [])
        self.assertTrue(widget(QtWidgets.QLabel, "stale").isVisible())

    def test_where_nothing_can_be_told_the_reading_can_be_checked(self) -> None:
        self.behave("cannot-tell")
        self.check()
        self.assertEqual(self.boxes(), [])
        self.assertIn("cannot be told", self.text("verdict"))
        self.assertIn("fits the views in no position", self.text("reasons"))
        button = widget(QtWidgets.QPushButton, "followUp")
        self.assertTrue(button.isVisible())
        self.assertEqual(button.text(), "Correct Sheet…")
        self.picture("check-cannot-tell")

    def test_a_drawing_that_cannot_be_read_is_an_error(self) -> None:
        self.behave("refuse")
        self.check()
        (box,) = self.boxes()
        self.assertIn("The page has no lines", box.text())
        self.assertEqual(self.text("verdict"), "")

    def test_without_a_drawing_one_is_asked_for(self) -> None:
        widget(QtWidgets.QLineEdit, "sheet").setText("")
        self.start()
        (box,) = self.boxes()
        self.assertIn("Choose a drawing first", box.text())

    def test_cancelling_shows_nothing(self) -> None:
        self.behave("slow")
        button = self.start()
        spin(500)
        widget(QtWidgets.QPushButton, "cancel").click()
        self.wait_for(button.isEnabled)
        self.assertEqual((self.text("verdict"), self.boxes()), ("", []))

    def test_a_document_that_is_closed_leaves_no_trace(self) -> None:
        self.behave("differs")
        self.check()
        FreeCAD.closeDocument("Test")
        spin(300)
        self.assertEqual(self.boxes(), [])

    def test_a_document_that_is_closed_while_the_engine_works_is_told(self) -> None:
        self.behave("takes-long")
        button = self.start()
        spin(300)
        FreeCAD.closeDocument("Test")
        if FreeCADGui.Control.activeDialog():
            self.choose_sheet(self.folder / "another.png")
            self.wait_for(button.isEnabled)
            (box,) = self.boxes()
            self.assertIn("closed", box.text())


class OfReconstruction(WindowCase):
    def test_the_drawing_of_a_reconstruction_is_offered(self) -> None:
        document = FreeCAD.newDocument("Test")
        group = document.addObject("App::DocumentObjectGroup", "Reconstruction")
        group.addProperty("App::PropertyString", "SheetPath")
        group.addProperty("App::PropertyStringList", "Settings")
        group.SheetPath = str(self.sheet)
        group.Settings = text_lines({"projection": "first", "page": "1"})
        part = document.addObject("Part::Feature", "Part")
        part.Shape = Part.read(str(fake_part.STEP_FILE))
        group.addObject(part)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(group)
        self.open_panel("GaussianCAD_Check")
        self.assertEqual(widget(QtWidgets.QLineEdit, "sheet").text(), str(self.sheet))
        self.assertEqual(widget(QtWidgets.QComboBox, "projection").currentText(), "First angle")
        self.assertIn("Part", widget(QtWidgets.QComboBox, "model").currentText())


class OfBody(WindowCase):
    def test_of_a_selected_feature_the_whole_body_is_checked(self) -> None:
        document = FreeCAD.newDocument("Test")
        document.addObject("Part::Box", "First")
        body = document.addObject("PartDesign::Body", "Body")
        box = document.addObject("PartDesign::AdditiveBox", "Box")
        body.addObject(box)
        document.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(box)
        self.open_panel("GaussianCAD_Check")
        self.assertEqual(widget(QtWidgets.QComboBox, "model").currentText(), "Body")
        self.assertEqual(widget(QtWidgets.QLineEdit, "sheet").text(), "")


class EmptyDocument(WindowCase):
    def test_nothing_to_check_is_told(self) -> None:
        FreeCAD.newDocument("Empty")
        self.open_panel("GaussianCAD_Check")
        self.choose_sheet(self.sheet)
        self.start()
        (box,) = self.boxes()
        self.assertIn("nothing to check", box.text())
