"""What do the sample sheets that ship with the product look like?

Writes ``resources/samples/<name>.png`` (front, top, right in third angle, 1920 x 1080) and
``<name>.step`` for three of the parts of :mod:`gaussiancad_core.samples`.
"""

import argparse
from pathlib import Path

from benchmarks.run.checkout import SAMPLES
from benchmarks.run.outcome import Outcome
from benchmarks.sheets.clean_sheets import ROLES
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.samples import sample

MINUTES = 0.5

SHIPPED = ("l-bracket", "boss-plate", "wedge-block")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("folder", nargs="?", type=Path, default=SAMPLES)


def run(options: argparse.Namespace) -> Outcome:
    """Write the sheets and solids."""
    folder: Path = options.folder
    folder.mkdir(parents=True, exist_ok=True)
    for name in SHIPPED:
        solid = sample(name).build()
        sheet = draw_sheet(solid, ROLES, Projection.THIRD, PRESETS["clean"])
        write_image(sheet.image, folder / f"{name}.png")
        write_step(solid, folder / f"{name}.step")
    return Outcome()
