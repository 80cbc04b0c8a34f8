"""Results in documents: made in one step, kept without the engine and without the addon."""

import os
import subprocess
import sys
from pathlib import Path

import fake_part
import FreeCAD
from run_cases import RunCase
from support import draw_sheet

from freecad.gaussiancad.engine.job import ReconstructJob, Scale, ScaleKind
from freecad.gaussiancad.engine.sentences import SENTENCES
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.objects.loading import LoadedRun, PartSource, load_run
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.objects.reconstruction import add_reconstruction
from freecad.gaussiancad.objects.reconstruction_features import find_part

STRANGER = """
import os, sys
import FreeCAD
document = FreeCAD.openDocument(os.environ["GAUSSIANCAD_DOCUMENT"])
part = next(o for o in document.Objects if o.TypeId == "Part::Feature")
surface = next(o for o in document.Objects if o.TypeId == "Mesh::Feature")
points = next(o for o in document.Objects if o.TypeId == "Points::Feature")
planes = [o for o in document.Objects if o.TypeId == "Image::ImagePlane"]
group = document.getObject("Reconstruction")
words = (
    round(part.Shape.Volume, 6), surface.Mesh.CountFacets, points.Points.CountPoints,
    len(planes), all(os.path.getsize(o.ImageFile) > 100 for o in planes),
    os.path.getsize(group.Sheet) > 100, group.Status, len(group.Group),
    "gaussiancad" in repr(sorted(sys.modules)),
)
with open(os.environ["GAUSSIANCAD_ANSWER"], "w") as file:
    file.write(repr(words))
sys.stdout.flush()
os._exit(0)
"""


