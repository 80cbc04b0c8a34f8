"""The texts for people: all of them translated, with their placeholders."""

import ast
import re
import unittest
from xml.etree import ElementTree

from freecad.gaussiancad.paths import ADDON_ROOT, TRANSLATIONS, UI
from freecad.gaussiancad.qt import QtCore

PLACEHOLDER = re.compile(r"{\w+}")

LANGUAGES = ("de", "zh-CN")
"""As FreeCAD names them in the files of its own texts."""


def texts_in_code() -> set[tuple[str, str]]:
    """(context, text) of every call that marks or translates one."""
    found = set()
    for path in (ADDON_ROOT / "freecad").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
                continue
            # A text that a variable holds was marked where it was written.
            texts = [argument.value for argument in node.args if isinstance(argument, ast.Constant)]
            if node.func.id in ("translate", "QT_TRANSLATE_NOOP") and len(texts) == 2:
                found.add((texts[0], texts[1]))
    return found


def texts_in_forms() -> set[tuple[str, str]]:
    """(context, text) of every text in the forms."""
    root = ElementTree.parse(UI / "preferences.ui").getroot()
    context = root.find("class").text
    return {(context, node.text) for node in root.iter("string")}


def translations(language: str) -> dict[tuple[str, str], str]:
    """The texts in a language by context and English text."""
    root = ElementTree.parse(TRANSLATIONS / f"GaussianCAD_{language}.ts").getroot()
    return {
        (context.find("name").text, message.find("source").text): message.find("translation").text
        for context in root.findall("context")
        for message in context.findall("message")
        if message.find("translation").get("type") is None
    }


class Languages(unittest.TestCase):
    def test_every_text_is_translated_and_none_is_left_over(self) -> None:
        for language in LANGUAGES:
            with self.subTest(language):
                self.assertEqual(set(translations(language)), texts_in_code() | texts_in_forms())

    def test_placeholders_are_the_same(self) -> None:
        for language in LANGUAGES:
            for (_, english), foreign in translations(language).items():
                with self.subTest(language, text=english):
                    self.assertTrue(foreign)
                    expected = sorted(PLACEHOLDER.findall(english))
                    self.assertEqual(sorted(PLACEHOLDER.findall(foreign)), expected)

    def test_the_compiled_texts_are_the_same(self) -> None:
        for language in LANGUAGES:
            translator = QtCore.QTranslator()
            self.assertTrue(translator.load(str(TRANSLATIONS / f"GaussianCAD_{language}.qm")))
            for (context, english), foreign in translations(language).items():
                self.assertEqual(translator.translate(context, english), foreign)

    def test_there_are_no_others(self) -> None:
        found = {path.stem.partition("_")[2] for path in TRANSLATIONS.glob("*.ts")}
        self.assertEqual(found, set(LANGUAGES))
