"""One seed of one source of ``verified``, in a process that can be ended."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import Enum

from benchmarks.parts.twin_parts import FAMILIES
from benchmarks.run.workers import FIRST, Row
from benchmarks.tasks.verified_grids import grid_cases, pair_cases
from benchmarks.tasks.verified_sheets import sheet_cases
from benchmarks.tasks.verified_sources import RANDOM, part_cases, twin_cases
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from sample_parts.classed import PartClass

_KINDS = (*(kind.value for kind in PartClass), RANDOM, RANDOM)
_ALL = (*FAMILIES, *_KINDS)

_LIMIT_S = 900.0


class Source(Enum):
    """Where parts and their drawings come from."""

    TWINS = "twins"
    GRIDS = "grids"
    PAIRS = "pairs"
    PARTS = "parts"
    SHEETS = "sheets"


_CASES: dict[Source, Callable[[int], Iterator[Row]]] = {
    Source.TWINS: lambda seed: twin_cases(*_named(tuple(FAMILIES), seed)),
    Source.GRIDS: grid_cases,
    Source.PAIRS: pair_cases,
    Source.PARTS: lambda seed: part_cases(*_named(_KINDS, seed)),
    Source.SHEETS: lambda seed: sheet_cases(*_named(_ALL, seed)),
}


def _named(kinds: tuple[str, ...], seed: int) -> tuple[str, int]:
    """All kinds in turn, and which part of the kind."""
    return kinds[seed % len(kinds)], seed // len(kinds)


@dataclass(frozen=True)
class Task:
    """A seed of a source: a few drawings of a few parts."""

    source: Source
    seed: int

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {"source": self.source.value, "seed": self.seed}

    @property
    def allowed(self) -> dict[str, float]:
        """s for all of it."""
        return {FIRST: _LIMIT_S}


def worked(task: Task) -> Iterator[Row]:
    """All that was found at one seed: a row for each drawing, under ``cases``."""
    silence_opencascade()
    cases: list[Row] = []
    for case in _CASES[task.source](task.seed):
        cases.append(case)
        # What was found counts even if the rest takes too long.
        yield {"cases": cases}
