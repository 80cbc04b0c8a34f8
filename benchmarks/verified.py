"""Whether what is called verified is the part, over thousands of small parts.

    .venv/bin/python benchmarks/verified.py [--sources NAME ...] [--seeds N] [--first N]
        [--workers N] [--json FILE] [--resume]

Parts come from seven sources, each with its seeds in turn:

- ``twins``: families of variants that hardly differ in what is seen of them, drawn under policies
  that leave lines out: where two have one drawing neither may be verified;
- ``grids``: sets of boxes of a small grid, of all of which it is known who looks like whom;
- ``pairs``: parts of larger grids that differ in a box or two and have one drawing, hidden lines
  and all;
- ``parts``: small parts of the classes, and by chance;
- ``changes``: the same drawing with strokes permuted or split, views turned, mirrored or added, on
  a busy machine: what is said of it must stay the same;
- ``cells``: all labels of a part's cells, enumerated without a solver: as many must fulfil the
  rules as the search claims;
- ``sheets``: through files and the whole engine.

When a solid that is called verified is false, :mod:`verified_judging` says.  The table counts all
drawings, by source and by policy; ``bound`` is the share of the faces of verified solids that lie
within what is said of their measures.  Exit code 1 if any was false, or anything changed that must
not: with 3,000 verified ones and none false, at most one in a thousand is (at 95 %).
"""

import argparse
import os
import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from resumable import resumed
from verified_work import Source, Task, worked
from workers import Row

from gaussiancad_core.modes import Status

_LINE = "{:34} {:>8} {:>9} {:>12} {:>7} {:>6} {:>8} {:>7}"
_HEAD = _LINE.format(
    "", "drawings", "verified", "approximate", "failed", "false", "changed", "bound"
)


@dataclass
class Count:
    """Drawings of one kind.

    Attributes:
        drawings: that were solved, or whose cells were enumerated.
        by_status: how many were called what.
        false: verified ones that are not the part.
        changed: where something changed, or was claimed, that must not be.
        within, faces: of verified solids, how many faces lie within the bound, of how many.
    """

    drawings: int = 0
    by_status: dict[str, int] = field(default_factory=dict)
    false: int = 0
    changed: int = 0
    within: int = 0
    faces: int = 0

    def add(self, case: Row) -> None:
        """Count one more."""
        self.drawings += 1
        if "status" in case:
            self.by_status[case["status"]] = self.by_status.get(case["status"], 0) + 1
        self.false += is_false(case)
        self.changed += has_changed(case)
        self.within += case.get("within", 0)
        self.faces += case.get("faces", 0)

    def line(self, name: str) -> str:
        """A line of the table."""
        by = self.by_status.get
        share = f"{100.0 * self.within / self.faces:.1f} %" if self.faces else ""
        statuses = (by(own.value, 0) for own in Status)
        return _LINE.format(name, self.drawings, *statuses, self.false, self.changed, share)


def main() -> int:
    """Run what is asked for; print the table."""
    options = _parser().parse_args()
    # Many small problems side by side: threads of one would only slow down the others.
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    seeds = range(options.first, options.first + options.seeds)
    tasks = [Task(Source(name), seed) for seed in seeds for name in options.sources]
    rows: list[Row] = []
    for row in resumed(tasks, worked, options.workers, options.json, options.resume):
        rows.append(row)
        _tell(row, len(rows), len(tasks))
    print(table(rows))
    cases = [case for row in rows for case in row.get("cases", ())]
    return 1 if any(is_false(case) or has_changed(case) for case in cases) else 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    names = [source.value for source in Source]
    parser.add_argument("--sources", nargs="*", default=names, choices=names, metavar="NAME")
    parser.add_argument("--seeds", type=int, default=200, help="of each source")
    parser.add_argument("--first", type=int, default=0, help="seed to begin with")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--json", type=Path, help="file of a JSON object a line, one a seed")
    parser.add_argument("--resume", action="store_true", help="only what the JSON file lacks")
    return parser


def is_false(case: Row) -> bool:
    """Whether a solid was called verified that is not the part."""
    return case.get("status") == Status.VERIFIED.value and bool(case.get("why"))


def has_changed(case: Row) -> bool:
    """Whether something changed that must not, or the search claims what is not so."""
    return bool(case.get("changed")) or ("status" not in case and bool(case.get("why")))


def table(rows: Iterable[Row]) -> str:
    """Counts by source, by policy, and in all; then what is wrong, line by line."""
    rows = list(rows)
    cases = [(row["source"], case) for row in rows for case in row.get("cases", ())]
    lines = [_HEAD]
    lines += _counted((source, case) for source, case in cases)
    lines += ["", *_counted((case["policy"], case) for _, case in cases)]
    lines += ["", *_counted(("all", case) for _, case in cases)]
    ended = [row for row in rows if "failure" in row]
    lines += [f"{row['source']} {row['seed']}: {row['failure']}" for row in ended]
    lines += [text for row in rows for text in _wrong(row)]
    return "\n".join(lines)


def _counted(named: Iterable[tuple[str, Row]]) -> Sequence[str]:
    counts: dict[str, Count] = {}
    for name, case in named:
        counts.setdefault(name, Count()).add(case)
    return [count.line(name) for name, count in counts.items()]


def _wrong(row: Row) -> list[str]:
    found = []
    for number, case in enumerate(row.get("cases", ())):
        if is_false(case) or has_changed(case):
            kind = "FALSE" if is_false(case) else "CHANGED"
            what = case.get("why") or case.get("changed")
            found.append(
                f"{kind} {row['source']} {row['seed']} case {number} ({case['policy']}): {what}"
            )
    return found


def _tell(row: Row, number: int, total: int) -> None:
    """A line about a seed, for who waits."""
    cases = row.get("cases", [])
    verified = sum(case.get("status") == Status.VERIFIED.value for case in cases)
    told = [f"{number}/{total} {row['source']} {row['seed']}: {verified} of {len(cases)} verified"]
    told += [row["failure"]] if "failure" in row else []
    print(*told, *_wrong(row), sep="; ", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
