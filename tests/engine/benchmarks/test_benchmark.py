"""What the benchmark does with its tasks, whatever they are."""

from dataclasses import replace
from pathlib import Path

import pytest
from benchmark import Plan, carry_out, main, parser, plan_of
from benchmark_ablations import Ablation, AblationTask
from benchmark_parts import DRAWN_KINDS, STRENGTHS, SheetKind, given_parts
from benchmark_runs import SCRATCH, Method, Run, RunTask
from benchmark_store import Store, progress
from counted_tasks import Counted, count

from gaussiancad_core.kernel.brep import write_step
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.samples.modelling import box


def tasks_in(folder: Path, *names: str) -> tuple[Counted, ...]:
    return tuple(Counted(name, folder) for name in names)


def plan_in(folder: Path, tasks: tuple[Counted, ...]) -> Plan:
    return Plan(tasks, folder / "kept", 2, {})


def worked_on(folder: Path) -> list[str]:
    return sorted(path.name.rpartition("-")[0] for path in folder.iterdir() if path.is_file())


def test_what_is_finished_is_not_done_again(tmp_path: Path) -> None:
    plan = plan_in(tmp_path, tasks_in(tmp_path, "one", "dies", "three"))
    stated: list[str] = []
    rows = carry_out(plan, count, stated.append)
    assert [row["task"] for row in rows] == ["one", "dies", "three"]
    assert [row.get("failure") for row in rows] == [None, "solve-crashed", None]
    assert worked_on(tmp_path) == ["dies", "one", "three"]
    assert "3/3" in stated[-2]
    stated.clear()
    assert carry_out(plan, count, stated.append) == rows
    assert worked_on(tmp_path) == ["dies", "one", "three"]
    assert stated == ["3 of 3 tasks were finished before\n"]


def test_what_ends_a_task_is_in_its_row_and_ends_no_other(tmp_path: Path) -> None:
    tasks = tasks_in(tmp_path, "refused", "defect", "sleeps", "last")
    tasks = tuple(replace(task, limit=0.3 if task.name == "sleeps" else 30.0) for task in tasks)
    refused, defect, slept, last = carry_out(plan_in(tmp_path, tasks), count, lambda _: None)
    assert (refused["failure"], refused["message"]) == ("refused-by-name", "its name is refused")
    assert (defect["failure"], defect["message"]) == ("error-ValueError", "a defect")
    assert (slept["failure"], slept["seconds"]) == ("solve-over-time", 0.3)
    assert last["told"] == 4 and "failure" not in last


def test_what_ended_processes_left_is_removed(tmp_path: Path) -> None:
    plan = plan_in(tmp_path, tasks_in(tmp_path, "one"))
    (plan.folder / SCRATCH / "left").mkdir(parents=True)
    carry_out(plan, count, lambda _: None)
    assert [path.name for path in plan.folder.iterdir()] == ["tasks"]


def test_a_run_that_was_stopped_goes_on(tmp_path: Path) -> None:
    plan = replace(plan_in(tmp_path, tasks_in(tmp_path, "a", "b", "c")), workers=1)

    def stop(text: str) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        carry_out(plan, count, stop)
    kept = list((plan.folder / "tasks").iterdir())
    assert [path.suffix for path in kept] == [".json"]
    # A file that was not written to its end has another name.
    (plan.folder / "tasks" / "c.json.part").write_text("{")
    rows = carry_out(plan, count, lambda _: None)
    assert [row["told"] for row in rows] == [1, 1, 1]
    assert worked_on(tmp_path).count("a") == 1


def test_names_that_differ_in_signs_alone_are_other_files(tmp_path: Path) -> None:
    store = Store(tmp_path)
    one, other = tasks_in(tmp_path, "a b", "a/b")
    store.put(one, {"row": 1})
    assert store.get(other) is None
    store.put(other, {"row": 2})
    assert (store.get(one), store.get(other)) == ({"row": 1}, {"row": 2})


def test_the_bar_tells_what_is_left() -> None:
    line = progress(3, 12, 2, 20.0, "part")
    assert line.startswith("\r[######......") and "3/12, 1:30 left, part" in line


def test_all_methods_go_through_all_sheets(tmp_path: Path) -> None:
    options = parser().parse_args(["--output", str(tmp_path)])
    tasks = plan_of(options).tasks
    runs = [task for task in tasks if isinstance(task, RunTask)]
    parts = {task.part for task in runs}
    assert len(runs) == len(parts) * len(DRAWN_KINDS) * len(Run)
    assert len(parts) == 6 and len(STRENGTHS) == 5
    assert sorted(m.value for run in Run for m in run.value) == sorted(m.value for m in Method)
    assert len({task.name for task in tasks}) == len(tasks)
    assert {task.ablation for task in tasks if isinstance(task, AblationTask)} == set(Ablation)


def test_other_folders_give_parts_and_pairs(tmp_path: Path) -> None:
    for name in ("1", "2"):
        write_step(box((0, 0, 0), (3, 2, int(name))), tmp_path / f"{name}.step")
    (tmp_path / "2.png").write_bytes(b"sheet")
    (tmp_path / "3.png").write_bytes(b"no solid")
    parts = list(given_parts(tmp_path, Projection.FIRST))
    assert [(part.case.name, part.sheet) for part in parts] == [
        ("1", None), ("2", tmp_path / "2.png")
    ]  # fmt: skip
    assert parts[0].kinds == DRAWN_KINDS and parts[1].kinds == (SheetKind.GIVEN,)
    # Another file of the same name is another task.
    (tmp_path / "2.png").write_bytes(b"another")
    assert list(given_parts(tmp_path, Projection.FIRST))[1].digest != parts[1].digest


def test_a_folder_without_parts_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "empty").mkdir()
    code = main(["--data", str(tmp_path / "empty"), "--output", str(tmp_path / "out")])
    assert code == 2
    assert "holds no STEP files" in capsys.readouterr().err
