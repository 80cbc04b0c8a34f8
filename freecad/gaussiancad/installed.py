"""Whether the workbench is whole: tests that FreeCAD's test workbench lists."""

import os
import tempfile
import unittest
from pathlib import Path

import FreeCAD

from freecad.gaussiancad import paths
from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.locate import SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun
from freecad.gaussiancad.engine.protocol import ResultKind
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.objects.reconstruction import new_reconstruction
from freecad.gaussiancad.objects.reconstruction_features import add_empty_part
from freecad.gaussiancad.preferences import read_preferences


class Installation(unittest.TestCase):
    """Files, a document, and the engine."""

    def test_files_are_there(self) -> None:
        """Every command has its icon, and each language its texts."""
        from freecad.gaussiancad import workbench_names

        for name in workbench_names.MENU:
            self.assertTrue((paths.ICONS / f"{name}.svg").is_file(), name)
        for texts in paths.TRANSLATIONS.glob("*.ts"):
            self.assertTrue(texts.with_suffix(".qm").is_file(), texts.name)

    def test_a_document_keeps_a_drawing(self) -> None:
        """What is saved is there again, without the engine."""
        with tempfile.TemporaryDirectory() as folder:
            sheet = Path(folder) / "sheet.png"
            sheet.write_bytes(b"a drawing")
            document = FreeCAD.newDocument("GaussianCADInstalled")
            group = new_reconstruction(document, ReconstructJob(str(sheet), ""))
            add_empty_part(group)
            path = str(Path(folder) / "kept.FCStd")
            document.saveAs(path)
            FreeCAD.closeDocument(document.Name)
            document = FreeCAD.openDocument(path)
            (group,) = (found for found in document.Objects if hasattr(found, "SheetPath"))
            self.assertEqual(Path(group.Sheet).read_bytes(), b"a drawing")
            self.assertEqual(len(group.Group), 1)
            FreeCAD.closeDocument(document.Name)

    def test_the_engine_makes_a_part(self) -> None:
        """The sample sheet becomes a solid; left out where no engine is installed."""
        try:
            preference = read_preferences().engine_python
            engine = find_engine(SearchPlaces.of_this_machine(preference, os.environ))
        except WorkbenchError as error:
            self.skipTest(str(error))
        with tempfile.TemporaryDirectory() as folder:
            sheet = paths.ADDON_ROOT / "resources" / "samples" / "l-bracket.png"
            job = ReconstructJob(str(sheet), folder, outcome=ResultKind.SOLID)
            run = EngineRun(engine, job.arguments())
            run.start()
            self.assertIs(run.wait().state, RunState.DONE)
            self.assertTrue((Path(folder) / "solid.step").is_file())
