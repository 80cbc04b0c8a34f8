"""What becomes of a part whose sheet is photographed at a slant?

Sheets of parts of all classes are drawn, laid on a table and photographed by a camera of chance:
tilt, turn, focal length, distortion of its lens, light, blur, noise, JPEG.  Each photograph goes
through ``gaussiancad reconstruct``; the solid is compared with the part in place, both with a
longest edge of 1, as a photograph may tell no size.

``--flat`` does the same without a camera.  ``right`` has the part's faces and an IoU of .98 at
least; ``close`` that IoU; a photograph is never ``verified``.
"""

import argparse
import json
import tempfile
from collections import Counter
from pathlib import Path

import cv2
import numpy as np
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.gp import gp_Pnt, gp_Trsf
from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.exact_measures import fine_mesh, mesh_iou
from benchmarks.run.engine import part_of
from benchmarks.run.outcome import Outcome, share
from benchmarks.sheets.clean_sheets import ROLES
from benchmarks.sheets.photographed import camera_of, photograph
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.kernel.brep import bounding_box, faces_of, moved_to_origin
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.samples.classed import PartClass, classed_part

MINUTES = 3

STYLES = ("dimensioned", "clean", "ansi,annotations=true,frame=true")
"""Styles of the sheets, by turns."""

LIMIT_S = 240
"""Seconds that one sheet may take."""

CLOSE = 0.98
"""IoU from which a solid is the part, but for its measures."""


def judged(folder: Path, truth: TopoDS_Shape) -> tuple[str, float | None]:
    """What became of a part: a word, and the IoU of its solid."""
    report = json.loads((folder / "report.json").read_text())
    solid = folder / "solid.step"
    if report["status"] == "failed" or not solid.exists():
        return "no solid", None
    item = _of_size_one(read_solid(solid))
    iou = mesh_iou(fine_mesh(item), fine_mesh(_of_size_one(truth)))
    if iou is None or iou < CLOSE:
        return "wrong, verified" if report["status"] == "verified" else "other solid", iou
    return "right" if len(faces_of(item)) == len(faces_of(truth)) else "close", iou


def _of_size_one(shape: TopoDS_Shape) -> TopoDS_Shape:
    longest = float(np.ptp(bounding_box(shape), axis=0).max())
    scaling = gp_Trsf()
    scaling.SetScale(gp_Pnt(0.0, 0.0, 0.0), 1.0 / longest)
    return moved_to_origin(BRepBuilderAPI_Transform(shape, scaling, True).Shape())


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--parts", type=int, default=1, help="of each class")
    parser.add_argument("--first", type=int, default=0, help="seed of the first")
    parser.add_argument("--flat", action="store_true", help="the sheets as they were drawn")
    parser.add_argument("--keep", type=Path, help="folder for photographs and results")


def run(options: argparse.Namespace) -> Outcome:
    """Print a line for each photograph, and the counts."""
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
                word, iou = _verdict(path, root / path.stem, truth)
                counts[word] += 1
                taken = f"tilt {camera.tilt:4.1f}  f {camera.focal:.2f}  bend {camera.bend:+.4f}"
                closeness = "" if iou is None else f"IoU {iou:.3f}"
                print(f"{path.stem:28}{taken}  {word:12}{closeness}", flush=True)
    total = counts.total()
    return Outcome(tuple(share(word, count, total) for word, count in counts.most_common()))


def _verdict(path: Path, folder: Path, truth: TopoDS_Shape) -> tuple[str, float | None]:
    ended = part_of(path, folder, limit_s=LIMIT_S)
    if ended.exit_code is None:
        return "too long", None
    if ended.exit_code:
        return f"exit {ended.exit_code}: {ended.error}", None
    return judged(folder, truth)
