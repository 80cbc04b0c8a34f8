"""The rows of tasks, kept in one file as they come, so that a run that was stopped can go on."""

import argparse
import json
import os
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.run.arguments import tell
from benchmarks.run.workers import Limited, Row, Work, run_all


@dataclass(frozen=True)
class Running:
    """How tasks are run.

    Attributes:
        workers: child processes.
        file: of a JSON object a line, one a task, to which rows are added; None for no file.
        resume: whether the rows that the file has count; else it is begun anew.
        one_thread: whether each child has one thread for its arrays.
    """

    workers: int
    file: Path | None = None
    resume: bool = False
    one_thread: bool = True

    @classmethod
    def of(cls, options: argparse.Namespace, *, one_thread: bool = True) -> "Running":
        """What :func:`benchmarks.run.arguments.add_running` was given."""
        return cls(options.workers, options.json, options.resume, one_thread)


def rows_of(
    tasks: Sequence[Limited],
    work: Work,
    running: Running,
    line: Callable[[Row], str],
    say: Callable[[str], None] = tell,
) -> list[Row]:
    """The rows of all tasks in their order; each is kept at once.

    Args:
        tasks: what is to be done; what is known of each beforehand tells it from others.
        work: what a child process does with one.
        running: how.
        line: a row in some words.
        say: takes a line of progress for each task.
    """
    if running.one_thread:
        # Many small problems side by side: threads of one would only slow down the others.
        for name in ("OMP_NUM_THREADS", "NUMBA_NUM_THREADS"):
            os.environ.setdefault(name, "1")
    found = _kept(running, tasks)
    left = [task for task in tasks if _key(task.known, task) not in found]
    if found:
        say(f"{len(found)} of {len(tasks)} tasks were finished before")
    began = time.monotonic()
    for done, (task, row) in enumerate(run_all(left, work, running.workers), start=1):
        if running.file is not None:
            with running.file.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(row) + "\n")
        found[_key(task.known, task)] = row
        seconds = (time.monotonic() - began) / done * (len(left) - done)
        say(f"{len(found)}/{len(tasks)}, {_clock(seconds)} left: {line(row)}")
    return [found[_key(task.known, task)] for task in tasks]


def _clock(seconds: float) -> str:
    return f"{int(seconds // 60)}:{int(seconds % 60):02d}"


def _key(row: Row, task: Limited) -> str:
    """What tells a task's row from others."""
    return json.dumps([row.get(name) for name in task.known])


def _kept(running: Running, tasks: Sequence[Limited]) -> dict[str, Row]:
    """The rows that a file has of some tasks; it is begun anew where they do not count."""
    path = running.file
    if path is None:
        return {}
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = (
        path.read_text(encoding="utf-8").splitlines() if running.resume and path.exists() else ()
    )
    rows = [row for line in lines if (row := _row(line)) is not None]
    # What a killed run wrote in part is not kept.
    path.write_text("".join(json.dumps(row) + "\n" for row in rows), encoding="utf-8")
    wanted = {_key(task.known, task) for task in tasks}
    keys = {_key(row, tasks[0]): row for row in rows} if tasks else {}
    return {key: row for key, row in keys.items() if key in wanted}


def _row(line: str) -> Row | None:
    try:
        return json.loads(line)
    except ValueError:
        return None
