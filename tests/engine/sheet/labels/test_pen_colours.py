"""Which colour draws edges is learnt from sure lines, and told of the doubtful ones."""

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from gaussiancad_core.cli import main
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.kernel.brep import volume
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.line_decoding import LabelledRun
from gaussiancad_core.sheet.labels.pen_colours import ColourPens, learnt_colours
from gaussiancad_core.sheet.tracing.ink_runs import Run
from sample_parts import sample

RED, BLUE = 1, 121
ROWS = {20: (BLUE, 5.0), 40: (RED, -5.0), 60: (BLUE, 0.1), 80: (RED, 0.1), 100: (0, 0.1)}
"""Row of each line, its tint, and its margin."""


def _shape(row: int) -> InkedShape:
    return InkedShape(Line((0.0, float(row)), (1.0, 0.0)), (InkedRun(Run(10.0, 290.0), 3.0),))


def _labelled(row: int, margin: float) -> LabelledRun:
    ink = InkClass.VISIBLE if margin > 0.0 else InkClass.DIMENSION
    return LabelledRun(_shape(row).runs[0], ink, margin, np.zeros(len(InkClass)))


def _learnt(tints: dict[int, tuple[int, float]]) -> ColourPens | None:
    tint = np.zeros((120, 300), np.uint8)
    for row, (item, _) in tints.items():
        tint[row - 2 : row + 3] = item
    shapes = [_shape(row) for row in tints]
    labelled = [[_labelled(row, margin)] for row, (_, margin) in tints.items()]
    return learnt_colours(tint, shapes, labelled, 3.0)


def _odds(pens: ColourPens, row: int) -> float:
    shape = _shape(row)
    (odds,) = set(pens.odds(shape, shape.runs[0], np.zeros((9, len(InkClass)))).tolist())
    return odds


def test_a_doubtful_line_is_what_the_sure_ones_of_its_colour_are() -> None:
    pens = _learnt(ROWS)
    assert _odds(pens, 60) > 2.0
    assert _odds(pens, 80) < -2.0
    # Of ink without colour no line is sure.
    assert _odds(pens, 100) == 0.0


def test_a_colour_whose_sure_lines_are_of_both_kinds_tells_nothing() -> None:
    pens = _learnt({**ROWS, 60: (BLUE, -5.0)})
    assert _odds(pens, 20) == pytest.approx(0.0)


def test_one_colour_is_no_evidence() -> None:
    assert _learnt({row: (BLUE, margin) for row, (_, margin) in ROWS.items()}) is None


def test_red_on_both_sides_of_the_cut_of_the_circle_of_hues_is_one_pen() -> None:
    pens = _learnt({20: (2, 5.0), 40: (60, -5.0), 60: (179, 0.1)})
    assert _odds(pens, 60) > 2.0


def test_a_coloured_sheet_becomes_the_same_solid_as_the_part_alone(tmp_path: Path) -> None:
    shape = sample("l-bracket").build()
    style = parse_style("dimensioned")
    drawn = draw_sheet(shape, (Role.FRONT, Role.TOP, Role.RIGHT), Projection.THIRD, style)
    grey = np.asarray(Image.fromarray(drawn.image).convert("L"))
    part = rasterise(tuple(stroke for view in drawn.views for stroke in view.strokes), style)
    rgb = np.repeat(grey[..., None], 3, axis=2)
    # Blue ink takes the red and the green of the light, and not the blue.
    rgb[..., 2] = np.where(part <= 0.0, 255, rgb[..., 2])
    Image.fromarray(rgb).save(tmp_path / "s.jpg", quality=90)
    words = ["reconstruct", str(tmp_path / "s.jpg"), "--output", str(tmp_path / "out")]
    assert main([*words, "--result", "solid", "--length", "x=80"]) == 0
    report = json.loads((tmp_path / "out" / "report.json").read_text("utf-8"))
    assert report["status"] == "verified", report["reasons"]
    assert report["solid"]["volume_mm3"] == pytest.approx(volume(shape), rel=2e-3)
