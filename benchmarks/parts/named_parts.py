"""Parts by name: the samples, and parts of each class of surfaces."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

from OCP.TopoDS import TopoDS_Shape

from sample_parts import SAMPLES
from sample_parts.classed import PartClass, classed_part

LEVELS = 4
"""Of numbers of faces, which the parts of a class have in turn: 8 to 48."""


@dataclass(frozen=True)
class Part:
    """What is measured.

    Attributes:
        name: of the row.
        build: makes the solid, mm.
    """

    name: str
    build: Callable[[], TopoDS_Shape]


def named_samples(names: Sequence[str]) -> Iterator[Part]:
    """The samples of some names, or all of them."""
    for part in SAMPLES:
        if not names or part.name in names:
            yield Part(part.name, part.build)


def named_classed(count: int, first: int = 0) -> Iterator[Part]:
    """So many parts of each class, from a seed on."""
    for kind in PartClass:
        for seed in range(first, first + count):
            yield Part(f"{kind.value}-{seed}", partial(classed_part, kind, seed, seed % LEVELS))
