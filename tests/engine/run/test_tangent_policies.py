"""One part under each way to draw its tangent edges: the same solid, and the policy is told."""

import json
from pathlib import Path

import pytest

from benchmarks.sheets.dxf_sheets import write_dxf
from gaussiancad_core.cli import main
from gaussiancad_core.drawing.drawn_sheet import part_lines
from gaussiancad_core.kernel.brep import soundness
from gaussiancad_core.kernel.brep_files import read_solid, write_step
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.tangent_policies import KNOWN_POLICIES, TangentPolicy
from sample_parts import sample

_VIEWS = Role.FRONT, Role.TOP, Role.RIGHT


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the part's exact solid."""
    folder = tmp_path_factory.mktemp("parts")
    write_step(sample("filleted-block").build(), folder / "filleted-block.step")
    return folder


def _made(sheet: Path, output: Path, *options: str) -> dict:
    stated = ["--output", str(output), "--result", "solid", "--length", "x=80", *options]
    assert main(["reconstruct", str(sheet), *stated]) == 0
    return json.loads((output / "report.json").read_text("utf-8"))


def _is_the_part(name: str, output: Path) -> None:
    truth, found = soundness(sample(name).build()), soundness(read_solid(output / "solid.step"))
    assert found.faces == truth.faces
    assert found.volume_mm3 == pytest.approx(truth.volume_mm3, rel=2e-3)


@pytest.mark.parametrize("policy", KNOWN_POLICIES)
def test_a_picture_gives_the_same_solid_under_each_policy(
    folder: Path, tmp_path: Path, policy: TangentPolicy
) -> None:
    drawn = tmp_path / "sheet.png"
    solid = str(folder / "filleted-block.step")
    assert main(["draw", solid, str(drawn), "--tangent-edges", policy.value]) == 0
    report = _made(drawn, tmp_path / "made")
    assert (report["status"], report["reasons"]) == ("verified", [])
    assert report["tangent_edges"] == policy.value
    _is_the_part("filleted-block", tmp_path / "made")
    reading = json.loads((tmp_path / "made" / "reading.json").read_text("utf-8"))
    counts = {"drawn": 0, "thin": 0, "left_out": 0, policy.value.replace("-", "_"): 4}
    assert reading["tangent_edges"] == {"policy": policy.value, "source": "inferred", **counts}
    tangents = [stroke["view"] for stroke in reading["strokes"] if stroke["kind"] == "tangent"]
    assert sorted(tangents) == (["front"] * 2 + ["right"] * 2 if policy.draws else [])


def test_a_file_that_draws_tangent_edges_gives_the_solid_and_a_reading_that_does(
    tmp_path: Path,
) -> None:
    """A rounding over a round corner: arcs of the plan are tangent edges, too."""
    lines = part_lines(sample("rounded-cover").build(), _VIEWS, tangent_edges=TangentPolicy.DRAWN)
    drawn = tmp_path / "sheet.dxf"
    write_dxf(lines, Projection.THIRD, drawn)
    report = _made(drawn, tmp_path / "made")
    assert (report["status"], report["tangent_edges"]) == ("verified", "drawn")
    _is_the_part("rounded-cover", tmp_path / "made")
    taken = _made(drawn, tmp_path / "taken", "--reading", str(tmp_path / "made" / "reading.json"))
    for name in ("status", "reasons", "tangent_edges"):
        assert taken[name] == report[name]
    readings = [
        json.loads((tmp_path / made / "reading.json").read_text("utf-8"))
        for made in ("made", "taken")
    ]
    assert readings[0]["tangent_edges"] == readings[1]["tangent_edges"]
    kinds = [[stroke["kind"] for stroke in reading["strokes"]] for reading in readings]
    assert kinds[0] == kinds[1] and kinds[0].count("tangent") >= 20
