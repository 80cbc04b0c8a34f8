"""Pens of a coloured picture, and which of them draws the part."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.cli import main
from gaussiancad_core.drawing.raster import rasterise
from gaussiancad_core.drawing.sheet import draw_sheet
from gaussiancad_core.drawing.style import parse_style
from gaussiancad_core.samples import sample
from gaussiancad_core.sheet.colour_pens import colour_pens
from gaussiancad_core.sheet.files.raster import read_raster

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)

Rgb = tuple[int, int, int]


def _read(rgb: np.ndarray, folder: Path, name: str = "sheet.png", **options: int) -> tuple:
    Image.fromarray(rgb).save(folder / name, **options)
    content = read_raster(folder / name, 1)
    return content.grey, content.tint


def _sheet(part: Rgb, dimension: Rgb) -> np.ndarray:
    """A closed outline with a hole, and a dimension line that crosses it, in two pens."""
    rgb = np.full((500, 700, 3), 255, np.uint8)
    cv2.rectangle(rgb, (100, 100), (400, 350), part, 2, cv2.LINE_AA)
    cv2.circle(rgb, (250, 220), 60, part, 2, cv2.LINE_AA)
    cv2.line(rgb, (60, 220), (640, 220), dimension, 2, cv2.LINE_AA)
    cv2.line(rgb, (250, 40), (250, 460), dimension, 2, cv2.LINE_AA)
    return rgb


@settings(max_examples=20, deadline=None)
@given(
    pens=st.permutations(
        [(0, 0, 0), (0, 90, 255), (230, 0, 20), (0, 160, 40), (160, 0, 200), (90, 90, 90)]
    )
)
def test_the_pen_that_encloses_draws_the_part_whatever_its_colour(
    pens: list[Rgb], tmp_path_factory: pytest.TempPathFactory
) -> None:
    part, dimension = pens[:2]
    folder = tmp_path_factory.mktemp("pens")
    grey, tint = _read(_sheet(part, dimension), folder)
    alone, _ = _read(_sheet(part, (255, 255, 255)), folder, "alone.png")
    if {part, dimension} <= {(0, 0, 0), (90, 90, 90)}:
        # Ink without colour is one pen.
        assert tint is None
        return
    found = colour_pens(grey, tint)
    ink, true = found.part < 200, alone < 200
    # Where they cross a little of the other pen stays.
    assert (ink & ~true).sum() < 0.05 * true.sum()
    # The other pen hides it where they cross: it is led through there.
    whole = _sheet(part, part) < 200
    assert (true & ~ink).sum() < 0.02 * true.sum() and whole.any()
    contours, _ = cv2.findContours(ink.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    assert max(cv2.contourArea(own) for own in contours) > 0.98 * 300 * 250


def test_shaded_areas_are_no_strokes(tmp_path: Path) -> None:
    rgb = _sheet((0, 0, 0), (0, 90, 255))
    cv2.rectangle(rgb, (480, 300), (650, 450), (120, 220, 180), cv2.FILLED)
    cv2.rectangle(rgb, (480, 300), (650, 450), (0, 0, 0), 2)
    found = colour_pens(*_read(rgb, tmp_path))
    assert found.part[280:470, 460:670].min() > 200
    assert found.part[95:360, 95:405].min() < 50


def test_a_sheet_of_one_pen_or_without_colour_is_left_as_it_is(tmp_path: Path) -> None:
    grey, tint = _read(_sheet((0, 0, 0), (80, 80, 80)), tmp_path)
    assert tint is None
    grey, tint = _read(_sheet((0, 0, 200), (0, 0, 200)), tmp_path)
    assert tint is not None and colour_pens(grey, tint) is None


@pytest.mark.parametrize(("name", "options"), [("s.png", {}), ("s.jpg", {"quality": 90})])
def test_a_coloured_sheet_becomes_the_same_solid_as_the_part_alone(
    name: str, options: dict[str, int], tmp_path: Path
) -> None:
    shape = sample("l-bracket").build()
    style = parse_style("dimensioned")
    drawn = draw_sheet(shape, ROLES, Projection.THIRD, style)
    grey = np.asarray(Image.fromarray(drawn.image).convert("L"))
    own = rasterise(tuple(stroke for view in drawn.views for stroke in view.strokes), style)
    rgb = np.repeat(grey[..., None], 3, axis=2)
    # Light that blue ink takes of red and green, and not of blue.
    beside = own <= 0.0
    rgb[..., 2] = np.where(beside, 255, rgb[..., 2])
    assert 0.001 < (beside & (grey < 100)).mean() < 0.1
    Image.fromarray(rgb).save(tmp_path / name, **options)
    output = tmp_path / "out"
    words = ["reconstruct", str(tmp_path / name), "--output", str(output), "--result", "solid"]
    assert main([*words, "--length", "x=80"]) == 0
    report = json.loads((output / "report.json").read_text("utf-8"))
    assert report["status"] == "verified", report["reasons"]
    assert report["solid"]["volume_mm3"] == pytest.approx(_volume(shape), rel=2e-3)


def _volume(shape: object) -> float:
    from gaussiancad_core.drawing.brep import volume

    return volume(shape)
