"""The real engine behind the panel; left out where it is not installed."""

import os
import unittest

import FreeCAD
import FreeCADGui
import MeshPart
import Part
from test_real_engine import SAMPLE, SAMPLE_SOLID, engine
from window import WindowCase, spin, widget

from freecad.gaussiancad.engine.job import ScaleKind
from freecad.gaussiancad.qt import QtCore, QtWidgets

GIVEN = os.environ.get("GAUSSIANCAD_PYTHON")


@unittest.skipIf(engine() is None, "the engine is not installed")
class RealRun(WindowCase):
    def test_the_engine_shows_what_freecad_cannot(self) -> None:
        self.set_variable("GAUSSIANCAD_PYTHON", GIVEN)
        self.open_panel("GaussianCAD_Reconstruct")
        path = self.folder / "plate.svg"
        path.write_text(
            "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='60mm' "
            "viewBox='0 0 100 60'><rect x='20' y='10' width='60' height='40' fill='none' "
            "stroke='black' stroke-width='.5'/></svg>"
        )
        self.choose_sheet(path)
        preview = widget(QtWidgets.QLabel, "preview")
        self.assertFalse(preview.has_picture)
        self.wait_for(lambda: preview.has_picture)

    def test_from_a_sheet_to_a_part_while_the_window_lives(self) -> None:
        self.set_variable("GAUSSIANCAD_PYTHON", GIVEN)
        document = FreeCAD.newDocument("Real")
        self.open_panel("GaussianCAD_Reconstruct")
        self.choose_sheet(SAMPLE)
        widget(QtWidgets.QComboBox, "preset").setCurrentIndex(0)
        scale = widget(QtWidgets.QComboBox, "scale")
        scale.setCurrentIndex(list(ScaleKind).index(ScaleKind.LENGTH_X))
        widget(QtWidgets.QAbstractSpinBox, "length").setProperty("rawValue", 80.0)
        beats: list[str] = []
        stage = widget(QtWidgets.QLabel, "stage")
        heart = QtCore.QTimer()
        heart.timeout.connect(lambda: beats.append(stage.text()))
        button = self.start()
        heart.start(100)
        self.wait_for(button.isEnabled, 600.0)
        heart.stop()
        # A window that hangs while the engine works has no beats in its stages.
        self.assertGreater(len(set(filter(lambda text: "Stage" in text, beats))), 4)
        self.assertGreater(len(beats), 50)
        self.assertEqual([box.text() for box in self.boxes()], [])
        self.picture("real-finished")
        self.assertEqual(document.UndoNames, ["Reconstruct from Drawing"])
        box = document.getObject("Part").Shape.BoundBox
        self.assertAlmostEqual(box.XLength, 80.0, delta=2.0)
        document.undo()
        self.assertEqual(document.Objects, [])

    def test_a_mesh_is_checked_against_its_drawing_and_again_once_it_is_mended(self) -> None:
        self.set_variable("GAUSSIANCAD_PYTHON", GIVEN)
        document = FreeCAD.newDocument("Real")
        solid = Part.read(str(SAMPLE_SOLID))
        hole = Part.makeCylinder(4.0, 200.0, FreeCAD.Vector(30, 10, -50))
        model = document.addObject("Mesh::Feature", "Scan")
        model.Mesh = MeshPart.meshFromShape(solid.cut(hole), LinearDeflection=0.02)
        view = FreeCADGui.getDocument("Real").ActiveView
        view.viewIsometric()
        view.fitAll()
        self.open_panel("GaussianCAD_Check")
        self.choose_sheet(SAMPLE)
        button = self.start()
        self.wait_for(button.isEnabled, 300.0)
        self.assertEqual([box.text() for box in self.boxes()], [])
        verdict = widget(QtWidgets.QLabel, "verdict")
        self.assertEqual(verdict.text(), "The model differs from the drawing.")
        # The sample has no numbers: lengths are those of the model, whatever was assumed.
        reasons = widget(QtWidgets.QLabel, "reasons").text()
        self.assertIn("the size was not checked", reasons)
        self.assertEqual(widget(QtWidgets.QPlainTextEdit, "log").toPlainText(), "")
        change = widget(QtWidgets.QTableWidget, "edits").item(0, 1).text()
        self.assertRegex(change, r"^Fill the hole of (8|8\.0\d+|7\.9\d+) mm at \(30, 10, 6\)$")
        self.picture("real-check")
        widget(QtWidgets.QTableWidget, "differences").selectRow(0)
        spin(1000)
        self.picture("real-check-difference")
        tabs = widget(QtWidgets.QTabWidget, "checkTabs")
        tabs.setCurrentIndex(1)
        self.picture("real-check-changes")
        tabs.setCurrentIndex(2)
        self.picture("real-check-drawing")
        model.Mesh = MeshPart.meshFromShape(solid, LinearDeflection=0.02)
        document.recompute()
        self.wait_for(widget(QtWidgets.QLabel, "stale").isVisible)
        self.start()
        self.wait_for(button.isEnabled, 300.0)
        self.assertEqual(verdict.text(), "The model agrees with the drawing.")
        self.assertEqual(len(document.Objects), 1)
