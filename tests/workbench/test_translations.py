"""The texts for people: all of them translated, with their placeholders."""

import ast
import re
import unittest
from xml.etree import ElementTree

from freecad.gaussiancad.paths import ADDON_ROOT, TRANSLATIONS, UI
from freecad.gaussiancad.qt import QtCore

PLACEHOLDER = re.compile(r"{\w+}")


def texts_in_code() -> set[tuple[str, str]]:
    """(context, text) of every call that marks or translates one."""
    found = set()
    for path in (ADDON_ROOT / "freecad").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
                continue
            if node.func.id in ("translate", "QT_TRANSLATE_NOOP"):
                context, text = (getattr(own, "value", None) for own in node.args)
                found.add((context, text))
    return found


def texts_in_forms() -> set[tuple[str, str]]:
    """(context, text) of every text in the forms."""
    root = ElementTree.parse(UI / "preferences.ui").getroot()
    context = root.find("class").text
    return {(context, node.text) for node in root.iter("string")}


def translations() -> dict[tuple[str, str], str]:
    """The German texts by context and English text."""
    root = ElementTree.parse(TRANSLATIONS / "GaussianCAD_de.ts").getroot()
    return {
        (context.find("name").text, message.find("source").text): message.find("translation").text
        for context in root.findall("context")
        for message in context.findall("message")
        if message.find("translation").get("type") is None
    }


class German(unittest.TestCase):
    def test_every_text_is_translated_and_none_is_left_over(self) -> None:
        self.assertEqual(set(translations()), texts_in_code() | texts_in_forms())

    def test_placeholders_are_the_same(self) -> None:
        for (_, english), german in translations().items():
            self.assertTrue(german)
            expected = sorted(PLACEHOLDER.findall(english))
            self.assertEqual(sorted(PLACEHOLDER.findall(german)), expected, english)

    def test_the_compiled_texts_are_the_same(self) -> None:
        translator = QtCore.QTranslator()
        self.assertTrue(translator.load(str(TRANSLATIONS / "GaussianCAD_de.qm")))
        for (context, english), german in translations().items():
            self.assertEqual(translator.translate(context, english), german)
