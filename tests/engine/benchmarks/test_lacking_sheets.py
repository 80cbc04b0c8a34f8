"""Exact drawings of a part, and what they are made to lack."""

from pathlib import Path
from random import Random

import ezdxf
import numpy as np
import pytest

from benchmarks.sheets.dxf_sheets import write_dxf
from benchmarks.sheets.lacking_sheets import Drawing, Lack, drawn_lacking
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.views import Linetype
from sample_parts.modelling import box, cut, cylinder

_PART = cut(
    box((0.0, 0.0, 0.0), (61.3, 40.0, 30.0)),
    box((40.0, -1.0, 18.0), (62.0, 41.0, 31.0)),
    cylinder(Axis.Z, (15.0, 12.0), 5.0, -1.0, 31.0),
)


def _drawn(lack: Lack) -> Drawing:
    return drawn_lacking(_PART, lack, Random(3))


def _all(drawing: Drawing) -> list[tuple[Role, DrawnStroke]]:
    return [(role, each) for role, row in drawing.lines.views.items() for each in row]


def test_without_hidden_lines_nothing_else_lacks() -> None:
    whole = [pair for pair in _all(_drawn(Lack.NOTHING)) if pair[1].linetype is Linetype.VISIBLE]
    assert _all(_drawn(Lack.HIDDEN)) == whole


def test_three_strokes_are_lost_and_one_has_the_other_linetype() -> None:
    whole, less = _all(_drawn(Lack.NOTHING)), _all(_drawn(Lack.STROKES))
    assert len(less) == len(whole) - 3
    assert sum(pair not in whole for pair in less) == 1


def test_rounded_places_are_on_a_grid() -> None:
    drawing = _drawn(Lack.DIGITS)
    grid = 1e-4 * drawing.lines.size.max()
    for (_, each), (_, exact) in zip(_all(drawing), _all(_drawn(Lack.NOTHING)), strict=True):
        points, places = each.sample(1e9), exact.sample(1e9)
        assert np.abs(points - places).max() <= grid
        if len(points) == 2:
            assert points / grid == pytest.approx(np.round(points / grid), abs=1e-6)


def test_a_section_is_hatched_and_stands_for_hidden_lines(tmp_path: Path) -> None:
    drawing = _drawn(Lack.HIDDEN_BUT_SECTION)
    assert all(each.linetype is Linetype.VISIBLE for _, each in _all(drawing))
    path = tmp_path / "sheet.dxf"
    write_dxf(drawing.lines, Projection.THIRD, path, drawing.hatching)
    entities = ezdxf.readfile(path).modelspace()
    count = sum(entity.dxf.layer == "HATCHING" for entity in entities)
    assert count == len(drawing.hatching[Role.RIGHT]) > 10
