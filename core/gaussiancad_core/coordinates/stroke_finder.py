"""Which stroke of a view runs through a place."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Linetype, Segment

LINKS = 96
"""Chords that stand for a curve."""


class StrokeFinder:
    """The strokes of a view as chords.

    Args:
        strokes: mm of the view's plane.
    """

    def __init__(self, strokes: Sequence[DrawnStroke]) -> None:
        starts, ends, owners = [], [], []
        for number, stroke in enumerate(strokes):
            if stroke.length <= 0.0:
                continue
            links = 1 if isinstance(stroke, Segment) else LINKS
            points = stroke.sample(stroke.length / links * (1.0 + 1e-9))
            starts.append(points[:-1])
            ends.append(points[1:])
            owners.append(np.full(len(points) - 1, number))
        nothing = np.zeros((0, 2))
        self._starts = np.concatenate([nothing, *starts])
        self._spans = np.concatenate([nothing, *ends]) - self._starts
        self._squares = np.maximum((self._spans**2).sum(axis=1), 1e-300)
        self._owners = np.concatenate([np.zeros(0, dtype=np.int64), *owners]).astype(np.int64)
        self._visible = np.array(
            [strokes[owner].linetype is Linetype.VISIBLE for owner in self._owners], dtype=bool
        )

    def nearest(self, place: npt.NDArray[np.float64], linetype: Linetype) -> int | None:
        """The number of the nearest stroke of a linetype to (2,) mm; None if there is none."""
        chosen = self._visible == (linetype is Linetype.VISIBLE)
        if not chosen.any():
            return None
        away = place - self._starts
        share = np.clip((away * self._spans).sum(axis=1) / self._squares, 0.0, 1.0)
        distances = ((away - share[:, None] * self._spans) ** 2).sum(axis=1)
        distances[~chosen] = np.inf
        return int(self._owners[int(distances.argmin())])
