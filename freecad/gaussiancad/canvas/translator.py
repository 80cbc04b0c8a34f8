"""The language of the window where FreeCAD does not choose it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile
from pathlib import Path

from freecad.gaussiancad.qt import QtCore

_TRANSLATIONS = Path(__file__).resolve().parents[1] / "translations"


def load_language(translator: QtCore.QTranslator, languages: Sequence[str]) -> bool:
    """Load the texts of the first language that there are texts in.

    Args:
        translator: that gets them.
        languages: that the user reads, such as ``zh-CN``, the best first.

    Returns:
        Whether there are any before English, which needs none.
    """
    before = takewhile(lambda name: name.partition("-")[0] != "en", languages)
    return any(translator.load(f"GaussianCAD_{name}", str(_TRANSLATIONS)) for name in before)
