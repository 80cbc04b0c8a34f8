"""Comparisons in documents, and the geometry that goes into them."""

from pathlib import Path

import fake_part
import FreeCAD
import Mesh
import Part
from run_cases import RunCase
from support import FolderCase, run_fake

from freecad.gaussiancad.engine.job import CompareJob
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.comparable import comparable_objects, export_geometry
from freecad.gaussiancad.objects.comparison import (
    CompareRequest,
    LoadedComparison,
    add_comparison,
    comparison_report,
    is_comparison,
    load_comparison,
    prepare_comparison,
    request_of,
    update_comparison,
)
from freecad.gaussiancad.objects.comparison_export import comparison_csv
from freecad.gaussiancad.objects.legend import (
    HEIGHT,
    STOPS,
    WIDTH,
    DeviationRange,
    colour_at,
    legend_image,
)
from freecad.gaussiancad.objects.sources import Source


class DocumentCase(RunCase):
    def setUp(self) -> None:
        super().setUp()
        self.part = self.document.addObject("Part::Feature", "Model")
        self.part.Shape = Part.read(str(fake_part.STEP_FILE))
        self.scan = self.document.addObject("Mesh::Feature", "Scan")
        stl = self.folder / "scan.stl"
        stl.write_text(fake_part.stl_text())
        self.scan.Mesh = Mesh.Mesh(str(stl))


class Candidates(DocumentCase):
    def test_solids_meshes_and_bodies_but_not_their_features(self) -> None:
        body = self.document.addObject("PartDesign::Body", "Body")
        box = self.document.addObject("PartDesign::AdditiveBox", "Box")
        body.addObject(box)
        self.document.addObject("PartDesign::Plane", "Datum")
        self.document.addObject("Part::Feature", "Empty")
        wire = self.document.addObject("Part::Feature", "Wire")
        wire.Shape = Part.makePolygon([FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(1, 0, 0)])
        self.document.addObject("Mesh::Feature", "EmptyMesh")
        self.document.addObject("Sketcher::SketchObject", "Sketch")
        self.document.recompute()
        names = [candidate.Name for candidate in comparable_objects(self.document)]
        self.assertEqual(names, ["Model", "Scan", "Body"])

    def test_geometry_is_written_where_it_stands(self) -> None:
        holder = self.document.addObject("App::Part", "Holder")
        holder.Placement.Base = FreeCAD.Vector(100, 0, 0)
        for moved in (self.part, self.scan):
            moved.Placement.Base = FreeCAD.Vector(0, 0, 7)
            holder.addObject(moved)
        body = self.document.addObject("PartDesign::Body", "Body")
        box = self.document.addObject("PartDesign::AdditiveBox", "Box")
        body.addObject(box)
        body.Placement.Base = FreeCAD.Vector(0, 50, 0)
        self.document.recompute()
        solid = Part.read(str(export_geometry(self.part, self.folder, "solid")))
        mesh = Mesh.Mesh(str(export_geometry(self.scan, self.folder, "mesh")))
        whole = Part.read(str(export_geometry(body, self.folder, "body")))
        for box, volume in ((solid.BoundBox, solid.Volume), (mesh.BoundBox, mesh.Volume)):
            low = (box.XMin, box.YMin, box.ZMin)
            for value, expected in zip(low, (100.0, 0.0, 7.0), strict=True):
                self.assertAlmostEqual(value, expected, places=4)
            self.assertAlmostEqual(volume, fake_part.VOLUME, delta=0.1)
        self.assertAlmostEqual(whole.BoundBox.YMin, 50.0, places=6)
        self.assertAlmostEqual(whole.Volume, 1000.0, places=6)

    def test_an_assembly_is_compared_as_a_whole(self) -> None:
        holder = self.document.addObject("App::Part", "Holder")
        assembly = self.document.addObject("App::Part", "Assembly")
        holder.Placement.Base = FreeCAD.Vector(0, 0, 100)
        assembly.Placement.Base = FreeCAD.Vector(100, 0, 0)
        holder.addObject(assembly)
        cut = self.document.addObject("Part::Cut", "Cut")
        cut.Base = self.document.addObject("Part::Box", "Base")
        cut.Tool = self.document.addObject("Part::Cylinder", "Tool")
        link = self.document.addObject("App::Link", "Again")
        link.LinkedObject = self.part
        link.Placement.Base = FreeCAD.Vector(0, 200, 0)
        for child in (self.part, self.scan, cut, cut.Base, cut.Tool, link):
            assembly.addObject(child)
        self.document.recompute()
        offered = comparable_objects(self.document)
        self.assertIn(assembly, offered)
        self.assertIn(link, offered)
        shape = Part.read(str(export_geometry(assembly, self.folder, "assembly")))
        self.assertEqual(len(shape.Solids), 3)
        volume = 2.0 * fake_part.VOLUME + cut.Shape.Volume
        self.assertAlmostEqual(shape.Volume, volume, delta=0.1)
        box = shape.BoundBox
        self.assertAlmostEqual(box.XMin, 100.0, places=5)
        self.assertAlmostEqual(box.ZMin, 100.0, places=5)
        self.assertAlmostEqual(box.YMax, 240.0, places=5)
        repeated = Part.read(str(export_geometry(link, self.folder, "link")))
        self.assertAlmostEqual(repeated.BoundBox.YMin, 200.0, places=5)
        self.assertAlmostEqual(repeated.BoundBox.ZMin, 100.0, places=5)
        state = Source(assembly).state()
        self.assertTrue(state)
        self.part.Placement.Base.x += 1.0
        self.document.recompute()
        self.assertNotEqual(Source(assembly).state(), state)

    def test_an_empty_assembly_is_none(self) -> None:
        self.document.addObject("App::Part", "Assembly")
        names = [candidate.Name for candidate in comparable_objects(self.document)]
        self.assertEqual(names, ["Model", "Scan"])

    def test_what_cannot_be_written_is_told(self) -> None:
        with self.assertRaises(WorkbenchError) as caught:
            export_geometry(self.part, self.folder / "missing", "solid")
        self.assertIs(caught.exception.code, ErrorCode.NOTHING_TO_COMPARE)
        self.assertIn("Model", caught.exception.message)


