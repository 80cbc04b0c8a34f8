"""How many seconds does each stage of ``gaussiancad reconstruct`` take, and how much memory?

Every sample part is drawn once and reconstructed by a process of its own, one after the other; the
figures are those of its report, and of the whole process by the clock.
"""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from benchmarks.run.outcome import Figure, Outcome
from benchmarks.sheets.clean_sheets import draw_clean
from gaussiancad_core.errors import UsageError
from gaussiancad_core.run.pipeline import STAGES
from gaussiancad_core.samples import SAMPLES, SamplePart

MINUTES = 8


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--preset", default="standard")
    parser.add_argument("--samples", nargs="*", default=[])


def run(options: argparse.Namespace) -> Outcome:
    """Print the table."""
    chosen = [s for s in SAMPLES if not options.samples or s.name in options.samples]
    names = (*STAGES, "process", "MB")
    print(f"preset {options.preset}")
    print(f"{'sample':20}" + "".join(f"{name:>10}" for name in names))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for part in chosen:
            rows.append(_measured(part, options.preset, Path(folder)))
            _print_row(part.name, rows[-1])
    if not rows:
        raise UsageError("unknown-sample", f"there is no sample {' '.join(options.samples)}")
    middle, most = np.median(rows, axis=0), np.max(rows, axis=0)
    _print_row("median", list(middle))
    _print_row("most", list(most))
    figures = (
        Figure("median of the whole process", round(float(middle[-2]), 1), "s"),
        Figure("most of the whole process", round(float(most[-2]), 1), "s"),
        Figure("most memory", round(float(most[-1])), "MB"),
    )
    return Outcome(figures)


def _print_row(name: str, row: list[float]) -> None:
    print(f"{name:20}" + "".join(f"{value:10.2f}" for value in row), flush=True)


def _measured(part: SamplePart, preset: str, folder: Path) -> list[float]:
    sheet, output = draw_clean(part.build(), folder / f"{part.name}.png"), folder / part.name
    command = [sys.executable, "-I", "-m", "gaussiancad_core", "reconstruct", str(sheet)]
    started = time.monotonic()
    subprocess.run(
        [*command, "--output", str(output), "--preset", preset], check=True, capture_output=True
    )
    elapsed = time.monotonic() - started
    report = json.loads((output / "report.json").read_text(encoding="utf-8"))
    return [*(report["seconds"][name] for name in STAGES), elapsed, report["peak_memory_mb"]]
