"""Rows of dashes that look like writing: hidden lines so close to each other that their ink joins.

Such pieces are broader than a dash, yet they stand as dashes do: alike, at even gaps, their length
along the row.  Letters are higher than wide, and stand across their row.
"""

import numpy as np
import numpy.typing as npt

_ROW = 3
"""Dashes from which the ends of a row may be cut."""

_EVEN, _EVEN_PX = 0.15, 2.0
"""Share of their length, and px, by which the lengths and the gaps of dashes differ at most."""

_SLENDER, _SLENDER_PAIR = 1.2, 1.5
"""Length of a dash, along its row, at least: in what it and those beside it measure across; and
where there are two alone."""

Floats = npt.NDArray[np.float64]


def are_dashes(boxes: Floats) -> bool:
    """Whether pieces are the dashes of hidden lines close beside each other.

    Args:
        boxes: (n, 4) x, y, width, height of the pieces of a word, px.
    """
    low, high = boxes[:, :2], boxes[:, :2] + boxes[:, 2:]
    axis = int(np.argmax(high.max(axis=0) - low.min(axis=0)))
    across = float(high[:, 1 - axis].max() - low[:, 1 - axis].min())
    spans = _spans(low[:, axis], high[:, axis])
    if len(spans) < 2:
        return False
    lengths = spans[:, 1] - spans[:, 0]
    gaps = spans[1:, 0] - spans[:-1, 1]
    # An edge cuts the first dash and the last.
    inner = lengths[1:-1] if len(lengths) > _ROW else lengths
    length = float(np.median(inner))
    return (
        length > (_SLENDER if len(spans) >= _ROW else _SLENDER_PAIR) * across
        and bool((np.abs(inner - length) <= _EVEN * length + _EVEN_PX).all())
        and bool((lengths <= length + _EVEN * length + _EVEN_PX).all())
        and float(np.ptp(gaps)) <= _EVEN * length + _EVEN_PX
    )


def _spans(starts: Floats, ends: Floats) -> Floats:
    """(n, 2) the intervals that pieces beside each other cover, in order."""
    order = np.argsort(starts)
    spans: list[list[float]] = []
    for start, end in zip(starts[order].tolist(), ends[order].tolist(), strict=True):
        if spans and start < spans[-1][1]:
            spans[-1][1] = max(spans[-1][1], end)
        else:
            spans.append([start, end])
    return np.array(spans)
