"""What is left of a batch that is killed, and is all of it there once it is resumed?

Batches of a few sheets are started; after a time by chance the batch itself, or a process of it, is
killed (SIGKILL), or another batch is started into the same folder.  Then no process of a killed
batch lives after five seconds; what lies under its final name is as in an unbroken batch; and after
``--resume`` every sheet is accounted for, and the tree is that of the unbroken batch, byte by byte
but for reports (which tell seconds) and the manifest.

Exit code 1 if anything was otherwise.
"""

import argparse
import csv
import hashlib
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import numpy as np
import psutil

from benchmarks.run.checkout import SAMPLES
from benchmarks.run.outcome import Figure, Outcome

MINUTES = 30

_SHEETS = ("l-bracket", "boss-plate", "wedge-block")
_OPTIONS = ("--result", "solid", "--length", "x=80", "--workers", "2")
_SURVIVE_S = 5.0
_VOLATILE = frozenset({"report.json", "report.csv", "index.html", "manifest.sqlite"})
_VICTIMS = ("batch", "batch", "sheet", "second batch")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--rounds", type=int, default=50)
    parser.add_argument("--first", type=int, default=0, help="seed to begin with")


def run(options: argparse.Namespace) -> Outcome:
    """Print what was done, and what was wrong."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        sheets = root / "sheets"
        sheets.mkdir()
        for name in _SHEETS:
            shutil.copy(SAMPLES / f"{name}.png", sheets)
        (sheets / "text.png").write_text("no picture")
        started = time.monotonic()
        assert _batch(sheets, root / "whole").wait() == 1
        usual = time.monotonic() - started
        whole = _tree(root / "whole")
        done: Counter[str] = Counter()
        wrong = 0
        for seed in range(options.first, options.first + options.rounds):
            lot = np.random.default_rng(seed)
            victim = _VICTIMS[int(lot.integers(len(_VICTIMS)))]
            output = root / f"out-{seed}"
            for fault in _broken(sheets, output, victim, float(lot.uniform(0.0, usual)), whole):
                wrong += 1
                print(f"WRONG {seed} ({victim}): {fault}", flush=True)
            done[victim] += 1
            shutil.rmtree(output, ignore_errors=True)
    print(", ".join(f"{victim} {count}" for victim, count in sorted(done.items())))
    figures = Figure("wrong", wrong), Figure("rounds", sum(done.values()))
    return Outcome(figures, wrong=bool(wrong))


def _broken(
    sheets: Path, output: Path, victim: str, after: float, whole: dict[str, str]
) -> list[str]:
    """What is wrong with a batch that is broken after some seconds, and resumed."""
    faults: list[str] = []
    batch = _batch(sheets, output)
    time.sleep(after)
    family = _family(batch.pid)
    if victim == "second batch" and batch.poll() is None and family:
        code = _batch(sheets, output).wait()
        # The first one may have ended meanwhile.
        if code != 2 and batch.poll() is None:
            faults.append(f"a second batch ended with {code}")
    elif victim == "sheet" and family:
        _kill(family[-1])
    else:
        batch.kill()
        batch.wait()
        alive = psutil.wait_procs(family, timeout=_SURVIVE_S)[1]
        faults += [f"{process} outlived the batch" for process in alive]
    batch.wait()
    half = {path for path, sha in _tree(output).items() if whole.get(path) != sha}
    faults += [f"{path} is half, or of no unbroken batch" for path in sorted(half)]
    if _batch(sheets, output, "--resume").wait() != 1:
        faults.append("the resumed batch did not end with 1")
    if _tree(output) != whole:
        faults.append("the resumed tree is another one")
    with open(output / "report.csv", encoding="utf-8", newline="") as file:
        codes = sorted(row["exit_code"] for row in csv.DictReader(file))
    if codes != ["0", "0", "0", "3"]:
        faults.append(f"the report has {codes}")
    left = [path.name for path in output.rglob(".gaussiancad-*") if path.is_dir()]
    faults += [f"{name} is left" for name in left]
    return faults


def _batch(sheets: Path, output: Path, *more: str) -> "subprocess.Popen[bytes]":
    command = [sys.executable, "-m", "gaussiancad_core", "batch", str(sheets)]
    return subprocess.Popen(
        [*command, "--output", str(output), *_OPTIONS, *more],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


def _family(pid: int) -> list[psutil.Process]:
    try:
        return psutil.Process(pid).children(recursive=True)
    except psutil.NoSuchProcess:
        return []


def _kill(process: psutil.Process) -> None:
    try:
        process.kill()
    except psutil.NoSuchProcess:
        return


def _tree(folder: Path) -> dict[str, str]:
    """SHA-256 of all files under their final names, but for those that tell times."""
    return {
        path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
        and path.name not in _VOLATILE
        and not any(part.startswith(".") for part in path.relative_to(folder).parts)
        and not path.name.endswith("-journal")
    }
