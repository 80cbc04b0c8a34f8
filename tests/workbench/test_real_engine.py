"""The real engine, from FreeCAD's console; left out where it is not installed."""

import csv
import math
import os
import signal
import tempfile
import unittest
from pathlib import Path

import FreeCAD
import Part
from support import HARD_NAME, FolderCase

from freecad.gaussiancad.batch import main
from freecad.gaussiancad.engine.check_file import (
    CheckVerdict,
    DifferenceKind,
    SheetCheck,
    read_check,
)
from freecad.gaussiancad.engine.check_job import CHECK_FILE, CHECK_PICTURE, CheckJob
from freecad.gaussiancad.engine.job import CompareJob, ReconstructJob, Scale, ScaleKind
from freecad.gaussiancad.engine.locate import Engine, SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun, RunResult, Watcher
from freecad.gaussiancad.engine.protocol import Event, EventKind, Preset
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.objects.comparison import CompareRequest, add_comparison, load_comparison
from freecad.gaussiancad.objects.legend import colour_at
from freecad.gaussiancad.objects.loading import load_run
from freecad.gaussiancad.objects.ply import read_vertices
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.objects.reconstruction import add_reconstruction
from freecad.gaussiancad.objects.reconstruction_features import find_part
from freecad.gaussiancad.objects.sources import Source
from freecad.gaussiancad.paths import ADDON_ROOT

SAMPLE = ADDON_ROOT / "resources" / "samples" / "l-bracket.png"
SAMPLE_SOLID = SAMPLE.with_suffix(".step")
PLAIN = Path(__file__).parent / "data" / "plain-part.png"
"""A small sheet, verified within a second."""


def engine() -> Engine | None:
    """The engine of this machine, or None."""
    try:
        return find_engine(SearchPlaces.of_this_machine("", os.environ))
    except WorkbenchError:
        return None


def run(arguments: list[str], stop_in: str = "") -> tuple[RunResult, list[Event]]:
    """Run the engine; cancel it when it begins the stage ``stop_in``."""
    events: list[Event] = []

    def on_event(event: Event) -> None:
        events.append(event)
        if stop_in and event.kind is EventKind.STAGE and event.text("name") == stop_in:
            process.cancel()

    process = EngineRun(engine(), arguments, Watcher(on_event))
    process.start()
    return process.wait(), events


