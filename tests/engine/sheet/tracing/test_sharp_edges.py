"""Lines along the pixels are placed between their edges, where these are sharp."""

import cv2
import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.image.clean_ink import CleanSheet
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.tracing.ink_shapes import refit_line
from gaussiancad_core.sheet.tracing.sharp_edges import between_edges

WIDTHS = (2.0, 2.3, 2.5, 3.0, 3.7)


def _sheet(at: float, width: float, *, upright: bool, blur: float = 0.0) -> CleanSheet:
    """One line across a small sheet; px whose centres are at integers."""
    pixels = np.arange(60)
    low, high = at - width / 2.0, at + width / 2.0
    covered = np.minimum(pixels + 0.5, high) - np.maximum(pixels - 0.5, low)
    weight = np.tile(np.clip(covered, 0.0, 1.0)[:, None], (1, 60)).astype(np.float32)
    if upright:
        weight = np.ascontiguousarray(weight.T)
    if blur:
        weight = cv2.GaussianBlur(weight, (0, 0), blur)
    return CleanSheet(weight > 0.5, weight, width, Turn(0.0, (30.0, 30.0)))


def _line(at: float, way: float, *, upright: bool) -> Line:
    return Line((at, 5.0), (0.0, way)) if upright else Line((5.0, at), (way, 0.0))


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("upright", [False, True])
def test_a_line_lies_between_its_edges(width: float, way: float, upright: bool) -> None:
    for at in np.arange(30.0, 31.0, 0.05):
        sheet = _sheet(float(at), width, upright=upright)
        start = _line(float(at) + 0.2, way, upright=upright)
        span = sorted((0.0, 45.0 * way))
        found = refit_line(sheet, start, [(span[0], span[1])])
        assert found.point[0 if upright else 1] == pytest.approx(at, abs=1e-3)


def test_dashes_and_lines_that_lean() -> None:
    at, along = 30.3, np.arange(0.0, 41.0)
    sheet = _sheet(at, 2.5, upright=False)
    line = _line(at + 0.05, 1.0, upright=False)
    assert between_edges(sheet, line, along).point[1] == pytest.approx(at, abs=1e-6)
    sheet.weight[:, 20:26] = 0.0
    sheet.weight[:, 19] *= 0.5
    dashes = np.concatenate([np.arange(0.0, 15.0), np.arange(21.0, 41.0)])
    assert between_edges(sheet, line, dashes).point[1] == pytest.approx(at, abs=1e-6)
    leaning = Line(line.point, (np.cos(0.01), np.sin(0.01)))
    assert between_edges(sheet, leaning, along) == leaning


def test_blurred_ink_is_centred_as_it_is() -> None:
    """As on scans: what leaves a pixel on one side is in the next one."""
    along = np.arange(0.0, 41.0)
    sheet = _sheet(30.3, 2.5, upright=False, blur=0.8)
    line = _line(30.35, 1.0, upright=False)
    assert between_edges(sheet, line, along) == line
