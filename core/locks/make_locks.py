"""Writes the lock files beside this script from ``core/pyproject.toml``; ``make lock`` runs it.

* ``engine-cuda.txt``: the engine, with PyTorch as indexes have it (CUDA on Linux, CPU elsewhere).
* ``engine-cpu.txt``: the same versions, but PyTorch's own CPU build and no CUDA packages.
* ``engine-solid.txt``: the same without the extra ``surface``: it reads sheets and makes solids.
* ``tests.txt``: what the tests need on top of one of the first two.

All lack what ``exclude-dependencies`` names, and what only that needs.

Each names every wheel by its hash, for all supported Pythons and platforms, and no index address:
where wheels come from is up to whoever installs.  One engine has two files because pip takes the
wheel whose hash is listed: a single file with the hashes of both PyTorch builds would fetch the
large one even where a small one is offered.

CPU wheels are looked for through pip and its configuration.  Where pip is offered none, the hashes
of the present file stay, as long as PyTorch's version does.
"""

import re
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from shutil import copy

LOCKS = Path(__file__).resolve().parent
PROJECT = LOCKS.parent / "pyproject.toml"

PYTHONS = ("3.11", "3.12", "3.13", "3.14")
"""What ``requires-python`` admits, the oldest first."""

CPU_PLATFORMS = ("manylinux_2_28_x86_64", "manylinux_2_28_aarch64")
"""Where PyTorch's CPU build differs from what package indexes have."""

CUDA_ONLY = re.compile(r"nvidia-|cuda-|triton==")
"""Starts of the entries that only PyTorch's CUDA build needs."""


def main(upgrade: bool) -> int:
    """Writes all lock files, or none; returns the exit status.

    Args:
        upgrade: take the newest versions that the project admits, instead of keeping the locked
            ones where they still fit.
    """
    project = tomllib.loads(PROJECT.read_text(encoding="utf-8"))
    extras = project["project"]["optional-dependencies"]
    excluded = project["tool"]["uv"]["exclude-dependencies"]
    solid = [
        *project["project"]["dependencies"],
        *project["build-system"]["requires"],
    ]
    engine = [*solid, *required(extras, "surface", "compare")]
    tests = required(extras, "test", "window", "cluster", "mcp")

    with tempfile.TemporaryDirectory() as folder:
        new = Path(folder)
        excludes = new / "excludes.in"
        excludes.write_text("\n".join(excluded), encoding="utf-8")
        for old in LOCKS.glob("*.txt"):
            copy(old, new)
        left_out = ("--excludes", str(excludes))
        resolve(engine, new / "engine-cuda.txt", upgrade, *left_out)
        cuda = (new / "engine-cuda.txt").read_text(encoding="utf-8")
        torch = re.search(r"^torch==(\S+)", cuda, re.MULTILINE)[1]
        hashes = sorted(offered_cpu_hashes(torch)) or locked_cpu_hashes(torch)
        if not hashes:
            print(
                f"No CPU build of torch {torch} is offered: name PyTorch's CPU wheels in pip's "
                "configuration (find-links or extra-index-url), then run `make lock` again.",
                file=sys.stderr,
            )
            return 1
        same = ("--constraints", str(new / "engine-cuda.txt"))
        resolve(solid, new / "engine-solid.txt", upgrade, *left_out, *same)
        resolve(tests, new / "tests.txt", upgrade, *left_out, *same)
        (new / "engine-cpu.txt").write_text(cpu_build(cuda, torch, hashes), encoding="utf-8")
        for lock in new.glob("*.txt"):
            copy(lock, LOCKS)
            print(lock.name)
    return 0


def required(extras: dict[str, list[str]], *names: str) -> list[str]:
    """What extras require, without what is in each for the sake of another one of them."""
    return [line for name in names for line in extras[name] if not line.startswith("gaussiancad")]


def resolve(requirements: list[str], lock: Path, upgrade: bool, *options: str) -> None:
    """Pins the requirements and all that they need, with hashes, in the file ``lock``."""
    source = lock.with_suffix(".in")
    source.write_text("\n".join(requirements), encoding="utf-8")
    command = [sys.executable, "-m", "uv", "pip", "compile", str(source), "--quiet"]
    command += ["--universal", "--python-version", PYTHONS[0], "--generate-hashes"]
    command += ["--no-annotate", "--custom-compile-command", "make lock", "-o", str(lock)]
    command += ["--upgrade"] if upgrade else []
    subprocess.run([*command, *options], check=True)


def cpu_build(lock: str, torch: str, hashes: list[str]) -> str:
    """The text of a lock with PyTorch's CPU build in place of the CUDA one."""
    header = "".join(re.findall(r"^#.*\n", lock, re.MULTILINE))
    cpu = " \\\n    ".join([f"torch=={torch}+cpu", *(f"--hash=sha256:{h}" for h in hashes)]) + "\n"
    kept = (entry for entry in entries(lock) if not CUDA_ONLY.match(entry))
    return header + "".join(cpu if entry.startswith("torch==") else entry for entry in kept)


def entries(lock: str) -> Iterator[str]:
    """The entries of a lock's text: a line that starts with a name, and its indented lines."""
    return (match[0] for match in re.finditer(r"^\w.*\n(?:[ ].*\n)*", lock, re.MULTILINE))


def offered_cpu_hashes(torch: str) -> set[str]:
    """SHA-256 of the CPU wheels that pip is offered, over all Pythons and platforms."""
    hashes = set()
    with tempfile.TemporaryDirectory() as folder:
        for python in PYTHONS:
            for platform in CPU_PLATFORMS:
                command = [sys.executable, "-m", "pip", "download", f"torch=={torch}+cpu"]
                command += ["--no-deps", "--only-binary", ":all:", "--dest", folder, "--quiet"]
                command += ["--python-version", python, "--platform", platform]
                subprocess.run(command, check=False, capture_output=True)
        for wheel in Path(folder).iterdir():
            with wheel.open("rb") as data:
                hashes.add(sha256(data.read()).hexdigest())
    return hashes


def locked_cpu_hashes(torch: str) -> list[str]:
    """SHA-256 of the CPU wheels in the present lock; empty if it has another version."""
    lock = LOCKS / "engine-cpu.txt"
    if not lock.exists():
        return []
    for entry in entries(lock.read_text(encoding="utf-8")):
        if entry.startswith(f"torch=={torch}+cpu "):
            return re.findall(r"sha256:(\w+)", entry)
    return []


if __name__ == "__main__":
    raise SystemExit(main(upgrade="--upgrade" in sys.argv[1:]))
