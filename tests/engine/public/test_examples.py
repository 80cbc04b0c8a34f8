"""The examples of the documentation run as they stand."""

import doctest
import re
import shutil
from pathlib import Path

import pytest

import gaussiancad

CHECKOUT = Path(__file__).resolve().parents[3]
SAMPLES = CHECKOUT / "resources" / "samples"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the files that examples name."""
    for name, sample in (
        ("sheet.png", "l-bracket.png"),
        ("truth.step", "l-bracket.step"),
    ):
        shutil.copy(SAMPLES / sample, tmp_path / name)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_page_on_python(folder: Path) -> None:
    text = (CHECKOUT / "docs" / "python.md").read_text("utf-8")
    examples = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert len(examples) >= 4
    names: dict[str, object] = {}
    for example in examples:
        exec(compile(example, "docs/python.md", "exec"), names)
    part = names["part"]
    assert isinstance(part, gaussiancad.Result)
    assert part.status == "verified"
    assert (folder / "part" / "solid.step").is_file()
    assert (folder / "drawn.png").is_file()


def test_the_package_itself(folder: Path) -> None:
    assert doctest.testmod(gaussiancad, verbose=False) == (0, 4)