class Groups(DocumentCase):
    def request(self) -> CompareRequest:
        return CompareRequest(Source(self.scan), Source(self.part))

    def compare(self) -> Path:
        output = self.folder / "out"
        result = export_geometry(self.scan, self.folder, "result")
        reference = export_geometry(self.part, self.folder, "reference")
        run_fake(CompareJob(str(result), str(reference), str(output)).arguments())
        return output

    def added(self) -> tuple[LoadedComparison, FreeCAD.DocumentObject]:
        loaded = load_comparison(self.compare(), self.folder)
        return loaded, add_comparison(self.document, loaded, self.request())

    def test_everything_is_there_in_one_undo_step(self) -> None:
        self.document.UndoMode = 1
        _, group = self.added()
        self.assertEqual(self.document.UndoCount, 1)
        self.assertEqual((group.Result, group.Reference), ("Scan", "Model"))
        self.assertEqual((group.Chamfer, group.Hausdorff, group.Emd), (0.0312, 0.12, 0.056))
        self.assertEqual((group.PointToSurface, group.VolumeIou), (0.004, 0.991))
        self.assertEqual(group.Floor, ["chamfer: 0.03", "hausdorff: 0.1", "emd: 0.05"])
        self.assertEqual(group.ColourRange.Value, 1.0)
        deviation, legend = group.Group
        self.assertAlmostEqual(deviation.Mesh.Volume, fake_part.VOLUME, places=2)
        for point, colour in zip(deviation.Mesh.Points, deviation.VertexColors, strict=True):
            self.assertAlmostEqual(colour[0], point.x / 60.0, delta=0.003)
        self.assertAlmostEqual(legend.XSize.Value / legend.YSize.Value, WIDTH / HEIGHT, places=6)
        self.assertGreater(legend.Placement.Base.x, 60.0)
        self.assertEqual((self.scan.Visibility, self.part.Visibility), (False, False))
        # A coloured mesh is no candidate for the next comparison.
        self.assertEqual(comparable_objects(self.document), [self.part, self.scan])
        self.document.undo()
        self.assertEqual(len(self.document.Objects), 2)

    def test_damaged_files_are_told(self) -> None:
        output = self.compare()
        deviation = output / "deviation.ply"
        whole = deviation.read_bytes()
        for damaged in (whole[:200], b"", whole.replace(b"red", b"rot")):
            deviation.write_bytes(damaged)
            with self.assertRaises(WorkbenchError) as caught:
                load_comparison(output, self.folder)
            self.assertIs(caught.exception.code, ErrorCode.RESULT_UNREADABLE)

    def test_the_range_recolours_the_mesh(self) -> None:
        loaded, group = self.added()
        deviation, _ = group.Group
        self.document.UndoMode = 1
        self.document.openTransaction("Range")
        group.ColourRange = 0.5
        self.document.commitTransaction()
        for value, colour in zip(deviation.Deviations, deviation.VertexColors, strict=True):
            expected = [channel / 255.0 for channel in colour_at(value / 0.5)]
            for channel, wanted in zip(colour[:3], expected, strict=True):
                self.assertAlmostEqual(channel, wanted, delta=0.01)
        self.document.undo()
        self.assertEqual(group.ColourRange.Value, 1.0)
        self.assertAlmostEqual(deviation.VertexColors[-1][0], loaded.colours[-1][0], delta=0.01)

    def test_a_change_makes_it_stale_and_comparing_again_mends_that(self) -> None:
        loaded, group = self.added()
        self.document.recompute()
        self.assertFalse(group.Stale)
        self.assertEqual(request_of(group), self.request())
        shape = self.part.Shape.copy()
        shape.translate(FreeCAD.Vector(1, 0, 0))
        self.part.Shape = shape
        self.document.recompute()
        self.assertTrue(group.Stale)
        update_comparison(group, loaded, self.request())
        self.assertFalse(group.Stale)
        self.document.recompute()
        self.assertFalse(group.Stale)

    def test_a_change_within_an_assembly_makes_it_stale(self) -> None:
        loaded = load_comparison(self.compare(), self.folder)
        assembly = self.document.addObject("App::Part", "Assembly")
        assembly.addObject(self.part)
        self.document.recompute()
        request = CompareRequest(Source(self.scan), Source(assembly))
        group = add_comparison(self.document, loaded, request)
        self.document.recompute()
        self.assertFalse(group.Stale)
        self.assertFalse(assembly.Visibility)
        self.part.Placement.Base = FreeCAD.Vector(0, 0, 3)
        self.document.recompute()
        self.assertTrue(group.Stale)

    def test_a_file_is_a_reference_and_its_change_is_seen(self) -> None:
        path = self.folder / "Führung – 支架.stl"
        path.write_text(fake_part.stl_text())
        request = CompareRequest(Source(self.scan), Source(path=str(path)))
        self.assertEqual(request.reference.file(self.folder), path)
        loaded = load_comparison(self.compare(), self.folder)
        group = add_comparison(self.document, loaded, request)
        self.assertEqual((group.Reference, group.ReferenceFile), (path.name, str(path)))
        self.assertIsNone(group.ReferenceObject)
        path.write_text(fake_part.stl_text() + " ")
        group.touch()
        self.document.recompute()
        self.assertTrue(group.Stale)
        path.unlink()
        with self.assertRaises(WorkbenchError) as caught:
            request.reference.file(self.folder)
        self.assertIs(caught.exception.code, ErrorCode.NOTHING_TO_COMPARE)

    def test_the_sheet_goes_along_for_the_page(self) -> None:
        group = self.document.addObject("App::DocumentObjectGroup", "Reconstruction")
        group.addProperty("App::PropertyFileIncluded", "Overlay")
        picture = self.folder / "lines.png"
        picture.write_bytes(b"a picture")
        group.Overlay = str(picture)
        self.assertIsNone(self.request().result.sheet())
        group.addObject(self.scan)
        scratch = self.folder / "scratch"
        scratch.mkdir()
        job = prepare_comparison(self.request(), scratch)
        self.assertEqual((scratch / "result" / "overlay.png").read_bytes(), b"a picture")
        self.assertEqual(Path(job.result), scratch / "result" / "Scan.stl")

    def test_it_is_all_there_after_saving(self) -> None:
        self.added()
        path = self.folder / "saved.FCStd"
        self.document.saveAs(str(path))
        FreeCAD.closeDocument(self.document.Name)
        group = next(o for o in FreeCAD.openDocument(str(path)).Objects if is_comparison(o))
        report = comparison_report(group)
        self.assertEqual([point.deviation for point in report.worst], [1.0, -0.75])
        self.assertEqual(len(report.histogram.shares), 4)
        self.assertEqual(report.engineering["agreement"], 0.875)
        self.assertEqual(request_of(group).result.label, "Scan")
        self.assertIn("<h1>fake", Path(group.Page).read_text())
        group.ColourRange = 2.0
        self.assertEqual(len(group.Group[0].Deviations), len(group.Group[0].VertexColors))

    def test_the_table_holds_every_number(self) -> None:
        loaded = load_comparison(self.compare(), self.folder)
        lines = comparison_csv(loaded.report).split("\r\n")
        self.assertEqual(lines[0], "measure,value")
        self.assertIn("chamfer,0.0312", lines)
        self.assertIn("protocols.engineering.result_to_reference.rms_mm,0.05", lines)
        self.assertIn("deviation.worst.1.point_mm.2,30.0", lines)


class Legends(FolderCase):
    def test_the_picture_runs_from_the_largest_value_down(self) -> None:
        for signed, lowest in ((True, STOPS[0]), (False, STOPS[2])):
            image = legend_image(DeviationRange(2.0, signed), with_text=False)
            for y, expected in ((35, STOPS[-1]), (485, lowest)):
                colour = image.pixelColor(45, y)
                channels = (colour.red(), colour.green(), colour.blue())
                for channel, wanted in zip(channels, expected, strict=True):
                    self.assertAlmostEqual(channel, wanted, delta=6)
