"""What a worker makes: crops of generated sheets, and now and then of published ones."""

import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from learning.feeding import Stream
from learning.published import PublishedSheet, published_crop
from learning.training_samples import Sample

Composing = Callable[[int, Sequence[Any], int, int], Iterator[Sample]]
"""Crops of the sheets of a seed: from parts, px of the crops' sides, and how many at most."""

_PUBLISHED = 0.22
"""Share of the sheets that are published ones, where there are any."""

_CROPS, _PUBLISHED_CROPS = 5, 3
"""Crops of a generated sheet, and of a published one."""

_MOST_FAILURES = 20
"""Sheets without a crop, one after the other, from which something is wrong with all of them."""


@dataclass(frozen=True)
class Mixture:
    """Of what samples are made.

    Attributes:
        parts: drawn parts, as the composing takes them.
        compose: makes sheets of them.
        published: sheets, none to do without.
        size: px of the sides of a sample.
        seed: of everything.
    """

    parts: Sequence[Any]
    compose: Composing
    published: tuple[PublishedSheet, ...]
    size: int
    seed: int

    def stream(self) -> Stream:
        """What each worker makes: the same in every run, another with each worker."""
        return self._samples

    def _samples(self, number: int) -> Iterator[Sample]:
        rng = np.random.default_rng([self.seed, number])
        failures = 0
        while True:
            if self.published and rng.random() < _PUBLISHED:
                for _ in range(_PUBLISHED_CROPS):
                    yield published_crop(self.published, self.size, rng)
                continue
            made = 0
            try:
                for sample in self.compose(_sheet_seed(rng), self.parts, self.size, _CROPS):
                    yield sample
                    made += 1
            except Exception:
                # One sheet of many thousands is no reason to lose a training.
                if failures == 0:
                    traceback.print_exc(file=sys.stderr)
            failures = 0 if made else failures + 1
            if failures == _MOST_FAILURES:
                raise RuntimeError(f"{failures} sheets one after the other had no crop")


def _sheet_seed(rng: np.random.Generator) -> int:
    return int(rng.integers(2**31))
