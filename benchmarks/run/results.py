"""The one store of results: a file for each benchmark, with an entry for each recorded run."""

import json
import os
import platform
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

from benchmarks.run.checkout import ROOT, commit
from benchmarks.run.outcome import Figure, Outcome

RESULTS = ROOT / "benchmarks" / "results"


@dataclass(frozen=True)
class Result:
    """What a benchmark found in one run.

    Attributes:
        about: what was measured.
        commit: at which state of the checkout.
        date: of the run, year-month-day; of the commit where the run's is not known.
        options: of the command.
        machine: what it ran on.
        figures: the headline first.
        head: columns of a table; empty without one.
        rows: of the table.
        limits: what qualifies the figures.
    """

    about: str
    commit: str
    date: str
    options: str = ""
    machine: str = ""
    figures: tuple[Figure, ...] = ()
    head: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()
    limits: str = ""

    @property
    def headline(self) -> str:
        """Date, commit and the first figure."""
        first = str(self.figures[0]) if self.figures else self.about
        return f"{self.date} {self.commit}: {first}"


def results_of(name: str, folder: Path = RESULTS) -> tuple[Result, ...]:
    """The recorded results of a benchmark, the newest last."""
    path = folder / f"{name}.json"
    if not path.is_file():
        return ()
    return tuple(_result(entry) for entry in json.loads(path.read_text(encoding="utf-8")))


def record(name: str, result: Result, folder: Path = RESULTS) -> Path:
    """Add a result to a benchmark's file, in place of an earlier one of the same options, whose
    words about it stay."""
    kept = [old for old in results_of(name, folder) if old.options != result.options]
    same = [old for old in results_of(name, folder) if old.options == result.options]
    if same and not result.limits:
        result = replace(result, about=same[-1].about, limits=same[-1].limits)
    path = folder / f"{name}.json"
    part = path.with_suffix(".part")
    part.write_text(as_text([*kept, result]), encoding="utf-8")
    part.replace(path)
    return path


def as_text(results: Sequence[Result]) -> str:
    """Results as they stand in a file."""
    filled = [
        {key: item for key, item in asdict(r).items() if item not in ("", ())} for r in results
    ]
    return json.dumps(filled, indent=1, ensure_ascii=False) + "\n"


def result_now(outcome: Outcome, options: str, about: str) -> Result:
    """The result of a run that ends now, on this machine."""
    machine = f"{os.cpu_count()} cores, {platform.system()} {platform.machine()}"
    day = datetime.now(UTC).date().isoformat()
    measured = outcome.figures, outcome.head, outcome.rows
    return Result(about, commit(), day, options, machine, *measured)


def _result(entry: dict) -> Result:
    return Result(
        **{
            **entry,
            "figures": tuple(Figure(**figure) for figure in entry.get("figures", ())),
            "head": tuple(entry.get("head", ())),
            "rows": tuple(map(tuple, entry.get("rows", ()))),
        }
    )
