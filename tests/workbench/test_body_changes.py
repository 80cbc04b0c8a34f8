"""Bodies of samples with other numbers, and what else a body can do whose offsets follow."""

from typing import Any

import FreeCAD
import Part
from body_cases import DATA, XY, ChangedCase, cylinder, hole, lines, pad, prism
from FreeCAD import Vector

from freecad.gaussiancad.objects.bodies import MadeBody, add_bodies, try_numbers
from freecad.gaussiancad.objects.body_check import check_body
from freecad.gaussiancad.objects.feature_file import read_features
from freecad.gaussiancad.objects.sheet_numbers import changed_numbers, set_back


class OfSamples(ChangedCase):
    """As the engine writes them."""

    def sample(self, name: str, exact: Part.Shape) -> MadeBody:
        (made,) = add_bodies(self.part(exact), read_features(DATA / f"{name}.json"))
        self.assert_is(made, exact)
        return made

    def counterbored(self, height: float) -> Part.Shape:
        made = Part.makeBox(80, 44, height)
        for x in (20, 60):
            made = made.cut(cylinder(6, height, (x, 22, 0)))
            made = made.cut(cylinder(11, 10, (x, 22, height - 10)))
        return made

    def test_counterbores_stay_at_the_top_of_a_higher_block(self) -> None:
        made = self.sample("counterbored-block", self.counterbored(28))
        for height in (33.6, 22.4):
            self.change("Pad1", "Length", height)
            self.assertEqual(check_body(made.body.Shape, self.counterbored(height)).words, "")

    def stair(self, length: float, top: float) -> Part.Shape:
        profile = [(0, 0), (90, 0), (90, 15), (60, 15), (60, 32), (30, 32), (30, top), (0, top)]
        stair = prism([(x, 0, z) for x, z in profile], (0, length, 0))
        return stair.cut(Part.makeBox(30, 16, 15, Vector(60, 12, 0)))

    def test_a_notch_that_goes_on_past_a_step(self) -> None:
        made = self.sample("stepped-block", self.stair(40, 50))
        self.assertNotIn("Pocket1.Length", " ".join(made.measured))
        self.change("Pad1", "Length", 48.0)
        self.change("Pad1", "Height", 60.0)
        self.assertEqual(check_body(made.body.Shape, self.stair(48, 60)).words, "")

    def pulley(self, width: float) -> Part.Shape:
        flat = [
            *((0, 0), (0, 16), (6, 16), (6, 38), (12, 38), (18, 28), (24, 28), (30, 38)),
            *((36, 38), (36, 16), (width, 16), (width, 0)),
        ]
        points = [Vector(38 + radius, along, 38) for along, radius in (*flat, flat[0])]
        face = Part.Face(Part.makePolygon(points))
        turned = face.revolve(Vector(38, 0, 38), Vector(0, 1, 0), 360)
        return turned.cut(cylinder(8, width, (38, 0, 38), (0, 1, 0)))

    def test_the_bore_of_a_wider_pulley_is_still_through(self) -> None:
        made = self.sample("pulley", self.pulley(42))
        self.change("Revolution1", "Width", 50.4)
        self.assertEqual(check_body(made.body.Shape, self.pulley(50.4)).words, "")


class Around(ChangedCase):
    """What else a body can do, with expressions."""

    def features(self) -> tuple[Part.Shape, list[dict[str, Any]]]:
        exact = Part.makeBox(40, 30, 20).cut(cylinder(3, 8, (10, 10, 12)))
        drilled = hole(
            {**XY, "offset": 20.0},
            (10, 10),
            depth=8.0,
            stands_on={"feature": "Pad1", "side": "end"},
            sources={"depth": "sheet"},
        )
        sides = pad(
            XY, lines((0, 0), (40, 0), (40, 30), (0, 30)), 20.0, sources={"length": "measured"}
        )
        return exact, [sides, drilled]

    def test_one_undo_step_and_what_is_done_again_still_follows(self) -> None:
        exact, features = self.features()
        part = self.part(exact)
        self.document.UndoMode = 1
        add_bodies(part, read_features(self.written(features)))
        self.assertEqual(self.document.UndoNames, ["To Body"])
        self.document.undo()
        self.assertEqual([each.Name for each in self.document.Objects], ["Part"])
        self.assertTrue(part.Visibility)
        self.document.redo()
        self.document.recompute()
        self.change("Pad1", "Length", 24.0)
        self.assertAlmostEqual(self.offset("Hole1Sketch"), 24.0, places=9)

    def test_a_document_that_is_opened_again_still_follows(self) -> None:
        exact, features = self.features()
        self.made(exact, *features)
        path = str(self.folder / "kept.FCStd")
        self.document.saveAs(path)
        self.close()
        self.document = FreeCAD.openDocument(path)
        self.change("Pad1", "Length", 24.0)
        self.assertAlmostEqual(self.offset("Hole1Sketch"), 24.0, places=9)

    def test_the_sheets_numbers_come_back_with_what_follows_them(self) -> None:
        exact, (sides, drilled) = self.features()
        made = self.made(exact, {**sides, "sources": {"length": "sheet"}}, drilled)
        self.change("Pad1", "Length", 24.0)
        self.assertEqual([each.path for each in changed_numbers(made.body)], ["Pad1.Length"])
        self.assertEqual(set_back([made.body]), 1)
        self.assertAlmostEqual(self.offset("Hole1Sketch"), 20.0, places=9)
        self.assert_is(made, exact)

    def test_numbers_are_tried_on_a_copy_that_follows_too(self) -> None:
        exact, features = self.features()
        tried = try_numbers(self.made(exact, *features))
        self.assertEqual((tried.trials.tried, tried.breaking), (2, ()))
        self.assertEqual(tried.body.State, ["Up-to-date"])
        self.assert_is(tried, exact)
