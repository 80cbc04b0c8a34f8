"""What the benchmark does with its tasks, whatever they are."""

import argparse
from pathlib import Path

import pytest
from counted_tasks import Counted, count

from benchmarks.ask.benchmark import Plan, add_arguments, carry_out, plan_of
from benchmarks.methods.benchmark_ablations import Ablation, AblationTask
from benchmarks.methods.benchmark_runs import SCRATCH, Method, Run, RunTask
from benchmarks.run.command import main
from benchmarks.sheets.benchmark_parts import DRAWN_KINDS, STRENGTHS, SheetKind, given_parts
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.samples.modelling import box


def options_of(*arguments: str) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    add_arguments(parser)
    return parser.parse_args(arguments)


def test_what_ended_processes_left_is_removed(tmp_path: Path) -> None:
    plan = Plan((Counted("one", tmp_path),), tmp_path / "kept", 2, {})
    (plan.folder / SCRATCH / "left").mkdir(parents=True)
    (row,) = carry_out(plan, count, lambda _: None)
    assert row["length"] == 3
    assert [path.name for path in plan.folder.iterdir()] == ["rows.jsonl"]


def test_all_methods_go_through_all_sheets(tmp_path: Path) -> None:
    tasks = plan_of(options_of("--output", str(tmp_path))).tasks
    runs = [task for task in tasks if isinstance(task, RunTask)]
    parts = {task.part for task in runs}
    assert len(runs) == len(parts) * len(DRAWN_KINDS) * len(Run)
    assert len(parts) == 6 and len(STRENGTHS) == 5
    assert sorted(m.value for run in Run for m in run.value) == sorted(m.value for m in Method)
    assert len({str(task.known) for task in tasks}) == len(tasks)
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
    data = ["--data", str(tmp_path / "empty"), "--output", str(tmp_path / "out")]
    assert main(["benchmark", *data]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "holds no STEP files" in line
