"""Numbers of a body that are changed on a copy: which break it, and that the body stays."""

from typing import Any

import FreeCAD
import Part
from body_cases import DATA, XY, BodyCase, bracket, cylinder, hole, lines, number, pad

from freecad.gaussiancad.objects.bodies import MadeBody, add_bodies, note_trials, try_numbers
from freecad.gaussiancad.objects.body_check import check_body
from freecad.gaussiancad.objects.body_numbers import set_value, value_of
from freecad.gaussiancad.objects.feature_file import read_features
from freecad.gaussiancad.objects.number_trials import NumberTrials, TrialOutcome


def boxes_that_touch() -> tuple[Part.Shape, list[dict[str, Any]]]:
    """Two pads side by side: a length of the first one leaves a gap, or goes into the other."""
    exact = Part.makeBox(40, 30, 20).fuse(Part.makeBox(10, 30, 20, FreeCAD.Vector(0, 0, 20)))
    first = pad(XY, lines((0, 0), (40, 0), (40, 30), (0, 30)), 20.0, sources={"length": "sheet"})
    second = pad(
        {**XY, "offset": 20.0}, lines((0, 0), (10, 0), (10, 30), (0, 30)), 20.0, name="Pad2"
    )
    return exact.removeSplitter(), [first, {**second, "sources": {"length": "measured"}}]


class Trials(BodyCase):
    def bracket(self) -> MadeBody:
        (made,) = add_bodies(self.part(bracket()), read_features(DATA / "bracket.json"))
        return made

    def test_all_numbers_of_a_bracket_can_be_changed(self) -> None:
        made = self.bracket()
        self.assertEqual((made.body.NumbersThatBreak, made.body.NumbersNotTried), ([], 5))
        documents, steps = set(FreeCAD.listDocuments()), self.document.UndoCount
        tried = try_numbers(made)
        self.assertEqual(tried.trials, TrialOutcome(5, (), 0))
        self.assertEqual((made.body.NumbersThatBreak, made.body.NumbersNotTried), ([], 0))
        self.assertEqual(set(FreeCAD.listDocuments()), documents)
        self.assertIs(FreeCAD.ActiveDocument, self.document)
        self.assertEqual(self.document.UndoCount, steps)
        self.assertEqual(made.body.State, ["Up-to-date"])
        self.assert_is(made, bracket())

    def test_numbers_that_break_the_body_are_named(self) -> None:
        exact, features = boxes_that_touch()
        made = try_numbers(self.made(exact, *features))
        # A lower first box leaves the second one in the air; a higher one holds it still.
        self.assertEqual(made.breaking, ())
        with NumberTrials(made.body, made.numbers) as trials:
            trials._factor = 0.97
            outcome = trials.run()
        self.assertEqual([each.path for each in outcome.breaking], ["Pad1.Length"])
        noted = note_trials(made, outcome)
        self.assertEqual(noted.breaking, ("Pad1.Length = 20 mm",))
        self.assertEqual(made.body.NumbersThatBreak, ["Pad1.Length = 20 mm"])
        self.assert_is(made, exact)

    def test_what_is_not_tried_in_time_is_counted(self) -> None:
        made = self.bracket()
        with NumberTrials(made.body, made.numbers, most_seconds=0.0) as trials:
            self.assertEqual(trials.fraction, 0.0)
            outcome = trials.run()
        self.assertEqual((outcome.tried, outcome.untried), (1, 4))
        self.assertEqual(note_trials(made, outcome).body.NumbersNotTried, 4)

    def test_the_numbers_of_a_second_body_are_its_own(self) -> None:
        self.bracket()
        exact, features = boxes_that_touch()
        made = try_numbers(self.made(exact, *features))
        self.assertEqual(made.trials.tried, 2)
        first = made.numbers[0]
        self.assertNotEqual(first.feature, "Pad1")
        self.assertEqual(value_of(self.document.getObject(first.feature), "Length"), 20.0)

    def test_one_undo_step_takes_back_what_was_noted_too(self) -> None:
        self.document.UndoMode = 1
        made = self.bracket()
        note_trials(made, TrialOutcome(5, made.numbers[:1], 2))
        self.assertEqual(self.document.UndoNames, ["To Body"])
        self.document.undo()
        self.document.redo()
        body = self.document.getObject("Body")
        self.assertEqual((len(body.NumbersThatBreak), body.NumbersNotTried), (1, 2))
        self.assertEqual(check_body(body.Shape, bracket()).words, "")


class Values(BodyCase):
    def test_a_number_is_read_and_set_where_it_is(self) -> None:
        exact = Part.makeBox(40, 30, 20).cut(cylinder(3, 20, (10, 10, 0)))
        sides = lines((0, 0), (40, 0), (40, 30), (0, 30))
        diameter = number("diameter", [[0, None]], 6.0, "Diameter")
        drilled = hole({**XY, "offset": 20.0}, (10, 10), constraints=[diameter])
        made = self.made(exact, pad(XY, sides, 20.0, sources={"length": "sheet"}), drilled)
        self.assertEqual([each.path for each in made.numbers], ["Pad1.Length", "Hole1.Diameter"])
        for each, value in zip(made.numbers, (25.0, 8.0), strict=True):
            # The hole stays where it begins, 20 mm above the origin.
            feature = self.document.getObject(each.feature)
            self.assertEqual(value_of(feature, each.name), each.value)
            set_value(feature, each.name, value)
            self.document.recompute()
            self.assertEqual(value_of(feature, each.name), value)
        self.assertEqual(made.body.SheetValues, [20.0, 6.0])
        self.assertAlmostEqual(
            made.body.Shape.Volume, 40 * 30 * 25 - cylinder(4, 20, (0, 0, 0)).Volume, places=4
        )
        self.assertIsNone(value_of(feature, "Nothing"))
        with self.assertRaises(ValueError):
            set_value(feature, "Nothing", 1.0)