@unittest.skipIf(engine() is None, "the engine is not installed")
class Sample(unittest.TestCase):
    """One run on the sample sheet, looked at from several sides."""

    @classmethod
    def setUpClass(cls) -> None:
        holder = tempfile.TemporaryDirectory(prefix=f"{HARD_NAME} ")
        cls.addClassCleanup(holder.cleanup)
        folder = Path(holder.name)
        cls.sheet = folder / "Blech 图.png"
        cls.sheet.write_bytes(SAMPLE.read_bytes())
        scale = Scale(ScaleKind.LENGTH_X, 80.0)
        cls.job = ReconstructJob(
            str(cls.sheet), str(folder / "out"), preset=Preset.DRAFT, scale=scale
        )
        cls.result, cls.events = run(cls.job.arguments())
        cls.folder = folder
        cls.document = FreeCAD.newDocument("Real")
        cls.addClassCleanup(FreeCAD.closeDocument, "Real")
        scratch = folder / "views"
        scratch.mkdir()
        if cls.result.state is RunState.DONE:
            cls.loaded = load_run(cls.job, scratch)
            cls.group = add_reconstruction(cls.document, cls.loaded)

    def test_the_run_succeeds_and_tells_its_stages_in_order(self) -> None:
        self.assertIs(self.result.state, RunState.DONE, self.result.log)
        self.assertIs(self.events[0].kind, EventKind.HELLO)
        self.assertEqual(self.events[0].number("protocol"), 1)
        self.assertIs(self.events[-1].kind, EventKind.RESULT)
        stages = [e for e in self.events if e.kind is EventKind.STAGE]
        count = stages[0].number("of")
        self.assertEqual([e.number("index") for e in stages], list(range(1, int(count) + 1)))

    def test_the_part_has_the_size_that_was_asked_for(self) -> None:
        part = find_part(self.group)
        box = part.Shape.BoundBox
        self.assertAlmostEqual(box.XLength, 80.0, delta=2.0)
        self.assertTrue(part.Shape.isValid())
        self.assertGreater(part.Shape.Volume, 0.0)
        surface = next(o for o in self.group.Group if o.TypeId == "Mesh::Feature")
        self.assertTrue(surface.Mesh.isSolid())
        self.assertAlmostEqual(surface.Mesh.Volume / part.Shape.Volume, 1.0, delta=0.05)

    def test_the_exact_part_is_filleted_cut_and_exported(self) -> None:
        part = find_part(self.group)
        self.assertTrue(part.Exact)
        whole, box = part.Shape, part.Shape.BoundBox
        number, edge = next(
            (number, edge)
            for number, edge in enumerate(whole.Edges, start=1)
            if all(abs(v.X) + abs(v.Z) < 1e-6 for v in edge.Vertexes)
        )
        fillet = self.document.addObject("Part::Fillet", "Fillet")
        fillet.Base, fillet.Edges = part, [(number, 3.0, 3.0)]
        tool = self.document.addObject("Part::Box", "Tool")
        tool.Length, tool.Width, tool.Height = box.XLength / 2, box.YLength, box.ZLength
        cut = self.document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = fillet, tool
        self.document.recompute()
        rounded, rest = fillet.Shape, cut.Shape
        self.assertTrue(rounded.isValid() and rest.isValid())
        removed = (1.0 - math.pi / 4.0) * 3.0**2 * edge.Length
        self.assertAlmostEqual(whole.Volume - rounded.Volume, removed, delta=1e-6 * whole.Volume)
        within = rounded.common(tool.Shape).Volume
        self.assertAlmostEqual(rest.Volume, rounded.Volume - within, delta=1e-6 * whole.Volume)
        self.assertGreater(min(rest.Volume, within), 0.1 * whole.Volume)
        for feature in (part, cut):
            path = self.folder / f"{feature.Name} 图.step"
            Part.export([feature], str(path))
            again = Part.Shape()
            again.read(str(path))
            self.assertTrue(again.isValid())
            self.assertEqual(len(again.Faces), len(feature.Shape.Faces))
            self.assertAlmostEqual(again.Volume / feature.Shape.Volume, 1.0, places=6)
        for name in ("Cut", "Tool", "Fillet"):
            self.document.removeObject(name)

    def test_the_views_enclose_the_part(self) -> None:
        planes = [o for o in self.group.Group if o.TypeId == "Image::ImagePlane"]
        self.assertEqual(len(planes), len(self.loaded.report.views))
        box = find_part(self.group).Shape.BoundBox
        front = next(o for o in planes if o.Label == "View front")
        self.assertAlmostEqual(front.Placement.Base.x, box.Center.x, delta=2.0)
        self.assertAlmostEqual(front.Placement.Base.z, box.Center.z, delta=2.0)
        self.assertGreater(front.Placement.Base.y, box.YMax)
        self.assertGreater(front.XSize.Value, 79.0)

    def test_the_points_are_the_reports_gaussians(self) -> None:
        cloud = next(o for o in self.group.Group if o.TypeId == "Points::Feature")
        self.assertEqual(cloud.Points.CountPoints, self.loaded.report.group("gaussians")["count"])
        self.assertEqual(len(cloud.Color), cloud.Points.CountPoints)

    def test_the_comparison_and_the_legend_speak_of_the_same_colours(self) -> None:
        output = self.folder / "comparison"
        result = self.folder / "out" / "surface.stl"
        job = CompareJob(str(result), str(SAMPLE_SOLID), str(output), points=500)
        ended, _ = run(job.arguments())
        self.assertIs(ended.state, RunState.DONE, ended.log)
        loaded = load_comparison(output, self.folder)
        self.assertGreater(loaded.report.floor["chamfer"], 0.0)
        vertices = read_vertices(output / "deviation.ply")
        rows = vertices.columns("red", "green", "blue", "deviation")
        for red, green, blue, deviation in rows[:: max(1, len(rows) // 500)]:
            expected = colour_at(deviation / loaded.scale.limit)
            for channel, wanted in zip((red, green, blue), expected, strict=True):
                self.assertAlmostEqual(channel, wanted, delta=1)
        surface = next(o for o in self.group.Group if o.TypeId == "Mesh::Feature")
        request = CompareRequest(Source(surface), Source(find_part(self.group)))
        group = add_comparison(self.document, loaded, request)
        self.assertEqual(group.Chamfer, loaded.report.distances["chamfer"])
        deviation = group.Group[0]
        self.assertEqual(len(deviation.VertexColors), deviation.Mesh.CountPoints)
        self.assertGreater(loaded.report.engineering["agreement"], 0.0)
        self.assertGreater(len(loaded.report.worst), 5)
        self.assertEqual(len(loaded.report.histogram.shares), 40)
        self.assertIn(b"<h1>surface.stl against", Path(group.Page).read_bytes())


@unittest.skipIf(engine() is None, "the engine is not installed")
class Check(FolderCase):
    """The sample's solid against the sample sheet, turned and moved in its document."""

    def check(self, shape: Part.Shape) -> tuple[RunResult, SheetCheck]:
        document = FreeCAD.newDocument("Check")
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        part = document.addObject("Part::Feature", "Part")
        part.Shape = shape
        turn = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90)
        self.place = FreeCAD.Placement(FreeCAD.Vector(7, -3, 100), turn)
        part.Placement = self.place
        model = Source(part).file(self.folder)
        output = self.folder / "check"
        length = Scale(ScaleKind.LENGTH_X, 80.0)
        result, _ = run(CheckJob(str(SAMPLE), str(model), str(output), scale=length).arguments())
        self.assertTrue((output / CHECK_PICTURE).is_file())
        return result, read_check(output / CHECK_FILE)

    def test_the_part_of_a_sheet_agrees_with_it(self) -> None:
        result, check = self.check(Part.read(str(SAMPLE_SOLID)))
        self.assertEqual((result.state, check.verdict), (RunState.DONE, CheckVerdict.AGREES))

    def test_a_hole_that_is_not_drawn_is_found_where_the_document_has_it(self) -> None:
        centre = FreeCAD.Vector(30, 10, 0)
        hole = Part.makeCylinder(4.0, 200.0, centre - FreeCAD.Vector(0, 0, 50))
        result, check = self.check(Part.read(str(SAMPLE_SOLID)).cut(hole))
        self.assertEqual((result.exit_code, result.code), (4, ""))
        self.assertIs(check.verdict, CheckVerdict.DIFFERS)
        rims = [
            each
            for each in check.differences
            if each.view == "top" and each.kind is DifferenceKind.EXTRA and not each.is_hidden
        ]
        self.assertTrue(rims)
        there = self.place.multVec(centre)
        for x, y, z in (end for rim in rims for piece in rim.pieces for end in piece):
            self.assertAlmostEqual(math.hypot(x - there.x, y - there.y), 4.0, delta=0.3)
            # On top of all, though the hole is drilled in the foot.
            self.assertAlmostEqual(z, 160.0, delta=0.3)
        edit = check.edits[0]
        self.assertEqual(edit.what, "fill")
        self.assertAlmostEqual(edit.diameter, 8.0, delta=0.1)
        self.assertAlmostEqual(edit.start[0], there.x, delta=0.3)
        self.assertAlmostEqual(edit.start[1], there.y, delta=0.3)
        # The drawing's x runs along the document's y.
        for found, expected in zip(check.axes[0], (0.0, 1.0, 0.0), strict=True):
            self.assertAlmostEqual(found, expected)


@unittest.skipIf(engine() is None, "the engine is not installed")
class Trouble(FolderCase):
    def test_a_cancelled_run_leaves_no_file(self) -> None:
        output = self.folder / "out"
        job = ReconstructJob(str(SAMPLE), str(output), preset=Preset.DRAFT)
        result, _ = run(job.arguments(), stop_in="lines")
        self.assertIs(result.state, RunState.CANCELLED)
        self.assertEqual(list(output.glob("**/*")) if output.exists() else [], [])

    def test_a_batch_makes_documents_and_keeps_them(self) -> None:
        sheets = self.folder / "sheets"
        sheets.mkdir()
        (sheets / "Blech 图.png").write_bytes(SAMPLE.read_bytes())
        (sheets / "text.png").write_text("this is no picture")
        arguments = [str(sheets), "--output", str(self.folder / "out")]
        arguments += ["--result", "solid", "--length", "x=80"]
        for number in (signal.SIGINT, signal.SIGTERM):
            self.addCleanup(signal.signal, number, signal.getsignal(number))
        self.assertEqual(main(arguments), 1)
        with open(self.folder / "out" / "report.csv", encoding="utf-8", newline="") as file:
            rows = {row["name"]: row for row in csv.DictReader(file)}
        self.assertEqual((rows["text"]["exit_code"], rows["text"]["code"]), ("3", "not-an-image"))
        self.assertEqual(rows["Blech 图"]["status"], "verified")
        path = self.folder / "out" / "Blech 图.FCStd"
        before = path.stat()
        self.assertEqual(main([*arguments, "--resume"]), 1)
        self.assertEqual(path.stat().st_ino, before.st_ino)
        document = FreeCAD.openDocument(str(path))
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        self.assertAlmostEqual(document.getObject("Part").Shape.BoundBox.XLength, 80.0, places=6)
        settings = texts_of(document.getObject("Reconstruction"), "Settings")
        self.assertEqual((settings["scale"], settings["result"]), ("x = 80", "solid"))

    def test_the_doctor_answers(self) -> None:
        result, _ = run(["doctor"])
        self.assertIs(result.state, RunState.DONE, result.log)
        self.assertIn("torch", result.output)
