"""A model against its drawing: the job, the run, what it left, and the words for it."""

import json
import math

import fake_part
import FreeCAD
import Part
from run_cases import RunCase
from support import FolderCase, draw_sheet, run_fake

from freecad.gaussiancad.engine.check_file import (
    CheckDifference,
    CheckEdit,
    CheckVerdict,
    DifferenceKind,
    parse_check,
    read_check,
)
from freecad.gaussiancad.engine.check_job import CHECK_FILE, CHECK_PICTURE, CheckJob
from freecad.gaussiancad.engine.check_words import (
    difference_words,
    edit_words,
    verdict_words,
    view_words,
)
from freecad.gaussiancad.engine.job import Projection, Scale, ScaleKind
from freecad.gaussiancad.engine.process import RunResult
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.sources import Source


class Job(FolderCase):
    def test_the_least_that_is_asked(self) -> None:
        self.assertEqual(
            CheckJob("-a.png", "b.step", "out").arguments(),
            [
                "check",
                "--output",
                "out",
                "--page",
                "1",
                "--projection",
                "auto",
                "--events",
                "--",
                "-a.png",
                "b.step",
            ],
        )

    def test_what_is_known_of_the_drawing_is_told(self) -> None:
        job = CheckJob(
            "a.pdf",
            "b.stl",
            "out",
            page=2,
            projection=Projection.FIRST,
            scale=Scale(ScaleKind.MM_PER_PIXEL, 0.25),
            thickness=Scale(ScaleKind.LENGTH_Y, 12.5),
            corrections="c.json",
        )
        stated = " ".join(job.arguments())
        self.assertIn("--page 2 --projection first --mm-per-pixel 0.25 --length y=12.5", stated)
        self.assertIn("--corrections c.json --events -- a.pdf b.stl", stated)

    def test_a_length_is_told_once(self) -> None:
        length = Scale(ScaleKind.LENGTH_Y, 12.5)
        job = CheckJob("a.pdf", "b.stl", "out", scale=length, thickness=length)
        self.assertEqual(job.arguments().count("--length"), 1)


class Run(FolderCase):
    def run_check(self) -> RunResult:
        output = self.folder / "check"
        sheet = draw_sheet(self.folder / "bracket.png")
        job = CheckJob(str(sheet), str(fake_part.STEP_FILE), str(output))
        result, events, _ = run_fake(job.arguments())
        self.stages = [event.text("name") for event in events if event.text("name")]
        self.output = output
        return result

    def test_a_model_that_agrees(self) -> None:
        result = self.run_check()
        self.assertEqual((result.state, result.exit_code), (RunState.DONE, 0))
        self.assertEqual(self.stages[-2:], ["judge", "write"])
        check = read_check(self.output / CHECK_FILE)
        self.assertIs(check.verdict, CheckVerdict.AGREES)
        self.assertEqual((check.reasons, check.differences, check.edits), ((),) * 3)
        self.assertTrue((self.output / CHECK_PICTURE).is_file())

    def test_a_model_that_differs_is_no_error_and_tells_no_code(self) -> None:
        self.behave("differs")
        result = self.run_check()
        self.assertEqual((result.exit_code, result.code), (4, ""))
        check = read_check(self.output / CHECK_FILE)
        self.assertIs(check.verdict, CheckVerdict.DIFFERS)
        note, worst, *_ = check.differences
        self.assertEqual((note.kind, note.text), (DifferenceKind.NOTE, "2x Ø4"))
        lengths = [difference.length for difference in check.differences[1:]]
        self.assertEqual(len(lengths), 6)
        self.assertEqual(lengths, sorted(lengths, reverse=True))
        self.assertEqual((worst.view, worst.kind), ("top", DifferenceKind.MISSING))
        places = [end for piece in worst.pieces for end in piece]
        # A circle of 10 mm on top of the bracket's box.
        for x, y, z in places:
            self.assertAlmostEqual(math.hypot(x - 40.0, y - 15.0), 5.0, delta=0.1)
            self.assertAlmostEqual(z, 30.0, delta=0.01)
        self.assertEqual([edit.what for edit in check.edits], ["drill", "shift"])
        self.assertEqual(check.axes, ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))

    def test_a_model_of_which_nothing_can_be_told(self) -> None:
        self.behave("cannot-tell")
        result = self.run_check()
        self.assertEqual((result.exit_code, result.code), (5, ""))
        check = read_check(self.output / CHECK_FILE)
        self.assertIs(check.verdict, CheckVerdict.CANNOT_TELL)
        self.assertIn("fits the views in no position", check.reasons[0].words)
        self.assertIsNone(check.axes)

    def test_a_drawing_that_is_refused_leaves_nothing_and_has_a_code(self) -> None:
        self.behave("refuse")
        result = self.run_check()
        self.assertEqual((result.exit_code, result.code), (4, "empty-drawing"))
        self.assertFalse((self.output / CHECK_FILE).exists())


