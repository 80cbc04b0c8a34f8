"""Features that repeat: rows, grids, circles, mirrored pairs; in values and in the script."""

import json
import re
from collections.abc import Sequence
from math import cos, radians, sin
from pathlib import Path
from typing import Any

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.as_json import solid_values
from gaussiancad_core.features.build123d_script import script_of
from gaussiancad_core.features.constraints import Numbers
from gaussiancad_core.features.difference import difference
from gaussiancad_core.features.feature_search import features_of
from gaussiancad_core.features.pattern_model import Circle, Mirror, Pattern, Row
from gaussiancad_core.features.patterns import patterns_of
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cut, cylinder, fuse

_PLATE = box((0, 0, 0), (100, 60, 10))
_DISC = cylinder(Axis.Z, (50.0, 50.0), 40.0, 0.0, 10.0)


def _bores(places: Sequence[tuple[float, float]], radius: float = 3.0) -> list[TopoDS_Shape]:
    return [cylinder(Axis.Z, place, radius, 0.0, 10.0) for place in places]


def _ring(count: int, radius: float, step: float, start: float = 10.0) -> list[TopoDS_Shape]:
    angles = [radians(start + k * step) for k in range(count)]
    return _bores([(50.0 + radius * cos(a), 50.0 + radius * sin(a)) for a in angles])


def _patterns(solid: TopoDS_Shape) -> tuple[Pattern, ...]:
    found = features_of(solid)
    assert found.is_whole
    return patterns_of(found.features)


def test_holes_at_equal_distances_are_a_row() -> None:
    (row,) = _patterns(cut(_PLATE, *_bores([(x, 20.0) for x in (10.0, 30.0, 50.0, 70.0)])))
    assert isinstance(row, Row)
    (step,) = row.steps
    assert (step.direction, step.count, step.distance) == ((1.0, 0.0, 0.0), 4, 20.0)
    assert [member.centre for member in row.members] == sorted(m.centre for m in row.members)


@pytest.mark.parametrize("places", [(10.0, 30.01, 50.0), (10.0, 35.0)])
def test_two_holes_and_one_that_is_off_by_a_hundredth_are_no_row(places: Sequence[float]) -> None:
    assert _patterns(cut(_PLATE, *_bores([(x, 20.0) for x in places]))) == ()


def test_rows_of_rows_are_a_grid() -> None:
    places = [(x, y) for y in (10.0, 35.0) for x in (10.0, 30.0, 50.0)]
    (grid,) = _patterns(cut(_PLATE, *_bores(places)))
    assert isinstance(grid, Row) and len(grid.members) == 6
    assert [(s.direction, s.count, s.distance) for s in grid.steps] == [
        ((1.0, 0.0, 0.0), 3, 20.0),
        ((0.0, 1.0, 0.0), 2, 25.0),
    ]


@pytest.mark.parametrize("with_axis", [False, True])
def test_holes_around_an_axis_are_a_circle(with_axis: bool) -> None:
    body = _DISC if with_axis else box((0, 0, 0), (110, 120, 10))
    (circle,) = _patterns(cut(body, *_ring(5, 28.0, 72.0)))
    assert isinstance(circle, Circle) and len(circle.members) == 5
    assert (circle.angle, circle.diameter) == (72.0, 56.0)
    assert circle.direction == (0.0, 0.0, 1.0)
    assert circle.point[:2] == pytest.approx((50.0, 50.0))


def test_a_part_of_a_turn_repeats_around_an_axis_that_the_part_has() -> None:
    (circle,) = _patterns(cut(_DISC, *_ring(4, 28.0, 30.0)))
    assert isinstance(circle, Circle) and len(circle.members) == 4
    assert circle.angle == 30.0
    assert _patterns(cut(box((0, 0, 0), (110, 120, 10)), *_ring(4, 28.0, 30.0))) == ()


def test_a_square_around_an_axis_is_a_circle_and_else_a_grid() -> None:
    four = _ring(4, 28.0, 90.0, 45.0)
    (circle,) = _patterns(cut(_DISC, *four))
    (grid,) = _patterns(cut(box((0, 0, 0), (110, 120, 10)), *four))
    assert isinstance(circle, Circle) and isinstance(grid, Row)


def test_a_grid_around_an_axis_stays_one() -> None:
    places = [(50.0 + x, 50.0 + y) for x in (-20, 0, 20) for y in (-20, 0, 20) if x or y]
    places += [(50.0, 50.0)]
    (grid,) = _patterns(cut(_DISC, *_bores(places)))
    assert isinstance(grid, Row) and len(grid.members) == 9


