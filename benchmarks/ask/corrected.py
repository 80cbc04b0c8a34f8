"""How far do sheets come on the canvas that a person corrects?

Recorded gestures are played as the events that a mouse and keys make, without a screen: those of
the tutorial, and with ``--data`` those of published drawings, in folders as ``real_sheets`` has
them.  A part is compared with the
true one at the size that it has, in the best of 24 orientations.

``before`` is the volume IoU of the part that stands without a correction.  Exit code 1 if a part
that is called ``verified`` is not the true one (IoU of 0.99 at least).
"""

import argparse
import json
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from benchmarks.judge.exact_measures import closeness_at_one_size
from benchmarks.run.arguments import existing_folder
from benchmarks.run.checkout import ROOT
from benchmarks.run.outcome import Figure, Outcome, share
from benchmarks.tasks.canvas_player import Played, Player, Step, recordings
from gaussiancad_core.kernel.brep_files import read_shape, read_solid
from gaussiancad_core.processes.library_behaviour import silence_opencascade

MINUTES = 3

RECORDINGS = Path(__file__).with_name("corrected_gestures.json")

_SAME_IOU = 0.99

_LINE = "{:34} {:>7} {:>12} {:>8} {:>11} {:>8} {:>8}"


@dataclass(frozen=True)
class Corrected:
    """A sheet before and after.

    Attributes:
        name: of the sheet.
        before: volume IoU of the part without a correction; 0 where there is none.
        status, gestures, operations, seconds: of the corrected sheet.
        iou: of its part; 0 where there is none.
    """

    name: str
    before: float
    status: str
    gestures: int
    operations: int
    seconds: float
    iou: float

    @property
    def is_false(self) -> bool:
        """Whether it is called verified and is not the true part."""
        return self.status == "verified" and self.iou < _SAME_IOU


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--data", type=existing_folder)
    parser.add_argument("--only", nargs="+")
    parser.add_argument("--json", type=Path)


def run(options: argparse.Namespace) -> Outcome:
    """Play the recordings and print the table."""
    silence_opencascade()
    rows = []
    print(_LINE.format("sheet", "before", "status", "gestures", "corrections", "seconds", "IoU"))
    for name, sheet, truth, steps in _found(options.data, options.only or [""]):
        row = measured(name, sheet, truth, steps)
        rows.append(row)
        values = (row.status, row.gestures, row.operations, f"{row.seconds:.0f}", f"{row.iou:.4f}")
        print(_LINE.format(name, f"{row.before:.4f}", *values), flush=True)
    if options.json:
        text = json.dumps([asdict(row) for row in rows], indent=1)
        options.json.write_text(f"{text}\n", encoding="utf-8")
    verified = sum(row.status == "verified" for row in rows)
    false = sum(row.is_false for row in rows)
    figures = (share("verified", verified, len(rows)), Figure("falsely verified", false))
    return Outcome(figures, wrong=bool(false))


def measured(name: str, sheet: Path, truth: Path, steps: Sequence[Step]) -> Corrected:
    """Play a recording, and compare the parts before and after with the true one."""
    with tempfile.TemporaryDirectory(prefix="gaussiancad-") as folder:
        player = Player(sheet, Path(folder))
        try:
            first = player.play(steps[:1])
            before = _iou(first, truth)
            try:
                played = player.play(steps[1:])
            except (LookupError, TimeoutError):
                # The window no longer offers what was pressed, or is at work for too long.
                played = replace(first, status="stopped", solid=None)
            iou = _iou(played, truth)
        finally:
            player.close()
    return Corrected(
        name, before, played.status, played.gestures, played.operations, played.seconds, iou
    )


def _iou(played: Played, truth: Path) -> float:
    """Common volume by united volume of a part and the true one, at the part's size."""
    if played.solid is None:
        return 0.0
    part = read_shape(played.solid)
    return closeness_at_one_size(part, read_solid(truth))[0].iou


def _found(data: Path | None, only: Sequence[str]) -> Iterator[tuple[str, Path, Path, list[Step]]]:
    """Name, sheet, true part and recording of the sheets that are there."""
    for name, steps in recordings(RECORDINGS).items():
        is_of_tutorial = name.startswith("tutorial/")
        folder = ROOT / "docs" if is_of_tutorial else data
        if folder is None or not any(text in name for text in only):
            continue
        sheet = folder / name
        truth = (
            ROOT / "resources/samples/l-bracket.step"
            if is_of_tutorial
            else sheet.with_suffix(".step")
        )
        if sheet.is_file() and truth.is_file():
            yield name, sheet, truth, steps
        else:
            print(f"{name}: not there", file=sys.stderr)
