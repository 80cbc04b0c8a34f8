"""Sheets as other programs draw them."""

from dataclasses import replace
from pathlib import Path

import pytest

from benchmarks.judge.exact_measures import closeness
from benchmarks.sheets.clean_sheets import ROLES
from benchmarks.sheets.exact_inputs import read_input
from benchmarks.sheets.foreign_sheets import Conventions, foreign_sheet
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import part_lines
from gaussiancad_core.kernel.brep import moved_to_origin
from gaussiancad_core.model.axes import Axis, Projection
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_protocol.modes import Status
from sample_parts import sample


def test_each_seed_is_a_program_of_its_own() -> None:
    programs = [Conventions.drawn_by_lot(seed) for seed in range(20)]
    assert programs == [Conventions.drawn_by_lot(seed) for seed in range(20)]
    assert len(set(programs)) == 20


@pytest.mark.parametrize(("grey", "width"), [(0, 1400), (140, 2800)])
def test_a_sheet_of_another_program_is_exact(grey: int, width: int, tmp_path: Path) -> None:
    """With grey hidden lines, at the pixels at which it is read, a line lies beside its place."""
    solid = sample("pocket-block").build()
    how = replace(Conventions.drawn_by_lot(3), grey=grey, width=width, height=width * 3 // 4)
    path = tmp_path / "sheet.png"
    lines = part_lines(solid, ROLES)
    write_image(foreign_sheet(lines, how).image, path)
    read = read_input(path, (Axis.X, float(lines.size[0])))
    found = exact_solid(read.views)
    assert found.status is Status.VERIFIED or grey
    assert found.shape is not None
    assert closeness(found.shape, moved_to_origin(solid)).exact


@pytest.mark.parametrize("projection", Projection)
@pytest.mark.parametrize("dimensioned", [False, True])
def test_views_stand_as_drawn_and_apart(dimensioned: bool, projection: Projection) -> None:
    lines = part_lines(sample("pocket-block").build(), ROLES)
    how = Conventions.drawn_by_lot(3, dimensioned=dimensioned)
    sheet = foreign_sheet(lines, how, projection)
    assert sheet.image.shape == (how.height, how.width, 3)
    front, top, right = (sheet[role].box for role in ROLES)
    assert (front[0], front[2]) == pytest.approx((top[0], top[2]))
    assert (front[1], front[3]) == pytest.approx((right[1], right[3]))
    third = projection is Projection.THIRD
    assert (top[3] < front[1]) is third
    assert (right[0] > front[2]) is third


def test_dimensions_are_drawn_around_the_views() -> None:
    lines = part_lines(sample("pocket-block").build(), ROLES)
    how = Conventions.drawn_by_lot(3, dimensioned=True)
    with_them = foreign_sheet(lines, how)
    without = foreign_sheet(lines, replace(how, dimensions=None))
    assert with_them.mm_per_pixel > without.mm_per_pixel
    for view in with_them.views:
        x0, y0, x1, y1 = (round(value) for value in view.box)
        ink = with_them.image[..., 0] < 128
        neighbour = ink[y0 - 100 : y1 + 100, x0 - 100 : x1 + 100].sum()
        assert neighbour > 1.3 * ink[y0 - 4 : y1 + 4, x0 - 4 : x1 + 4].sum()
