"""What the engine imports, what it declares, and what the locks pin are the same."""

import ast
import re
import sys
import tomllib
from importlib.metadata import files
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

CHECKOUT = Path(__file__).resolve().parents[2]
CORE = CHECKOUT / "core"
PROJECT = tomllib.loads((CORE / "pyproject.toml").read_text(encoding="utf-8"))
EXTRAS = PROJECT["project"]["optional-dependencies"]
SOLID = [
    *PROJECT["project"]["dependencies"],
    *PROJECT["build-system"]["requires"],
]
"""Of an engine that makes exact solids alone."""

ENGINE = [*SOLID, *EXTRAS["compare"], *EXTRAS["surface"]]
TESTS = [*EXTRAS["test"], *EXTRAS["window"], *EXTRAS["cluster"], *EXTRAS["mcp"]]
EXCLUDED = PROJECT["tool"]["uv"]["exclude-dependencies"]
CUDA = [re.split(r"\W", line)[0] for line in EXTRAS["cuda"]]
"""Modules of the extra for GPUs, which is not installed where there is none; named as packages."""

HELPED = ("tests/engine/benchmarks", "tests/engine/sketch")
"""Folders of tests with scripts that help them."""

LOCKS = ("engine-cpu.txt", "engine-cuda.txt", "engine-solid.txt", "tests.txt")

CUDA_ONLY = ("nvidia-", "cuda-", "triton")


def of_here(lines: list[str]) -> list[Requirement]:
    """The requirements that count for this Python and platform."""
    requirements = [r for r in map(Requirement, lines) if r.name != PROJECT["project"]["name"]]
    return [r for r in requirements if r.marker is None or r.marker.evaluate()]


def lock_text(name: str) -> str:
    """The text of a lock."""
    return (CORE / "locks" / name).read_text(encoding="utf-8")


def pins(name: str) -> dict[str, str]:
    """Package to version, of the entries that count for this Python and platform."""
    lines = re.findall(r"^(\w[^\\\n]*)", lock_text(name), re.MULTILINE)
    counted = of_here([line.strip() for line in lines])
    found = {canonicalize_name(r.name): str(r.specifier).removeprefix("==") for r in counted}
    assert len(found) == len(counted)
    return found


@pytest.mark.parametrize(
    ("lock", "declared"),
    [
        ("engine-cpu.txt", ENGINE),
        ("engine-cuda.txt", ENGINE),
        ("engine-solid.txt", SOLID),
        ("tests.txt", TESTS),
    ],
)
def test_locks_pin_what_is_declared(lock: str, declared: list[str]) -> None:
    pinned = pins(lock)
    for requirement in of_here(declared):
        version = pinned[canonicalize_name(requirement.name)]
        assert requirement.specifier.contains(version), (requirement, version)


def test_the_builds_differ_in_pytorch_alone() -> None:
    cpu, cuda = pins("engine-cpu.txt"), pins("engine-cuda.txt")
    assert cpu.pop("torch") == cuda.pop("torch") + "+cpu"
    assert cpu == {name: pin for name, pin in cuda.items() if not name.startswith(CUDA_ONLY)}


@pytest.mark.parametrize("lock", LOCKS)
def test_what_is_excluded_is_in_no_lock(lock: str) -> None:
    assert EXCLUDED
    found = re.findall(r"^([\w.-]+)==", lock_text(lock), re.MULTILINE)
    assert len(found) > 10
    assert not {canonicalize_name(name) for name in (*EXCLUDED, "plotly")} & set(found)


def test_the_engine_of_solids_alone_is_a_part_of_the_others() -> None:
    solid, cpu = pins("engine-solid.txt"), pins("engine-cpu.txt")
    assert solid.items() <= cpu.items()
    assert not {"torch", "open3d", "open3d-cpu", "trimesh", "manifold3d", "pot"} & solid.keys()


def test_the_tests_need_no_other_versions_than_the_engine() -> None:
    engine, tests = pins("engine-cuda.txt"), pins("tests.txt")
    shared = engine.keys() & tests.keys()
    assert {name: engine[name] for name in shared} == {name: tests[name] for name in shared}


@pytest.mark.parametrize("lock", LOCKS)
def test_locks_hold_hashes_and_no_addresses(lock: str) -> None:
    text = lock_text(lock)
    assert "/" not in text
    entries = re.findall(r"^\w.*\n(?: .*\n)*", text, re.MULTILINE)
    assert entries
    assert all(re.search(r"--hash=sha256:[0-9a-f]{64}\b", entry) for entry in entries)


@pytest.mark.parametrize(
    ("folder", "declared"),
    [
        ("core", ENGINE + TESTS),
        ("benchmarks", ENGINE),
        ("learning", ENGINE + TESTS),
        ("sample_parts", ENGINE),
        ("tests/engine", ENGINE + TESTS),
        ("tests/docs", ENGINE + TESTS),
        ("tests/learning", ENGINE + TESTS),
    ],
)
def test_every_import_is_declared(folder: str, declared: list[str]) -> None:
    # The window is the workbench's, which goes along in the wheel.
    known = {
        "gaussiancad",
        "gaussiancad_core",
        "gaussiancad_protocol",
        "freecad",
        *sys.stdlib_module_names,
        *CUDA,
    }
    # Whoever asks for its shapes has it.
    known.add("build123d")
    known |= {name for package in of_here(declared) for name in provided(package.name)}
    # A folder imports from itself and its scripts each other; those of make are tested and
    # measured, too, as is the package of benchmarks, beside what helps their tests.
    known |= {Path(folder).name, "benchmarks", "sample_parts"}
    known |= {"learning"} if "learning" in folder else set()
    for scripts in (folder, "scripts", *HELPED):
        known |= {path.stem for path in (CHECKOUT / scripts).glob("*.py")}
    undeclared = {
        (name, path.name)
        for path in (CHECKOUT / folder).rglob("*.py")
        for name in imported(path) - known
    }
    assert undeclared == set()


@pytest.mark.parametrize("folder", ["core/gaussiancad", "core/gaussiancad_core", "freecad"])
def test_the_product_needs_nothing_that_is_for_a_checkout(folder: str) -> None:
    paths = list((CHECKOUT / folder).rglob("*.py"))
    assert len(paths) > 10
    apart = {"learning", "benchmarks", "sample_parts", "tests", "scripts"}
    assert {path.name for path in paths if imported(path) & apart} == set()


def provided(distribution: str) -> set[str]:
    """The top-level modules that an installed distribution brings."""
    return {file.parts[0].partition(".")[0] for file in files(distribution) or ()}


def imported(path: Path) -> set[str]:
    """The top-level names of all modules that a file imports."""
    nodes = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
    names = [alias.name for n in nodes if isinstance(n, ast.Import) for alias in n.names]
    names += [n.module for n in nodes if isinstance(n, ast.ImportFrom) and n.module and not n.level]
    return {name.partition(".")[0] for name in names}
