"""A number that is changed in the body shows on the canvas, with the real engine."""

import os
import subprocess
import unittest
from pathlib import Path

import FreeCAD
import FreeCADGui
from test_real_engine import SAMPLE, engine
from window import WindowCase, spin

from freecad.gaussiancad.canvas.changes import CHANGED
from freecad.gaussiancad.objects.body_check import check_body
from freecad.gaussiancad.objects.body_numbers import set_value, value_of
from freecad.gaussiancad.objects.sheet_numbers import changed_numbers
from freecad.gaussiancad.panels import correct
from freecad.gaussiancad.qt import QtWidgets
from freecad.gaussiancad.remodelling import remodel

GIVEN = os.environ.get("GAUSSIANCAD_PYTHON")


@unittest.skipIf(engine() is None, "the engine is not installed")
class ChangedNumbers(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.set_variable("GAUSSIANCAD_PYTHON", GIVEN)
        self.document = FreeCAD.newDocument("Changed")
        self.addCleanup(self.close_docks)
        self.dock = correct.open_sheet(self.dimensioned())
        canvas = self.dock.canvas
        self.wait_for(lambda: canvas.sheet is not None and not canvas.busy, 120.0)
        spin(200)

    def dimensioned(self) -> Path:
        """A sheet of the sample with all its dimensions."""
        path = self.folder / "l-bracket.png"
        drawn = [str(SAMPLE.with_suffix(".step")), str(path), "--style", "dimensioned"]
        command = [engine().python, "-I", "-m", "gaussiancad_core", "draw", *drawn]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, timeout=120)
        return path

    def close_docks(self) -> None:
        for dock in correct.open_docks():
            dock.close()
        spin(200)

    def purple(self) -> list[str]:
        """What stands on the canvas in the colour of changed numbers."""
        items = self.dock.canvas.canvas_view.scene().items()
        return [
            item.text()
            for item in items
            if isinstance(item, QtWidgets.QGraphicsSimpleTextItem)
            and item.brush().color().name() == CHANGED
        ]

    def rows(self) -> list[str]:
        return [line.text for line in self.dock.canvas.problems.lines]

    def test_from_a_number_in_the_body_to_the_sheet_and_back(self) -> None:
        (made,) = remodel(self.document.getObject("Part"))
        self.assertEqual(made.breaking, ())
        exact = made.body.Shape.copy()
        number = next(
            each for each in made.numbers if each.on_sheet and round(each.value, 3) == 80.0
        )
        feature = self.document.getObject(number.feature)
        self.document.openTransaction("Edit")
        set_value(feature, number.name, 95.0)
        self.document.recompute()
        self.document.commitTransaction()
        self.wait_for(self.purple)
        self.assertEqual(self.purple(), ["80 \u2192 95"])
        self.assertIn(f"{number.path}: 80 mm on the sheet, 95 mm in the body", self.rows())
        self.dock.canvas.canvas_view.fit()
        spin(300)
        self.picture("changed-numbers")
        self.document.undo()
        self.wait_for(lambda: not self.purple())
        self.document.redo()
        self.wait_for(self.purple)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.runCommand("GaussianCAD_SheetNumbers")
        self.wait_for(lambda: not self.purple())
        self.assertEqual(changed_numbers(made.body), ())
        self.assertEqual(value_of(feature, number.name), number.value)
        self.assertEqual(self.document.UndoNames[0], "Back to the Sheet's Numbers")
        self.assertEqual(check_body(made.body.Shape, exact).words, "")
        self.assertNotIn("in the body", " ".join(self.rows()))
        FreeCADGui.runCommand("GaussianCAD_SheetNumbers")
        (box,) = self.boxes()
        self.assertIn("No body has a number", box.text())
