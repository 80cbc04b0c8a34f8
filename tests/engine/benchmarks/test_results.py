"""The store of results, and the page that is written from it."""

from dataclasses import replace
from pathlib import Path

from benchmarks.run.catalogue import entries
from benchmarks.run.figures_page import CHAPTERS, PAGE, figures_page
from benchmarks.run.outcome import Figure, Outcome, as_table, share
from benchmarks.run.results import RESULTS, Result, record, result_now, results_of

_RESULT = Result("two sheets", "abc1234", "2026-01-02", "--parts 2", figures=(Figure("IoU", 0.5),))


def test_the_page_is_what_the_results_give() -> None:
    assert PAGE.read_text(encoding="utf-8") == figures_page()


def test_every_question_has_a_result() -> None:
    assert {path.stem for path in RESULTS.iterdir()} == {entry.name for entry in entries()}


def test_every_file_of_results_is_that_of_a_benchmark_and_is_on_the_page() -> None:
    names = {entry.name for entry in entries()}
    recorded = {path.stem for path in RESULTS.iterdir()}
    assert recorded <= names
    assert {name for chapter in CHAPTERS.values() for name in chapter} <= names
    text = figures_page()
    for name in recorded:
        assert f"`python -m benchmarks {name}`" in text
        assert all(result.figures and result.commit for result in results_of(name))


def test_a_result_is_kept_and_replaced_by_a_later_run_of_the_same_options(tmp_path: Path) -> None:
    limited = replace(_RESULT, limits="Looked at while it was made.")
    record("verified", limited, tmp_path)
    other = replace(_RESULT, options="--parts 3", figures=(share("exact", 1, 3),))
    record("verified", other, tmp_path)
    assert results_of("verified", tmp_path) == (limited, other)
    later = replace(_RESULT, commit="def5678", about="anything")
    record("verified", later, tmp_path)
    # What qualifies a figure still does.
    kept = replace(later, about=limited.about, limits=limited.limits)
    assert results_of("verified", tmp_path) == (other, kept)
    assert [path.name for path in tmp_path.iterdir()] == ["verified.json"]


def test_a_table_stands_below_its_figures(tmp_path: Path) -> None:
    table = replace(_RESULT, head=("sheet", "IoU"), rows=(("a", "0.25"), ("b", "0.75")))
    record("verified", table, tmp_path)
    assert results_of("verified", tmp_path) == (table,)
    text = figures_page(tmp_path)
    assert "| sheet | IoU |\n| --- | --- |\n| a | 0.25 |\n| b | 0.75 |\n" in text
    assert "**two sheets** (`--parts 2`; abc1234, 2026-01-02): IoU: 0.5." in text


def test_a_run_of_now_has_its_commit_and_machine() -> None:
    outcome = Outcome((Figure("s", 1.25, "s"),), head=("sheet",), rows=(("a",),))
    result = result_now(outcome, "--parts 2", "all parts")
    assert (result.head, result.rows) == (outcome.head, outcome.rows)
    assert result.commit and result.machine
    assert result.headline == f"{result.date} {result.commit}: s: 1.25 s"


def test_columns_of_numbers_stand_right() -> None:
    lines = as_table(("", "sheets"), [("all", 3), ("the others", "10 %")]).splitlines()
    assert lines == ["            sheets", "all              3", "the others    10 %"]
