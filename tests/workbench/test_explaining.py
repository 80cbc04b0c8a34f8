"""A report in sentences for who uses the window."""

import re
import unittest

from fake_engine import report as fake_report

from freecad.gaussiancad.engine.explaining import MODELS, OUTCOMES, explanation_lines
from freecad.gaussiancad.engine.report import parse_report
from freecad.gaussiancad.paths import ADDON_ROOT

TRACE = ADDON_ROOT / "core" / "gaussiancad_core" / "solid" / "search_trace.py"


def explained(status: str = "approximate", **values: object) -> list[str]:
    reason = {"code": "two-views", "message": "no"}
    reasons = [] if status == "verified" else [reason]
    return explanation_lines(parse_report("", {**fake_report("a.png", status, reasons), **values}))


class Explaining(unittest.TestCase):
    def test_reasons_come_first_and_a_verified_part_needs_none(self) -> None:
        self.assertEqual(explained("verified"), [])
        self.assertEqual(explained()[0], "Why the shape is not certain:")
        self.assertEqual(explained("failed")[0], "Why there is no part:")
        self.assertIn("only two directions of view", explained()[1])

    def test_what_was_assumed_has_an_alternative(self) -> None:
        entry = {
            "code": "hole-through",
            "message": "no",
            "args": {"view": "top", "diameter_mm": 8.0},
            "alternative": "no",
            "at": None,
        }
        line = explained("verified", assumptions=[entry])[1]
        self.assertIn("hole of 8 mm in the view “top”", line)
        self.assertIn("Otherwise: It ends inside", line)

    def test_what_was_tried_is_told_in_order(self) -> None:
        first = {
            "model": "as-drawn",
            "outcome": "contradictory",
            "given_up": [{"view": "top"}],
            "given_up_mm": 12.34,
            "faces": 0,
            "taken": False,
        }
        second = {
            "model": "undrawn-lines",
            "outcome": "all-lines",
            "faces": 8,
            "agreement": 0.995,
            "taken": True,
        }
        lines = explained("verified", trace=[first, second])
        self.assertEqual(lines[0], "What was tried for the solid:")
        self.assertIn("12.3 mm", lines[1])
        self.assertRegex(lines[2], r"Faces: 8, .* 99\.5%\. This one was taken\.$")

    def test_the_longest_differences_are_named_and_the_others_counted(self) -> None:
        places = [
            {"view": "front", "at": [1, 2], "length_mm": 9.0 - n, "missing": n % 2 == 0}
            for n in range(8)
        ]
        lines = explained("verified", disagreements=places)
        self.assertEqual(len(lines), 8)
        self.assertIn("front: the part lacks a line of 9.0 mm", lines[1])
        self.assertIn("front: the part has a line of 8.0 mm too many", lines[2])
        self.assertIn("and 2 more", lines[7])

    def test_contradicting_lines_and_what_was_not_used(self) -> None:
        line = {"view": "top", "drawn": None, "suspect": True, "fitting": "visible"}
        unused = [{"kind": "detail", "box": [0, 0, 1, 1], "why": "no"}]
        lines = explained("verified", conflict=[line], unused=unused)
        self.assertIn("• enlarged detail", lines)
        self.assertIn("top: a place where nothing is drawn (without it", lines[-1])

    def test_reports_of_another_shape_are_no_error(self) -> None:
        odd = {key: [None, 3, {}] for key in ("assumptions", "trace", "conflict", "disagreements")}
        self.assertTrue(explained("verified", **odd))
        self.assertEqual(explained("verified", trace="none", assumptions=None), [])

    def test_every_model_and_outcome_of_the_engine_has_a_name(self) -> None:
        text = TRACE.read_text(encoding="utf-8")
        for name, names in (("ModelKind", MODELS), ("Outcome", OUTCOMES)):
            body = text.partition(f"class {name}(")[2].partition("\nclass ")[0]
            known = set(re.findall(r'^    [A-Z_]+ = "([a-z-]+)"', body, re.MULTILINE))
            self.assertEqual(known, set(names))
