"""Seconds per stage and peak memory of whole ``gaussiancad reconstruct`` processes.

Every sample part is drawn once and reconstructed by a process of its own, one after the other; the
figures are those of its report, and of the whole process by the clock.

    .venv/bin/python benchmarks/stages.py [--preset standard] [--samples NAME ...]
"""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.run.pipeline import STAGES
from gaussiancad_core.samples import SAMPLES, SamplePart


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--preset", default="standard")
    parser.add_argument("--samples", nargs="*", default=[])
    options = parser.parse_args()
    chosen = [s for s in SAMPLES if not options.samples or s.name in options.samples]
    names = (*STAGES, "process", "MB")
    print(f"preset {options.preset}")
    print(f"{'sample':20}" + "".join(f"{name:>10}" for name in names))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for sample in chosen:
            rows.append(_run(sample, options.preset, Path(folder)))
            _print_row(sample.name, rows[-1])
    _print_row("median", list(np.median(rows, axis=0)))
    _print_row("most", list(np.max(rows, axis=0)))


def _print_row(name: str, row: list[float]) -> None:
    print(f"{name:20}" + "".join(f"{value:10.2f}" for value in row), flush=True)


def _run(sample: SamplePart, preset: str, folder: Path) -> list[float]:
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    drawn = draw_sheet(sample.build(), roles, Projection.THIRD, parse_style("clean"))
    sheet, output = folder / f"{sample.name}.png", folder / sample.name
    write_image(drawn.image, sheet)
    command = [sys.executable, "-I", "-m", "gaussiancad_core", "reconstruct", str(sheet)]
    started = time.monotonic()
    subprocess.run(
        [*command, "--output", str(output), "--preset", preset], check=True, capture_output=True
    )
    elapsed = time.monotonic() - started
    report = json.loads((output / "report.json").read_text(encoding="utf-8"))
    return [*(report["seconds"][name] for name in STAGES), elapsed, report["peak_memory_mb"]]


if __name__ == "__main__":
    main()
