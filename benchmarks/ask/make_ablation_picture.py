"""What do median filters and line finders do to a noisy scan?

A noisy scan of a sample is read with median filters of 0, 3, 5 and 7 px, its lines found by ridges
and by the paper's Canny edges and Hough transforms.  Each field shows one view as it was read:
visible strokes green, hidden ones blue, missed points red, wrong ones magenta.
"""

import argparse
import tempfile
from itertools import chain
from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt

from benchmarks.judge.reading_found import Found, drawn_over, read
from benchmarks.judge.stroke_matching import Marks, match
from benchmarks.run.outcome import Outcome
from benchmarks.sheets.clean_sheets import ROLES
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.sheet_style import SheetStyle, parse_style
from gaussiancad_core.errors import GaussianCadError
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.samples import sample
from gaussiancad_core.sheet.reading_options import Finder, ReadingOptions

MINUTES = 5

KERNELS = (0, 3, 5, 7)
STYLE = "scan,visible-width=2,hidden-width=1.2,dash=5,gap=4,salt=0.02"
"""Thin lines, short dashes, and much noise: here filters matter."""

FIELD = 300
"""px, width of a field."""

LEVEL = 30
"""Step of the picture's colours."""


def field(sheet: Sheet, style: SheetStyle, path: Path, reading: ReadingOptions) -> npt.NDArray:
    """(h, w, 3) one view as it was read in one way, with its figures."""
    drawn = [stroke for view in sheet.views for stroke in view.strokes]
    found: Found | None = None
    try:
        found = read(path, reading)
        seen = list(chain.from_iterable(found.strokes.values()))
        lengths, _, marks = match(drawn, seen, 0.5 * style.visible_width)
        stated = [
            f"{kind.value} {lengths[kind].precision:.3f}/{lengths[kind].recall:.3f}"
            for kind in Linetype
        ]
    except GaussianCadError as error:
        marks, stated = Marks(), ["not read", error.code]
    picture = drawn_over(sheet.image, found, marks)
    x0, y0, x1, y1 = (round(2.0 * value) for value in sheet[Role.FRONT].box)
    shown = picture[y0 - 20 : y1 + 20, x0 - 20 : x1 + 20]
    scale = FIELD / shown.shape[1]
    shown = cv2.resize(shown, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
    name = f"{reading.finder.value}, median {reading.median_kernel or 'none'}"
    board = np.full((66, FIELD, 3), 255, np.uint8)
    for row, text in enumerate((name, *stated)):
        place = (10, 18 + 20 * row)
        cv2.putText(board, text, place, cv2.FONT_HERSHEY_SIMPLEX, 0.5, (0, 0, 0), 1, cv2.LINE_AA)
    return np.concatenate([board, shown])


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("picture", type=Path)
    parser.add_argument("--part", default="three-axis-block")
    parser.add_argument("--style", default=STYLE)


def run(options: argparse.Namespace) -> Outcome:
    """Write the picture."""
    style = parse_style(options.style)
    lines = part_lines(sample(options.part).build(), ROLES)
    sheet = compose_sheet(lines, Projection.THIRD, style)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "sheet.png"
        write_image(sheet.image, path, style.jpeg_quality, sheet.dpi)
        rows = [
            np.concatenate(
                [
                    field(sheet, style, path, ReadingOptions(median_kernel=kernel, finder=finder))
                    for kernel in KERNELS
                ],
                axis=1,
            )
            for finder in Finder
        ]
    # Few levels of grey keep the file small.
    write_image(np.concatenate(rows) // LEVEL * LEVEL + LEVEL // 2, options.picture)
    return Outcome()
