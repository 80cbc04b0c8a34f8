"""Every code that the engine can give a person is explained in docs/messages.md."""

import ast
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GIVERS = {"_warn", "warned", "doubted", "_told", "_tell"}


def _codes_in(path: Path) -> set[str]:
    codes = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.Call):
            continue
        name = getattr(node.func, "id", getattr(node.func, "attr", ""))
        if not (name.endswith("Error") or name in GIVERS):
            continue
        for argument in node.args[:2]:
            if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
                if re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)+|cancelled", argument.value):
                    codes.add(argument.value)
                break
    return codes


def test_every_code_is_explained() -> None:
    sources = (ROOT / "core" / "gaussiancad_core").rglob("*.py")
    given = set().union(*(_codes_in(path) for path in sources))
    explained = set(re.findall(r"`([a-z0-9-]+)`", (ROOT / "docs/messages.md").read_text("utf-8")))
    assert len(given) > 40
    assert not given - explained


def test_no_code_is_explained_that_no_one_gives() -> None:
    sources = "\n".join(
        path.read_text("utf-8") for path in (ROOT / "core" / "gaussiancad_core").rglob("*.py")
    )
    text = (ROOT / "docs/messages.md").read_text("utf-8")
    rows = re.findall(r"^\| ((?:`[a-z0-9-]+`(?:, )?)+) \|", text, re.MULTILINE)
    listed = {code for row in rows for code in re.findall(r"`([a-z0-9-]+)`", row)}
    assert not {code for code in listed if not re.search(rf'["\[]{code}["\]]', sources)}
