"""Make the sample sheets that ship with the product.

    .venv/bin/python scripts/sample_sheets.py [FOLDER]

Writes ``<name>.png`` (front, top, right in third angle, 1920 x 1080) and ``<name>.step`` for three
of the parts of ``sample_parts``; into ``resources/samples`` if no folder is named.
"""

import sys
from pathlib import Path

from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.axes import Projection, Role

ADDON = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ADDON))

from sample_parts import sample  # noqa: E402

SAMPLES = ADDON / "resources" / "samples"
SHIPPED = ("l-bracket", "boss-plate", "wedge-block")
ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)


def write_samples(folder: Path) -> None:
    """Write the sheets and solids into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in SHIPPED:
        solid = sample(name).build()
        sheet = draw_sheet(solid, ROLES, Projection.THIRD, PRESETS["clean"])
        write_image(sheet.image, folder / f"{name}.png")
        write_step(solid, folder / f"{name}.step")


if __name__ == "__main__":
    write_samples(Path(sys.argv[1]) if sys.argv[1:] else SAMPLES)
