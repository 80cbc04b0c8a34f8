from dataclasses import replace
from pathlib import Path

from benchmarks.parts.exact_cases import Case
from benchmarks.run.workers import Worker
from benchmarks.sheets.exact_inputs import InputKind
from benchmarks.tasks.exact_work import Task, causes, solved, worked


def test_a_part_that_takes_too_long_is_ended_and_the_next_one_is_not(tmp_path: Path) -> None:
    worker = Worker(worked)
    task = Task(Case("planes-0", "planes", 0, 0), InputKind.VECTORS, tmp_path, 0.0)
    try:
        late = worker.run(task)
        row = worker.run(replace(task, limit=300.0))
    finally:
        worker.close()
    assert (late["failure"], late["seconds"]) == ("solve-over-time", 0.0)
    assert causes(late) == ["solve-over-time"]
    assert "failure" not in row
    assert solved(row) and row["faces"] == row["true_faces"]
