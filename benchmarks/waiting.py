"""What a user waits for: seconds to the solid and to the end of ``gaussiancad reconstruct``.

Sample parts are drawn once, and reconstructed by processes of their own, one at a time.  With
several engines, each the Python of another installation, every sample goes through all of them
before the next one, so that a busy machine is busy for all.  An engine without the event ``solid``
has its solid when it ends.  ``missing`` are the seconds until a sheet that does not exist is told.
With ``--processor`` they are seconds of processor time, which is what counts on a busy machine.

    .venv/bin/python benchmarks/waiting.py [--samples NAME ...] [--repeat 3] [--result both]
    .venv/bin/python benchmarks/waiting.py --engines before=OTHER/bin/python after=.venv/bin/python
"""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import psutil

from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.samples import SAMPLES

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)


@dataclass(frozen=True)
class Wait:
    """Seconds by the clock, or of processor time.

    Attributes:
        solid: until the solid is told, or the run ends.
        end: until the run ends.
    """

    solid: float
    end: float


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--samples", nargs="*", default=[])
    parser.add_argument("--engines", nargs="*", default=[f"this={sys.executable}"])
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--result", default="both")
    parser.add_argument("--processor", action="store_true")
    options = parser.parse_args()
    engines = dict(pair.split("=", 1) for pair in options.engines)
    waits: dict[str, dict[str, list[Wait]]] = {name: defaultdict(list) for name in engines}
    print(f"{'sample':20}" + "".join(f"{name + ' solid':>16}{'end':>8}" for name in engines))
    with tempfile.TemporaryDirectory() as folder:
        sheets = dict(_drawn(options.samples, Path(folder)))
        for sample, sheet in sheets.items():
            for _ in range(options.repeat):
                for name, python in engines.items():
                    waits[name][sample].append(waited(python, sheet, Path(folder) / name, options))
            _print_row(sample, [_median(waits[name][sample]) for name in engines])
        _print_row("median", [_median_of_all(waits[name]) for name in engines])
        gone = Path(folder) / "missing.png"
        told = {name: [] for name in engines}
        for _ in range(options.repeat):
            for name, python in engines.items():
                told[name].append(waited(python, gone, Path(folder) / name, options))
        _print_row("missing", [_median(told[name]) for name in engines])


def waited(python: str, sheet: Path, output: Path, options: argparse.Namespace) -> Wait:
    """Reconstruct a sheet in a process of its own."""
    command = [python, "-I", "-m", "gaussiancad_core", "reconstruct", str(sheet), "--events"]
    started = time.monotonic()
    process = subprocess.Popen(
        [*command, "--output", str(output), "--result", options.result],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        encoding="utf-8",
    )
    watched = psutil.Process(process.pid)
    solid, end = None, 0.0
    # Standard input stays open: its end would stop the run.
    for line in process.stdout:
        # A process that has ended tells no processor time: the last event is taken for the end.
        end = sum(watched.cpu_times()[:2]) if options.processor else time.monotonic() - started
        if json.loads(line)["event"] == "solid":
            solid = end
    process.wait()
    return Wait(end if solid is None else solid, end)


def _drawn(names: list[str], folder: Path) -> list[tuple[str, Path]]:
    found = []
    for sample in SAMPLES:
        if not names or sample.name in names:
            sheet = draw_sheet(sample.build(), ROLES, Projection.THIRD, parse_style("clean"))
            path = folder / f"{sample.name}.png"
            write_image(sheet.image, path)
            found.append((sample.name, path))
    return found


def _median(waits: list[Wait]) -> Wait:
    return Wait(
        float(np.median([own.solid for own in waits])), float(np.median([own.end for own in waits]))
    )


def _median_of_all(samples: dict[str, list[Wait]]) -> Wait:
    return _median([_median(own) for own in samples.values()])


def _print_row(name: str, waits: list[Wait]) -> None:
    print(f"{name:20}" + "".join(f"{own.solid:16.1f}{own.end:8.1f}" for own in waits), flush=True)


if __name__ == "__main__":
    main()
