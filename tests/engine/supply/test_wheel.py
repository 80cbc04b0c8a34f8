"""What others install: the wheel and the source archive, and what lies in them."""

import ast
import os
import runpy
import shutil
import subprocess
import sys
import tarfile
from email import message_from_string
from email.message import Message
from pathlib import Path
from zipfile import ZipFile

import pytest

ROOT = Path(__file__).resolve().parents[3]

BUILD = """
from setuptools import build_meta
build_meta.build_sdist("made")
build_meta.build_wheel("made")
"""

WINDOW = """
import sys
from pathlib import Path
from freecad.gaussiancad.canvas import failed, standalone, translator
from freecad.gaussiancad.qt import QtCore, QtWidgets
application = QtWidgets.QApplication([])
assert translator.load_language(QtCore.QTranslator(), ["de"])
window = standalone.StandaloneWindow()
for name, module in sys.modules.items():
    if name.startswith("freecad.") and getattr(module, "__file__", None):
        assert Path(module.__file__).is_relative_to(sys.argv[1]), name
assert not {"numpy", "gaussiancad_core", "FreeCAD"} & set(sys.modules)
print("opened")
"""


def run(program: str, *arguments: str, folder: Path, **variables: str) -> str:
    """What a program of Python prints."""
    command = [sys.executable, "-c", program, *arguments]
    done = subprocess.run(
        command,
        capture_output=True,
        encoding="utf-8",
        check=False,
        cwd=folder,
        env={**os.environ, **variables},
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder with both, made of a copy that has no links."""
    core = tmp_path_factory.mktemp("wheel") / "core"
    left_out = shutil.ignore_patterns("__pycache__", "*.egg-info", "build", "dist")
    shutil.copytree(ROOT / "core", core, ignore=left_out)
    run(BUILD, folder=core)
    return core / "made"


@pytest.fixture(scope="module")
def wheel(made: Path) -> ZipFile:
    (path,) = made.glob("*.whl")
    assert path.name.endswith("-py3-none-any.whl")
    return ZipFile(path)


@pytest.fixture(scope="module")
def facts(wheel: ZipFile) -> Message:
    (name,) = [entry for entry in wheel.namelist() if entry.endswith(".dist-info/METADATA")]
    return message_from_string(wheel.read(name).decode("utf-8"))


def test_the_links_lead_to_what_they_stand_for() -> None:
    text = (ROOT / "LICENSE").read_bytes()
    assert (ROOT / "core" / "LICENSE").read_bytes() == text
    assert (ROOT / "core" / "freecad").resolve() == ROOT / "freecad"
    translations = ROOT / "freecad" / "gaussiancad" / "translations"
    assert translations.resolve() == ROOT / "resources" / "translations"


def test_the_licence_is_inside(wheel: ZipFile, facts: Message) -> None:
    network = "gaussiancad_core/writing/text_network/LICENSE"
    assert facts["License-Expression"] == "LGPL-2.1-or-later AND Apache-2.0"
    assert facts.get_all("License-File") == ["LICENSE", network]
    for text, path in (("LICENSE", ROOT / "LICENSE"), (network, ROOT / "core" / network)):
        (name,) = [
            entry for entry in wheel.namelist() if entry.endswith(f".dist-info/licenses/{text}")
        ]
        assert wheel.read(name) == path.read_bytes()


def test_it_describes_itself(facts: Message) -> None:
    text = (ROOT / "core" / "README.md").read_text(encoding="utf-8")
    assert facts.get_payload().strip() == text.strip()
    assert facts["Description-Content-Type"] == "text/markdown"
    urls = facts.get_all("Project-URL")
    assert urls and all("https://example.org/" in entry for entry in urls)
    assert len(facts["Keywords"].split(",")) > 3
    assert "Typing :: Typed" in facts.get_all("Classifier")


def test_type_checkers_find_the_types(wheel: ZipFile) -> None:
    for package in ("gaussiancad", "gaussiancad_core", "gaussiancad_protocol"):
        assert f"{package}/py.typed" in wheel.namelist()


def test_what_is_for_a_checkout_is_not_inside(wheel: ZipFile) -> None:
    names = wheel.namelist()
    places = {name.partition("/")[0] for name in names if ".dist-info/" not in name}
    assert places == {"freecad", "gaussiancad", "gaussiancad_core", "gaussiancad_protocol"}


def test_each_module_of_the_engine_is_inside(wheel: ZipFile) -> None:
    core = ROOT / "core"
    inside = {name for name in wheel.namelist() if name.startswith("gaussiancad")}
    for package in ("gaussiancad", "gaussiancad_core", "gaussiancad_protocol"):
        for path in (core / package).rglob("*.py"):
            name = path.relative_to(core).as_posix()
            assert name in inside, name
    assert "gaussiancad_core/sheet/labels/labels.onnx" in inside
    network = "gaussiancad_core/writing/text_network/"
    there = {path.name for path in (core / network).iterdir()}
    assert {name.removeprefix(network) for name in inside if name.startswith(network)} == there


def test_the_window_opens_from_the_wheel_alone(wheel: ZipFile, tmp_path: Path) -> None:
    wheel.extractall(tmp_path / "site")
    place = str(tmp_path / "site")
    said = run(WINDOW, place, folder=tmp_path, PYTHONPATH=place, QT_QPA_PLATFORM="offscreen")
    assert said == "opened\n"


def test_of_the_workbench_only_the_window_is_inside(wheel: ZipFile, tmp_path: Path) -> None:
    wheel.extractall(tmp_path / "site")
    listing = WINDOW.replace(
        'print("opened")',
        'print("\\n".join(name for name in sys.modules if name.startswith("freecad.")))',
    )
    place = str(tmp_path / "site")
    said = run(listing, place, folder=tmp_path, PYTHONPATH=place, QT_QPA_PLATFORM="offscreen")
    inside = {
        name.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
        for name in wheel.namelist()
        if name.startswith("freecad/") and name.endswith(".py")
    }
    assert inside == set(said.split())


def test_the_source_archive_has_what_the_wheel_is_made_of(made: Path, wheel: ZipFile) -> None:
    (path,) = made.glob("*.tar.gz")
    with tarfile.open(path) as archive:
        assert all(entry.isfile() or entry.isdir() for entry in archive.getmembers())
        names = {entry.name.partition("/")[2] for entry in archive.getmembers()}
    assert {"LICENSE", "README.md", "pyproject.toml", "setup.py"} <= names
    assert {name for name in wheel.namelist() if ".dist-info/" not in name} <= names


def test_an_old_python_is_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = ROOT / "core" / "gaussiancad_core" / "__main__.py"
    text = path.read_text(encoding="utf-8")
    # Python 3.7 can read it, and leaves before anything that it could not.
    ast.parse(text, feature_version=(3, 7))
    monkeypatch.setattr(sys, "version_info", (3, 7, 3))
    with pytest.raises(SystemExit) as ended:
        runpy.run_path(str(path))
    assert ended.value.code == 6
    assert "Python 3.7 is too old" in capsys.readouterr().err