class Documents(RunCase):
    def setUp(self) -> None:
        super().setUp()
        self.sheet = draw_sheet(self.folder / "bracket.png")

    def run_job(self, behaviour: str) -> LoadedRun:
        self.behave(behaviour)
        scale = Scale(ScaleKind.LENGTH_X, 60.0)
        job = ReconstructJob(str(self.sheet), str(self.folder / behaviour), scale=scale)
        return self.loaded(job)

    def test_everything_is_there_in_one_undo_step(self) -> None:
        self.document.UndoMode = 1
        group = add_reconstruction(self.document, self.run_job("ok"))
        self.assertEqual(self.document.UndoCount, 1)
        self.assertEqual(group.Label, "Reconstruction of bracket")
        kinds = sorted(child.TypeId for child in group.Group)
        expected = ["Image::ImagePlane"] * 3
        expected += ["Mesh::Feature", "Part::Feature", "Points::Feature"]
        self.assertEqual(kinds, expected)
        part = find_part(group)
        self.assertAlmostEqual(part.Shape.Volume, fake_part.VOLUME, places=6)
        self.assertTrue(part.Shape.isValid())
        self.assertEqual((part.Label, part.Exact, part.Status), ("Part", True, "verified"))
        surface = next(o for o in group.Group if o.TypeId == "Mesh::Feature")
        self.assertTrue(surface.Mesh.isSolid())
        self.assertAlmostEqual(surface.Mesh.Volume, fake_part.VOLUME, places=2)
        cloud = next(o for o in group.Group if o.TypeId == "Points::Feature")
        self.assertEqual((cloud.Points.CountPoints, len(cloud.Color)), (600, 600))
        self.assertEqual((part.Visibility, surface.Visibility, cloud.Visibility), (1, 0, 0))
        self.document.undo()
        self.assertEqual(self.document.Objects, [])
        self.document.redo()
        self.assertEqual(len(self.document.Objects), 7)

    def test_the_report_is_in_properties(self) -> None:
        run = self.run_job("ambiguous")
        group = add_reconstruction(self.document, run)
        self.assertEqual(group.Status, "approximate")
        self.assertEqual(group.Reasons, ["ambiguous: another solid fits the sheet"])
        self.assertEqual(group.Warnings, [f"scale-assumed: {SENTENCES['scale-assumed']}"])
        self.assertEqual(group.MillimetresPerPixel, 0.25)
        self.assertEqual(group.TotalSeconds, 3.75)
        self.assertEqual(texts_of(group, "Seconds")["solid"], "1.25")
        self.assertEqual(texts_of(group, "ViewAgreement")["front.hidden_recall"], "0.97")
        self.assertEqual(texts_of(group, "ViewBoxes")["top"], "100, 100, 340, 260")
        self.assertEqual(texts_of(group, "EngineVersions")["versions.torch"], "none")
        self.assertEqual(texts_of(group, "Settings")["scale"], "x = 60")
        self.assertEqual(group.ReportJson, run.report.text)
        self.assertEqual(group.Projection, "third (inferred)")
        self.assertEqual(group.SheetPath, str(self.sheet))
        self.assertEqual(Path(group.Sheet).read_bytes(), self.sheet.read_bytes())
        self.assertEqual(find_part(group).Label, "Part (approximate)")
        other = next(o for o in group.Group if o.Label == "Alternative 1")
        self.assertAlmostEqual(other.Shape.Volume, fake_part.VOLUME, places=6)
        self.assertFalse(other.Visibility)

    def test_without_an_exact_solid_the_part_says_so(self) -> None:
        run = self.run_job("surface")
        self.assertIs(run.part.source, PartSource.SURFACE)
        group = add_reconstruction(self.document, run)
        part = find_part(group)
        self.assertEqual((part.Label, part.Exact), ("Part (faceted, approximate)", False))
        surface = next(o for o in group.Group if o.TypeId == "Mesh::Feature")
        self.assertEqual((part.Visibility, surface.Visibility), (False, True))

    def test_a_solid_of_slabs_says_so(self) -> None:
        part = find_part(add_reconstruction(self.document, self.run_job("sketched")))
        self.assertEqual((part.Label, part.Exact), ("Part (slabs, approximate)", True))

    def test_the_views_stand_behind_the_part_at_true_scale(self) -> None:
        group = add_reconstruction(self.document, self.run_job("ok"))
        planes = {o.Label: o for o in group.Group if o.TypeId == "Image::ImagePlane"}
        self.assertEqual(sorted(planes), ["View front", "View right", "View top"])
        for role, box in fake_part.BOXES.items():
            plane = planes[f"View {role}"]
            margin = round(0.04 * max(box[2] - box[0], box[3] - box[1]))
            width = (box[2] - box[0] + 2 * margin) * fake_part.MM_PER_PIXEL
            self.assertAlmostEqual(plane.XSize.Value, width, places=6)
        front = planes["View front"].Placement
        self.assertLess((front.Base - FreeCAD.Vector(30, 49, 15)).Length, 1e-9)
        self.assertLess(
            (front.Rotation.multVec(FreeCAD.Vector(0, 1, 0)) - FreeCAD.Vector(0, 0, 1)).Length, 1e-9
        )
        right = planes["View right"].Placement
        self.assertLess((right.Base - FreeCAD.Vector(-9, 20, 15)).Length, 1e-9)
        self.assertLess(
            (right.Rotation.multVec(FreeCAD.Vector(1, 0, 0)) - FreeCAD.Vector(0, 1, 0)).Length, 1e-9
        )

    def test_a_document_opens_where_neither_engine_nor_addon_is(self) -> None:
        add_reconstruction(self.document, self.run_job("ok"))
        path = self.folder / "kept.FCStd"
        self.document.saveAs(str(path))
        self.close_all()
        script = self.folder / "stranger.py"
        script.write_text(STRANGER)
        answer = self.folder / "answer"
        profile = self.folder / "profile"
        profile.mkdir()
        variables = {
            **os.environ,
            "FREECAD_USER_HOME": str(profile),
            "GAUSSIANCAD_DOCUMENT": str(path),
            "GAUSSIANCAD_ANSWER": str(answer),
        }
        subprocess.run(
            [sys.executable, str(script)],
            env=variables,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            check=True,
            timeout=120,
        )
        expected = (fake_part.VOLUME, 20, 600, 3, True, True, "verified", 6, False)
        self.assertEqual(answer.read_text(), repr(expected))

    def test_the_addon_takes_a_saved_document_up_again(self) -> None:
        add_reconstruction(self.document, self.run_job("ok"))
        path = self.folder / "kept.FCStd"
        self.document.saveAs(str(path))
        self.close_all()
        document = FreeCAD.openDocument(str(path))
        group = document.getObject("Reconstruction")
        self.assertEqual(type(group.Proxy).__name__, "Reconstruction")
        self.assertEqual(group.State, ["Up-to-date"])
        document.recompute()
        self.assertAlmostEqual(find_part(group).Shape.Volume, fake_part.VOLUME, places=6)

    def test_a_result_that_cannot_be_read_leaves_the_document_alone(self) -> None:
        for behaviour in ("liar", "half", "refuse"):
            with self.assertRaises(WorkbenchError):
                self.run_job(behaviour)
        self.assertEqual(self.document.Objects, [])

    def test_an_error_on_the_way_in_is_undone(self) -> None:
        run = self.run_job("ok")
        Path(run.views[0].path).unlink()
        for undo_mode in (0, 1):
            self.document.UndoMode = undo_mode
            with self.assertRaises(Exception):  # noqa: B017 - FreeCAD's type differs
                add_reconstruction(self.document, run)
            self.assertEqual(self.document.Objects, [])
            self.assertEqual(self.document.UndoCount, 0)

    def test_a_sheet_that_qt_cannot_read_is_seen_through_the_overlay(self) -> None:
        self.run_job("ok")
        overlay = draw_sheet(self.folder / "ok" / "overlay.png")
        pdf = self.folder / "drawing.pdf"
        pdf.write_bytes(b"%PDF-1.4")
        scratch = self.folder / "scratch"
        scratch.mkdir()
        run = load_run(ReconstructJob(str(pdf), str(self.folder / "ok")), scratch)
        self.assertEqual([view.role for view in run.views], ["front", "top", "right"])
        group = add_reconstruction(self.document, run)
        self.assertEqual(Path(group.Overlay).read_bytes(), overlay.read_bytes())
