"""Which strokes of a file its picture shows: layers may be off, and what lies beyond the sheet."""

from collections.abc import Iterator, Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.content import PAPER_LEVEL, Grey
from gaussiancad_core.files.vectors import VectorStroke
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve

SHOWN = 0.3
"""Share of a stroke that shows at least: the gaps of dashes do not, and nothing of a layer that is
off, or of what is clipped or covered."""

_MOST_SAMPLES = 5000
"""Points at which a stroke is looked for in the picture."""

_AT_ONCE = 1000
"""Strokes that are looked for together, which bounds the memory."""

_Floats = npt.NDArray[np.float64]


def shown_strokes(strokes: Sequence[VectorStroke], grey: Grey) -> tuple[VectorStroke, ...]:
    """Those strokes that a picture shows."""
    shares = shown_shares(strokes, grey)
    return tuple(stroke for stroke, share in zip(strokes, shares, strict=True) if share >= SHOWN)


def shown_shares(strokes: Sequence[VectorStroke], grey: Grey) -> list[float]:
    """Share of the points along each stroke at which the picture shows anything.

    Points off the sheet count as blank, those in the gaps of dashes too.
    """
    blocks = (strokes[first : first + _AT_ONCE] for first in range(0, len(strokes), _AT_ONCE))
    return [share for block in blocks for share in _shares(block, grey)]


def _shares(strokes: Sequence[VectorStroke], grey: Grey) -> list[float]:
    chains = list(_chains(stroke.curve for stroke in strokes))
    points, owners = _between(chains)
    finite = np.isfinite(points).all(axis=1)
    points, owners = points[finite], owners[finite]
    cells = np.floor(np.clip(points, -1.0, max(grey.shape) + 1.0)).astype(int)
    height, width = grey.shape
    inside = ((cells >= 0) & (cells < [width, height])).all(axis=1)
    columns, rows = cells[inside].T
    inked = owners[inside][grey[rows, columns] < PAPER_LEVEL]
    of_each = np.bincount(owners, minlength=len(strokes))
    shares = np.bincount(inked, minlength=len(strokes)) / np.maximum(of_each, 1)
    return [float(share) for share in shares]


def _chains(curves: Iterator[Curve]) -> Iterator[_Floats]:
    """(n, 2) corners of a chain along each curve."""
    for curve in curves:
        if isinstance(curve, LineSegment):
            yield np.array((curve.start, curve.end))
        elif isinstance(curve, Chain):
            yield np.array(curve.points)
        else:
            yield curve.vertices(max(1.0, curve.length / _MOST_SAMPLES))


def _between(chains: Sequence[_Floats]) -> tuple[_Floats, npt.NDArray[np.int64]]:
    """(n, 2) points a px apart along chains, and (n,) the number of each one's chain."""
    if not chains:
        return np.zeros((0, 2)), np.zeros(0, dtype=np.int64)
    counts = np.array([len(chain) for chain in chains])
    corners, chain = np.concatenate(chains), np.repeat(np.arange(len(chains)), counts)
    ways = np.diff(corners, axis=0, append=corners[-1:])
    ends = np.cumsum(counts) - 1
    # From the last corner of a chain nothing leads on.
    ways[ends] = 0.0
    lengths = np.hypot(*ways.T)
    known = np.where(np.isfinite(lengths), lengths, 0.0)
    step = np.maximum(1.0, np.bincount(chain, known) / _MOST_SAMPLES)
    pieces = np.maximum(np.ceil(known / step[chain]), 1.0).astype(np.int64)
    piece = np.repeat(np.arange(len(corners)), pieces)
    number = np.arange(len(piece)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    points = corners[piece] + number[:, None] * (ways / pieces[:, None])[piece]
    return points, chain[piece]
