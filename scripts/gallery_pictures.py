"""Make the pictures at the head of the README: four sheets, and the solids that come of them.

    .venv/bin/python scripts/gallery_pictures.py [FOLDER [NAME...]]

``gallery-photograph.png`` has a sheet that was photographed at a slant, ``gallery.png`` a scan, a
sheet with a section, and a clean one.  Solids are drawn by the run itself; what is printed says
whether each has the faces of the part.  Where no folder is named they go to ``docs/images``; where
sheets are named, as ``scan``, the others are left out.
"""

import json
import sys
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import cv2
import numpy as np
from OCP.TopoDS import TopoDS_Shape
from photographed_sheet import Camera, Picture, photograph

import gaussiancad
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Projection, Role

ADDON = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ADDON))

from sample_parts.classed import PartClass, classed_part  # noqa: E402

IMAGES = ADDON / "docs" / "images"
SAMPLES = ADDON / "resources" / "samples"
ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)

CAMERA = Camera(tilt=17.0, focal=0.75, bend=0.0, surroundings=True)

WIDTH, HEIGHT = 760, 470
"""px of a sheet, or of a solid, in the gallery."""


@dataclass(frozen=True)
class Exhibit:
    """A sheet of the gallery.

    Attributes:
        name: of its files.
        part: what is drawn.
        style: of the sheet.
        seed: of its defects.
        camera: that takes it; None for the sheet itself.
    """

    name: str
    part: Callable[[], TopoDS_Shape]
    style: str
    seed: int = 0
    camera: Camera | None = None


EXHIBITS = (
    Exhibit(
        "photograph", partial(read_solid, SAMPLES / "boss-plate.step"), "dimensioned", 3, CAMERA
    ),
    Exhibit("scan", partial(read_solid, SAMPLES / "wedge-block.step"), "workshop", 4),
    Exhibit(
        "section", partial(read_solid, SAMPLES / "l-bracket.step"), "dimensioned,section=front", 4
    ),
    Exhibit("clean", partial(classed_part, PartClass.SLANTS, 2, 1), "ansi", 2),
)


def made(exhibit: Exhibit, folder: Path) -> tuple[Picture, Picture, str]:
    """The sheet, the solid made from it, and the verdict."""
    style = parse_style(exhibit.style)
    sheet = draw_sheet(exhibit.part(), ROLES, Projection.THIRD, style, exhibit.seed)
    picture = cv2.cvtColor(sheet.image, cv2.COLOR_RGB2BGR)
    if exhibit.camera is not None:
        grey = cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY)
        picture = photograph(grey, exhibit.camera, np.random.default_rng(exhibit.seed))
    path, results = folder / f"{exhibit.name}.png", folder / exhibit.name
    cv2.imwrite(str(path), picture)
    gaussiancad.reconstruct(path, result="solid").save(results)
    report = json.loads((results / "report.json").read_text())
    return picture, cv2.imread(str(results / "preview.png")), report["status"]


def side_by_side(sheet: Picture, solid: Picture) -> Picture:
    """Both in one row."""
    return np.hstack([_framed(sheet), _framed(solid)])


def _framed(picture: Picture) -> Picture:
    """A picture in the middle of white paper of the gallery's size."""
    factor = min((WIDTH - 16) / picture.shape[1], (HEIGHT - 16) / picture.shape[0])
    size = round(picture.shape[1] * factor), round(picture.shape[0] * factor)
    small = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    frame = np.full((HEIGHT, WIDTH, 3), 255, np.uint8)
    x, y = (WIDTH - size[0]) // 2, (HEIGHT - size[1]) // 2
    frame[y : y + size[1], x : x + size[0]] = small
    return frame


def main(folder: Path, names: Sequence[str] = ()) -> None:
    """Write both pictures into a folder, and print the verdicts."""
    rows: dict[str, list[Picture]] = {"gallery-photograph": [], "gallery": []}
    with tempfile.TemporaryDirectory() as temporary:
        for exhibit in (item for item in EXHIBITS if not names or item.name in names):
            sheet, solid, status = made(exhibit, Path(temporary))
            faces = len(faces_of(read_solid(Path(temporary) / exhibit.name / "solid.step")))
            true_faces = len(faces_of(exhibit.part()))
            print(f"{exhibit.name}: {status}, {faces} faces of {true_faces}", flush=True)
            rows["gallery" if exhibit.camera is None else "gallery-photograph"].append(
                side_by_side(sheet, solid)
            )
    for name, pictures in rows.items():
        if pictures:
            cv2.imwrite(str(folder / f"{name}.png"), np.vstack(pictures))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if sys.argv[1:] else IMAGES, sys.argv[2:])
