"""Draw the sample sheets that ship with the product.

Writes ``resources/samples/<name>.png`` (front, top, right in third angle, 1920 x 1080) and
``<name>.step`` for three of the parts of :mod:`gaussiancad_core.samples`.

    python benchmarks/make_samples.py [FOLDER]
"""

import sys
from pathlib import Path

from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.kernel.brep import write_step
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.samples import sample

SHIPPED = ("l-bracket", "boss-plate", "wedge-block")
ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)


def main(folder: Path) -> None:
    """Write the sheets and solids into ``folder``."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in SHIPPED:
        solid = sample(name).build()
        sheet = draw_sheet(solid, ROLES, Projection.THIRD, PRESETS["clean"])
        write_image(sheet.image, folder / f"{name}.png")
        write_step(solid, folder / f"{name}.step")


if __name__ == "__main__":
    default = Path(__file__).parent.parent / "resources" / "samples"
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else default)
