"""Tasks that children work on quickly: nothing heavy is imported here."""

import os
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from benchmarks.run.workers import FIRST, SOLVE, Row
from gaussiancad_core.errors import UsageError


@dataclass(frozen=True)
class Counted:
    """A task that leaves a file for each time that it is worked on."""

    name: str
    folder: Path
    limit: float = 30.0

    @property
    def known(self) -> Row:
        return {"task": self.name}

    @property
    def allowed(self) -> dict[str, float]:
        return {FIRST: 30.0, SOLVE: self.limit}


def count(task: Counted) -> Iterator[Row]:
    (task.folder / f"{task.name}-{os.urandom(4).hex()}").touch()
    yield {"stage": SOLVE}
    if task.name == "dies":
        os._exit(1)
    if task.name == "refused":
        raise UsageError("refused-by-name", "its name is refused")
    if task.name == "defect":
        raise ValueError("a defect")
    if task.name == "sleeps":
        time.sleep(600.0)
    yield {"length": len(task.name)}
