"""How much of which parts becomes features, how fast, and can their numbers be changed?

The features of each part are found in a process with a limit and built again; then each number
that drives them is made larger, one at a time.

Groups are ``samples``, and the six classes of parts that ``exact_solid`` has, 20 each,
levels in turn; with ``--data`` the parts are all STEP files under folders instead (of several
solids in a file the largest one).

``whole`` counts the parts that features make up alone; ``faces`` is the share of faces, of all
others, that features made over a base; ``over`` those that were ended at the time limit.
``f/face`` is features per face of the whole parts, ``s`` and ``p95`` are seconds, median and 95th
percentile, what was ended at the limit among them; ``free`` sums the degrees of freedom that
sketches have left, ``red.`` their redundant constraints, both by the rank of equations that are
written down here anew.  ``same`` counts the parts whose features, built in mm, are the solid.
``changed`` is the share of driving numbers (those of sketches, solved anew, too) that leave one
valid solid when one alone is made larger by ``--change``: at most ``--numbers`` of a part, spread
evenly.  Below are the numbers that cannot be changed, by kind.
"""

import argparse
from collections import Counter
from collections.abc import Iterator, Sequence
from statistics import median

import numpy as np

from benchmarks.parts.exact_cases import Case, classed_cases
from benchmarks.run.arguments import add_running, existing_folder
from benchmarks.run.outcome import Outcome, as_cells, as_table, share
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import Row
from benchmarks.tasks.feature_work import SAMPLES, Task, worked
from sample_parts import SAMPLES as PARTS
from sample_parts.classed import PartClass

MINUTES = 30

_HEAD = ("parts", "whole", "over", "faces", "f/face", "s", "p95", "free", "red.", "same", "changed")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    groups = [SAMPLES, *(kind.value for kind in PartClass)]
    parser.add_argument("--groups", nargs="*", default=groups, choices=groups, metavar="NAME")
    parser.add_argument("--parts", type=int, default=20, help="of each class")
    parser.add_argument("--seed", type=int, default=0, help="of the first part of each class")
    parser.add_argument("--data", type=existing_folder, nargs="*", help="folders of STEP files")
    parser.add_argument("--only", nargs="*", default=[], help="parts of names")
    parser.add_argument("--numbers", type=int, default=40, help="to be changed, of each part")
    parser.add_argument("--change", type=float, default=3.0, help="percent")
    add_running(parser, limit_s=60.0)


def run(options: argparse.Namespace) -> Outcome:
    """Work on the parts; print the table."""
    tasks = [
        Task(case, options.limit, 1.0 + options.change / 100.0, options.numbers)
        for case in _cases(options)
        if not options.only or any(text in case.name for text in options.only)
    ]
    rows = rows_of(tasks, worked, Running.of(options, one_thread=False), in_words)
    cells = as_cells(list(by_group(rows)))
    print(as_table(("", *_HEAD), cells))
    failed: Counter[str] = Counter()
    for row in rows:
        failed.update(row.get("failed", {}))
    print("\n".join(["", "not to be changed:", *_tallied(failed)]))
    whole = sum(bool(row.get("whole")) for row in rows)
    return Outcome((share("parts that are whole", whole, len(rows)),), False, ("", *_HEAD), cells)


def _cases(options: argparse.Namespace) -> Iterator[Case]:
    if options.data is not None:
        for folder in options.data:
            for path in sorted(folder.rglob("*")):
                if path.suffix.lower() in (".step", ".stp"):
                    name = str(path.relative_to(folder).with_suffix(""))
                    yield Case(name, folder.name, step=path)
        return
    if SAMPLES in options.groups:
        for part in PARTS:
            yield Case(part.name, SAMPLES)
    classes = [PartClass(name) for name in options.groups if name != SAMPLES]
    yield from classed_cases(classes, options.parts, options.seed)


def by_group(rows: Sequence[Row]) -> Iterator[tuple[object, ...]]:
    """The cells of :data:`_HEAD` for each group, and for all."""
    names = list(dict.fromkeys(row["group"] for row in rows))
    for name in names:
        yield _counted(name, [row for row in rows if row["group"] == name])
    if len(names) > 1:
        yield _counted("all", rows)


def _tallied(counts: Counter[str]) -> list[str]:
    return [f"{count:6} {name}" for name, count in counts.most_common()]


def _counted(group: str, rows: Sequence[Row]) -> tuple[object, ...]:
    found = [row for row in rows if "by_features" in row]
    whole = [row for row in found if row["whole"]]
    seconds = [row["seconds"] for row in rows if "seconds" in row]
    others = [row["by_features"] for row in found if not row["whole"]]
    tried = sum(row.get("tried", 0) for row in rows)
    failed = sum(sum(row.get("failed", {}).values()) for row in rows)
    each = [sum(row["features"].values()) / row["faces"] for row in whole]
    return (
        group,
        len(rows),
        len(whole),
        sum(row.get("failure") == "solve-over-time" for row in rows),
        f"{np.mean(others):.2f}" if others else "-",
        f"{median(each):.2f}" if each else "-",
        f"{median(seconds):.2f}" if seconds else "-",
        f"{np.percentile(seconds, 95):.1f}" if seconds else "-",
        sum(row["freedom"] for row in found),
        sum(row["redundant"] for row in found),
        sum(row["same"] for row in found),
        f"{1.0 - failed / tried:.3f}" if tried else "-",
    )


def in_words(row: Row) -> str:
    """A part in a line."""
    if row.get("whole"):
        kinds = ", ".join(f"{count} {kind}" for kind, count in row.get("features", {}).items())
        return f"{row['group']}/{row['name']}: {row['faces']} faces, {kinds}"
    return f"{row['group']}/{row['name']}: {row.get('by_features')} {row.get('failure', '')}"
