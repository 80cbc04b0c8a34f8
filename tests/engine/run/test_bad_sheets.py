"""A sheet on which a line is missing: the run says which, and where, and marks it."""

import json
from pathlib import Path

import cv2
import numpy as np

from gaussiancad_core.cli import main
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.model.axes import Projection, Role
from sample_parts import SAMPLES

_YELLOW = (66, 228, 240)
"""Of OpenCV: blue, green, red."""


def test_a_missing_line_is_named_boxed_and_marked(tmp_path: Path) -> None:
    part = next(sample for sample in SAMPLES if sample.name == "l-bracket")
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    drawn = draw_sheet(part.build(), roles, Projection.THIRD, parse_style("clean"))
    image = drawn.image.copy()
    x0, y0, x1, y1 = drawn[Role.TOP].box
    per_mm = (x1 - x0) / 80.0
    # The lower side of the bore in the wall: 14 mm long, 18 mm above the front.
    left, right, height = x0, x0 + 14.0 * per_mm, y1 - 18.0 * per_mm
    rows = slice(round(height) - 6, round(height) + 7)
    image[rows, round(left) + 5 : round(right) - 4] = 255
    write_image(image, tmp_path / "sheet.png")
    output = tmp_path / "model"
    words = ["reconstruct", str(tmp_path / "sheet.png"), "--output", str(output)]
    options = ["--projection", "third", "--length", "x=80", "--result", "solid"]
    assert main([*words, *options]) == 0
    report = json.loads((output / "report.json").read_text())
    assert report["status"] == "approximate"
    stated = {reason["code"]: reason["message"] for reason in report["reasons"]}
    assert "a hidden line is missing in the top view" in stated["lines-contradict"]
    suspect = report["conflict"][0]
    assert (suspect["view"], suspect["drawn"], suspect["fitting"]) == ("top", None, "hidden")
    assert np.allclose(suspect["box"], [left, height, right, height], atol=8.0)
    overlay = cv2.imread(str(output / "overlay.png"))
    yellow = (overlay == _YELLOW).all(axis=2)
    middle = round((left + right) / 2.0)
    assert yellow[rows, middle].any()
    # Nothing else of that view is marked.
    yellow[round(height) - 12 : round(height) + 13, round(left) - 12 : round(right) + 13] = False
    assert not yellow[round(y0) : round(y1), round(x0) : round(x1)].any()
