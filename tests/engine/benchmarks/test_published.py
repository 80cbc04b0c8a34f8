"""The yardstick for published drawings, on drawings of our own."""

import shutil
from pathlib import Path

import pytest

from benchmarks.ask.published import COLUMNS, Task, by_source, failed_at, reasons, worked
from benchmarks.run.checkout import SAMPLES
from benchmarks.run.command import main
from benchmarks.sheets.published import sheets_of
from benchmarks.tasks.sheet_solids import Sheet, is_false, is_the_part


@pytest.fixture
def data(tmp_path: Path, plain_picture: Path, plain_step: Path) -> Path:
    """A sheet of a part, one beside another part, and one beside none."""
    folder = tmp_path / "source"
    folder.mkdir()
    for name in ("right", "other", "alone"):
        shutil.copy(plain_picture, folder / f"{name}.png")
    shutil.copy(plain_step, folder / "right.step")
    shutil.copy(SAMPLES / "boss-plate.step", folder / "other.step")
    return tmp_path


def _row(data: Path, name: str, limit: float = 60.0) -> dict:
    task = Task(Sheet(data / "source" / f"{name}.png", limit))
    row = dict(task.known)
    for bit in worked(task):
        row |= bit
    return row


def test_only_sheets_with_their_part_are_taken(data: Path) -> None:
    assert [path.stem for path in sheets_of(data)] == ["other", "right"]


def test_a_part_is_told_from_another(data: Path) -> None:
    right, other = _row(data, "right"), _row(data, "other")
    assert right["views"] and not right["from_file"]
    assert right["status"] == other["status"] == "verified"
    assert right["iou"] > 0.999 and is_the_part(right) and not is_false(right)
    assert is_false(other)
    assert right["roles"] and min(right["strokes"]) > 0.99 and not other["roles"]
    # Nothing on the sheet tells its scale.
    assert failed_at(right) == "scale" and failed_at(other) == "roles"
    *_, counts = by_source([right, other])
    stated = dict(zip(("", *COLUMNS), counts, strict=True))
    names = ("sheets", "ended", "views", "file's", "roles", "solid", "exact", "verif.", "false")
    assert [stated[name] for name in names] == [2, 2, 2, 0, 1, 2, 1, 1, 1]


def test_a_run_that_does_not_end_is_counted(data: Path) -> None:
    row = _row(data, "right", 0.05)
    assert row["exit_code"] is None and not row["views"]
    assert not is_false(row)
    assert reasons([row]) == ["first wrong at: time 1", "not the part: over-time 1"]


def test_a_folder_that_is_not_there_is_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["published", "--data", str(tmp_path / "none")])
    assert ended.value.code == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "there is no folder" in line


def test_nothing_to_do_is_an_empty_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["published", "--data", str(tmp_path)]) == 0
    assert capsys.readouterr().out.splitlines()[1].split()[:2] == ["all", "0"]
