"""What an installation without extras does, and what it says of what it lacks."""

import json
import os
import subprocess
import sys
import tomllib
from importlib import metadata
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from gaussiancad_core.errors import EngineError
from gaussiancad_core.storage.extras import MODULES, Extra, demand, lacking, result_kind
from gaussiancad_protocol.exit_codes import ExitCode
from gaussiancad_protocol.modes import ResultKind

ROOT = Path(__file__).resolve().parents[3]

BLOCKED = (
    *("torch", "open3d", "trimesh", "manifold3d", "ot", "distributed", "mcp", "onnx"),
    *("PySide6", "gsplat", "skimage"),
)
"""Top-level modules of the extras' packages."""

PLAIN = """
import sys
from importlib.machinery import PathFinder

class Plain(PathFinder):
    @classmethod
    def find_spec(cls, name, path=None, target=None):
        if name.partition(".")[0] in {blocked}:
            return None
        return super().find_spec(name, path, target)

sys.meta_path[:] = [Plain if finder is PathFinder else finder for finder in sys.meta_path]
from gaussiancad_core.cli import main
sys.exit(main(sys.argv[1:]))
"""
"""A command where none of these can be found, as if they were not installed."""


def plain(*arguments: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """The command in an environment without extras."""
    program = PLAIN.format(blocked=set(BLOCKED))
    command = [sys.executable, "-c", program, *arguments]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    return subprocess.run(
        command, capture_output=True, encoding="utf-8", check=False, cwd=folder, env=environment
    )


def test_what_an_extra_is_there_for_is_what_it_declares() -> None:
    text = (ROOT / "core" / "pyproject.toml").read_text(encoding="utf-8")
    extras = tomllib.loads(text)["project"]["optional-dependencies"]

    def names(extra: str) -> set[str]:
        found = set()
        for requirement in map(Requirement, extras[extra]):
            inner = set().union(*map(names, requirement.extras)) if requirement.extras else set()
            found |= inner or {canonicalize_name(requirement.name)}
        return found

    for extra, modules in MODULES.items():
        known = {canonicalize_name(name) for one_of in modules.values() for name in one_of}
        assert names(extra.value) <= known, extra
        # Of the distributions that bring a module, the extra names one at least.
        for one_of in modules.values():
            assert names(extra.value) & set(map(canonicalize_name, one_of)), (extra, one_of)
    everything = names("all")
    others = set(Extra) - {Extra.CUDA}
    assert everything == set().union(*(names(extra.value) for extra in others))
    plain_names = {canonicalize_name(Requirement(line).name) for line in metadata_lines()}
    assert not plain_names & (everything | names("cuda"))


def test_the_names_of_extras_stay() -> None:
    text = (ROOT / "core" / "pyproject.toml").read_text(encoding="utf-8")
    extras = tomllib.loads(text)["project"]["optional-dependencies"]
    names = {"surface", "compare", "window", "ocr", "cuda", "cluster", "mcp", "all"}
    assert names <= set(extras)
    # What it brought is part of the plain installation.
    assert extras["ocr"] == []


def metadata_lines() -> list[str]:
    """What the plain installation requires."""
    text = (ROOT / "core" / "pyproject.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)["project"]["dependencies"]


def test_no_version_is_pinned() -> None:
    lines = list(metadata_lines())
    text = (ROOT / "core" / "pyproject.toml").read_text(encoding="utf-8")
    for extra in tomllib.loads(text)["project"]["optional-dependencies"].values():
        lines += extra
    for requirement in map(Requirement, lines):
        assert not {"==", "==="} & {part.operator for part in requirement.specifier}, requirement


@pytest.mark.parametrize("options", [(), ("--result", "solid")])
def test_a_sheet_becomes_its_solid_without_any_extra(
    options: tuple[str, ...], plain_sheet: Path, tmp_path: Path
) -> None:
    done = plain("reconstruct", str(plain_sheet), "--output", "out", *options, folder=tmp_path)
    assert done.returncode == 0
    report = json.loads((tmp_path / "out" / "report.json").read_text(encoding="utf-8"))
    assert report["status"] == "verified" and report["solid"]["faces"] == 9
    assert report["surface"] is None and report["gaussians"] is None
    assert (tmp_path / "out" / "solid.step").is_file()
    if options:
        assert "extra" not in done.stderr
        return
    assert done.stderr.count("[surface-left-out]") == 1
    assert 'pip install "gaussiancad-core[surface]"' in done.stderr
    warnings = {warning["code"]: warning for warning in report["warnings"]}
    assert warnings["surface-left-out"]["args"]["extra"] == "surface"


@pytest.mark.parametrize(
    ("arguments", "extra"),
    [
        (["reconstruct", "{sheet}", "--output", "out", "--result", "surface"], "surface"),
        (["reconstruct", "{sheet}", "--output", "out", "--device", "cuda"], "cuda"),
        (["compare", "a.step", "b.step"], "compare"),
        (["correct", "{sheet}"], "window"),
        (["batch", "{sheet}", "--output", "out", "--scheduler", "tcp://host:8786"], "cluster"),
    ],
)
def test_what_needs_an_extra_names_it(
    arguments: list[str], extra: str, plain_sheet: Path, tmp_path: Path
) -> None:
    done = plain(*(word.format(sheet=plain_sheet) for word in arguments), folder=tmp_path)
    assert done.returncode == ExitCode.ENGINE
    (line,) = done.stderr.splitlines()
    assert line.startswith("gaussiancad: ") and line.endswith("[extra-missing]")
    assert f'pip install "gaussiancad-core[{extra}]"' in line
    assert not (tmp_path / "out" / "solid.step").exists()


def test_the_doctor_tells_which_extras_are_there(tmp_path: Path) -> None:
    done = plain("doctor", folder=tmp_path)
    assert done.returncode == 0, done.stdout
    for name in ("surface", "compare", "window", "cluster", "mcp", "cuda"):
        assert f'pip install "gaussiancad-core[{name}]"' in done.stdout
    assert "complete, without surface, compare" in done.stdout
    assert "BROKEN" not in done.stdout


def test_kernels_are_compiled_without_those_of_the_surface(tmp_path: Path) -> None:
    assert plain("warm-up", folder=tmp_path).returncode == 0


def test_what_is_asked_for_is_taken_and_else_what_is_installed_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert lacking(Extra.SURFACE) == () and result_kind(None) is ResultKind.BOTH
    demand(Extra.SURFACE, "a surface")
    monkeypatch.setitem(MODULES, Extra.SURFACE, {"no_such_module": ("nothing",)})
    assert lacking(Extra.SURFACE) == ("no_such_module",)
    assert result_kind(None) is ResultKind.SOLID
    assert result_kind(ResultKind.BOTH) is ResultKind.BOTH
    with pytest.raises(EngineError) as caught:
        demand(Extra.SURFACE, "a surface")
    assert caught.value.code == "extra-missing"
    assert metadata.version("gaussiancad-core")
