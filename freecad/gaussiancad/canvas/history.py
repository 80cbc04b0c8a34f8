"""Corrections of a sheet in the order in which they were said, with undo and redo."""

from __future__ import annotations

import json
import os
from pathlib import Path

SCHEMA = "gaussiancad-corrections/1"


class History:
    """The operations of a person.

    Args:
        operations: said before.
    """

    def __init__(self, operations: list[dict] | None = None) -> None:
        self._steps: list[list[dict]] = [[own] for own in operations or []]
        self._undone: list[list[dict]] = []

    @property
    def operations(self) -> list[dict]:
        """All of them, in order."""
        return [own for step in self._steps for own in step]

    def say(self, operations: list[dict]) -> None:
        """Add operations that are one step."""
        if operations:
            self._steps.append(list(operations))
            self._undone.clear()

    def undo(self) -> bool:
        """Take the last step back; whether there was one."""
        if not self._steps:
            return False
        self._undone.append(self._steps.pop())
        return True

    def redo(self) -> bool:
        """Say again what was taken back last; whether there was anything."""
        if not self._undone:
            return False
        self._steps.append(self._undone.pop())
        return True


def read_again(operations: list[dict]) -> list[dict]:
    """The first operations, up to the last that boxes a view: with them the engine has to read the
    sheet again, to tell the strokes in the box; none where no view was boxed."""
    boxed = [n for n, own in enumerate(operations, start=1) if own["op"] == "view" and "box" in own]
    return operations[: boxed[-1]] if boxed else []


def corrections_path(sheet: Path) -> Path:
    """Where the corrections of a sheet are, beside it."""
    return sheet.with_name(sheet.name + ".corrections.json")


def read_corrections(sheet: Path) -> list[dict]:
    """The operations beside a sheet; none where there is no file.

    Raises:
        ValueError: the file is no corrections.
    """
    path = corrections_path(sheet)
    if not path.is_file():
        return []
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        found = None
    whole = isinstance(found, dict) and found.get("schema") == SCHEMA
    operations = found.get("ops", []) if whole else None
    if not isinstance(operations, list) or not all(_is_operation(own) for own in operations):
        raise ValueError(f"{path.name} is no file of corrections: move it away, or mend it")
    return operations


def _is_operation(found: object) -> bool:
    return isinstance(found, dict) and isinstance(found.get("op"), str)


def write_corrections(sheet: Path, sha256: str, operations: list[dict]) -> None:
    """Write the corrections beside a sheet; where there are none, no file is left."""
    path = corrections_path(sheet)
    if not operations:
        path.unlink(missing_ok=True)
        return
    content = {"schema": SCHEMA, "sheet_sha256": sha256, "ops": operations}
    # The file appears only when whole.
    beside = path.with_name(path.name + ".part")
    beside.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    os.replace(beside, path)
