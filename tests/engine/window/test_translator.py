"""The languages of the window without FreeCAD."""

import os
import sys
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
sys.path.insert(0, str(Path(__file__).resolve().parents[3]))

from freecad.gaussiancad.canvas.translator import load_language
from freecad.gaussiancad.qt import QtCore


@pytest.mark.parametrize(
    ("locale", "top"), [("de_DE", "oben"), ("de_AT", "oben"), ("zh_CN", "\u4fef\u89c6\u56fe")]
)
def test_a_locale_finds_its_texts(locale: str, top: str) -> None:
    translator = QtCore.QTranslator()
    assert load_language(translator, QtCore.QLocale(locale).uiLanguages())
    assert translator.translate("GaussianCAD", "top") == top


def test_others_stay_english() -> None:
    translator = QtCore.QTranslator()
    assert not load_language(translator, ["fr-Latn-FR", "fr-FR", "fr"])
    assert not load_language(translator, ["en-US", "en", "de-DE", "de"])
    assert load_language(translator, ["fr", "de-DE", "de"])
