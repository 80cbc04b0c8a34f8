"""Which sheets a batch takes, and what is asked of each."""

from pathlib import Path

import pytest

from gaussiancad_core.batches.batch_inputs import BatchSheet, collect_sheets
from gaussiancad_core.cli.batch import _job_with
from gaussiancad_core.cli.parser import build_parser
from gaussiancad_core.cli.reconstruct import job_of
from gaussiancad_core.errors import LimitError, UsageError
from gaussiancad_core.model.axes import Axis
from gaussiancad_protocol.modes import ResultKind


def _collected(named: list[str], *options: str) -> list[BatchSheet]:
    stated = build_parser().parse_args(["batch", *named, "--output", "out", *options])
    job = job_of(stated, Path(), stated.output)
    return collect_sheets(stated.sheets, job, lambda item: _job_with(stated, item))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("b.PNG", "a.pdf", "notes.txt", ".hidden.png", "sub/c.dxf", ".git/d.png"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("")
    return tmp_path


def test_folders_files_and_patterns_are_taken_once(folder: Path) -> None:
    found = _collected([str(folder), str(folder / "a.pdf"), str(folder / "*.txt")])
    names = [sheet.path.relative_to(folder).as_posix() for sheet in found]
    assert names == ["a.pdf", "b.PNG", "sub/c.dxf", "notes.txt"]
    assert all(sheet.job.sheet == sheet.path for sheet in found)


def test_what_a_batch_wrote_is_no_sheet(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)
    (folder / "out").mkdir()
    (folder / "out" / "preview.png").write_text("")
    assert [sheet.path.name for sheet in _collected(["."])] == ["a.pdf", "b.PNG", "c.dxf"]


def test_a_table_has_options_for_each_sheet(folder: Path) -> None:
    table = folder / "table.csv"
    table.write_text(
        "\ufeffsheet,length,mm-per-pixel,page,result\na.pdf,x=80,,2,\nsub/c.dxf,,0.5,,surface\n",
        "utf-8",
    )
    first, second = _collected([str(table)], "--length", "y=30", "--result", "solid")
    assert first.path == folder / "a.pdf" and second.path == folder / "sub" / "c.dxf"
    assert (first.job.reading.lengths, first.job.page) == (((Axis.X, 80.0),), 2)
    assert first.job.result is ResultKind.SOLID and second.job.result is ResultKind.SURFACE
    assert second.job.reading.lengths == () and second.job.reading.mm_per_pixel == 0.5


@pytest.mark.parametrize(
    ("text", "stated"),
    [
        ("name\na.png\n", "line 2"),
        ("sheet,page\na.png,0\n", "line 2"),
        ("sheet,color\na.png,3\n", "color"),
        ("sheet\na.png\nb.png,x=3\n", "line 3"),
        ("sheet\n\xff", "table.csv"),
    ],
)
def test_a_table_that_says_nonsense_is_told_with_its_line(
    text: str, stated: str, folder: Path
) -> None:
    (folder / "table.csv").write_bytes(text.encode("latin-1"))
    with pytest.raises(UsageError, match=stated):
        _collected([str(folder / "table.csv")])


def test_no_sheet_at_all_is_wrong_usage(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as stated:
        _collected([str(tmp_path), str(tmp_path / "*.png")])
    assert stated.value.code == "no-sheets"


def test_a_table_of_more_lines_than_are_taken_is_told(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("gaussiancad_core.batches.batch_inputs._MOST_ROWS", 2)
    table = folder / "table.csv"
    table.write_text("sheet,page\n" + "a.pdf,2\nb.PNG,2\n")
    assert [sheet.job.page for sheet in _collected([str(table)])] == [2, 2]
    table.write_text("sheet\n" + "a.pdf\nb.PNG\na.pdf\n")
    with pytest.raises(LimitError) as caught:
        _collected([str(table)])
    assert caught.value.code == "too-many-elements"
