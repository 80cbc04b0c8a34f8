"""Who keeps a person's corrections: a file beside the sheet here; in FreeCAD the document."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Protocol

SCHEMA = "gaussiancad-corrections/1"


class CorrectionsStore(Protocol):
    """Corrections in the order in which they were said.

    Attributes:
        operations: all of them.
        has_undo: whether undo and redo are the canvas's own keys.
    """

    operations: list[dict]
    has_undo: bool

    def add(self, operations: list[dict]) -> None:
        """Add operations as one step."""

    def undo(self) -> None:
        """Take the last step back, if there is one."""

    def redo(self) -> None:
        """Say again what was taken back last."""


class CorrectionsFile:
    """Corrections in the file beside a sheet, with the steps since it was opened.

    Args:
        sheet: path of it.
        page: of a file with pages.

    Raises:
        ValueError: the file is damaged.
    """

    has_undo = True

    def __init__(self, sheet: Path, page: int = 1) -> None:
        self._path = corrections_path(sheet, page)
        self._sha256, found = read_corrections(self._path)
        self._steps: list[list[dict]] = [[item] for item in found]
        self._undone: list[list[dict]] = []

    @property
    def operations(self) -> list[dict]:
        """All of them, in order."""
        return [item for step in self._steps for item in step]

    def belongs_to(self, sha256: str) -> bool:
        """Whether the corrections are of a sheet.

        Those of another one, or of another version, are left out, and moved aside before anything
        is written.
        """
        mine = not self._sha256 or self._sha256 == sha256
        if not mine:
            self._steps = []
        self._sha256 = sha256
        return mine

    def add(self, operations: list[dict]) -> None:
        """Add operations that are one step."""
        if operations:
            self._steps.append(list(operations))
            self._undone.clear()
            self._write()

    def undo(self) -> None:
        """Take the last step back, if there is one."""
        if self._steps:
            self._undone.append(self._steps.pop())
            self._write()

    def redo(self) -> None:
        """Say again what was taken back last, if anything was."""
        if self._undone:
            self._steps.append(self._undone.pop())
            self._write()

    def _write(self) -> None:
        move_aside(self._path, self._sha256)
        write_corrections(self._path, self._sha256, self.operations)


def read_again(operations: list[dict]) -> list[dict]:
    """The first operations, up to the last that boxes a view: with them the engine has to read the
    sheet again, to tell the strokes in the box; none where no view was boxed."""
    boxed = [
        n
        for n, operation in enumerate(operations, start=1)
        if operation["op"] == "view" and "box" in operation
    ]
    return operations[: boxed[-1]] if boxed else []


def corrections_path(sheet: Path, page: int = 1) -> Path:
    """Where the corrections of a sheet are, beside it."""
    name = sheet.name if page == 1 else f"{sheet.name}.page-{page}"
    return sheet.with_name(name + ".corrections.json")


def read_corrections(path: Path) -> tuple[str, list[dict]]:
    """SHA-256 of the sheet that a file of corrections is of, and the operations; nothing where
    there is no file.

    Raises:
        ValueError: the file is no corrections.
    """
    if not path.is_file():
        return "", []
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        found = None
    whole = isinstance(found, dict) and found.get("schema") == SCHEMA
    operations = operations_in(found.get("ops", [])) if whole else None
    if operations is None:
        raise ValueError(f"{path.name} is no file of corrections: move it away, or mend it")
    return str(found.get("sheet_sha256", "")), operations


def operations_in(found: object) -> list[dict] | None:
    """JSON values as operations; None where they are none."""
    if not isinstance(found, list):
        return None
    whole = all(isinstance(item, dict) and isinstance(item.get("op"), str) for item in found)
    return found if whole else None


def move_aside(path: Path, sha256: str) -> None:
    """Rename a file of corrections that is not of the sheet with that SHA-256."""
    if path.is_file() and read_corrections(path)[0] != sha256:
        os.replace(path, path.with_name(path.name + ".old"))


def write_corrections(path: Path, sha256: str, operations: list[dict]) -> None:
    """Write a file of corrections, whole or not at all; where there are none, no file is left."""
    if not operations:
        path.unlink(missing_ok=True)
        return
    content = {"schema": SCHEMA, "sheet_sha256": sha256, "ops": operations}
    neighbour = path.with_name(path.name + ".part")
    neighbour.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    os.replace(neighbour, path)
