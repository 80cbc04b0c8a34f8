"""How long does a user of the command wait for the solid, and for the end?

Sample parts are drawn once, and reconstructed by processes of their own, one at a time.  With
several engines, each the Python of another installation, every sample goes through all of them
before the next one, so that a busy machine is busy for all.  An engine without the event ``solid``
has its solid when it ends.  ``missing`` are the seconds until a sheet that does not exist is told.
With ``--processor`` they are seconds of processor time, which is what counts on a busy machine.
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

from benchmarks.parts.named_parts import named_samples
from benchmarks.run.outcome import Figure, Outcome
from benchmarks.sheets.clean_sheets import draw_clean
from gaussiancad_core.errors import UsageError

MINUTES = 20


@dataclass(frozen=True)
class Wait:
    """Seconds by the clock, or of processor time.

    Attributes:
        solid: until the solid is told, or the run ends.
        end: until the run ends.
    """

    solid: float
    end: float


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--samples", nargs="*", default=[])
    parser.add_argument("--engines", nargs="*", default=[f"this={sys.executable}"])
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--result", default="both")
    parser.add_argument("--processor", action="store_true")


def run(options: argparse.Namespace) -> Outcome:
    """Print the table."""
    engines = dict(pair.split("=", 1) for pair in options.engines)
    waits: dict[str, dict[str, list[Wait]]] = {name: defaultdict(list) for name in engines}
    print(f"{'sample':20}" + "".join(f"{name + ' solid':>16}{'end':>8}" for name in engines))
    with tempfile.TemporaryDirectory() as folder:
        sheets = dict(_drawn(options.samples, Path(folder)))
        for part, sheet in sheets.items():
            for _ in range(options.repeat):
                for name, python in engines.items():
                    waits[name][part].append(waited(python, sheet, Path(folder) / name, options))
            _print_row(part, [_median(waits[name][part]) for name in engines])
        if not sheets:
            raise UsageError("unknown-sample", f"there is no sample {' '.join(options.samples)}")
        medians = [_median_of_all(waits[name]) for name in engines]
        _print_row("median", medians)
        gone = Path(folder) / "missing.png"
        missing: dict[str, list[Wait]] = {name: [] for name in engines}
        for _ in range(options.repeat):
            for name, python in engines.items():
                missing[name].append(waited(python, gone, Path(folder) / name, options))
        _print_row("missing", [_median(missing[name]) for name in engines])
    figures = (
        Figure(f"{name}: {what}", round(seconds, 1), "s")
        for name, wait in zip(engines, medians, strict=True)
        for what, seconds in (("to the solid", wait.solid), ("to the end", wait.end))
    )
    return Outcome(tuple(figures))


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
    return [
        (part.name, draw_clean(part.build(), folder / f"{part.name}.png"))
        for part in named_samples(names)
    ]


def _median(waits: list[Wait]) -> Wait:
    return Wait(
        float(np.median([wait.solid for wait in waits])),
        float(np.median([wait.end for wait in waits])),
    )


def _median_of_all(samples: dict[str, list[Wait]]) -> Wait:
    return _median([_median(sample) for sample in samples.values()])


def _print_row(name: str, waits: list[Wait]) -> None:
    print(
        f"{name:20}" + "".join(f"{wait.solid:16.1f}{wait.end:8.1f}" for wait in waits), flush=True
    )
