"""A run in sentences."""

import json
from pathlib import Path

import pytest

from gaussiancad_core.cli import main
from gaussiancad_core.report.explanation import explained, explained_place, explained_view, verdict

_RUN = Path(__file__).with_name("explained_run.json")
_REPORT, _READING = json.loads(_RUN.read_text(encoding="utf-8")).values()


@pytest.mark.parametrize(
    ("status", "source", "shape", "where"),
    [
        ("verified", "drawing", "Shape verified.", "from the drawing"),
        ("verified", "numbers", "Shape verified.", "from the sheet's numbers"),
        ("approximate", "drawing", "Shape not certain.", "from the drawing"),
    ],
)
def test_the_verdict_speaks_of_shape_and_measures(
    status: str, source: str, shape: str, where: str
) -> None:
    measures = {"uncertainty_mm": 0.0812, "source": source}
    assert verdict({**_REPORT, "status": status, "measures": measures}) == (
        f"{shape} Measures to ±0.081 mm ({where})."
    )


@pytest.mark.parametrize(
    ("scale", "warnings", "known"),
    [
        ("default", [], False),
        ("sheet", [{"code": "full-scale-assumed", "message": "", "args": {}}], False),
        ("sheet", [{"code": "full-scale-assumed", "message": "", "args": {"case": "file"}}], True),
        ("sheet", [], True),
        ("dimension", [{"code": "views-disagree", "message": ""}], True),
    ],
)
def test_what_nobody_knows_the_size_of_has_no_measures(
    scale: str, warnings: list[dict], known: bool
) -> None:
    measures = {"uncertainty_mm": 0.0812, "source": "drawing"}
    stated = {"status": "verified", "scale_source": scale, "warnings": warnings}
    line = verdict({**_REPORT, **stated, "measures": measures})
    assert line.startswith("Shape verified. Measures" if known else "Size unknown")


@pytest.mark.parametrize(
    ("reasons", "warnings"), [(["photographed-at-a-slant"], []), ([], ["views-disagree"])]
)
def test_views_that_fit_no_one_scale_have_no_bound(reasons: list[str], warnings: list[str]) -> None:
    stated = {
        "status": "approximate",
        "scale_source": "dimension",
        "measures": None,
        "reasons": [{"code": code, "message": ""} for code in reasons],
        "warnings": [{"code": code, "message": ""} for code in warnings],
    }
    line = verdict({**_REPORT, **stated})
    assert line.startswith("Shape not certain. How exact its measures are is not known")


def test_a_failure_says_why() -> None:
    failed = {**_REPORT, "status": "failed", "measures": None}
    assert verdict(failed) == "No model. The solid does not show a line."


def test_all_that_was_tried_is_told_in_order() -> None:
    lines = explained(_REPORT)
    text = "\n".join(lines)
    assert lines[0] == verdict(_REPORT)
    first, second = (text.index(f"{number}. ") for number in (1, 2))
    assert first < second
    for words in (
        "the solid does not show a line [lines-unexplained]",
        "nothing lies inside; otherwise: bores",
        "the front view at (10, 20)-(210, 120) px, no hidden line in it",
        "third angle projection (by its lines)",
        "(120 rules over 30 cells): no solid: its lines contradict each other",
        "a solid whose lines differ from the sheet's; this one was taken",
        "a stretch where nothing is drawn of 4.2 mm in the front view at (50, 60) px",
        "Edges that bound one face only, at (x, y, z) mm: (1.0, 2.0, 3.0)",
        "all others agree where it is drawn not at all",
    ):
        assert words in text


@pytest.mark.parametrize(
    ("at", "text"),
    [
        ((150, 22), "A visible line of 200 px of the front view (s1)."),
        ((100, 91), "A hidden arc of 63 px of the front view, 80.0 % sure (s2)."),
        ((141, 270), "A visible ellipse of the top view (s3)."),
        ((320, 30), "A text: no line of the part (s4)."),
        (
            (620, 21),
            "A visible line of 40 px of the front view, 52.0 % sure (s5). The labels network tells "
            "it by the look of its ink. If that is wrong, it is a dimension line.",
        ),
        (
            (620, 81),
            "A centre of 40 px: no line of the part, 90.0 % sure (s6). Its width, colour or "
            "rhythm tells it; its look is that of an edge. If that is wrong, it is a hidden "
            "edge.",
        ),
        ((620, 141), "A hidden line of 40 px of the front view (s7). A person said so."),
        ((450, 70), "It lies within a section that was not used: it shows more."),
        ((100, 48), "No line was read at (100, 48) px; the nearest is 28 px away."),
        ((50, 62), "the solid lacks 4.1 mm of line in the front view, at (52, 61) px"),
    ],
)
def test_a_place_is_told_what_is_known_of_it(at: tuple[float, float], text: str) -> None:
    assert text in explained_place(_REPORT, _READING, at)


def test_a_view_is_told_with_what_was_given_up_in_it() -> None:
    lines = explained_view(_REPORT, _READING, "front")
    assert lines[0].endswith("has 2 visible and 2 hidden lines.")
    # What is not all is not called all.
    assert "99.9 %" in lines[1]
    assert any(line.startswith("- a stretch where nothing is drawn") for line in lines)


def _written(folder: Path) -> Path:
    (folder / "report.json").write_text(json.dumps(_REPORT), encoding="utf-8")
    (folder / "reading.json").write_text(json.dumps(_READING), encoding="utf-8")
    return folder


def test_the_command_prints_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = _written(tmp_path)
    assert main(["explain", str(folder)]) == 0
    assert capsys.readouterr().out.splitlines() == explained(_REPORT)
    assert main(["explain", str(folder), "--at", "150,22"]) == 0
    assert "(s1)" in capsys.readouterr().out
    assert main(["explain", str(folder), "--view", "top"]) == 0
    assert capsys.readouterr().out.startswith("The top view")


@pytest.mark.parametrize(
    ("arguments", "code", "exit_code"),
    [(["--view", "left"], "unknown-view", 2), (["--at", "4"], "wrong-usage", 2)],
)
def test_what_cannot_be_asked_is_one_line(
    arguments: list[str],
    code: str,
    exit_code: int,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["explain", str(_written(tmp_path)), *arguments]) == exit_code
    error = capsys.readouterr().err
    assert f"[{code}]" in error and error.count("\n") == 1


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (None, "no-report"),
        ("{", "damaged-report"),
        ("[" * 100_000, "damaged-report"),
        ('{"schema": 1}', "old-report"),
    ],
)
def test_a_folder_without_a_readable_report_is_one_line(
    text: str | None, code: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if text is not None:
        (tmp_path / "report.json").write_text(text, encoding="utf-8")
    assert main(["explain", str(tmp_path)]) == 3
    error = capsys.readouterr().err
    assert f"[{code}]" in error and error.count("\n") == 1


@pytest.mark.parametrize(
    "text", ["[", "[]", '{"schema": "gaussiancad-construction/1"}', '{"schema": 1}']
)
def test_a_construction_that_is_none_is_told_in_one_line(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = _written(tmp_path)
    assert main(["explain", str(folder)]) == 0
    (folder / "construction.json").write_text(text, encoding="utf-8")
    assert main(["explain", str(folder)]) == 3
    stated = capsys.readouterr().err.strip()
    assert stated.count("\n") == 0
    assert stated.endswith(("[damaged-report]", "[old-report]"))
