"""What benchmarks/benchmark.py keeps of finished tasks, and how it tells that it goes on."""

import hashlib
import json
import os
import re
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from workers import Limited, Row, Work, run_all

import gaussiancad_core

_BAR = 24
_SHOWN = ("benchmark_page", "benchmark_tables", "benchmark_records")


class NamedTask(Limited, Protocol):
    """A task with a name of its own."""

    @property
    def name(self) -> str:
        """What tells it from other tasks."""


@dataclass(frozen=True)
class Store:
    """A folder with one file for each finished task.

    Attributes:
        folder: of the files; it is made when the first one is written.
    """

    folder: Path

    def get(self, task: NamedTask) -> Row | None:
        """The row of a task, if it was finished before."""
        path = self._path(task)
        return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None

    def put(self, task: NamedTask, row: Row) -> None:
        """Keep a row; a run that is killed leaves it whole or not at all."""
        path = self._path(task)
        path.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(path, json.dumps(row).encode("utf-8"))

    def _path(self, task: NamedTask) -> Path:
        # The name for people, the digest because names may differ in what files cannot be called.
        readable = re.sub(r"[^A-Za-z0-9.-]+", "-", task.name)[:80]
        digest = hashlib.sha256(task.name.encode("utf-8")).hexdigest()[:8]
        return self.folder / f"{readable}-{digest}.json"


def write_atomically(path: Path, content: bytes) -> None:
    """Write a file that is there whole or not at all."""
    with tempfile.NamedTemporaryFile(dir=path.parent, suffix=".part", delete=False) as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
    # Temporary files are the owner's alone.
    os.chmod(file.name, 0o644)
    Path(file.name).replace(path)


def fingerprint(settings: str) -> str:
    """Of the code that makes and measures, and of what it was asked for: others are other rows."""
    digest = hashlib.sha256(settings.encode("utf-8"))
    for folder in (Path(gaussiancad_core.__file__).parent, Path(__file__).parent):
        for path in sorted(folder.rglob("*.py")):
            # How results are shown does not change them.
            if not path.name.startswith(_SHOWN):
                digest.update(path.read_bytes())
    return digest.hexdigest()[:12]


def rows_of(
    tasks: Sequence[NamedTask], store: Store, work: Work, workers: int, tell: Callable[[str], None]
) -> Iterator[tuple[NamedTask, Row]]:
    """The rows of all tasks, kept ones first, the others as they come; each is kept at once."""
    left = []
    for task in tasks:
        row = store.get(task)
        if row is None:
            left.append(task)
        else:
            yield task, row
    kept = len(tasks) - len(left)
    if kept:
        tell(f"{kept} of {len(tasks)} tasks were finished before\n")
    started = time.monotonic()
    for number, (task, row) in enumerate(run_all(left, work, workers), start=1):
        store.put(task, row)
        tell(progress(kept + number, len(tasks), number, time.monotonic() - started, task.name))
        yield task, row
    if left:
        tell("\n")


def progress(done: int, total: int, own: int, seconds: float, name: str) -> str:
    """A line with a bar and the time that is left, if the rest takes as long as the last ones."""
    filled = round(_BAR * done / total)
    left = seconds / own * (total - done)
    clock = f"{int(left // 60)}:{int(left % 60):02d}"
    bar = "#" * filled + "." * (_BAR - filled)
    return f"\r[{bar}] {done}/{total}, {clock} left, {name:60.60}"


def tell_on_stderr(text: str) -> None:
    """Write a line; in a file each has a line of its own."""
    if not sys.stderr.isatty():
        text = text.strip("\r\n").rstrip() + "\n" if text.strip() else ""
    sys.stderr.write(text)
    sys.stderr.flush()
