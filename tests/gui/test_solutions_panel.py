"""*Choose among Solutions…* in a real window, with the fake engine."""

import fake_part
import FreeCAD
import FreeCADGui
from pivy import coin
from window import WindowCase, spin, widget

from freecad.gaussiancad.qt import QtCore, QtWidgets

NAMES = ("Part", "Alternative", "Alternative001")
VOLUMES = (fake_part.VOLUME, *fake_part.ALTERNATIVE_VOLUMES)


class Choosing(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Test")
        self.behave("several")
        self.open_panel("GaussianCAD_Reconstruct")
        self.choose_sheet(self.sheet)
        button = self.start()
        self.wait_for(button.isEnabled)
        self.undo_names = list(self.document.UndoNames)

    def open_from_the_run(self) -> None:
        button = widget(QtWidgets.QPushButton, "followUp")
        self.assertTrue(button.isVisible())
        self.assertEqual(button.text(), "Choose among 3 Solutions…")
        button.click()
        self.wait_for(self.is_open)
        spin(200)

    def is_open(self) -> bool:
        return self.window.findChild(QtWidgets.QPushButton, "keep") is not None

    def shown(self) -> list[str]:
        found = (self.document.getObject(name) for name in NAMES)
        return [one.Name for one in found if one is not None and one.ViewObject.isVisible()]

    def marks(self) -> int:
        """Bodies that mark what the shown solution has more or less."""
        search = coin.SoSearchAction()
        search.setType(coin.SoIndexedFaceSet.getClassTypeId(), False)
        search.setInterest(coin.SoSearchAction.ALL)
        search.apply(FreeCADGui.getDocument(self.document.Name).ActiveView.getSceneGraph())
        return search.getPaths().getLength()

    def press(self, name: str) -> None:
        widget(QtWidgets.QPushButton, name).click()
        spin(50)

    def position(self) -> str:
        return widget(QtWidgets.QLabel, "position").text()

    def details(self) -> str:
        return widget(QtWidgets.QPlainTextEdit, "details").toPlainText()

    def press_cancel(self) -> None:
        boxes = self.window.findChildren(QtWidgets.QDialogButtonBox)
        kind = QtWidgets.QDialogButtonBox.StandardButton.Cancel
        next(box.button(kind) for box in boxes if box.button(kind) and box.isVisible()).click()
        self.wait_for(lambda: not FreeCADGui.Control.activeDialog())

    def test_flipping_shows_one_at_a_time_and_what_is_known_of_it(self) -> None:
        self.picture("solutions-offered")
        self.open_from_the_run()
        self.assertEqual((self.position(), self.shown()), ("1 of 3", ["Part"]))
        self.assertIn("simplest", self.details())
        doubts = widget(QtWidgets.QPlainTextEdit, "doubts").toPlainText()
        self.assertIn("3 different solids have these lines", doubts)
        table = widget(QtWidgets.QTableWidget, "solutions")
        self.picture("solutions-first")
        cells = [[table.item(row, column).text() for column in range(3)] for row in range(3)]
        self.assertEqual(cells[0], ["8", "36000 mm³", "99.8%"])
        self.assertEqual(cells[1][1:], ["35000 mm³", "99.7%"])
        self.assertEqual(cells[2][1:], ["36500 mm³", "99.0%"])
        self.press("next")
        self.assertEqual((self.position(), self.shown()), ("2 of 3", [NAMES[1]]))
        self.assertIn("Magenta: 1000 mm³ less than solution 1", self.details())
        self.assertIn("within X 0…5, Y 10…30, Z 20…30 mm", self.details())
        self.assertEqual(self.marks(), 1)
        self.picture("solutions-second")
        self.press("next")
        self.assertEqual((self.position(), self.shown()), ("3 of 3", [NAMES[2]]))
        self.assertIn("Read in first angle", self.details())
        self.assertIn("Orange: 500 mm³ more than solution 1", self.details())
        self.assertEqual(table.place, 2)
        self.picture("solutions-third")
        self.press("next")
        self.assertEqual(self.position(), "1 of 3")
        self.press("previous")
        self.assertEqual(self.position(), "3 of 3")
        table.selectRow(1)
        spin(50)
        self.assertEqual((self.position(), self.shown()), ("2 of 3", [NAMES[1]]))
        self.assertEqual(self.document.UndoNames, self.undo_names)

    def test_keeping_one_is_one_undo_step(self) -> None:
        self.open_from_the_run()
        self.press("next")
        self.press("keep")
        self.wait_for(lambda: not FreeCADGui.Control.activeDialog())
        self.assertEqual(self.shown(), ["Part"])
        self.assertAlmostEqual(self.document.Part.Shape.Volume, VOLUMES[1], places=6)
        self.assertIsNone(self.document.getObject(NAMES[1]))
        self.assertIsNone(self.document.getObject(NAMES[2]))
        self.assertEqual(self.document.UndoNames, ["Keep Solution", *self.undo_names])
        self.assertFalse(self.action().isEnabled())
        self.picture("solutions-kept")
        self.document.undo()
        spin(200)
        for name, volume in zip(NAMES, VOLUMES, strict=True):
            self.assertAlmostEqual(self.document.getObject(name).Shape.Volume, volume, places=6)
        self.assertEqual(self.shown(), ["Part"])
        self.assertEqual(self.document.UndoNames, self.undo_names)
        self.document.redo()
        spin(200)
        self.assertAlmostEqual(self.document.Part.Shape.Volume, VOLUMES[1], places=6)
        self.assertEqual(self.shown(), ["Part"])

    def test_cancelling_leaves_everything_as_it_was(self) -> None:
        self.open_from_the_run()
        self.press("next")
        self.press_cancel()
        self.assertEqual((self.shown(), self.marks()), (["Part"], 0))
        self.assertEqual(self.document.UndoNames, self.undo_names)
        for name, volume in zip(NAMES, VOLUMES, strict=True):
            self.assertAlmostEqual(self.document.getObject(name).Shape.Volume, volume, places=6)

    def test_a_panel_closed_from_outside_leaves_everything_as_it_was(self) -> None:
        self.open_from_the_run()
        self.press("previous")
        self.assertEqual(self.shown(), [NAMES[2]])
        FreeCADGui.Control.closeDialog()
        self.wait_for(lambda: self.shown() == ["Part"])

    def test_the_toolbar_opens_it_too(self) -> None:
        FreeCADGui.Control.closeDialog()
        spin(100)
        self.open_panel("GaussianCAD_Solutions")
        self.wait_for(self.is_open)
        self.assertEqual(self.position(), "1 of 3")
        self.press_cancel()
        other = FreeCAD.newDocument("Other")
        self.wait_for(lambda: not self.action().isEnabled())
        FreeCAD.closeDocument(other.Name)

    def test_a_closed_document_closes_no_window(self) -> None:
        self.open_from_the_run()
        FreeCAD.closeDocument(self.document.Name)
        spin(200)
        if self.is_open():
            self.press("next")
            self.assertEqual(len(self.boxes()), 1)

    def test_without_a_choice_nothing_is_offered(self) -> None:
        self.behave("ok")
        button = self.start()
        self.wait_for(button.isEnabled)
        self.assertFalse(widget(QtWidgets.QPushButton, "followUp").isVisible())

    def action(self) -> QtCore.QObject:
        FreeCADGui.updateGui()
        spin(500)
        return next(
            action
            for bar in self.window.findChildren(QtWidgets.QToolBar)
            for action in bar.actions()
            if "GaussianCAD_Solutions" in (action.data() or "") + action.objectName()
        )
