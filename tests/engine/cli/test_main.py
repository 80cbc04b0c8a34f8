"""The command line: exit codes, and one line for every mistake."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from gaussiancad_core.cli import main


def _line(capsys: pytest.CaptureFixture[str]) -> str:
    errors = capsys.readouterr().err
    assert errors.count("\n") == 1 and errors.startswith("gaussiancad: ")
    return errors


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["nonsense"],
        ["reconstruct", "a.png"],
        ["reconstruct", "a.png", "--output", "o", "--view", "front=1,2,3"],
        ["reconstruct", "a.png", "--output", "o", "--view", "inside=1,2,3,4"],
        ["reconstruct", "a.png", "--output", "o", "--view", "front=3,2,1,4"],
        ["reconstruct", "a.png", "--output", "o", "--length", "w=3"],
        ["reconstruct", "a.png", "--output", "o", "--length", "x=-3"],
        ["reconstruct", "a.png", "--output", "o", "--mm-per-pixel", "nan"],
        ["reconstruct", "a.png", "--output", "o", "--colour", "red"],
        ["reconstruct", "a.png", "--output", "o", "--seed", "-1"],
        ["reconstruct", "a.png", "--output", "o", "--page", "0"],
        ["reconstruct", "a.png", "--output", "o", "--preset", "best"],
        ["reconstruct", "", "--output", "o"],
        ["read", "a.png", "--output", ""],
        ["draw", "a.step", "b.png", "--projection", "second"],
    ],
)
def test_wrong_usage_is_one_line_and_exit_code_2(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    assert caught.value.code == 2
    assert "[wrong-usage]" in _line(capsys)


@pytest.mark.parametrize(
    ("arguments", "exit_code", "code"),
    [
        (["reconstruct", "missing.png", "--output", "{tmp}/o"], 3, "file-missing"),
        (["reconstruct", "{tmp}/text.png", "--output", "{tmp}/o"], 3, "not-an-image"),
        (["reconstruct", "{tmp}/a.pdf", "--output", "{tmp}/o"], 3, "damaged-pdf"),
        (["reconstruct", "{tmp}/text.png", "--output", "{tmp}/text.png/o"], 2, "output-not-wri"),
        (["reconstruct", "{tmp}/text.png", "--output", "{tmp}/o", "--device", "cuda"], 6, "cuda-"),
        (["reconstruct", "{tmp}/empty.png", "--output", "{tmp}/o"], 3, "empty-file"),
        (["reconstruct", "{tmp}", "--output", "{tmp}/o"], 3, "not-a-file"),
        (["reconstruct", ".", "--output", "{tmp}/o"], 3, "not-a-file"),
        (["read", "/", "--output", "{tmp}/o"], 3, "not-a-file"),
        (["compare", "{tmp}/text.png", "missing.step"], 3, "model-format-unknown"),
        (["draw", "missing.step", "{tmp}/a.png"], 3, "file-missing"),
        (["draw", "missing.step", "{tmp}/a.png", "--style", "rough"], 2, "style-unknown"),
    ],
)
def test_errors_are_one_line_with_their_code(
    arguments: list[str],
    exit_code: int,
    code: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / "text.png").write_text("this is text")
    (tmp_path / "a.pdf").write_bytes(b"%PDF-1.7")
    (tmp_path / "empty.png").write_bytes(b"")
    assert main([argument.format(tmp=tmp_path) for argument in arguments]) == exit_code
    assert f"[{code}" in _line(capsys)


def test_a_role_can_be_named_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    box = ["--view", "front=0,0,9,9"]
    assert main(["reconstruct", "a.png", "--output", str(tmp_path / "o"), *box, *box]) == 2
    assert "[view-repeated]" in _line(capsys)


def test_draw_and_compare_print_what_they_made(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from gaussiancad_core.kernel.brep_files import write_step
    from sample_parts import SAMPLES

    part = next(sample for sample in SAMPLES if sample.name == "pocket-block")
    write_step(part.build(), tmp_path / "p 图.step")
    capsys.readouterr()
    assert main(["draw", str(tmp_path / "p 图.step"), str(tmp_path / "s.png")]) == 0
    assert "3 views" in capsys.readouterr().out and (tmp_path / "s.png").exists()
    both = [str(tmp_path / "p 图.step")] * 2
    assert main(["compare", *both, "--json", "--points", "500"]) == 0
    figures = json.loads(capsys.readouterr().out)
    assert figures["schema"] == 1 and figures["volume_iou"] == pytest.approx(1.0)


def test_the_doctor_finds_this_engine_complete(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["doctor"]) == 0
    assert "the engine is complete" in capsys.readouterr().out


HEAVY = {
    *("numpy", "scipy", "cv2", "skimage", "PIL", "numba", "torch", "open3d", "trimesh"),
    *("manifold3d", "OCP", "ortools", "pandas", "psutil", "onnxruntime"),
}


def _loaded(*arguments: str) -> tuple[int, set[str]]:
    """Exit code of the command in a process of its own, and the heavy libraries that it loaded."""
    program = (
        "import sys\n"
        "from gaussiancad_core.cli import main\n"
        "code = 0\n"
        "try: code = main(sys.argv[1:])\n"
        "except SystemExit as end: code = end.code\n"
        "print('\\n' + ' '.join(sys.modules))\n"
        "sys.exit(code)"
    )
    command = [sys.executable, "-c", program, *arguments]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    return done.returncode, HEAVY & set(done.stdout.splitlines()[-1].split())


@pytest.mark.parametrize(
    ("arguments", "exit_code"),
    [
        (["--help"], 0),
        (["reconstruct", "--help"], 0),
        (["reconstruct"], 2),
        (["reconstruct", "{tmp}/a.png", "--output", "{tmp}/o", "--seed", "x"], 2),
        (["reconstruct", "{tmp}/missing.png", "--output", "{tmp}/o"], 3),
        (["reconstruct", "{tmp}/a.dwg", "--output", "{tmp}/o"], 3),
        (["reconstruct", "{tmp}/a.png", "--output", "{tmp}/a.png/o"], 2),
    ],
)
def test_what_can_be_told_at_once_loads_no_heavy_library(
    arguments: list[str], exit_code: int, tmp_path: Path
) -> None:
    (tmp_path / "a.png").write_bytes(b"\x89PNG\r\n\x1a\n")
    (tmp_path / "a.dwg").write_bytes(b"AC1032")
    stated = _loaded(*(argument.format(tmp=tmp_path) for argument in arguments))
    assert stated == (exit_code, set())
    assert {path.name for path in tmp_path.iterdir()} == {"a.png", "a.dwg"}


def test_a_run_for_the_solid_alone_loads_nothing_that_makes_surfaces(
    plain_picture: Path, tmp_path: Path
) -> None:
    options = ("--result", "solid", "--length", "x=80")
    code, heavy = _loaded(
        "reconstruct", str(plain_picture), "--output", str(tmp_path / "o"), *options
    )
    assert code == 0
    assert "OCP" in heavy
    assert not heavy & {"torch", "open3d", "trimesh", "manifold3d"}


def test_a_file_whose_strokes_tell_its_views_loads_nothing_that_follows_pixels(
    tmp_path: Path,
) -> None:
    front, top = '<rect x="60" y="120" width="80" height="40"/>', '<rect x="60" y="50" width="80"'
    (tmp_path / "plate.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="200mm" '
        'viewBox="0 0 200 200"><g fill="none" stroke="#000" stroke-width="0.5">'
        f'{front}{top} height="50"/></g></svg>'
    )
    code, heavy = _loaded("read", str(tmp_path / "plate.svg"), "--output", str(tmp_path / "o"))
    reading = json.loads((tmp_path / "o" / "reading.json").read_text("utf-8"))
    assert code == 0 and {view["role"] for view in reading["views"]} == {"front", "top"}
    assert "cv2" in heavy and not heavy & {"scipy", "numba", "onnxruntime", "OCP"}


def test_batch_goes_on_after_a_sheet_that_fails(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "text.png").write_text("this is text")
    sheets = [str(tmp_path / "text.png"), str(tmp_path / "missing.png")]
    assert main(["batch", *sheets, "--output", str(tmp_path / "out"), "--workers", "2"]) == 1
    rows = (tmp_path / "out" / "report.csv").read_text("utf-8").splitlines()
    assert len(rows) == 3
    assert "not-an-image" in rows[1] and "file-missing" in rows[2]
    assert capsys.readouterr().out.count("failed") == 2