class File(FolderCase):
    def test_what_is_missing_reads_as_nothing(self) -> None:
        check = parse_check({"verdict": "differs", "differences": [{}], "edits": [{}, 3]})
        self.assertEqual(check.differences, (CheckDifference("", None, False, 0.0, ()),))
        self.assertEqual(check.edits, (CheckEdit("", "", 0.0, None, None, None),))
        self.assertEqual((check.reasons, check.axes), ((), None))

    def test_damaged_places_are_left_out(self) -> None:
        good = [[0, 0, 0], [1, 0, 0]]
        bad = [[[0, 0], [1, 0]], [[0, 0, 0]], "x", [[0, 0, None], [1, 0, 0]]]
        values = {"view": "top", "kind": "missing", "of": "hidden line", "model": [good, *bad]}
        (difference,) = parse_check({"verdict": "differs", "differences": [values]}).differences
        self.assertEqual(difference.pieces, (((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)),))
        self.assertTrue(difference.is_hidden)

    def test_the_axes_of_a_turned_model_are_as_long_as_one(self) -> None:
        matrix = [[0, 0.5, 0, 5], [-0.5, 0, 0, 40], [0, 0, 2, -10], [0, 0, 0, 1]]
        check = parse_check({"verdict": "agrees", "pose": {"matrix": matrix}})
        self.assertEqual(check.axes, ((0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0)))
        for damaged in (None, {}, {"matrix": [[0, 0, 0]] * 3}, {"matrix": [[1, 0], [0, 1]]}):
            self.assertIsNone(parse_check({"verdict": "agrees", "pose": damaged}).axes)

    def test_where_the_size_is_not_known_lengths_are_those_of_the_model(self) -> None:
        values = {
            "verdict": "differs",
            "pose": {"scale": 0.8, "scale_source": "given"},
            "reasons": [
                {
                    "code": "circle-missing",
                    "message": "no circle",
                    "args": {"view": "top", "diameter_mm": 10.0, "right": 40.0},
                }
            ],
            "differences": [{"length_mm": 20.0}],
            "edits": [{"what": "fill", "mm": 5.0, "diameter_mm": 10.0}],
        }
        check = parse_check(values)
        self.assertTrue(check.is_size_checked)
        self.assertEqual(check.reasons[0].args["diameter_mm"], 10.0)
        self.assertEqual((check.differences[0].length, check.edits[0].diameter), (20.0, 10.0))
        for source in ("default", "sheet"):
            values["pose"]["scale_source"] = source
            check = parse_check(values)
            self.assertFalse(check.is_size_checked)
            self.assertEqual(
                check.reasons[0].args, {"view": "top", "diameter_mm": 8.0, "right": 40.0}
            )
            self.assertIn("a circle of 8 mm", check.reasons[0].words)
            edit = check.edits[0]
            self.assertEqual(
                (check.differences[0].length, edit.length, edit.diameter), (16.0, 4.0, 8.0)
            )

    def test_of_a_model_that_fits_nowhere_nothing_is_said_of_the_size(self) -> None:
        self.assertTrue(parse_check({"verdict": "cannot-tell", "pose": None}).is_size_checked)

    def test_a_file_without_a_verdict_is_told(self) -> None:
        path = self.folder / CHECK_FILE
        for content in ("{}", "[1]", "{", json.dumps({"verdict": "perhaps"})):
            path.write_text(content)
            with self.assertRaises(WorkbenchError) as caught:
                read_check(path)
            self.assertIs(caught.exception.code, ErrorCode.RESULT_UNREADABLE)


