"""Documents of older versions: what they hold is there, in properties that FreeCAD shows."""

import tempfile
from pathlib import Path

import FreeCAD
from support import FolderCase, draw_sheet, run_fake
from test_comparison import DocumentCase

from freecad.gaussiancad.engine.job import CompareJob, ReconstructJob
from freecad.gaussiancad.objects.comparable import export_geometry
from freecad.gaussiancad.objects.comparison import (
    CompareRequest,
    add_comparison,
    load_comparison,
)
from freecad.gaussiancad.objects.comparison_properties import range_mm
from freecad.gaussiancad.objects.known_sheets import page_of
from freecad.gaussiancad.objects.loading import load_run
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.objects.reconstruction import add_reconstruction, put_reconstruction
from freecad.gaussiancad.objects.reconstruction_properties import SCHEMA_VERSION
from freecad.gaussiancad.objects.sources import Source

OLD = Path(__file__).parent / "data" / "reconstruction-schema-1.FCStd"
"""Saved by the version that kept its texts in maps."""

MAPS = {
    "Settings": {"page": "2", "scale": "x = 60", "colour": "#78a0d2"},
    "ViewBoxes": {"front": "1, 2, 3, 4"},
    "ViewAgreement": {"front.recall": "0.97"},
    "Seconds": {"solid": "1.25"},
    "EngineVersions": {"versions.torch": "2.4: a note", "sheet": "C: drive.png"},
}


class OldDocuments(FolderCase):
    def setUp(self) -> None:
        super().setUp()
        self.addCleanup(self.close_all)

    def close_all(self) -> None:
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    def finished(self) -> object:
        sheet = draw_sheet(self.folder / "bracket.png")
        job = ReconstructJob(str(sheet), str(self.folder / "run"), page=2)
        run_fake(job.arguments())
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        return load_run(job, Path(scratch.name))

    def old_document(self) -> Path:
        """As version 1 saved it."""
        document = FreeCAD.newDocument("Old")
        group = add_reconstruction(document, self.finished())
        for name, texts in MAPS.items():
            heading = group.getGroupOfProperty(name)
            group.removeProperty(name)
            group.addProperty("App::PropertyMap", name, heading, "an old tip")
            setattr(group, name, texts)
            group.setEditorMode(name, 1)
        group.SchemaVersion = 1
        group.removeProperty("MeasuresWithin")
        group.addProperty("App::PropertyFloat", "MeasuresToMillimetres", "Report", "bound")
        group.MeasuresToMillimetres = 0.125
        path = self.folder / "old.FCStd"
        document.saveAs(str(path))
        self.close_all()
        return path

    def test_all_that_an_old_document_holds_is_in_the_new_properties(self) -> None:
        document = FreeCAD.openDocument(str(self.old_document()))
        group = document.getObject("Reconstruction")
        for name, texts in MAPS.items():
            self.assertEqual(group.getTypeIdOfProperty(name), "App::PropertyStringList")
            self.assertEqual(texts_of(group, name), texts)
            self.assertEqual(group.getEditorMode(name), ["ReadOnly"])
        self.assertEqual(group.getTypeIdOfProperty("MeasuresWithin"), "App::PropertyLength")
        self.assertEqual(group.MeasuresWithin.Value, 0.125)
        self.assertNotIn("MeasuresToMillimetres", group.PropertiesList)
        self.assertEqual((page_of(group), group.SchemaVersion), (2, SCHEMA_VERSION))
        again = self.folder / "again.FCStd"
        document.saveAs(str(again))
        self.close_all()
        group = FreeCAD.openDocument(str(again)).getObject("Reconstruction")
        self.assertEqual(texts_of(group, "Settings"), MAPS["Settings"])
        self.assertEqual(group.MeasuresWithin.Value, 0.125)
        self.assertTrue(group.MeasuresWithin.UserString.endswith(" mm"))

    def test_a_document_that_an_older_version_saved_is_read_without_loss(self) -> None:
        group = FreeCAD.openDocument(str(OLD)).getObject("Reconstruction")
        settings = texts_of(group, "Settings")
        self.assertEqual((settings["preset"], settings["scale-down"]), ("standard", "1"))
        self.assertEqual(len(settings), 9)
        self.assertEqual(texts_of(group, "ViewBoxes")["top"], "100, 100, 340, 260")
        self.assertEqual(len(texts_of(group, "ViewAgreement")), 12)
        self.assertEqual(texts_of(group, "Seconds")["solid"], "1.25")
        self.assertEqual(texts_of(group, "EngineVersions")["device"], "cpu")
        self.assertEqual((group.MeasuresWithin.Value, group.SchemaVersion), (0.0, SCHEMA_VERSION))
        self.assertEqual((len(group.Group), group.Status), (6, "verified"))

    def test_a_second_run_works_on_what_was_brought_up_to_date(self) -> None:
        document = FreeCAD.openDocument(str(self.old_document()))
        group = document.getObject("Reconstruction")
        put_reconstruction(document, self.finished())
        self.assertEqual(len([o for o in document.Objects if hasattr(o, "SheetPath")]), 1)
        self.assertEqual(texts_of(group, "Settings")["preset"], "standard")

    def test_no_property_of_this_version_is_hidden_from_an_editor_by_its_type(self) -> None:
        group = add_reconstruction(FreeCAD.newDocument("New"), self.finished())
        kinds = {group.getTypeIdOfProperty(name) for name in group.PropertiesList}
        self.assertNotIn("App::PropertyMap", kinds)


class OldComparisons(DocumentCase):
    def test_the_range_and_the_floor_are_kept(self) -> None:
        output = self.folder / "out"
        result = export_geometry(self.scan, self.folder, "result")
        reference = export_geometry(self.part, self.folder, "reference")
        run_fake(CompareJob(str(result), str(reference), str(output)).arguments())
        request = CompareRequest(Source(self.scan), Source(self.part))
        group = add_comparison(self.document, load_comparison(output, self.folder), request)
        for name in ("Floor", "ColourRange"):
            group.removeProperty(name)
        group.addProperty("App::PropertyMap", "Floor", "Comparison", "floor")
        group.Floor = {"chamfer": "0.03", "emd": "0.05"}
        group.addProperty("App::PropertyFloat", "RangeMillimetres", "Comparison", "range")
        group.RangeMillimetres = 0.75
        name, path = group.Name, str(self.folder / "old.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        group = FreeCAD.openDocument(path).getObject(name)
        self.assertEqual(texts_of(group, "Floor"), {"chamfer": "0.03", "emd": "0.05"})
        self.assertEqual(group.ColourRange.Value, 0.75)
        group.ColourRange = "2 mm"
        self.assertEqual(range_mm(group), 2.0)
