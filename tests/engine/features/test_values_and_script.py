"""``features.json`` and the build123d script."""

import ast
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.as_json import named, solid_values
from gaussiancad_core.features.build123d_script import script_of
from gaussiancad_core.features.constraints import Numbers
from gaussiancad_core.features.difference import difference
from gaussiancad_core.features.feature_model import FeatureList, Holes
from gaussiancad_core.features.feature_search import features_of
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Axis
from sample_parts import SAMPLES
from sample_parts.modelling import box, cone, cut, cylinder, fuse, revolved

Solve = Callable[[TopoDS_Shape], FeatureList]


def _flange() -> TopoDS_Shape:
    """All kinds of features but pockets and chamfers."""
    body = fuse(
        box((0, 0, 0), (60, 40, 10)),
        revolved([(10, 0), (10, 9), (25, 6), (25, 0)], Axis.Z, (30, 20)),
    )
    bores = [cylinder(Axis.Z, (x, 8.0), 2.5, 0.0, 10.0) for x in (8.0, 52.0)]
    sunk = cone(Axis.Z, (8.0, 32.0), (2.0, 4.0), 8.0, 10.0)
    blind = cylinder(Axis.Z, (30.0, 20.0), 3.0, 12.0, 25.0)
    deep = [cylinder(Axis.Z, (8.0, 32.0), 2.0, 0.0, 10.0), sunk, blind]
    ring = cylinder(Axis.Z, (52.0, 32.0), 5.0, 7.0, 10.0)
    return cut(body, *bores, *deep, cylinder(Axis.Z, (52.0, 32.0), 3.0, 0.0, 10.0), ring)


@pytest.fixture(scope="module")
def flange() -> FeatureList:
    return features_of(_flange())


def _values(found: FeatureList, *numbers: float) -> dict[str, Any]:
    values = solid_values(found, Numbers(numbers), None)
    return json.loads(json.dumps(values))


def test_names_are_their_own_and_tell_what_they_are(flange: FeatureList) -> None:
    values = _values(flange)
    names = [feature["name"] for feature in values["features"]]
    assert len(set(names)) == len(names) == len(named(flange.features))
    for feature in values["features"]:
        assert re.fullmatch(rf"{feature['kind'].capitalize()}\d+", feature["name"])
        dimensions = [
            constraint["name"]
            for constraint in feature.get("sketch", feature)["constraints"]
            if "name" in constraint
        ]
        assert len(set(dimensions)) == len(dimensions)


def test_a_sketch_has_its_plane_its_edges_and_what_fixes_them(flange: FeatureList) -> None:
    pad, turned = _values(flange)["features"][:2]
    assert (pad["kind"], turned["kind"]) == ("pad", "revolution")
    assert pad["sketch"]["plane"] == {
        "name": "XY",
        "right": [1.0, 0.0, 0.0],
        "up": [0.0, 1.0, 0.0],
        "normal": [0.0, 0.0, 1.0],
        "offset": 0.0,
    }
    assert [edge["kind"] for edge in pad["sketch"]["geometry"]] == ["line"] * 4
    assert set(turned["axis"]) == {"point", "direction"}
    for feature in (pad, turned):
        count = len(feature["sketch"]["geometry"])
        for constraint in feature["sketch"]["constraints"]:
            for element, spot in constraint["of"]:
                assert -1 <= element < count
                assert spot in (None, "start", "end", "centre")


def test_numbers_tell_where_they_are_from(flange: FeatureList) -> None:
    plain, stated = _values(flange), _values(flange, 60.0, 10.0, 5.0)
    sources = re.findall(r'"(sheet|measured)"', json.dumps(plain))
    assert set(sources) == {"measured"}
    pad = stated["features"][0]
    assert pad["sources"] == {"length": "sheet"}
    dimensions = {
        round(constraint["value"], 6): constraint["source"]
        for constraint in pad["sketch"]["constraints"]
        if "value" in constraint
    }
    assert dimensions == {60.0: "sheet", 40.0: "measured"}
    drilled = [f for f in stated["features"] if f["kind"] == "hole" and f["diameter"] == 5.0]
    assert [feature["sources"]["diameter"] for feature in drilled] == ["sheet"]


def test_holes_are_circles_in_the_plane_that_they_enter(flange: FeatureList) -> None:
    holes = [feature for feature in _values(flange)["features"] if feature["kind"] == "hole"]
    made = [feature for feature in flange.features if isinstance(feature, Holes)]
    assert [len(hole["centres"]) for hole in holes] == [len(hole.centres) for hole in made]
    assert sorted(len(hole["centres"]) for hole in holes) == [1, 1, 1, 2]
    for hole in holes:
        count = len(hole["centres"])
        elements = {element for c in hole["constraints"] for element, _ in c["of"]}
        assert elements <= {-1, *range(count)}
        diameters = [c["value"] for c in hole["constraints"] if c["kind"] == "diameter"]
        assert diameters == pytest.approx([hole["diameter"]])
    sinks = [hole["sink"] for hole in holes if hole["sink"] is not None]
    assert sorted(sink["degrees"] > 0.0 for sink in sinks) == [False, True]


def _assigned(script: str) -> list[str]:
    """Names that a script gives numbers to."""
    return [
        target.id
        for line in ast.parse(script).body
        if isinstance(line, ast.Assign) and isinstance(line.value, ast.Constant)
        for target in line.targets
        if isinstance(target, ast.Name)
    ]


def _script(*solids: FeatureList) -> str:
    return script_of([_values(each) for each in solids])


@pytest.mark.parametrize("count", [1, 2])
def test_a_script_names_each_parameter_once_before_it_is_used(
    flange: FeatureList, count: int
) -> None:
    script = _script(*[flange] * count)
    compile(script, "features.py", "exec")
    names = _assigned(script)
    assert len(set(names)) == len(names) > 10
    tree = ast.parse(script)
    read = {
        node.id
        for node in ast.walk(tree)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id.isupper()
    }
    assert read == set(names)


def test_a_script_tells_what_is_on_the_sheet(flange: FeatureList) -> None:
    script = script_of([_values(flange, 10.0)])
    (line,) = [line for line in script.splitlines() if line.startswith("PAD1_LENGTH")]
    assert line == "PAD1_LENGTH = 10.0  # on the sheet"


def _run(script: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> TopoDS_Shape:
    pytest.importorskip("build123d")
    monkeypatch.chdir(folder)
    exec(compile(script, "features.py", "exec"), {})
    return read_solid(folder / "part.step")


def test_the_script_makes_the_solid(
    flange: FeatureList, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert difference(_flange(), _run(_script(flange), tmp_path, monkeypatch)).is_none


@pytest.mark.parametrize("part", SAMPLES, ids=lambda part: part.name)
def test_the_scripts_of_samples_make_them(
    part,  # noqa: ANN001
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pytest.importorskip("build123d")
    solid = part.build()
    script = _script(features_of(solid))
    assert difference(solid, _run(script, tmp_path, monkeypatch)).is_none