class Words(FolderCase):
    def test_each_verdict_has_a_sentence(self) -> None:
        sentences = {verdict_words(verdict) for verdict in CheckVerdict}
        self.assertEqual(len(sentences), len(CheckVerdict))

    def test_each_difference_has_a_word_and_a_sentence(self) -> None:
        for kind in (*DifferenceKind, None):
            for is_hidden in (False, True):
                word, sentence = difference_words(CheckDifference("top", kind, is_hidden, 1.0, ()))
                self.assertTrue(word and sentence)
        hidden = CheckDifference("front A-A", DifferenceKind.EXTRA, True, 1.0, ())
        self.assertEqual(difference_words(hidden)[0], "Extra, hidden")
        self.assertEqual(view_words(hidden), "front A-A")

    def test_changes_are_told_in_the_coordinates_of_the_model(self) -> None:
        start, end = (1.0, 2.0, 3.0), (1.5, 2.0, 3.0)
        for edit, expected in (
            (CheckEdit("fill", "", 1.0, start, None, 10.0), "Fill the hole of 10 mm at (1, 2, 3)"),
            (CheckEdit("drill", "", 1.0, None, end, 4.5), "Drill a hole of 4.5 mm at (1.5, 2, 3)"),
            (
                CheckEdit("move", "", 1.0, start, end, 10.0),
                "Move the hole of 10 mm from (1, 2, 3) to (1.5, 2, 3)",
            ),
            (
                CheckEdit("shift", "", 1.0, start, end, None),
                "Move the flat face at (1, 2, 3) to (1.5, 2, 3)",
            ),
            (
                CheckEdit("mirror", "", 1.0, None, None, None),
                "Take the mirror image of the model",
            ),
            # What is not known here, or lacks a value, stays as the engine said it.
            (CheckEdit("bend", "bend it", 1.0, start, end, None), "bend it"),
            (CheckEdit("fill", "fill it", 1.0, None, None, 10.0), "fill it"),
        ):
            self.assertEqual(edit_words(edit), expected)

    def test_notes_and_numbers_are_told_with_what_the_model_has(self) -> None:
        note = {"view": "top", "kind": "note", "text": "4x {Ø5}", "stated": 4, "measured": 3}
        number = {"view": "front", "kind": "number", "stated": 13.0, "measured": 13.355}
        pose = {"scale": 2.0, "scale_source": "default"}
        values = {"verdict": "differs", "differences": [note, number], "pose": pose}
        words = [difference_words(each) for each in parse_check(values).differences]
        # Where the size is not known lengths are those of the model; counts are what they are.
        self.assertEqual(
            words,
            [
                ("Note", "Note “4x {Ø5}”: the drawing says 4, the model has 3."),
                ("Number", "The drawing states 26 mm, the model has 26.71 mm."),
            ],
        )


class Model(RunCase):
    def test_the_box_of_a_model_is_that_of_its_geometry_in_the_document(self) -> None:
        part = self.document.addObject("Part::Feature", "Model")
        part.Shape = Part.makeBox(10, 20, 30)
        part.Placement.Base = FreeCAD.Vector(5, 0, 0)
        holder = self.document.addObject("App::Part", "Assembly")
        holder.Placement.Base = FreeCAD.Vector(0, 0, 100)
        holder.addObject(part)
        box = Source(part).box()
        corners = (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax)
        for found, expected in zip(corners, (5, 0, 100, 15, 20, 130), strict=True):
            self.assertAlmostEqual(found, expected)
        self.assertFalse(Source(path="a.step").box().isValid())
