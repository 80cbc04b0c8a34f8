"""Sheets as other programs draw them."""

from dataclasses import replace
from pathlib import Path

import pytest
from exact_inputs import ROLES, read_input
from exact_measures import closeness
from foreign_sheets import Conventions, foreign_sheet

from gaussiancad_core.axes import Axis, Projection
from gaussiancad_core.drawing.brep import moved_to_origin
from gaussiancad_core.drawing.sheet import part_lines
from gaussiancad_core.modes import Status
from gaussiancad_core.samples import sample
from gaussiancad_core.solid.exact import exact_solid


def test_each_seed_is_a_program_of_its_own() -> None:
    programs = [Conventions.drawn_by_lot(seed) for seed in range(20)]
    assert programs == [Conventions.drawn_by_lot(seed) for seed in range(20)]
    assert len(set(programs)) == 20


@pytest.mark.parametrize("grey", [0, 140])
def test_a_sheet_of_another_program_is_verified(grey: int, tmp_path: Path) -> None:
    solid = sample("pocket-block").build()
    how = replace(Conventions.drawn_by_lot(3), grey=grey, width=1600, height=1200)
    path = tmp_path / "sheet.png"
    lines = part_lines(solid, ROLES)
    path.write_bytes(foreign_sheet(lines, how))
    read = read_input(path, (Axis.X, float(lines.size[0])), projection=Projection.THIRD)
    found = exact_solid(read.views)
    assert found.status is Status.VERIFIED
    assert found.shape is not None
    assert closeness(found.shape, moved_to_origin(solid)).exact
