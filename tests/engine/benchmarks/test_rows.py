"""Rows that are kept from run to run."""

from dataclasses import replace
from pathlib import Path

import pytest
from counted_tasks import Counted, count

from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import Row


def _rows(
    names: str, folder: Path, *, resume: bool, workers: int = 1, said: list[str] | None = None
) -> list[Row]:
    running = Running(workers, folder / "rows.jsonl", resume)
    tasks = [Counted(name, folder) for name in names.split()]
    say = [].append if said is None else said.append
    return rows_of(tasks, count, running, lambda row: row["task"], say)


def _times(name: str, folder: Path) -> int:
    return len(list(folder.glob(f"{name}-*")))


def test_what_was_done_is_not_done_again(tmp_path: Path) -> None:
    said: list[str] = []
    rows = _rows("one dies three", tmp_path, resume=False, workers=2, said=said)
    assert [row["task"] for row in rows] == ["one", "dies", "three"]
    assert [row.get("failure") for row in rows] == [None, "solve-crashed", None]
    assert len(said) == 3 and said[-1].startswith("3/3, 0:00 left: ")
    said.clear()
    assert _rows("three one dies", tmp_path, resume=True, said=said) == [rows[2], *rows[:2]]
    assert said == ["3 of 3 tasks were finished before"]
    assert [row["task"] for row in _rows("four one", tmp_path, resume=True)] == ["four", "one"]
    assert [_times(name, tmp_path) for name in ("one", "dies", "three", "four")] == [1] * 4
    # Rows of tasks that nobody asks for now are still there.
    assert len(_rows("one dies three four", tmp_path, resume=True)) == 4
    assert _times("dies", tmp_path) == 1


def test_a_new_run_begins_anew(tmp_path: Path) -> None:
    _rows("a b", tmp_path, resume=False)
    _rows("a", tmp_path, resume=False)
    assert _times("a", tmp_path) == 2
    assert len((tmp_path / "rows.jsonl").read_text().splitlines()) == 1


def test_a_run_that_was_stopped_goes_on(tmp_path: Path) -> None:
    def stop(_: str) -> None:
        raise KeyboardInterrupt

    tasks = [Counted(name, tmp_path) for name in "abc"]
    running = Running(1, tmp_path / "rows.jsonl", resume=True)
    with pytest.raises(KeyboardInterrupt):
        rows_of(tasks, count, running, str, stop)
    # What a killed run wrote in part is no row.
    with (tmp_path / "rows.jsonl").open("a") as stream:
        stream.write('{"task": "b", "to')
    rows = rows_of(tasks, count, running, str, lambda _: None)
    assert [row["length"] for row in rows] == [1, 1, 1]
    # A task that was at work when the run was stopped is begun again.
    assert _times("a", tmp_path) == 1


def test_what_ends_a_task_is_in_its_row_and_ends_no_other(tmp_path: Path) -> None:
    tasks = [Counted(name, tmp_path) for name in ("refused", "defect", "sleeps", "last")]
    tasks[2] = replace(tasks[2], limit=0.3)
    refused, defect, slept, last = rows_of(tasks, count, Running(2), str, lambda _: None)
    assert (refused["failure"], refused["message"]) == ("refused-by-name", "its name is refused")
    assert (defect["failure"], defect["message"]) == ("error-ValueError", "a defect")
    assert (slept["failure"], slept["seconds"]) == ("solve-over-time", 0.3)
    assert last["length"] == 4 and "failure" not in last
