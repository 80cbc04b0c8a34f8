"""The commands of the first pages run as they stand, as far as a machine without a window can.

What takes long is given a small sample, or options that make it short.  What opens a window, stays,
or needs FreeCAD or a GPU is asked for its help, and make for what it would do.  A command of a kind
that nobody thought of here fails: say how it is tried.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from doc_commands import lines_of
from doc_texts import CHECKOUT, Kind, page_passages

pytestmark = pytest.mark.slow

_BEGINS = re.compile(
    r"(?:\w+=\S+ )*(?:make |sudo make |\.venv/bin/|python3? |\.ci/\w|gaussiancad )"
)
"""How a command begins that is meant to be typed."""

_PLACEHOLDER = re.compile(r"(?<![\w=-])[A-Z]{3,}\b(?!=)|[A-Z]+\.\.\.|\[")

LONG = {
    "reconstruct": "--result solid",
    "batch": "--result solid",
    "learning": "--steps 1 --parts 2 --size 64 --batch 2 --workers 1 --device cpu",
}
"""What is added to commands that take long otherwise."""

PICTURES = {"gallery_pictures.py": ["clean"], "sample_sheets.py": []}
"""Scripts that write among the documentation or the samples if no folder is named, and the pictures
that are named to them besides."""

HELP = {"correct", "serve"}
"""Of the engine, what opens a window or stays."""

Command = list[str]


def commands_of(page: str, spans: bool) -> list[str]:
    """The commands that a page has in blocks, and those between backticks if asked for."""
    path = CHECKOUT / page
    found: list[str] = []
    for passage in page_passages(path, path.read_text("utf-8")):
        if passage.kind is Kind.COMMANDS:
            found += [line for _, line in lines_of(passage.text) if _BEGINS.match(line)]
        elif spans:
            found += [span for _, span in passage.spans() if _BEGINS.match(span)]
    return list(dict.fromkeys(line for line in found if not _PLACEHOLDER.search(line)))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory, plain_picture: Path, plain_step: Path) -> Path:
    """A folder with the files that commands name."""
    place = tmp_path_factory.mktemp("typed")
    shutil.copy(plain_picture, place / "sheet.png")
    shutil.copy(plain_step, place / "reference.step")
    for name in ("sheets", "drawings"):
        (place / name).mkdir()
        shutil.copy(plain_picture, place / name)
    return place


def done(command: Command, folder: Path) -> str:
    """What a command prints; it ends well."""
    places = [str(CHECKOUT / "core"), str(CHECKOUT), *(path for path in sys.path if path)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(places)}
    ended = subprocess.run(
        command,
        cwd=folder,
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert ended.returncode == 0, (command, ended.stdout[-2000:], ended.stderr[-2000:])
    return ended.stdout


def helped(command: Command, folder: Path) -> None:
    """The help of a command has each of its options."""
    options = [word for word in command if word.startswith("--")]
    first = next((index for index, word in enumerate(command) if word.startswith("--")), None)
    text = done([*command[:first], "--help"], folder)
    assert [option for option in options if option not in text] == []


def of_the_engine(words: Command, folder: Path) -> None:
    """``gaussiancad …``"""
    start = [sys.executable, "-m", "gaussiancad_core"]
    if words[0] in HELP:
        helped([*start, *words], folder)
    else:
        done([*start, *words, *LONG.get(words[0], "").split()], folder)


def of_make(words: Command, folder: Path) -> None:
    """``make …``: what it would do."""
    assert done(["make", "--directory", str(CHECKOUT), "--dry-run", *words], folder)


def of_a_module(words: Command, folder: Path) -> None:
    """``python -m …``"""
    start = [sys.executable, "-m"]
    name, *rest = words
    if name == "pytest":
        asked = [str(CHECKOUT / word) if word.startswith("tests/") else word for word in rest]
        assert " passed" in done([*start, name, *asked], folder)
    elif name == "benchmarks" and not rest[0].startswith("--"):
        helped([*start, *words], folder)
    elif name == "learning" and "--steps" not in rest:
        # A page names the same with fewer steps.
        helped([*start, *words], folder)
    elif name == "build":
        assert (CHECKOUT / rest[0] / "pyproject.toml").is_file()
    else:
        done([*start, *words, *LONG.get(name, "").split()], folder)


def of_a_file(words: Command, folder: Path) -> None:
    """``python3 FILE …``"""
    path = CHECKOUT / words[0]
    if path.name == "gaussiancad_batch.py":
        if shutil.which("freecadcmd"):
            helped([sys.executable, str(path), *words[1:]], folder)
    elif path.name in PICTURES:
        done([sys.executable, str(path), str(folder), *PICTURES[path.name]], folder)
    elif path.name == "run_freecad_suites.py":
        assert (CHECKOUT / "tests" / words[1]).is_dir()
    else:
        done([sys.executable, str(path), *words[1:]], folder)


WAYS: list[tuple[str, Callable[[Command, Path], None]]] = [
    (r"(?:sudo )?make ", of_make),
    (r"(?:\.venv/bin/)?gaussiancad ", of_the_engine),
    (r"(?:\.venv/bin/)?python3? -m ", of_a_module),
    (r"(?:\w+=\S+ )*(?:\.venv/bin/)?python3? (?=\w)", of_a_file),
]
"""How a command begins, and how the rest of it is tried."""


def tried(command: str, folder: Path) -> None:
    """Try one command."""
    for begin, way in WAYS:
        if match := re.match(begin, command):
            way(shlex.split(command[match.end() :], comments=True), folder)
            return
    if command == ".ci/run":
        done(["bash", "-n", str(CHECKOUT / command)], folder)
        return
    pytest.fail(f"nobody says how `{command}` is tried")


def test_the_first_page_has_commands_for_each_thing_to_do() -> None:
    found = commands_of("README.md", spans=False)
    assert len(found) >= 10
    assert {command.split()[0] for command in found} == {"make", ".venv/bin/gaussiancad", "python3"}


def test_the_commands_of_the_first_page_run_one_after_the_other(folder: Path) -> None:
    for command in commands_of("README.md", spans=True):
        tried(command, folder)
    for name in ("model/solid.step", "features/features.py", "comparison/comparison.json"):
        assert (folder / name).is_file()
    assert (folder / "models" / "report.csv").is_file()


def others() -> Iterator[object]:
    """Commands of the other pages, those that the first one has left out."""
    known = set(commands_of("README.md", spans=True))
    for page in ("CONTRIBUTING.md", "learning/README.md"):
        for command in commands_of(page, spans=True):
            if command not in known:
                known.add(command)
                yield pytest.param(command, id=f"{page}: {command}")


@pytest.mark.parametrize("command", list(others()))
def test_the_commands_for_contributors_run(folder: Path, command: str) -> None:
    tried(command, folder)
