"""Seconds that a user of the window waits: on the canvas, and in FreeCAD's panel."""

import json
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.run.checkout import ROOT, SAMPLES
from benchmarks.tasks.opened_canvas import Canvas

sys.path.insert(0, str(ROOT / "scripts"))

from freecad_window import run_in_window
from tutorial_pictures import SHEETS as TUTORIAL

PANEL = ROOT / "scripts" / "window_panel.py"

_PANEL_SECONDS = 300.0
"""s that a sheet may take in the panel."""


@dataclass(frozen=True)
class Waited:
    """What one sheet took.

    Attributes:
        sheet: its name.
        way: by which it was opened.
        read: s from the click to what was read; None where it was not.
        part: s from the click to the part; None where there is none.
    """

    sheet: str
    way: str
    read: float | None
    part: float | None


def shipped_sheets() -> list[Path]:
    """The samples, and the sheets of the tutorial."""
    tutorial = (ROOT / "docs" / "tutorial" / f"{name}.png" for name in TUTORIAL)
    return [*sorted(SAMPLES.glob("*.png")), *tutorial]


def on_canvas(sheet: Path, folder: Path) -> Iterator[Waited]:
    """A sheet as the first one of its engines, and again while that is open."""
    first = Canvas(sheet, folder / "cold")
    try:
        first.open()
        yield Waited(sheet.stem, "canvas, cold", first.read_s, first.part_s)
        again = Canvas(sheet, folder / "warm", engines=first.window.engines)
        try:
            again.open()
            yield Waited(sheet.stem, "canvas, warm", again.read_s, again.part_s)
        finally:
            again.close()
    finally:
        first.close()


def in_panel(sheets: Sequence[Path], folder: Path) -> Iterator[Waited]:
    """Sheets in the panel of one window of FreeCAD, one after another.

    Raises:
        ChildProcessError: FreeCAD failed.
    """
    folder.mkdir()
    found = folder / "seconds.jsonl"
    variables = {
        "GAUSSIANCAD_SHEETS": "\n".join(map(str, sheets)),
        "GAUSSIANCAD_SECONDS": str(found),
    }
    status = run_in_window(PANEL, folder / "profile", variables, _PANEL_SECONDS * len(sheets))
    if status != 0:
        raise ChildProcessError(f"FreeCAD ended with {status}")
    for line in found.read_text(encoding="utf-8").splitlines():
        entry = json.loads(line)
        yield Waited(Path(entry["sheet"]).stem, "panel", entry["read"], entry["solid"])
