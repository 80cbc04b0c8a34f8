"""The examples of the documentation run as they stand."""

import doctest
import re
import shutil
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest
from PIL import Image

import gaussiancad

pytestmark = pytest.mark.slow

CHECKOUT = Path(__file__).resolve().parents[2]


@pytest.fixture
def folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, plain_picture: Path, plain_step: Path
) -> Path:
    """A folder with the files that examples name."""
    shutil.copy(plain_picture, tmp_path / "sheet.png")
    shutil.copy(plain_step, tmp_path / "truth.step")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def examples_of(page: str) -> list[str]:
    """The programs of a page of the checkout."""
    text = (CHECKOUT / page).read_text("utf-8")
    return re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


def test_the_page_on_python(folder: Path) -> None:
    examples = examples_of("docs/python.md")
    assert len(examples) >= 4
    names: dict[str, object] = {}
    for example in examples:
        exec(compile(example, "docs/python.md", "exec"), names)
    part = names["part"]
    assert isinstance(part, gaussiancad.Result)
    assert part.status == "verified"
    assert (folder / "part" / "solid.step").is_file()
    assert (folder / "drawn.png").is_file()


def test_the_first_page(folder: Path) -> None:
    (example,) = examples_of("README.md")
    Image.open("sheet.png").save("sheet.pdf", resolution=50.0)
    quick = SimpleNamespace(reconstruct=partial(gaussiancad.reconstruct, preset="draft"))
    names: dict[str, object] = {"gaussiancad": quick}
    exec(compile(example, "README.md", "exec"), names)
    result = names["result"]
    assert isinstance(result, gaussiancad.Result)
    assert result.status == "verified"
    # What the page says of the folder.
    for name in ("report.json", "solid.step", "surface.stl", "gaussians.ply", "overlay.png"):
        assert (folder / "model" / name).is_file()


def test_the_page_of_the_wheel_has_the_same_example() -> None:
    (example,) = examples_of("README.md")
    assert examples_of("core/README.md") == [f"import gaussiancad\n\n{example}"]


def test_the_package_itself(folder: Path) -> None:
    shutil.copy(CHECKOUT / "resources" / "samples" / "l-bracket.png", folder / "sheet.png")
    assert doctest.testmod(gaussiancad, verbose=False) == (0, 4)
