"""Rows of tasks, kept in a file as they come, so that a run that was broken off can go on."""

import json
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from exact_work import causes, solved
from workers import Limited, Row, Work, run_all


def resumed(
    tasks: Sequence[Limited], work: Work, workers: int, file: Path | None, resume: bool
) -> Iterator[Row]:
    """Rows of all tasks: those that a file has from before, then the others as they come.

    Args:
        tasks: what is to be done.
        work: what a child process does with one.
        workers: child processes.
        file: of a JSON object a line, one a task, to which rows are added; None for no file.
        resume: whether the rows that the file has count; else it is begun anew.
    """
    wanted = {_key(task.known, task) for task in tasks}
    done = set()
    if file is not None and not resume:
        file.write_text("", encoding="utf-8")
    for row in _earlier(file) if resume and file is not None else []:
        if tasks and _key(row, tasks[0]) in wanted:
            done.add(_key(row, tasks[0]))
            yield row
    left = [task for task in tasks if _key(task.known, task) not in done]
    for _, row in run_all(left, work, workers):
        if file is not None:
            with file.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(row) + "\n")
        yield row


def tell(row: Row, number: int, total: int) -> None:
    """A line about a row, for who waits."""
    verdict = "exact" if solved(row) else ", ".join(causes(row))
    told = ", ".join([row.get("status", ""), *(row["reasons"] if solved(row) else ())])
    iou = f" IoU {row['iou']:.4f}" if "iou" in row else ""
    print(
        f"{number}/{total} {row['name']} {row['input']}: {verdict} ({told}){iou} "
        f"faces {row.get('faces', '-')}/{row.get('true_faces', '-')} "
        f"{row.get('seconds', float('nan')):.2f} s",
        file=sys.stderr,
        flush=True,
    )


def _key(row: Row, task: Limited) -> tuple[str, ...]:
    """What tells a task's row from others."""
    return tuple(row[name] for name in task.known)


def _earlier(path: Path) -> list[Row]:
    if not path.exists():
        return []
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines() if line]
