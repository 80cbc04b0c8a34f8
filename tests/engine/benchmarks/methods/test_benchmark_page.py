"""What the benchmark's tables and its page say of rows."""

import re
from html import unescape
from pathlib import Path

import cv2
import pytest

from benchmarks.ask.benchmark import Plan, content_of
from benchmarks.methods.benchmark_ablations import AblationTask, ablation_tasks
from benchmarks.methods.benchmark_page import PUBLISHED, Content, benchmark_page
from benchmarks.methods.benchmark_records import Record, records_of
from benchmarks.methods.benchmark_runs import Method, Run
from benchmarks.methods.benchmark_tables import failure_table, part_table, result_tables
from benchmarks.run.charts import Chart, Series, round_scale, write_chart
from benchmarks.run.workers import Row
from gaussiancad_core.comparison.comparing import compare_models
from gaussiancad_core.comparison.comparison_options import CompareOptions, Protocol
from gaussiancad_core.comparison.comparison_report import comparison_dict
from gaussiancad_core.comparison.model_files import Model
from gaussiancad_core.kernel.brep import tessellate
from gaussiancad_core.model.meshes import make_mesh
from gaussiancad_core.samples.modelling import box

SHEETS = ("clean", "ends 2 px")


@pytest.fixture(scope="module")
def compared() -> Row:
    """A box that lacks a tenth of its height beside the whole one."""
    whole, lower = (
        Model(make_mesh(*tessellate(box((0, 0, 0), (100, 60, height)), 0.1))) for height in (50, 45)
    )
    options = CompareOptions(points=200, protocols=tuple(Protocol))
    return comparison_dict(compare_models(lower, whole, options)[0])


@pytest.fixture(scope="module")
def rows(compared: Row) -> list[Row]:
    """Two parts: one with all models, one whose engine was ended and whose swept outlines fail."""
    found = []
    for sheet in SHEETS:
        for part in ("one", "<two>"):
            for run in Run:
                models: Row = {
                    method.value: {
                        "status": "approximate",
                        "seconds": 2.0,
                        "exact": False,
                        "comparison": compared,
                        "picture": "QUJD",
                        "range_mm": 0.5,
                    }
                    for method in run.value
                }
                row: Row = {"part": part, "input": sheet, "run": run.name, "models": models}
                if part == "<two>" and run is Run.ENGINE:
                    row |= {"models": {method.value: {} for method in run.value}, "seconds": 90.0}
                    row["failure"] = "solve-over-time"
                if run is Run.ENGINE and part == "one":
                    models[Method.SOLID.value]["status"] = "verified"
                    models[Method.SOLID.value]["exact"] = sheet == "clean"
                if run is Run.OUTLINES and part == "<two>":
                    models[Method.SWEEP.value] = {"status": "failed", "failure": "no-model"}
                found.append(row)
    return found


@pytest.fixture(scope="module")
def content(rows: list[Row], tmp_path_factory: pytest.TempPathFactory) -> Content:
    tasks = tuple(ablation_tasks(30.0, quick=False))
    missing = [{**task.known, "failure": "solve-over-time"} for task in tasks]
    plan = Plan(tasks, tmp_path_factory.mktemp("plan"), 1, {"seed": "7"})
    return content_of(plan, [*rows, *missing])


def row_of(table: tuple[tuple[str, ...], ...], sheet: str, method: Method) -> tuple[str, ...]:
    return next(row[2:] for row in table if row[:2] == (sheet, method.value))


def test_tables_have_the_numbers_of_the_protocols(rows: list[Row], compared: Row) -> None:
    paper, deepcad, engineering, _ = (table.rows for table in result_tables(records_of(rows)))
    assert len(paper) == len(SHEETS) * len(Method)
    assert row_of(paper, "clean", Method.PAPER)[:2] == ("2/2", f"{compared['chamfer']:.4f}")
    assert row_of(paper, "clean", Method.SOLID)[0] == "1/2"
    # Nothing is scaled by engineers: a tenth of the height is a tenth of the volume.
    cells = row_of(engineering, "clean", Method.HULL)
    assert cells[5] == "10.00"
    assert float(cells[7]) == pytest.approx(0.9, abs=0.05)
    # What is missing is invalid.
    assert row_of(deepcad, "clean", Method.HULL)[-1] == "0"
    assert row_of(deepcad, "clean", Method.SWEEP)[-1] == "50"
    assert row_of(deepcad, "clean", Method.HULL)[1] == (
        f"{compared['protocols']['deepcad']['chamfer_x1000']:.4f}"
    )


