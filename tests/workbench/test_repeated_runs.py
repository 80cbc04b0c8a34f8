"""A second run of a drawing: the objects of the first one change in place, in one undo step."""

import shutil
from pathlib import Path

import fake_part
import FreeCAD
import Part
from run_cases import RunCase
from support import draw_sheet

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.protocol import ResultKind, Status
from freecad.gaussiancad.objects.early_part import complete, leave, show_early
from freecad.gaussiancad.objects.known_sheets import group_of, reconstruction_among, sheet_of
from freecad.gaussiancad.objects.loading import LoadedRun
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.objects.reconstruction import put_reconstruction
from freecad.gaussiancad.objects.reconstruction_features import find_part

STEP = "Reconstruct from Drawing"


class Repeated(RunCase):
    def setUp(self) -> None:
        super().setUp()
        self.sheet = draw_sheet(self.folder / "bracket.png")
        self.document.UndoMode = 1
        self.group = put_reconstruction(self.document, self.finished("ok"))
        self.names = self.all_names()

    def all_names(self) -> list[str]:
        return sorted(found.Name for found in self.document.Objects)

    def finished(self, behaviour: str, sheet: Path | None = None, page: int = 1) -> LoadedRun:
        self.behave(behaviour)
        outcome = ResultKind.SURFACE if behaviour == "surface" else ResultKind.BOTH
        folder = str(self.folder / behaviour)
        shutil.rmtree(folder, ignore_errors=True)
        job = ReconstructJob(str(sheet or self.sheet), folder, outcome=outcome, page=page)
        return self.loaded(job)

    def built_on_the_part(self) -> FreeCAD.DocumentObject:
        """A body of the user's that follows the part."""
        mirror = self.document.addObject("Part::Mirroring", "Mirror")
        mirror.Source = find_part(self.group)
        mirror.Normal = FreeCAD.Vector(1, 0, 0)
        self.document.recompute()
        return mirror

    def test_the_same_objects_have_the_new_result_in_one_step(self) -> None:
        mirror = self.built_on_the_part()
        part = find_part(self.group)
        part.Shape = Part.makeBox(1, 2, 3)
        before = self.document.UndoCount
        group = put_reconstruction(self.document, self.finished("contradicts"))
        self.assertIs(group, self.group)
        self.assertEqual(self.document.UndoCount, before + 1)
        self.assertEqual(self.document.UndoNames[0], STEP)
        self.assertEqual(self.all_names(), sorted([*self.names, "Mirror"]))
        self.assertEqual((part.Label, group.Status), ("Part (approximate)", "approximate"))
        self.assertAlmostEqual(part.Shape.Volume, fake_part.VOLUME, places=6)
        self.assertAlmostEqual(mirror.Shape.Volume, fake_part.VOLUME, places=6)
        self.document.undo()
        self.assertEqual((part.Label, group.Status), ("Part", "verified"))
        self.assertEqual(len(group.Group), 6)

    def test_a_part_stays_where_it_was_put_and_keeps_its_name(self) -> None:
        part = find_part(self.group)
        part.Placement.Base = FreeCAD.Vector(5, 6, 7)
        part.Label = "Bracket"
        put_reconstruction(self.document, self.finished("contradicts"))
        self.assertEqual((part.Label, part.Placement.Base), ("Bracket", FreeCAD.Vector(5, 6, 7)))

    def test_what_the_second_run_lacks_goes_unless_it_is_used(self) -> None:
        put_reconstruction(self.document, self.finished("several"))
        alternatives = [n for n in self.all_names() if n.startswith("Alternative")]
        self.assertEqual(len(alternatives), 2)
        user = self.document.addObject("Part::Mirroring", "Mirror")
        user.Source = self.document.getObject(alternatives[1])
        put_reconstruction(self.document, self.finished("ok"))
        left = [n for n in self.all_names() if n.startswith("Alternative")]
        self.assertEqual(left, [alternatives[1]])
        self.assertFalse(self.document.getObject(left[0]).Visibility)

    def test_another_drawing_or_page_is_another_group(self) -> None:
        other = draw_sheet(self.folder / "other.png")
        second = put_reconstruction(self.document, self.finished("ok", other))
        third = put_reconstruction(self.document, self.finished("ok", page=2))
        self.assertEqual(len({self.group.Name, second.Name, third.Name}), 3)
        self.assertIs(group_of(self.document, self.sheet, 2), third)

    def test_a_copy_of_the_drawing_elsewhere_is_the_same_drawing(self) -> None:
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        copy = Path(shutil.copy(self.sheet, elsewhere))
        self.assertIs(group_of(self.document, copy, 1), self.group)
        self.assertIsNone(group_of(self.document, copy, 2))
        self.assertIsNone(group_of(self.document, copy.rename(elsewhere / "other.png"), 1))
        changed = elsewhere / self.sheet.name
        changed.write_bytes(self.sheet.read_bytes() + b"\0")
        self.assertIsNone(group_of(self.document, changed, 1))

    def test_the_documents_copy_serves_where_the_drawing_is_gone(self) -> None:
        path = str(self.sheet)
        self.sheet.unlink()
        copy = sheet_of(self.group)
        content = copy.read_bytes()
        group = put_reconstruction(self.document, self.finished("ok", copy))
        self.assertIs(group, self.group)
        self.assertEqual((group.SheetPath, Path(group.Sheet)), (path, copy))
        self.assertEqual(copy.read_bytes(), content)
        self.assertEqual(texts_of(group, "Settings")["page"], "1")

    def test_an_early_part_takes_the_place_of_the_earlier_one(self) -> None:
        part = find_part(self.group)
        job = ReconstructJob(str(self.sheet), str(self.folder / "again"))
        early = show_early(self.document, job, Path(fake_part.STEP_FILE), Status.APPROXIMATE)
        self.assertEqual(early.group, self.group.Name)
        self.assertEqual(self.group.Group, [part])
        self.assertEqual((self.group.ReportJson, self.group.Status), ("", "approximate"))
        self.assertEqual(self.document.UndoNames, [STEP, STEP])
        group = complete(early, self.document, self.finished("ok"))
        self.assertIs(group, self.group)
        self.assertEqual(self.document.UndoNames, [STEP, STEP])
        self.assertEqual(self.all_names(), self.names)
        self.assertTrue(group.ReportJson)

    def test_a_cancelled_run_can_be_undone_to_the_result_of_before(self) -> None:
        job = ReconstructJob(str(self.sheet), str(self.folder / "again"))
        early = show_early(self.document, job, Path(fake_part.STEP_FILE), Status.VERIFIED)
        self.assertTrue(leave(early, "The run was cancelled."))
        self.assertEqual(self.group.Reasons, ["The run was cancelled."])
        self.document.undo()
        self.assertEqual(self.all_names(), self.names)
        self.assertTrue(self.group.ReportJson)
        self.assertEqual(len(self.group.Group), 6)

    def test_the_reconstruction_is_found_from_its_part(self) -> None:
        part = find_part(self.group)
        box = self.document.addObject("Part::Box", "Box")
        self.assertIs(reconstruction_among([box, part]), self.group)
        self.assertIs(reconstruction_among([self.group]), self.group)
        self.assertIsNone(reconstruction_among([box]))
