"""The choice among solids that all have the drawing's lines."""

import fake_part
import FreeCAD
from run_cases import RunCase
from support import draw_sheet

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.reconstruction import add_reconstruction
from freecad.gaussiancad.objects.reconstruction_features import find_part
from freecad.gaussiancad.objects.solutions import SolutionSet, group_with_choice, has_choice

VOLUMES = (fake_part.VOLUME, *fake_part.ALTERNATIVE_VOLUMES)


class Solutions(RunCase):
    def setUp(self) -> None:
        super().setUp()
        self.group = self.reconstruct("several")
        self.document.UndoMode = 1
        self.solutions = SolutionSet(self.group)

    def reconstruct(self, behaviour: str) -> FreeCAD.DocumentObject:
        self.behave(behaviour)
        sheet = draw_sheet(self.folder / "bracket.png")
        job = ReconstructJob(str(sheet), str(self.folder / behaviour))
        return add_reconstruction(self.document, self.loaded(job))

    def shown(self) -> list[bool]:
        features = map(self.solutions.feature, range(len(self.solutions)))
        return [bool(feature.Visibility) for feature in features]

    def volumes(self) -> list[float]:
        """Of everything that may be the part."""
        return [round(o.Shape.Volume, 6) for o in self.group.Group if o.TypeId == "Part::Feature"]

    def test_they_come_in_the_engines_order_with_what_it_knows_of_them(self) -> None:
        features = [self.solutions.feature(place) for place in range(len(self.solutions))]
        for feature, volume in zip(features, VOLUMES, strict=True):
            self.assertAlmostEqual(feature.Shape.Volume, volume, places=6)
        self.assertEqual([f.Agreement for f in features], [0.9984, 0.9971, 0.9902])
        self.assertEqual([f.Projection for f in features[1:]], ["third", "first"])

    def test_only_a_reconstruction_with_several_solids_has_a_choice(self) -> None:
        self.assertTrue(has_choice(self.group))
        self.assertIs(group_with_choice(self.document), self.group)
        self.assertFalse(any(has_choice(child) for child in self.group.Group))
        for behaviour in ("ok", "surface"):
            self.assertFalse(has_choice(self.reconstruct(behaviour)))
        self.assertEqual(group_with_choice(self.document).Name, self.group.Name)
        self.assertIsNone(group_with_choice(None))

    def test_one_is_shown_at_a_time_and_looking_leaves_no_trace(self) -> None:
        self.assertEqual(self.shown(), [True, False, False])
        for place in (2, 0, 1):
            self.solutions.show(place)
            self.assertEqual(self.shown(), [place == other for other in range(3)])
        self.solutions.restore()
        self.assertEqual(self.shown(), [True, False, False])
        self.assertEqual(self.document.UndoCount, 0)

    def test_differences_are_told_by_volume_and_place(self) -> None:
        without, block = self.solutions.difference(1), self.solutions.difference(2)
        self.assertEqual((without.more.volume, without.more.shape), (0.0, None))
        self.assertAlmostEqual(without.less.volume, 1000.0, places=6)
        box = without.less.shape.BoundBox
        self.assertLess((box.Center - FreeCAD.Vector(2.5, 20.0, 25.0)).Length, 1e-6)
        self.assertLess(abs(box.XLength - 5) + abs(box.YLength - 20) + abs(box.ZLength - 10), 1e-6)
        self.assertAlmostEqual(block.more.volume, 500.0, places=6)
        self.assertEqual((block.less.volume, block.less.shape), (0.0, None))
        same = self.solutions.difference(0)
        self.assertEqual((same.more.volume, same.less.volume), (0.0, 0.0))

    def test_what_is_kept_becomes_the_part_in_one_undo_step(self) -> None:
        for place in range(3):
            self.solutions = SolutionSet(self.group)
            self.solutions.show(place)
            self.solutions.keep(place)
            self.assertEqual(self.volumes(), [round(VOLUMES[place], 6)])
            part = find_part(self.group)
            self.assertEqual((part.Name, bool(part.Visibility)), ("Part", True))
            self.assertEqual(self.group.Choice, f"{place + 1} / 3")
            self.assertFalse(has_choice(self.group))
            self.assertEqual(self.document.UndoNames, ["Keep Solution"])
            self.document.undo()
            self.assertEqual(self.volumes(), [round(volume, 6) for volume in VOLUMES])
            self.assertEqual(self.shown(), [True, False, False])
            self.assertFalse(hasattr(self.group, "Choice"))
        self.document.redo()
        self.assertEqual(self.volumes(), [round(VOLUMES[2], 6)])

    def test_what_was_built_on_the_part_follows(self) -> None:
        cut = self.document.addObject("Part::Cut", "Cut")
        tool = self.document.addObject("Part::Box", "Tool")
        tool.Length, tool.Width, tool.Height = 60.0, 40.0, 5.0
        cut.Base, cut.Tool = find_part(self.group), tool
        self.document.recompute()
        self.solutions.keep(2)
        self.assertAlmostEqual(cut.Shape.Volume, VOLUMES[2] - 60.0 * 40.0 * 5.0, places=6)

    def test_an_alternative_that_is_used_elsewhere_stays(self) -> None:
        used = self.solutions.feature(1)
        mirror = self.document.addObject("Part::Mirroring", "Mirror")
        mirror.Source = used
        self.document.recompute()
        self.solutions.keep(2)
        self.assertEqual(self.volumes(), [round(VOLUMES[2], 6), round(VOLUMES[1], 6)])
        self.assertFalse(used.Visibility)
        # It is kept for what uses it, not to choose among it again.
        self.assertFalse(has_choice(self.group))
        self.assertAlmostEqual(mirror.Shape.Volume, VOLUMES[1], places=6)

    def test_solutions_that_are_gone_cannot_be_kept(self) -> None:
        self.document.removeObject(self.solutions.feature(2).Name)
        self.assertFalse(self.solutions.alive)
        before = self.volumes()
        with self.assertRaises(WorkbenchError) as caught:
            self.solutions.keep(1)
        self.assertIs(caught.exception.code, ErrorCode.SOLUTIONS_GONE)
        self.assertEqual(self.volumes(), before)
        self.close_all()
        self.assertFalse(self.solutions.alive)
        self.solutions.restore()

    def test_the_choice_is_kept_in_the_file(self) -> None:
        self.solutions.keep(1)
        path = self.folder / "kept.FCStd"
        self.document.saveAs(str(path))
        self.close_all()
        group = FreeCAD.openDocument(str(path)).getObject("Reconstruction")
        self.assertEqual((group.Choice, has_choice(group)), ("2 / 3", False))
        self.assertAlmostEqual(find_part(group).Shape.Volume, VOLUMES[1], places=6)
