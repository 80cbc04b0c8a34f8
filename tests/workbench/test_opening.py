"""Drawings that FreeCAD opens and imports itself; the tests of the installation."""

import os
import unittest

import FreeCAD
from support import FolderCase, draw_sheet
from test_real_engine import SAMPLE, engine

from freecad.gaussiancad import installed, opening
from freecad.gaussiancad.errors import WorkbenchError

GIVEN = os.environ.get("GAUSSIANCAD_PYTHON")


class Opening(FolderCase):
    def tearDown(self) -> None:
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        super().tearDown()

    def test_drawings_are_among_the_files_that_freecad_opens(self) -> None:
        for suffix in ("pdf", "dxf", "svg", "png", "jpeg", "tif", "bmp", "webp"):
            self.assertIn("freecad.gaussiancad.opening", FreeCAD.getImportType(suffix), suffix)

    def test_the_tests_of_the_installation_are_listed(self) -> None:
        self.assertIn("freecad.gaussiancad.installed", FreeCAD.__unit_test__)
        suite = unittest.defaultTestLoader.loadTestsFromModule(installed)
        result = unittest.TestResult()
        suite.run(result)
        self.assertEqual((result.failures, result.errors, result.testsRun), ([], [], 3))

    @unittest.skipIf(engine() is None, "the engine is not installed")
    def test_a_drawing_is_opened_and_imported_without_a_window(self) -> None:
        self.set_variable("GAUSSIANCAD_PYTHON", GIVEN)
        opening.open(str(SAMPLE))
        document = FreeCAD.ActiveDocument
        self.assertTrue(document.getObject("Part").Shape.isValid())
        opening.insert(str(SAMPLE), document.Name)
        groups = [found for found in document.Objects if hasattr(found, "SheetPath")]
        self.assertEqual(len(groups), 2)

    @unittest.skipIf(engine() is None, "the engine is not installed")
    def test_a_picture_that_is_no_drawing_is_told(self) -> None:
        self.set_variable("GAUSSIANCAD_PYTHON", GIVEN)
        sheet = self.folder / "broken.png"
        sheet.write_bytes(draw_sheet(self.folder / "whole.png").read_bytes()[:200])
        with self.assertRaises(WorkbenchError):
            opening.open(str(sheet))
        self.assertEqual(FreeCAD.listDocuments(), {})
