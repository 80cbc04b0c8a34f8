"""Rows that are kept from run to run."""

from pathlib import Path

from counted_tasks import Counted, count
from resumable import resumed


def _rows(names: str, folder: Path, resume: bool) -> list[str]:
    tasks = [Counted(name, folder) for name in names]
    rows = resumed(tasks, count, 1, folder / "rows.json", resume)
    return [row["task"] for row in rows]


def _times(name: str, folder: Path) -> int:
    return len(list(folder.glob(f"{name}-*")))


def test_what_was_done_is_not_done_again(tmp_path: Path) -> None:
    assert _rows("ab", tmp_path, resume=False) == ["a", "b"]
    assert sorted(_rows("bc", tmp_path, resume=True)) == ["b", "c"]
    assert [_times(name, tmp_path) for name in "abc"] == [1, 1, 1]
    assert sorted(_rows("abc", tmp_path, resume=True)) == ["a", "b", "c"]
    assert [_times(name, tmp_path) for name in "abc"] == [1, 1, 1]


def test_a_new_run_begins_anew(tmp_path: Path) -> None:
    _rows("ab", tmp_path, resume=False)
    assert _rows("a", tmp_path, resume=False) == ["a"]
    assert _times("a", tmp_path) == 2
    assert len((tmp_path / "rows.json").read_text().splitlines()) == 1
