"""Photographs of sheets, taken at a slant: what becomes of the part.

Sheets of parts of all classes are drawn, laid on a table and photographed by a camera of chance:
tilt, turn, focal length, distortion of its lens, light, blur, noise, JPEG.  Each photograph goes
through ``gaussiancad reconstruct``; the solid is compared with the part in place, both with a
longest edge of 1, as a photograph may tell no size.

    .venv/bin/python benchmarks/photographs.py [--parts 1] [--first 0] [--flat] [--keep DIR]

``--flat`` does the same without a camera.  ``right`` has the part's faces and an IoU of .98 at
least; ``close`` that IoU; a photograph is never ``verified``.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt
from exact_measures import fine_mesh, mesh_iou
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.gp import gp_Pnt, gp_Trsf
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.kernel.brep import bounding_box, faces_of, moved_to_origin, read_solid
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.samples.classed import PartClass, classed_part

STYLES = ("dimensioned", "clean", "ansi,annotations=true,frame=true")
"""Styles of the sheets, by turns."""

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)

LIMIT_S = 240
"""Seconds that one sheet may take."""

CLOSE = 0.98
"""IoU from which a solid is the part, but for its measures."""

Picture = npt.NDArray[np.uint8]


@dataclass(frozen=True)
class Camera:
    """How a sheet is photographed.

    Attributes:
        tilt: degrees from straight above.
        focal: focal length, in the longer side of the picture.
        bend: radial distortion, share at the picture's corners.
        surroundings: whether there is a dark table around the paper.
    """

    tilt: float
    focal: float
    bend: float
    surroundings: bool


def camera_of(random: np.random.Generator) -> Camera:
    """A camera of chance, in a hand."""
    return Camera(
        float(random.uniform(2.0, 25.0)),
        float(random.uniform(0.65, 0.9)),
        float(random.uniform(-0.004, 0.004)),
        bool(random.random() < 0.75),
    )


def photograph(sheet: Picture, camera: Camera, random: np.random.Generator) -> Picture:
    """(h, w, 3) uint8 BGR a picture of a sheet on a table.

    Args:
        sheet: (h, w) uint8.
        camera: that takes it.
        random: of light, noise, and the way in which the camera is tilted and turned.
    """
    height, width = sheet.shape
    size = (round(1.5 * max(sheet.shape)), round(1.125 * max(sheet.shape)))
    focal = camera.focal * size[0]
    way, turn = random.uniform(0.0, 2.0 * np.pi), np.radians(random.uniform(-5.0, 5.0))
    tilt = np.radians(camera.tilt) * np.array([np.cos(way), np.sin(way), 0.0])
    rotation = cv2.Rodrigues(tilt)[0] @ cv2.Rodrigues(np.array([0.0, 0.0, turn]))[0]
    middle = np.array([width, height]) / 2
    rim = np.array([[0, 0], [width, 0], [width, height], [0, height]]) - middle
    seen, distance = rim, 0.3 * focal
    while np.abs(seen / (np.array(size) / 2)).max() > 0.93 or distance == 0.3 * focal:
        distance *= 1.02
        places = np.column_stack([rim, np.zeros(4)]) @ rotation.T + [0.0, 0.0, distance]
        if (places[:, 2] > 0.1 * focal).all():
            seen = focal * places[:, :2] / places[:, 2:]
    homography = cv2.getPerspectiveTransform(
        (rim + middle).astype(np.float32),
        (seen + np.array(size) / 2).astype(np.float32),
    )
    paper = cv2.warpPerspective(np.full_like(sheet, 255), homography, size, borderValue=0)
    picture = cv2.warpPerspective(sheet, homography, size, flags=cv2.INTER_AREA, borderValue=255)
    share = (paper / 255.0)[..., None]
    table = np.full((size[1], size[0], 3), 255.0)
    if camera.surroundings:
        grain = random.normal(0.0, 1.0, (size[1] // 40 + 2, size[0] // 8 + 2))
        wood = cv2.resize(grain, size, interpolation=cv2.INTER_CUBIC)[..., None]
        table = random.uniform(30.0, 130.0, 3) * (1.0 + 0.12 * wood)
    coloured = picture[..., None] * share + table * (1.0 - share)
    coloured = _bent(coloured, camera.bend)
    y, x = np.mgrid[0 : size[1], 0 : size[0]] / size[0] - 0.5
    side = random.uniform(0.0, 2.0 * np.pi)
    light = 0.8 + random.uniform(0.0, 0.35) * (x * np.cos(side) + y * np.sin(side))
    lit = coloured * light[..., None] * random.uniform(0.9, 1.0, 3)
    blurred = cv2.GaussianBlur(lit, (0, 0), random.uniform(0.5, 1.1))
    noisy = blurred + random.normal(0.0, random.uniform(1.0, 5.0), blurred.shape)
    return np.clip(noisy, 0.0, 255.0).astype(np.uint8)


def _bent(picture: npt.NDArray[np.float64], bend: float) -> npt.NDArray[np.float64]:
    """A picture as a lens with radial distortion gives it."""
    height, width = picture.shape[:2]
    y, x = np.mgrid[0:height, 0:width].astype(np.float32)
    dx, dy = x - width / 2, y - height / 2
    factor = 1.0 + bend * (dx**2 + dy**2) / ((width / 2) ** 2 + (height / 2) ** 2)
    places = (width / 2 + dx * factor, height / 2 + dy * factor)
    return cv2.remap(
        picture,
        *(own.astype(np.float32) for own in places),
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )


def judged(folder: Path, truth: TopoDS_Shape) -> tuple[str, float | None]:
    """What became of a part: a word, and the IoU of its solid."""
    report = json.loads((folder / "report.json").read_text())
    solid = folder / "solid.step"
    if report["status"] == "failed" or not solid.exists():
        return "no solid", None
    own = _of_size_one(read_solid(solid))
    iou = mesh_iou(fine_mesh(own), fine_mesh(_of_size_one(truth)))
    if iou is None or iou < CLOSE:
        return "wrong, verified" if report["status"] == "verified" else "other solid", iou
    return "right" if len(faces_of(own)) == len(faces_of(truth)) else "close", iou


def _of_size_one(shape: TopoDS_Shape) -> TopoDS_Shape:
    longest = float(np.ptp(bounding_box(shape), axis=0).max())
    scaling = gp_Trsf()
    scaling.SetScale(gp_Pnt(0.0, 0.0, 0.0), 1.0 / longest)
    return moved_to_origin(BRepBuilderAPI_Transform(shape, scaling, True).Shape())


def main() -> None:
    """Print a line for each photograph, and the counts."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--parts", type=int, default=1, help="of each class")
    parser.add_argument("--first", type=int, default=0, help="seed of the first")
    parser.add_argument("--flat", action="store_true", help="the sheets as they were drawn")
    parser.add_argument("--keep", type=Path, help="folder for photographs and results")
    options = parser.parse_args()
    counts: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as temporary:
        root = options.keep or Path(temporary)
        root.mkdir(parents=True, exist_ok=True)
        for seed in range(options.first, options.first + options.parts):
            for number, kind in enumerate(PartClass):
                random = np.random.default_rng([seed, number])
                truth = moved_to_origin(classed_part(kind, seed, seed % 3))
                style = parse_style(STYLES[(seed + number) % len(STYLES)])
                sheet = draw_sheet(truth, ROLES, Projection.THIRD, style, seed)
                camera = camera_of(random)
                grey = cv2.cvtColor(sheet.image, cv2.COLOR_RGB2GRAY)
                path = root / f"{kind.value}-{seed}.jpg"
                picture = grey if options.flat else photograph(grey, camera, random)
                cv2.imwrite(str(path), picture)
                folder = root / path.stem
                word, iou = _run(path, folder, truth)
                counts[word] += 1
                told = f"tilt {camera.tilt:4.1f}  f {camera.focal:.2f}  bend {camera.bend:+.4f}"
                closeness = "" if iou is None else f"IoU {iou:.3f}"
                print(f"{path.stem:28}{told}  {word:12}{closeness}", flush=True)
    print(", ".join(f"{count} {word}" for word, count in counts.most_common()))


def _run(path: Path, folder: Path, truth: TopoDS_Shape) -> tuple[str, float | None]:
    command = [sys.executable, "-m", "gaussiancad_core", "reconstruct", str(path)]
    command += ["--output", str(folder), "--result", "solid"]
    try:
        ended = subprocess.run(
            command, capture_output=True, text=True, timeout=LIMIT_S, check=False
        )
    except subprocess.TimeoutExpired:
        return "too long", None
    if ended.returncode != 0:
        line = ended.stderr.strip().splitlines()[-1:] or [""]
        return f"exit {ended.returncode}: {line[0].rpartition('[')[2].rstrip(']')}", None
    return judged(folder, truth)


if __name__ == "__main__":
    main()
