"""Sets of closed intervals on a line and on a circle (radians)."""

from collections.abc import Iterable

from gaussiancad_core.geometry.points import FULL_TURN

Interval = tuple[float, float]


def unite(intervals: Iterable[Interval], gap: float) -> list[Interval]:
    """The union, sorted; gaps of at most ``gap`` are closed."""
    united: list[Interval] = []
    for low, high in sorted(intervals):
        if united and low <= united[-1][1] + gap:
            united[-1] = (united[-1][0], max(united[-1][1], high))
        else:
            united.append((low, high))
    return united


def subtract(intervals: Iterable[Interval], taken: Iterable[Interval]) -> list[Interval]:
    """What of ``intervals`` lies in none of ``taken``."""
    left = list(intervals)
    for low, high in taken:
        left = [
            part
            for start, end in left
            for part in ((start, min(end, low)), (max(start, high), end))
            if part[1] > part[0]
        ]
    return left


def unite_on_circle(intervals: Iterable[Interval], gap: float) -> list[Interval]:
    """The union of angles, each interval starting in [0, 2 pi); the whole circle is (0, 2 pi).

    Args:
        intervals: (start, end) radians with ``start <= end <= start + 2 pi``.
        gap: radians; smaller gaps are closed.
    """
    flat: list[Interval] = []
    for low, high in intervals:
        start = low % FULL_TURN
        end = start + (high - low)
        flat.append((start, min(end, FULL_TURN)))
        if end > FULL_TURN:
            flat.append((0.0, end - FULL_TURN))
    united = unite(flat, gap)
    if not united:
        return []
    first, last = united[0], united[-1]
    if first[0] + FULL_TURN <= last[1] + gap:
        if len(united) == 1:
            return [(0.0, FULL_TURN)]
        united = [*united[1:-1], (last[0], first[1] + FULL_TURN)]
    return united
