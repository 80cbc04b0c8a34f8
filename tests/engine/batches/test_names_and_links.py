import csv
import os
from pathlib import Path

import pytest

from gaussiancad_core.batches.job_arguments import job_arguments
from gaussiancad_core.cli import main
from gaussiancad_core.cli.parser import build_parser
from gaussiancad_core.cli.reconstruct import job_of
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.report.job import Job
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_protocol.modes import Preset, Recipe, ResultKind


def test_options_give_the_same_job_again() -> None:
    reading = ReadingOptions(
        projection=Projection.FIRST,
        views=((Role.FRONT, (1.5, 2.0, 30.0, 40.0)), (Role.LEFT, (50.0, 2.0, 80.0, 40.0))),
        lengths=((Axis.Y, 42.5),),
        colour=(1, 200, 30),
        median_kernel=5,
    )
    job = Job(
        Path("sheet.png"),
        Path("out"),
        reading,
        page=2,
        result=ResultKind.SURFACE,
        recipe=Recipe.PAPER,
        preset=Preset.DRAFT,
        seed=7,
        resume=True,
        scale_down=3,
        transforms=True,
    )
    command = ["reconstruct", "sheet.png", "--output", "out", *job_arguments(job)]
    options = build_parser().parse_args(command)
    assert job_of(options, options.sheet, options.output) == job


HOSTILE = ("..", "-dash", "=1+1", "report.csv", "a\nb")


def test_no_name_and_no_link_leads_out_of_the_folder(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    sheets = tmp_path / "sheets"
    sheets.mkdir()
    raw = os.fsencode(sheets) + b"/caf\xe9.png"
    for path in [*(sheets / f"{name}.png" for name in HOSTILE), Path(os.fsdecode(raw))]:
        path.write_bytes(b"no picture")
    output = tmp_path / "deep" / "out"
    output.mkdir(parents=True)
    victim = tmp_path / "victim"
    (victim / "cameras").mkdir(parents=True)
    (victim / "cameras" / "mine.txt").write_text("mine")
    (sheets / "linked.png").write_bytes(b"no picture")
    (output / "linked").symlink_to(victim)
    before = _tree(tmp_path, output)
    found = sorted(sheets.iterdir())
    assert (
        main(["batch", *map(str, found), str(found[0]), "--output", str(output), "--workers", "2"])
        == 1
    )
    assert _tree(tmp_path, output) == before
    with open(output / "report.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(found)
    codes = {row["name"]: row["exit_code"] for row in rows}
    assert codes.pop("linked") == "2" and set(codes.values()) == {"3"}
    assert not any(cell.startswith(("=", "+", "-", "@")) for row in rows for cell in row.values())
    assert "Traceback" not in capfd.readouterr().err


@pytest.mark.parametrize(
    "name", ["manifest.sqlite", "manifest.sqlite-journal", ".gaussiancad-batch.lock"]
)
def test_no_link_stands_for_what_a_batch_keeps(
    name: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "out").mkdir()
    (tmp_path / "sheet.png").write_bytes(b"no picture")
    (tmp_path / "mine").write_text("mine")
    for target in ("mine", "nothing"):
        link = tmp_path / "out" / name
        link.symlink_to(tmp_path / target)
        assert main(["batch", str(tmp_path / "sheet.png"), "--output", str(tmp_path / "out")]) == 2
        assert "[output-is-link]" in capfd.readouterr().err
        link.unlink()
    assert (tmp_path / "mine").read_text() == "mine" and not (tmp_path / "nothing").exists()


def _tree(root: Path, but: Path) -> dict[Path, bytes]:
    """All files under a folder but those under another one."""
    files = (path for path in root.rglob("*") if path.is_file() and but not in path.parents)
    return {path: path.read_bytes() for path in files}
