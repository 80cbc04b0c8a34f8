"""The part of a run that goes on: there at once, one undo step with the rest, never taken away."""

import shutil

import fake_part
import FreeCAD
from run_cases import RunCase
from support import draw_sheet

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.objects.early_part import EarlyPart, complete, leave, show_early
from freecad.gaussiancad.objects.loading import LoadedRun
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.objects.reconstruction_features import find_part

STEP = "Reconstruct from Drawing"


class EarlyParts(RunCase):
    def setUp(self) -> None:
        super().setUp()
        self.job = ReconstructJob(
            str(draw_sheet(self.folder / "bracket.png")), str(self.folder / "out")
        )
        self.document.UndoMode = 1

    def show(self, status: Status = Status.VERIFIED) -> EarlyPart:
        path = self.folder / "solid.step"
        shutil.copy(fake_part.STEP_FILE, path)
        early = show_early(self.document, self.job, path, status)
        # The document holds the part, not the file.
        path.unlink()
        return early

    def finished(self, behaviour: str = "ok") -> LoadedRun:
        self.behave(behaviour)
        return self.loaded(self.job)

    def test_the_part_is_there_at_once(self) -> None:
        group = self.show(Status.APPROXIMATE).find()
        part = find_part(group)
        self.assertEqual(group.Group, [part])
        self.assertAlmostEqual(part.Shape.Volume, fake_part.VOLUME, places=6)
        self.assertEqual((part.Label, part.Exact), ("Part (approximate)", True))
        self.assertEqual((part.Status, group.Status), ("approximate", "approximate"))
        self.assertEqual(group.Label, "Reconstruction of bracket")
        self.assertEqual(texts_of(group, "Settings")["preset"], "standard")
        self.assertEqual(self.document.UndoNames, [STEP])

    def test_what_the_user_did_between_is_left_alone(self) -> None:
        early = self.show()
        part = find_part(early.find())
        self.document.openTransaction("Mine")
        mine = self.document.addObject("Part::Feature", "Mine")
        mine.Shape = part.Shape
        self.document.commitTransaction()
        group = complete(early, self.document, self.finished("contradicts"))
        self.assertEqual(self.document.UndoNames, [STEP, "Mine", STEP])
        self.assertEqual(find_part(group).Name, part.Name)
        self.assertEqual(part.Label, "Part (approximate)")
        kinds = sorted(child.TypeId for child in group.Group)
        expected = ["Image::ImagePlane"] * 3
        expected += ["Mesh::Feature", "Part::Feature", "Points::Feature"]
        self.assertEqual(kinds, expected)
        self.assertTrue(group.ReportJson)
        self.document.undo()
        names = {child.Name for child in self.document.Objects}
        self.assertEqual(names, {"Reconstruction", "Part", "Mine"})

    def test_what_was_undone_comes_whole(self) -> None:
        early = self.show()
        self.document.undo()
        group = complete(early, self.document, self.finished())
        self.assertEqual(len(group.Group), 6)
        self.assertEqual(self.document.UndoNames, [STEP])

    def test_without_undo_steps_the_part_is_kept_and_completed(self) -> None:
        self.document.UndoMode = 0
        early = self.show()
        group = complete(early, self.document, self.finished())
        self.assertEqual((len(group.Group), len(self.document.Objects)), (6, 7))
        self.assertEqual([child.Name for child in group.Group].count("Part"), 1)

    def test_where_the_document_is_gone_all_goes_to_the_other_one(self) -> None:
        early = self.show()
        FreeCAD.closeDocument(self.document.Name)
        self.assertFalse(leave(early, "x"))
        other = FreeCAD.newDocument("Other")
        self.assertIs(complete(early, other, self.finished()).Document, other)

    def test_a_file_that_is_no_solid_leaves_the_document_alone(self) -> None:
        path = self.folder / "solid.step"
        path.write_text("no solid")
        with self.assertRaises(WorkbenchError):
            show_early(self.document, self.job, path, Status.VERIFIED)
        self.assertEqual((self.document.Objects, self.document.UndoCount), ([], 0))
