"""The canvas in FreeCAD, with the real engine; left out where it is not installed."""

import os
import shutil
import unittest
from pathlib import Path

import FreeCAD
import FreeCADGui
from test_real_engine import SAMPLE, engine
from window import WindowCase, spin

from freecad.gaussiancad.canvas.history import corrections_path
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.panels import correct
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

GIVEN = os.environ.get("GAUSSIANCAD_PYTHON")

_KEYS = QtCore.Qt.KeyboardModifier.NoModifier


@unittest.skipIf(engine() is None, "the engine is not installed")
class Canvas(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.set_variable("GAUSSIANCAD_PYTHON", GIVEN)
        self.copy = Path(shutil.copy(SAMPLE, self.folder))
        self.document = FreeCAD.newDocument("Canvas")
        self.canvas = self.opened()
        self.addCleanup(self.close_canvas)

    def opened(self) -> SheetWindow:
        """The canvas on a copy of the sample, with the sheet read."""

        class Chosen:
            SheetPath = str(self.copy)

        own = correct.open_canvas([Chosen()])
        self.wait_for(lambda: own.sheet is not None, 120.0)
        spin(200)
        return own

    def close_canvas(self) -> None:
        if self.canvas is not None:
            self.canvas.close()
            self.canvas = None

    def press(self, key: QtCore.Qt.Key) -> None:
        for kind in (
            QtCore.QEvent.Type.ShortcutOverride,
            QtCore.QEvent.Type.KeyPress,
            QtCore.QEvent.Type.KeyRelease,
        ):
            QtWidgets.QApplication.sendEvent(self.canvas.board, QtGui.QKeyEvent(kind, key, _KEYS))
        spin(50)

    def test_a_sheet_is_read_corrected_and_becomes_a_part(self) -> None:
        drawn = [own for own in self.canvas.sheet.strokes if own.kind == "visible"]
        self.assertGreater(len(drawn), 10)
        self.picture("canvas-read")
        self.canvas.say_length(((0.0, 0.0), (100.0, 0.0)), 50.0)
        self.assertTrue(corrections_path(self.copy).is_file())
        self.canvas.solve()
        self.wait_for(lambda: self.document.getObject("Part") is not None, 300.0)
        self.assertEqual(self.document.UndoNames, ["Reconstruct from Drawing"])
        first = self.document.getObject("Part").Shape.BoundBox.XLength
        self.picture("canvas-solved")
        self.canvas.say_length(((0.0, 0.0), (100.0, 0.0)), 100.0)
        self.wait_for(lambda: not self.canvas.busy, 300.0)
        self.canvas.solve()
        self.wait_for(lambda: not self.canvas.busy, 300.0)
        spin(200)
        groups = [own for own in self.document.Objects if own.Name.startswith("Reconstruction")]
        self.assertEqual(len(groups), 1)
        (part,) = (own for own in groups[0].Group if own.isDerivedFrom("Part::Feature"))
        self.assertAlmostEqual(part.Shape.BoundBox.XLength, 2.0 * first, delta=0.02 * first)
        self.document.undo()
        again = [own for own in self.document.Objects if own.isDerivedFrom("Part::Feature")]
        self.assertAlmostEqual(again[0].Shape.BoundBox.XLength, first, delta=1e-6)

    def test_delete_on_the_canvas_erases_a_stroke_and_no_object(self) -> None:
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        FreeCADGui.Selection.addSelection(box)
        stroke = next(own for own in self.canvas.sheet.strokes if own.kind == "visible")
        self.canvas.board.select({stroke.id})
        self.press(QtCore.Qt.Key.Key_Delete)
        self.assertEqual([own["op"] for own in self.canvas.operations], ["erase"])
        self.assertIsNotNone(self.document.getObject("Box"))
        self.canvas.undo()
        self.assertEqual(self.canvas.operations, [])
        self.assertFalse(corrections_path(self.copy).exists())

    def test_a_closed_canvas_ends_its_engine(self) -> None:
        self.canvas.solve()
        self.assertTrue(self.canvas.busy)
        self.close_canvas()
        spin(500)
        self.assertEqual(self.document.Objects, [])