def test_false_verdicts_are_counted(rows: list[Row]) -> None:
    verdicts = list(result_tables(records_of(rows)))[-1].rows
    # verified, approximate, failed, exact, false
    assert row_of(verdicts, "clean", Method.SOLID)[:5] == ("1", "0", "1", "1", "0")
    assert row_of(verdicts, "ends 2 px", Method.SOLID)[:5] == ("1", "0", "1", "0", "1")
    # The time until a run was ended counts.
    assert row_of(verdicts, "clean", Method.SOLID)[5:] == ("46.0", "90.0")


def test_what_was_verified_and_not_measured_is_false() -> None:
    record = Record("a", "clean", Method.SOLID, {"status": "verified", "failure": "over-time"})
    assert record.falsely_verified and record.status == "failed"


def test_what_ended_a_run_is_told(rows: list[Row]) -> None:
    failures = failure_table(records_of(rows)).rows
    assert ("clean", Method.SURFACE.value, "solve-over-time", "1") in failures
    assert ("clean", Method.SWEEP.value, "no-model", "1") in failures
    by_part = part_table(records_of(rows), "clean").rows
    assert [row[0] for row in by_part] == ["one", "<two>"]
    assert by_part[0][1 + list(Method).index(Method.SOLID)].endswith(" ve")
    assert by_part[1][1 + list(Method).index(Method.SOLID)] == "solve-over-time"


def test_the_page_holds_every_table_chart_and_picture(content: Content) -> None:
    text = benchmark_page(content).decode("utf-8")
    stated = unescape(text)
    tables = (PUBLISHED, *content.tables, *content.ablations)
    assert len(content.ablations) == 3 and len(content.tables) == 4 + 1 + len(SHEETS)
    for table in tables:
        assert table.title in stated and table.note in stated
        for name in (*table.head, *(cell for row in table.rows for cell in row)):
            assert f">{name}<" in stated, name
    assert text.count("data:image/png;base64,") == 4
    # One part has five models on both sheets, the other two on each.
    assert text.count("data:image/jpeg;base64,QUJD") == len(SHEETS) * (5 + 2)
    assert ">7<" in text and "Python" in text


def test_columns_of_numbers_stand_right(content: Content) -> None:
    text = benchmark_page(content).decode("utf-8")
    assert '<th class="number">CD</th>' in text and '<td class="number">0.307</td>' in text
    assert '<td class="number">1/2</td>' in text
    assert "<td>solve-over-time</td>" in text and "<th>method</th>" in text


@pytest.mark.parametrize(
    ("greatest", "top", "ticks"),
    [(0.6432, 0.8, 5), (1.0, 1.0, 6), (0.2581, 0.3, 4), (0.0, 1.0, 6), (37.0, 40.0, 5)],
)
def test_charts_end_at_a_round_number(greatest: float, top: float, ticks: int) -> None:
    assert round_scale(greatest) == (pytest.approx(top), ticks)


def test_values_that_stand_for_less_are_rings(tmp_path: Path) -> None:
    series = Series("", [1.0, 2.0], [False, True])
    write_chart(Chart("", ["a", "b"], [series]), tmp_path / "chart.png")
    blue = (cv2.imread(str(tmp_path / "chart.png")) == (180, 119, 31)).all(axis=2)
    dots = [blue[y - 3 : y + 4, x - 3 : x + 4] for x, y in ((100, 228), (530, 56))]
    assert [bool(dot[3, 3]) for dot in dots] == [True, False]
    assert all(dot[0, 3] for dot in dots)


def test_the_page_needs_nothing_and_names_are_text(content: Content) -> None:
    text = benchmark_page(content).decode("utf-8")
    assert not re.search(r"https?://|@import|url\(|<script", text)
    assert "<two>" not in text and "&lt;two&gt;" in text


def test_ablations_have_a_row_a_setting(content: Content) -> None:
    settings = [task.setting for task in ablation_tasks(1.0, quick=False)]
    assert [row[0] for table in content.ablations for row in table.rows] == settings
    assert all(isinstance(task, AblationTask) for task in ablation_tasks(1.0, quick=True))
    assert len(list(ablation_tasks(1.0, quick=True))) == 6