def test_holes_are_mirrored_in_a_plane_that_mirrors_the_part() -> None:
    pair = _bores([(30.0, 12.0), (70.0, 12.0)])
    (mirror,) = _patterns(cut(_PLATE, *pair))
    assert isinstance(mirror, Mirror)
    assert (mirror.frame.normal, mirror.height) == ((1.0, 0.0, 0.0), 50.0)
    assert _patterns(cut(box((0, 0, 0), (101, 60, 10)), *pair)) == ()


def _pins(heights: Sequence[float]) -> TopoDS_Shape:
    """A plate with pins in a row."""
    places = zip((20.0, 45.0, 70.0), heights, strict=True)
    return fuse(_PLATE, *(box((x - 4, 16, 10), (x + 4, 24, top)) for x, top in places))


def test_pads_of_one_sketch_and_length_repeat() -> None:
    (row,) = _patterns(_pins([20.0, 20.0, 20.0]))
    assert isinstance(row, Row) and row.steps[0].distance == 25.0
    assert {member.centre for member in row.members} == {None}
    assert _patterns(_pins([20.0, 22.0, 24.0])) == ()


def test_pockets_of_one_sketch_and_depth_repeat() -> None:
    pockets = [box((x, 10, 5), (x + 6, 30, 10)) for x in (10.0, 25.0, 40.0, 55.0)]
    found = features_of(cut(_PLATE, *pockets))
    assert [type(feature).__name__ for feature in found.features] == ["Extrusion"] * 5
    (row,) = patterns_of(found.features)
    assert isinstance(row, Row) and len(row.members) == 4
    assert row.steps[0].distance == 15.0


def _values(solid: TopoDS_Shape, *numbers: float) -> dict[str, Any]:
    return json.loads(json.dumps(solid_values(features_of(solid), Numbers(numbers), None)))


def test_values_tell_members_and_where_numbers_are_from() -> None:
    values = _values(cut(_DISC, *_ring(6, 28.0, 60.0)), 56.0)
    (pattern,) = values["patterns"]
    assert (pattern["kind"], pattern["name"]) == ("circular", "Pattern1")
    names = {feature["name"]: feature for feature in values["features"]}
    assert {(name, centre) for name, centre in pattern["members"]} == {
        ("Hole1", k) for k in range(6)
    }
    assert len(names["Hole1"]["centres"]) == 6
    assert (pattern["count"], pattern["angle"], pattern["diameter"]) == (6, 60.0, 56.0)
    assert pattern["sources"] == {"diameter": "sheet"}
    (row,) = _values(cut(_PLATE, *_bores([(x, 20.0) for x in (10.0, 30.0, 50.0)])))["patterns"]
    assert row["kind"] == "linear" and row["steps"][0]["sources"] == {"distance": "measured"}


def _solids() -> dict[str, TopoDS_Shape]:
    grid = [(x, y) for y in (10.0, 35.0) for x in (10.0, 30.0, 50.0)]
    blind = [cylinder(Axis.Z, (30.0 + 5 * k, 20.0), 1.0, 0.0, 6.0) for k in range(4)]
    return {
        "circle": cut(_DISC, *_ring(6, 28.0, 60.0)),
        "grid": cut(_PLATE, *_bores(grid)),
        "mirror": cut(_PLATE, *_bores([(30.0, 12.0), (70.0, 12.0)])),
        "pins": _pins([20.0, 20.0, 20.0]),
        "from below": cut(_PLATE, *blind),
        "circle from below": cut(
            _DISC,
            *(
                cylinder(Axis.Z, (50 + 20 * cos(k), 50 + 20 * sin(k)), 2.0, 0.0, 5.0)
                for k in (radians(20.0 + 120.0 * j) for j in range(3))
            ),
        ),
    }


@pytest.mark.parametrize("name", _solids())
def test_a_script_makes_what_repeats_in_a_loop(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    solid = _solids()[name]
    script = script_of([_values(solid)])
    compile(script, "features.py", "exec")
    assert len(re.findall("^for copy in", script, re.MULTILINE)) == 1
    assert len(re.findall("drilled\\(", script)) <= 2
    pytest.importorskip("build123d")
    monkeypatch.chdir(tmp_path)
    exec(script, {})
    assert difference(solid, read_solid(tmp_path / "part.step")).is_none


def test_one_number_of_a_script_changes_all_that_repeats(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = script_of([_values(_solids()["circle"])])
    wider = script.replace("PATTERN1_DIAMETER = 56.0", "PATTERN1_DIAMETER = 60.0")
    assert wider != script
    pytest.importorskip("build123d")
    monkeypatch.chdir(tmp_path)
    exec(wider, {})
    wanted = cut(_DISC, *_ring(6, 30.0, 60.0))
    assert difference(wanted, read_solid(tmp_path / "part.step")).is_none
