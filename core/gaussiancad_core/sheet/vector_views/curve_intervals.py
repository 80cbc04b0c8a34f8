"""Stretches of a line, circle or ellipse: united, and taken off each other.

A stretch is (start, end) in px of length along its shape, the end behind the start.  On a shape
that closes on itself it starts within the first turn and may reach into the second.
"""

from collections.abc import Iterable

import numpy as np

Span = tuple[float, float]


def united(spans: Iterable[Span], around: float = np.inf, slack: float = 0.0) -> list[Span]:
    """Stretches that touch or overlap as one, in order.

    Args:
        spans: in any order.
        around: length of a shape that closes on itself.
        slack: gap that counts as touching.
    """
    flat = _flat(spans, around)
    joined: list[Span] = []
    for start, end in flat:
        if joined and start - joined[-1][1] <= slack:
            joined[-1] = (joined[-1][0], max(joined[-1][1], end))
        else:
            joined.append((start, end))
    if not joined or not np.isfinite(around):
        return joined
    if joined[0][0] + around - joined[-1][1] <= slack:
        if len(joined) == 1:
            return [(joined[0][0], joined[0][0] + around)]
        first = joined.pop(0)
        joined[-1] = (joined[-1][0], first[1] + around)
    return joined


def without(
    spans: Iterable[Span], taken: Iterable[Span], around: float = np.inf, least: float = 0.0
) -> list[Span]:
    """What of the first stretches the others do not cover, where it is longer than ``least``."""
    gone = _flat(taken, around)
    left: list[Span] = []
    for begin, stop in _flat(spans, around):
        at = begin
        for low, high in gone:
            if high <= at or low >= stop:
                continue
            if low > at:
                left.append((at, low))
            at = max(at, high)
        if at < stop:
            left.append((at, stop))
    return [span for span in united(left, around) if span[1] - span[0] > least]


def _flat(spans: Iterable[Span], around: float) -> list[Span]:
    """Sorted stretches within one turn."""
    if not np.isfinite(around):
        return sorted(spans)
    flat: list[Span] = []
    for start, end in spans:
        length = min(end - start, around)
        low = float(np.mod(start, around))
        if low + length <= around:
            flat.append((low, low + length))
        else:
            flat += [(low, around), (0.0, low + length - around)]
    return sorted(flat)
