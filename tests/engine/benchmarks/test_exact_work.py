from dataclasses import replace
from pathlib import Path

import pytest

from benchmarks.parts.exact_cases import USUAL_LEVELS, Case, classed_cases
from benchmarks.run.workers import Row, Worker
from benchmarks.sheets.exact_inputs import InputKind, kept_lines, make_input
from benchmarks.tasks.exact_tables import summary, tables
from benchmarks.tasks.exact_work import Task, causes, close, falsely_verified, solved, worked
from gaussiancad_core.model.axes import Role
from sample_parts.classed import PartClass

EXACT: Row = {
    "group": "planes", "name": "a", "input": "vectors", "status": "verified", "reasons": [],
    "valid": True, "exact": True, "iou": 1.0, "faces": 10, "true_faces": 10, "seconds": 0.5,
}  # fmt: skip
WRONG = {**EXACT, "name": "b", "exact": False, "iou": 0.9, "seconds": 1.5}
OFF = {**EXACT, "name": "c", "exact": False, "iou": 0.99}
LATE = {
    "group": "holes", "name": "d", "input": "vectors", "true_faces": 12,
    "failure": "solve-over-time",
}  # fmt: skip
DOUBTED = {
    **WRONG, "name": "e", "status": "approximate", "reasons": ["ambiguous"], "mirrored": "x",
}  # fmt: skip


def test_what_counts() -> None:
    rows = (EXACT, WRONG, OFF, LATE, DOUBTED)
    assert [solved(row) for row in rows] == [True, False, False, False, False]
    assert [close(row) for row in rows] == [True, False, True, False, False]
    assert [falsely_verified(row) for row in rows] == [False, True, True, False, False]
    assert [causes(row) for row in rows] == [
        [], ["verified-but-wrong"], ["verified-but-wrong"], ["solve-over-time"],
        ["ambiguous", "mirrored"],
    ]  # fmt: skip


def test_tables_count_by_group_and_cause() -> None:
    rows = [EXACT, WRONG, OFF, LATE, DOUBTED]
    head, planes, holes, total, causes_line = tables(rows).strip().splitlines()
    of_planes = dict(zip(["parts", "exact", "close"], planes.split()[1:4], strict=True))
    assert of_planes == {"parts": "4", "exact": "0.250", "close": "0.500"}
    assert head.split()[:2] == ["vectors", "parts"]
    assert planes.split()[6:8] == ["2", "1"]
    assert holes.split()[:3] == ["holes", "1", "0.000"]
    assert total.split()[1] == "5"
    assert "verified-but-wrong 2" in causes_line and "solve-over-time 1" in causes_line
    recorded = ("planes", "1, 3 of 4"), ("holes", "0, 0 of 1"), ("all", "1, 3 of 5")
    assert summary(rows) == (("exact, verified", "vectors"), recorded)


def test_cases_go_through_all_levels() -> None:
    classes = [PartClass.PLANES, PartClass.HOLES]
    cases = list(classed_cases(classes, 2 * USUAL_LEVELS, 0))
    names = {(case.group, case.name) for case in cases}
    assert len(cases) == len(names) == 4 * USUAL_LEVELS
    assert {case.level for case in cases} == set(range(USUAL_LEVELS))


@pytest.fixture(scope="module")
def case() -> Case:
    return Case("planes-0", "planes", 0, 0)


def test_lines_are_kept(case: Case, tmp_path: Path) -> None:
    truth = case.truth()
    first = kept_lines(case, truth, tmp_path)
    (kept,) = (tmp_path / "exact-lines").iterdir()
    stamp = kept.stat().st_mtime_ns
    assert kept_lines(case, truth, tmp_path).views == first.views
    assert kept.stat().st_mtime_ns == stamp


def test_a_sheet_shows_the_same_part_as_its_exact_lines(case: Case, tmp_path: Path) -> None:
    truth = case.truth()
    exact, read = (
        make_input(case, truth, kind, tmp_path) for kind in (InputKind.VECTORS, InputKind.CLEAN)
    )
    assert set(read.views.roles) == {Role.FRONT, Role.TOP, Role.RIGHT}
    assert read.views.size == pytest.approx(exact.views.size, rel=2e-3)
    assert read.px_mm > 100.0 * exact.px_mm


def test_a_part_that_takes_too_long_is_ended_and_the_next_one_is_not(
    case: Case, tmp_path: Path
) -> None:
    worker = Worker(worked)
    task = Task(case, InputKind.VECTORS, tmp_path, 0.0)
    try:
        late = worker.run(task)
        row = worker.run(replace(task, limit=300.0))
    finally:
        worker.close()
    assert (late["failure"], late["seconds"]) == ("solve-over-time", 0.0)
    assert causes(late) == ["solve-over-time"]
    assert "failure" not in row
    assert solved(row) and row["faces"] == row["true_faces"]
