"""The documentation quotes the window as it speaks."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs" / "troubleshooting.md"

_QUOTE = re.compile(r"^> (.+)$", re.MULTILINE)
_VALUE = re.compile(r"\{\w*\}")


def _sentences() -> set[str]:
    """Texts of the workbench as they are said outside of the canvas, with an ellipsis for each
    value."""
    found = set()
    for path in (ROOT / "freecad" / "gaussiancad").glob("**/*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                said = node.value.replace("{canvas}", "in Correct Sheet")
                found.add(_VALUE.sub("\u2026", said))
    return found


SENTENCES = _sentences()


@pytest.mark.parametrize("quote", _QUOTE.findall(PAGE.read_text("utf-8")))
def test_what_is_quoted_is_said(quote: str) -> None:
    assert quote in SENTENCES
