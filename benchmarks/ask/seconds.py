"""How many seconds does a user wait, of the command and of the window, and how much memory is used?

``command``: sample parts are drawn once and reconstructed by processes of their own, one at a time:
seconds until the solid is told and until the end, and the most memory.

``reading``: with ``--data`` each PDF file of one page (SOURCE/NAME.pdf) is read as ``gaussiancad
read`` does: seconds of processor time, without imports.

``window``: the shipped samples and the sheets of the tutorial are opened in three ways, and the
seconds from the click to what was read and to the part are noted:

- ``canvas, cold``: *Correct Sheet* opens as the first of its window, and starts its engines.
- ``canvas, warm``: it opens while another sheet is open, whose engines have read and solved.
- ``panel``: *Reconstruct from Drawing* in FreeCAD on a virtual screen, from the press of *Start* to
  the solid in the document; each run has an engine of its own.

The last line tells how many processes wanted a core, at the beginning and at the end: compare
figures only where it is about the same.
"""

import argparse
import os
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from statistics import median

import numpy as np

from benchmarks.parts.named_parts import named_samples
from benchmarks.run.arguments import add_data, is_chosen, tell
from benchmarks.run.outcome import Figure, Outcome, as_table
from benchmarks.sheets.clean_sheets import draw_clean
from benchmarks.tasks.engine_seconds import Wait, reading_seconds, waited
from gaussiancad_core.errors import UsageError

MINUTES = 25

_GROUPS = ("command", "reading", "window")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--groups", nargs="*", default=_GROUPS, choices=_GROUPS, metavar="NAME")
    parser.add_argument("--samples", nargs="*", default=[])
    parser.add_argument("--every", type=int, default=1, help="of the PDF files")
    add_data(parser, required=False)


def run(options: argparse.Namespace) -> Outcome:
    """Print the tables."""
    load = os.getloadavg()[0]
    figures: list[Figure] = []
    with tempfile.TemporaryDirectory(prefix="gaussiancad-seconds-") as folder:
        scratch = Path(folder)
        if "command" in options.groups:
            figures += _of_command(options.samples, scratch)
        if "reading" in options.groups and options.data is not None:
            figures += _of_reading(options, scratch)
        if "window" in options.groups:
            figures += _of_window(scratch)
    print(f"load {load:.1f}, {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    return Outcome(tuple(figures))


def _of_command(names: Sequence[str], folder: Path) -> Iterator[Figure]:
    waits: dict[str, Wait] = {}
    for part in named_samples(names):
        sheet = draw_clean(part.build(), folder / f"{part.name}.png")
        waits[part.name] = waited(sheet, folder / part.name)
        tell(f"{part.name}: {waits[part.name]}")
    if not waits:
        raise UsageError("unknown-sample", f"there is no sample {' '.join(names)}")
    cells = [
        (name, f"{wait.solid:.1f}", f"{wait.end:.1f}", f"{wait.memory:.0f}")
        for name, wait in waits.items()
    ]
    print(as_table(("command", "to the solid s", "to the end s", "MB"), cells))
    yield Figure("command, to the solid", round(median(w.solid for w in waits.values()), 1), "s")
    yield Figure("command, to the end", round(median(w.end for w in waits.values()), 1), "s")
    yield Figure("most memory", round(max(wait.memory for wait in waits.values())), "MB")


def _of_reading(options: argparse.Namespace, folder: Path) -> Iterator[Figure]:
    sheets = [
        sheet for sheet in sorted(options.data.glob("*/*.pdf")) if is_chosen(sheet, options.only)
    ]
    seconds = []
    for sheet, spent in reading_seconds(sheets[:: options.every], folder):
        seconds.append(spent)
        tell(f"{sheet.parent.name}/{sheet.stem}: {spent:.2f} CPU s")
    if seconds:
        middle, most = np.percentile(seconds, (50.0, 95.0))
        yield Figure(f"reading, median of {len(seconds)}", round(middle, 2), "CPU s")
        yield Figure("reading, 95 %", round(most, 2), "CPU s")


def _of_window(folder: Path) -> Iterator[Figure]:
    # Qt is loaded only where it is needed.
    from benchmarks.tasks.window_seconds import in_panel, on_canvas, shipped_sheets

    sheets = shipped_sheets()
    every = [waited for sheet in sheets for waited in on_canvas(sheet, folder / sheet.stem)]
    every += in_panel(sheets, folder / "panel")
    cells = [
        (item.sheet, item.way, *("-" if s is None else f"{s:.1f}" for s in (item.read, item.part)))
        for item in every
    ]
    print(as_table(("sheet", "way", "read s", "part s"), cells))
    for way in dict.fromkeys(item.way for item in every):
        known = [item.part for item in every if item.way == way and item.part is not None]
        yield Figure(way, round(median(known), 1) if known else "none", "s")
