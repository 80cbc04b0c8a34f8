"""What the engine says, in the words of the window."""

import ast
import re
import unittest

from freecad.gaussiancad.engine.protocol import Code
from freecad.gaussiancad.engine.sentences import ALTERNATIVES, SENTENCES
from freecad.gaussiancad.engine.wording import (
    Place,
    alternative,
    drawing_name,
    role_name,
    stage_name,
    worded,
)
from freecad.gaussiancad.paths import ADDON_ROOT

ENGINE = ADDON_ROOT / "core" / "gaussiancad_core"
VALUE = re.compile(r"{(\w+)}")

WORDED = (
    "Reasons",
    "Assumptions",
    "Warnings",
    "Warnings of a comparison",
    "Reasons of a check",
    "Errors: reading files",
    "Errors: no model follows from the sheet",
)
"""Headings of docs/messages.md whose codes a window shows."""


def listed_codes() -> set[str]:
    """The codes under those headings."""
    text = (ADDON_ROOT / "docs" / "messages.md").read_text(encoding="utf-8")
    found: set[str] = set()
    for part in text.split("\n## ")[1:]:
        title, _, body = part.partition("\n")
        if title in WORDED:
            for row in re.findall(r"^\| ((?:`[a-z0-9-]+`(?:, )?)+) \|", body, re.MULTILINE):
                found.update(re.findall(r"`([a-z0-9-]+)`", row))
    return found


def sent_values() -> dict[str, set[str]]:
    """The names of the values that may be sent with each code: those of the calls in the same
    function as the code, or in the same module where it stands outside of functions."""
    found: dict[str, set[str]] = {}
    for path in ENGINE.rglob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
        within = {id(node) for function in functions for node in ast.walk(function)}
        outside = _codes(node for node in ast.walk(tree) if id(node) not in within)
        for code in outside:
            found.setdefault(code, set()).update(_names(ast.walk(tree)))
        for this_function in functions:
            for code in _codes(ast.walk(this_function)):
                found.setdefault(code, set()).update(_names(ast.walk(this_function)))
    return found


def _codes(nodes: object) -> set[str]:
    return {
        Code[node.attr].value
        for node in nodes
        if isinstance(node, ast.Attribute) and getattr(node.value, "id", "") == "Code"
    }


def _names(nodes: object) -> set[str]:
    found = set()
    for node in nodes:
        if isinstance(node, ast.Call):
            found.update(keyword.arg for keyword in node.keywords if keyword.arg)
        elif isinstance(node, ast.Dict):
            found.update(key.value for key in node.keys if isinstance(key, ast.Constant))
    return found


class Sentences(unittest.TestCase):
    def test_every_code_that_a_window_shows_has_one(self) -> None:
        listed = listed_codes()
        self.assertGreater(len(listed), 80)
        self.assertEqual(listed - set(SENTENCES), set())

    def test_there_is_none_that_the_engine_does_not_send(self) -> None:
        sources = "\n".join(path.read_text(encoding="utf-8") for path in ENGINE.rglob("*.py"))
        for key in (*SENTENCES, *ALTERNATIVES):
            for word in key.split(":"):
                member = f"Code.{word.upper().replace('-', '_')}"
                self.assertTrue(f'"{word}"' in sources or member in sources, key)

    def test_their_places_are_among_the_values_that_are_sent(self) -> None:
        sent = sent_values()
        # Values of these are put together in functions that know no code.
        sent["nothing-hidden"] |= sent["assumed"]
        numbers = {"bodies", "holes", "cavities"}
        pairs = {f"{model}_{number}" for model in ("result", "reference") for number in numbers}
        sent["topology-differs"] |= pairs
        for key, sentence in SENTENCES.items():
            code = key.partition(":")[0]
            with self.subTest(key):
                self.assertEqual(set(VALUE.findall(sentence)) - sent[code] - {"canvas"}, set())

    def test_they_speak_of_the_window_and_of_no_pixels_on_the_sheet(self) -> None:
        for key, sentence in SENTENCES.items():
            with self.subTest(key):
                self.assertRegex(sentence, r"^[A-Z{].*\.$")
                self.assertNotRegex(sentence, r"--|gaussiancad |\bpx\b|json|alternatives/")


class Wording(unittest.TestCase):
    def test_values_fill_the_places(self) -> None:
        self.assertEqual(
            worded("page-missing", "no", {"path": "a.pdf", "count": 2, "page": 3}),
            "There is no page 3: the last page of the file is page 2.",
        )
        self.assertIn(
            "is 25.4 times as large",
            worded("unit-mismatch", "", {"ratio": 25.4000001, "factor": 0.03937}),
        )

    def test_the_case_tells_which_sentence_it_is(self) -> None:
        plain = worded("search-unfinished", "no")
        self.assertEqual(worded("search-unfinished", "no", {"case": "nobody-knows"}), plain)
        self.assertNotEqual(worded("search-unfinished", "no", {"case": "clock"}), plain)

    def test_words_among_the_values_are_worded_too(self) -> None:
        values = {"axis": "X", "views": "front, top", "percent": 12}
        self.assertIn("(front, top)", worded("views-contradict", "no", values))
        symbol = {"symbol": "first", "other": "third", "taken": "first"}
        self.assertIn("says first angle", worded("symbol-contradicts-lines", "no", symbol))
        self.assertIn("enlarged detail", worded("unused-view", "no", {"kind": "detail"}))
        count = {"model": "reference", "count": 3}
        self.assertIn("the reference (open edges: 3)", worded("model-open", "no", count))

    def test_what_is_not_known_stays_as_the_engine_said_it(self) -> None:
        self.assertEqual(worded("never-heard", "as it {was}"), "as it {was}")
        self.assertEqual(worded("page-missing", "as it was", {"page": 3}), "as it was")
        self.assertEqual(worded("page-missing", "as it was", ["no", "object"]), "as it was")
        self.assertEqual(worded("never-heard", ""), "never-heard")
        self.assertEqual(alternative("never-heard", "something else"), "something else")
        self.assertEqual(stage_name("never_heard"), "never heard")
        self.assertEqual((role_name("aslant"), drawing_name("sketch")), ("aslant", "sketch"))

    def test_nobody_is_sent_to_where_they_are(self) -> None:
        sentence = worded("no-views", "")
        self.assertIn("Box the views in Correct Sheet and", sentence)
        sentence = worded("no-views", "", None, Place.CANVAS)
        self.assertIn("Box the views here and", sentence)
        self.assertEqual([text for text in SENTENCES.values() if "Correct Sheet" in text], [])

    def test_a_value_with_braces_fills_nothing(self) -> None:
        stated = worded("file-missing", "no", {"path": "{page}.pdf"})
        self.assertIn("{page}.pdf", stated)

    def test_every_stage_and_kind_of_drawing_has_a_name(self) -> None:
        pipeline = ast.parse((ENGINE / "run" / "pipeline.py").read_text(encoding="utf-8"))
        for name in _constant(pipeline, "STAGES"):
            self.assertIn(" ", stage_name(name), name)
        kinds = ENGINE / "sheet" / "special_views" / "view_kinds.py"
        names = re.findall(r'^    [A-Z_]+ = "([a-z-]+)"', kinds.read_text("utf-8"), re.MULTILINE)
        for name in names:
            if name != "section":
                self.assertNotEqual(drawing_name(name), name)


def _constant(tree: ast.Module, name: str) -> tuple[str, ...]:
    for node in tree.body:
        if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == name:
            return ast.literal_eval(node.value)
    raise AssertionError(name)
