"""From a file to its strokes to what is written beside them: no room imports a later one."""

import ast
from pathlib import Path

import pytest

import gaussiancad_core

ENGINE = Path(gaussiancad_core.__file__).parent

SHARED = {"axes", "drawing", "ellipses", "errors", "lengths", "messages", "processes", "views"}
"""What all of these rooms may use."""


def imported_by(room: str) -> dict[str, str]:
    """The other rooms, and modules beside them, that a room imports, each with who does."""
    found: dict[str, str] = {}
    for path in (ENGINE / room).rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module is not None:
                package, *rest = node.module.split(".")
                if package == "gaussiancad_core":
                    names = rest[:1] or [each.name for each in node.names]
                    found |= dict.fromkeys(names, path.name)
    found.pop(room, None)
    return found


@pytest.mark.parametrize(
    ("room", "earlier"),
    [
        ("files", set()),
        ("sheet", {"files", "unseen"}),
        ("writing", {"files", "sheet"}),
    ],
)
def test_a_room_imports_only_earlier_ones(room: str, earlier: set[str]) -> None:
    imported = imported_by(room)
    assert earlier <= imported.keys()
    assert {name: by for name, by in imported.items() if name not in earlier | SHARED} == {}
