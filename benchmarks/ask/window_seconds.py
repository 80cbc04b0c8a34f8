"""How long does a user of the window wait from the click to the solid?

Sheets are opened on the canvas and in the panel, as events of the window, and the seconds to what
was read and to the part are noted.

Without sheets: the samples and those of the tutorial.  Three ways, one sheet after another:

- ``canvas, cold``: *Correct Sheet* opens as the first of its window, and starts its engines.
- ``canvas, warm``: it opens while another sheet is open, whose engines have read and solved.
- ``panel``: *Reconstruct from Drawing* in FreeCAD on a virtual screen, from the press of *Start* to
  the solid in the document; each run has an engine of its own.

``read`` are the seconds until the sheet is read, ``part`` those from then to the part, ``-`` for
what does not come: of a sheet whose lines make no part.  The last line tells how many processes
wanted a core, at the beginning and at the end: compare figures only where it is about the same.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.run.checkout import ROOT
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.tasks.canvas_player import Player

sys.path.insert(0, str(ROOT / "scripts"))

from freecad_window import run_in_window
from tutorial_pictures import SHEETS as TUTORIAL

MINUTES = 10

PANEL = ROOT / "scripts" / "window_panel.py"

_PANEL_SECONDS = 300.0
"""s that a sheet may take in the panel."""

_LINE = "{:24} {:14} {:>8} {:>8} {:>8}"


@dataclass(frozen=True)
class Waited:
    """What one sheet took.

    Attributes:
        sheet: its name.
        way: which of the three.
        read: s from the click to what was read; None where it was not.
        total: s from the click to the part; None where there is none.
    """

    sheet: str
    way: str
    read: float | None
    total: float | None

    @property
    def part(self) -> float | None:
        """s from what was read to the part."""
        return None if self.read is None or self.total is None else self.total - self.read


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("sheets", nargs="*", type=Path)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--without-freecad", action="store_true")


def run(options: argparse.Namespace) -> Outcome:
    """Print the table."""
    sheets = [sheet.resolve() for sheet in options.sheets] or _sheets()
    print(_LINE.format("sheet", "way", "read s", "part s", "total s"))
    every: list[Waited] = []
    load = os.getloadavg()[0]
    with tempfile.TemporaryDirectory(prefix="gaussiancad-seconds-") as folder:
        for sheet in sheets:
            runs = [
                waited
                for number in range(options.repeat)
                for waited in on_canvas(sheet, Path(folder) / f"{sheet.stem}-{number}")
            ]
            every += _print_medians(runs)
        if not options.without_freecad:
            of_panel = [
                waited
                for number in range(options.repeat)
                for waited in in_panel(sheets, Path(folder) / f"panel-{number}")
            ]
            every += _print_medians(of_panel)
    figures = []
    for way in dict.fromkeys(run.way for run in every):
        of_way = [run for run in every if run.way == way and run.total is not None]
        read, part, total = (
            statistics.median([getattr(run, name) for run in of_way]) if of_way else None
            for name in ("read", "part", "total")
        )
        print(_row("median", way, read, part, total), flush=True)
        figures.append(Figure(way, "none" if total is None else round(total, 1), "s"))
    print(f"load {load:.1f}, {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    return Outcome(tuple(figures))


def on_canvas(sheet: Path, folder: Path) -> list[Waited]:
    """A sheet as the first one of its engines, and again while that is open."""
    cold = Player(sheet, folder / "cold")
    try:
        first = _opened(cold, sheet.stem, "canvas, cold")
        warm = Player(sheet, folder / "warm", engines=cold.window.engines)
        try:
            return [first, _opened(warm, sheet.stem, "canvas, warm")]
        finally:
            warm.close()
    finally:
        cold.close()


def in_panel(sheets: Sequence[Path], folder: Path) -> Iterator[Waited]:
    """Sheets in the panel of one window of FreeCAD, one after another."""
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


def _opened(player: Player, name: str, way: str) -> Waited:
    """Open the sheet of a player, and wait for its part."""
    at: dict[str, float] = {}

    def note(what: str) -> None:
        at.setdefault(what, time.monotonic() - began)

    player.window.session.read.connect(lambda: note("read"))
    player.window.session.solved.connect(lambda _, folder: note("solved") if folder else None)
    began = time.monotonic()
    player.play([["open"]])
    return Waited(name, way, at.get("read"), at.get("solved"))


def _print_medians(runs: Sequence[Waited]) -> list[Waited]:
    """Print and return the median run of each sheet and way: by the time to the part."""
    found = []
    for key in dict.fromkeys((run.sheet, run.way) for run in runs):
        alike = [run for run in runs if (run.sheet, run.way) == key]
        alike.sort(key=lambda run: (run.total is None, run.total or run.read or 0.0))
        median = alike[(len(alike) - 1) // 2]
        found.append(median)
        print(_row(*key, median.read, median.part, median.total), flush=True)
    return found


def _row(sheet: str, way: str, *seconds: float | None) -> str:
    return _LINE.format(
        sheet, way, *("-" if value is None else f"{value:.1f}" for value in seconds)
    )


def _sheets() -> list[Path]:
    """The samples, and the sheets of the tutorial."""
    samples = (ROOT / "resources" / "samples").glob("*.png")
    return [*sorted(samples), *(ROOT / "docs" / "tutorial" / f"{name}.png" for name in TUTORIAL)]
