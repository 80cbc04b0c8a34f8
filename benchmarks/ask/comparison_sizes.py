"""How many seconds and how much memory does a comparison of large meshes take?

A sphere with a bump as the result against a plain one, each with the asked number of triangles, as
binary STL; each run is a process of its own, with all protocols and its files written.
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import trimesh

from benchmarks.run.outcome import Figure, Outcome

MINUTES = 5


@dataclass(frozen=True)
class Cost:
    """What a run took: seconds, those of all processors together, and most MB."""

    seconds: float
    cpu_seconds: float
    megabytes: float


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--triangles", type=int, nargs="+", default=[20_480, 1_310_720])
    parser.add_argument("--points", type=int, nargs="+", default=[10_000, 100_000])


def run(options: argparse.Namespace) -> Outcome:
    """Print a line a size."""
    print(f"{'triangles':>10}{'points':>10}{'s':>8}{'CPU s':>8}{'MB':>8}{'page, MB':>10}")
    figures = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for triangles in options.triangles:
            files = write_pair(folder, triangles)
            for points in options.points:
                cost = cost_of(files, folder / "out", points)
                page = (folder / "out" / "comparison.html").stat().st_size / 1e6
                row = f"{cost.seconds:>8.1f}{cost.cpu_seconds:>8.1f}{cost.megabytes:>8.0f}"
                print(f"{triangles:>10}{points:>10}{row}{page:>10.1f}", flush=True)
                about = f"{triangles} triangles, {points} points"
                figures += [Figure(about, round(cost.seconds, 1), "s")]
                figures += [Figure(about, round(cost.megabytes), "MB")]
    return Outcome(tuple(figures))


def write_pair(folder: Path, triangles: int) -> tuple[Path, Path]:
    """A sphere with a bump and a plain one, of the next number that quartering reaches."""
    subdivisions = max(0, round(np.log(triangles / 20) / np.log(4)))
    ball = trimesh.creation.icosphere(subdivisions, 50.0)
    plain, bumped = folder / "plain.stl", folder / "bumped.stl"
    ball.export(plain)
    away = np.linalg.norm(ball.vertices - [35.0, 30.0, 20.0], axis=1)
    ball.vertices *= 1.0 + 0.02 * np.exp(-((away / 15.0) ** 2))[:, None]
    ball.export(bumped)
    return bumped, plain


def cost_of(files: tuple[Path, Path], output: Path, points: int) -> Cost:
    """What one comparison costs."""
    command = [sys.executable, "-m", "gaussiancad_core", "compare", *map(str, files)]
    command += ["--output", str(output), "--points", str(points), "--protocol", "all"]
    started = time.perf_counter()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        _, status, usage = _wait(process)
    if status:
        raise ChildProcessError(f"compare ended with {status}")
    seconds = time.perf_counter() - started
    return Cost(seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0)


def _wait(process: subprocess.Popen[bytes]) -> tuple[int, int, resource.struct_rusage]:
    found = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(found[1])
    return found[0], process.returncode, found[2]
