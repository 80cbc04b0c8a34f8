"""``--page all``: each page of a file by itself."""

import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

from gaussiancad_core.cli import main

SAMPLES = Path(__file__).resolve().parents[3] / "resources" / "samples"


def _pages(path: Path, *pictures: Image.Image) -> Path:
    first, *rest = pictures
    first.save(path, save_all=True, append_images=rest)
    return path


def _sample(name: str) -> Image.Image:
    return Image.open(SAMPLES / name).convert("L")


def test_each_page_has_a_folder_and_one_that_fails_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    blank = Image.new("L", (400, 300), 255)
    sheet = _pages(tmp_path / "set.tif", _sample("boss-plate.png"), blank, _sample("l-bracket.png"))
    output = tmp_path / "out"
    assert main(["read", str(sheet), "--output", str(output), "--page", "all"]) == 1
    stated = capsys.readouterr()
    assert [path.name for path in sorted(output.iterdir())] == ["page-1", "page-3"]
    assert (output / "page-3" / "reading.json").is_file()
    assert stated.out.count("front, top, right") == 2
    (line,) = stated.err.strip().splitlines()
    assert line.startswith("gaussiancad: page 2: ") and line.endswith("[blank-sheet]")


def test_where_no_page_is_a_drawing_the_first_failure_counts(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    blank = Image.new("L", (400, 300), 255)
    sheet = _pages(tmp_path / "set.tif", blank, blank)
    assert main(["read", str(sheet), "--output", str(tmp_path / "o"), "--page", "all"]) == 4
    assert capsys.readouterr().err.count("[blank-sheet]") == 3


def test_a_file_that_speaks_of_one_page_goes_with_one_page(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sheet = _pages(tmp_path / "set.tif", _sample("boss-plate.png"))
    command = ["read", str(sheet), "--output", str(tmp_path / "o"), "--page", "all"]
    assert main([*command, "--reading", "reading.json"]) == 2
    assert "[one-page-only]" in capsys.readouterr().err


def test_a_page_too_far_is_told_before_what_works_on_pages_is_loaded(tmp_path: Path) -> None:
    sheet = _pages(tmp_path / "set.tif", _sample("boss-plate.png"))
    heavy = ("gaussiancad_core.run.check_stage", "gaussiancad_core.run.read_run", "torch", "open3d")
    code = (
        "import sys; from gaussiancad_core.cli import main; code = main(sys.argv[1:]); "
        f"print(code, [name for name in {heavy!r} if name in sys.modules])"
    )
    arguments = ["reconstruct", str(sheet), "--page", "999999", "--output", str(tmp_path / "out")]
    ended = subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True
    )
    assert ended.stdout == "3 []\n" and "[page-missing]" in ended.stderr
