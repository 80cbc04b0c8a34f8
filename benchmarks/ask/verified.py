"""Is what is called verified the part, over thousands of small parts?

Parts are drawn under policies that leave lines out, solved, and judged where they are called
verified; of each it is known which other parts have the same drawing.

Parts come from five sources, each with its seeds in turn:

- ``twins``: families of variants that hardly differ in what is seen of them, drawn under policies
  that leave lines out: where two have one drawing neither may be verified;
- ``grids``: sets of boxes of a small grid, of all of which it is known who looks like whom;
- ``pairs``: parts of larger grids that differ in a box or two and have one drawing, hidden lines
  and all;
- ``parts``: small parts of the classes, and by chance;
- ``sheets``: through files and the whole engine.

When a solid that is called verified is false, :mod:`benchmarks.judge.verified_judging` says.  The
table counts all drawings, by source and by policy; ``bound`` is the share of the faces of verified
solids that lie within what is said of their measures.  Exit code 1 if any was false: with 3,000
verified ones and none false, at most one in a thousand is (at 95 %).
"""

import argparse
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from benchmarks.run.arguments import add_running
from benchmarks.run.outcome import Figure, Outcome, as_cells, as_table, share
from benchmarks.run.rows import Running, rows_of
from benchmarks.run.workers import Row
from benchmarks.tasks.verified_work import Source, Task, worked
from gaussiancad_protocol.modes import Status

MINUTES = 120

_HEAD = ("", "drawings", "verified", "approximate", "failed", "false", "bound")


@dataclass
class Count:
    """Drawings of one kind.

    Attributes:
        drawings: that were solved.
        by_status: how many were called what.
        false: verified ones that are not the part.
        within, faces: of verified solids, how many faces lie within the bound, of how many.
    """

    drawings: int = 0
    by_status: dict[str, int] = field(default_factory=dict)
    false: int = 0
    within: int = 0
    faces: int = 0

    def add(self, case: Row) -> None:
        """Count one more."""
        self.drawings += 1
        if "status" in case:
            self.by_status[case["status"]] = self.by_status.get(case["status"], 0) + 1
        self.false += is_false(case)
        self.within += case.get("within", 0)
        self.faces += case.get("faces", 0)

    def line(self, name: str) -> tuple[object, ...]:
        """A line of the table."""
        by = self.by_status.get
        within = f"{100.0 * self.within / self.faces:.1f} %" if self.faces else ""
        statuses = (by(item.value, 0) for item in Status)
        return name, self.drawings, *statuses, self.false, within


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    names = [source.value for source in Source]
    parser.add_argument("--sources", nargs="*", default=names, choices=names, metavar="NAME")
    parser.add_argument("--seeds", type=int, default=200, help="of each source")
    parser.add_argument("--first", type=int, default=0, help="seed to begin with")
    add_running(parser)


def run(options: argparse.Namespace) -> Outcome:
    """Run what is asked for; print the table."""
    seeds = range(options.first, options.first + options.seeds)
    tasks = [Task(Source(name), seed) for seed in seeds for name in options.sources]
    rows = rows_of(tasks, worked, Running.of(options), in_words)
    print(table(rows))
    cases = [case for row in rows for case in row.get("cases", ())]
    false = sum(map(is_false, cases))
    verified = sum(case.get("status") == Status.VERIFIED.value for case in cases)
    figures = (
        Figure("falsely verified", false),
        share("verified", verified, len(cases)),
    )
    return Outcome(figures, bool(false), _HEAD, by_source(rows))


def is_false(case: Row) -> bool:
    """Whether a solid was called verified that is not the part."""
    return case.get("status") == Status.VERIFIED.value and bool(case.get("why"))


def by_source(rows: Sequence[Row]) -> tuple[tuple[str, ...], ...]:
    """The cells of :data:`_HEAD` by source, and of all."""
    cases = [(row["source"], case) for row in rows for case in row.get("cases", ())]
    return as_cells([*_counted(cases), *_counted(("all", case) for _, case in cases)])


def table(rows: Sequence[Row]) -> str:
    """Counts by source, by policy, and in all; then what is wrong, line by line."""
    cases = [(row["source"], case) for row in rows for case in row.get("cases", ())]
    counted = [*_counted(cases), *_counted((case["policy"], case) for _, case in cases)]
    lines = [as_table(_HEAD, [*counted, *_counted(("all", case) for _, case in cases)])]
    ended = [row for row in rows if "failure" in row]
    lines += [f"{row['source']} {row['seed']}: {row['failure']}" for row in ended]
    lines += [text for row in rows for text in _wrong(row)]
    return "\n".join(lines)


def _counted(named: Iterable[tuple[str, Row]]) -> Sequence[tuple[object, ...]]:
    counts: dict[str, Count] = {}
    for name, case in named:
        counts.setdefault(name, Count()).add(case)
    return [count.line(name) for name, count in counts.items()]


def _wrong(row: Row) -> list[str]:
    found = []
    for number, case in enumerate(row.get("cases", ())):
        if is_false(case):
            where = f"{row['source']} {row['seed']} case {number} ({case['policy']})"
            found.append(f"FALSE {where}: {case['why']}")
    return found


def in_words(row: Row) -> str:
    """A line about a seed, for who waits."""
    cases = row.get("cases", [])
    verified = sum(case.get("status") == Status.VERIFIED.value for case in cases)
    said = f"{row['source']} {row['seed']}: {verified} of {len(cases)} verified"
    return "; ".join([said, *([row["failure"]] if "failure" in row else []), *_wrong(row)])
