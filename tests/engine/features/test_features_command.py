"""``gaussiancad features``: a file to features, a script, and what they stand over."""

import json
from pathlib import Path

import pytest
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakePolygon
from OCP.BRepOffsetAPI import BRepOffsetAPI_ThruSections
from OCP.gp import gp_Pnt
from OCP.TopoDS import TopoDS_Shape, TopoDS_Wire

from gaussiancad_core.cli import main
from gaussiancad_core.features.difference import difference
from gaussiancad_core.features.features_command import write_features
from gaussiancad_core.kernel.brep import compound_of
from gaussiancad_core.kernel.brep_files import read_solid, write_brep, write_step
from gaussiancad_core.model.axes import Axis
from sample_parts import sample
from sample_parts.modelling import box, cut, cylinder


def _square(half: float, height: float, turn: bool) -> TopoDS_Wire:
    made = BRepBuilderAPI_MakePolygon()
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    if turn:
        corners = [(-1.4, 0), (0, -1.4), (1.4, 0), (0, 1.4)]
    for x, y in corners:
        made.Add(gp_Pnt(20.0 + half * x, 20.0 + half * y, height))
    made.Close()
    return made.Wire()


def _twisted() -> TopoDS_Shape:
    """A body whose four sides are twisted."""
    made = BRepOffsetAPI_ThruSections(True, True)
    made.AddWire(_square(18.0, 0.0, False))
    made.AddWire(_square(18.0, 30.0, True))
    made.Build()
    return made.Shape()


def _values(folder: Path) -> dict:
    return json.loads((folder / "features.json").read_text(encoding="utf-8"))


def test_each_solid_of_a_file_has_its_features(tmp_path: Path) -> None:
    ball = cut(box((0, 0, 0), (30, 20, 10)), cylinder(Axis.Z, (15, 10), 4.0, 0.0, 10.0))
    write_step(compound_of([ball, box((50, 0, 0), (60, 10, 5))]), tmp_path / "two.step")
    found = write_features(tmp_path / "two.step", tmp_path / "out")
    assert [len(features.features) for features in found] == [2, 1]
    values = _values(tmp_path / "out")
    assert values["schema"] == "gaussiancad-features/1"
    assert [solid["whole"] for solid in values["solids"]] == [True, True]
    assert [solid["base"] for solid in values["solids"]] == [None, None]
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [
        "features.json",
        "features.py",
    ]
    compile((tmp_path / "out" / "features.py").read_text(encoding="utf-8"), "f.py", "exec")


def test_a_solid_of_free_form_faces_is_a_base(tmp_path: Path) -> None:
    twisted = _twisted()
    write_step(twisted, tmp_path / "twisted.step")
    (found,) = write_features(tmp_path / "twisted.step", tmp_path / "out")
    assert not found.is_whole and found.features == ()
    (solid,) = _values(tmp_path / "out")["solids"]
    assert (solid["whole"], solid["base"], solid["features"]) == (False, "base-1.step", [])
    assert difference(twisted, read_solid(tmp_path / "out" / "base-1.step")).is_none


def test_holes_and_edge_breaks_stand_over_a_base(tmp_path: Path) -> None:
    from benchmarks.tasks.feature_changes import rebuilt

    twisted = _twisted()
    bored = cut(
        twisted,
        cylinder(Axis.Z, (20, 20), 4.0, -1.0, 31.0),
        cylinder(Axis.Z, (28, 20), 2.0, 22.0, 31.0),
    )
    write_brep(bored, tmp_path / "bored.brep")
    (found,) = write_features(tmp_path / "bored.brep", tmp_path / "out")
    assert not found.is_whole
    (solid,) = _values(tmp_path / "out")["solids"]
    assert [feature["kind"] for feature in solid["features"]] == ["hole", "hole"]
    base = read_solid(tmp_path / "out" / "base-1.step")
    assert difference(twisted, base).is_none
    made = rebuilt(found.features, base)
    assert made is not None and difference(bored, made).is_none
    assert "base-1.step" in (tmp_path / "out" / "features.py").read_text(encoding="utf-8")


def test_output_of_before_is_replaced(tmp_path: Path) -> None:
    write_step(_twisted(), tmp_path / "a.step")
    write_step(box((0, 0, 0), (3, 2, 1)), tmp_path / "b.step")
    write_features(tmp_path / "a.step", tmp_path / "out")
    write_features(tmp_path / "b.step", tmp_path / "out")
    assert not (tmp_path / "out" / "base-1.step").exists()
    assert _values(tmp_path / "out")["solids"][0]["whole"]


@pytest.mark.parametrize("content", [b"", b"solid nothing", b"ISO-10303-21;\n"])
def test_a_file_that_is_no_solid_is_told_in_one_line(
    content: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "a.step").write_bytes(content)
    assert main(["features", str(tmp_path / "a.step"), "--output", str(tmp_path / "out")]) == 3
    errors = capsys.readouterr().err
    assert errors.count("\n") == 1 and errors.startswith("gaussiancad: ")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(("seconds", "is_whole"), [(60.0, True), (0.01, False)])
def test_what_takes_too_long_is_a_base(
    seconds: float, is_whole: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_step(sample("pocket-block").build(), tmp_path / "a.step")
    out = tmp_path / "out"
    arguments = ["features", str(tmp_path / "a.step"), "--output", str(out)]
    assert main([*arguments, "--seconds", str(seconds)]) == 0
    (solid,) = _values(out)["solids"]
    assert solid["whole"] is is_whole
    assert (out / "base-1.step").exists() is not is_whole
    assert f"{int(is_whole)} of 1 solids" in capsys.readouterr().out
