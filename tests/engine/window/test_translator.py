"""The languages of the window without FreeCAD."""

import pytest

from freecad.gaussiancad.canvas.translator import load_language
from freecad.gaussiancad.engine.wording import Place, worded
from freecad.gaussiancad.qt import QtCore, QtWidgets


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


@pytest.mark.parametrize(
    ("language", "elsewhere", "here"),
    [
        ("de", "Umrahmen Sie die Ansichten mit \u201eBlatt", "Umrahmen Sie die Ansichten hier und"),
        ("zh-CN", "\u8bf7\u5728\u201c\u6821\u6b63", "\u8bf7\u5728\u6b64\u6846\u9009"),
    ],
)
def test_on_the_canvas_nobody_is_sent_to_it(
    application: QtWidgets.QApplication, language: str, elsewhere: str, here: str
) -> None:
    translator = QtCore.QTranslator()
    assert load_language(translator, [language])
    application.installTranslator(translator)
    try:
        assert elsewhere in worded("no-views", "")
        assert here in worded("no-views", "", None, Place.CANVAS)
    finally:
        application.removeTranslator(translator)
