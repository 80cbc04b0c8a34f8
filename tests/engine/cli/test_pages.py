"""``--page all``: each page of a file by itself."""

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
    told = capsys.readouterr()
    assert [own.name for own in sorted(output.iterdir())] == ["page-1", "page-3"]
    assert (output / "page-3" / "reading.json").is_file()
    assert told.out.count("front, top, right") == 2
    (line,) = told.err.strip().splitlines()
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
