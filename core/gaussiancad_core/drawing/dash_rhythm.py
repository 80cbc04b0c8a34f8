"""Dashes of one stroke: whole dashes at both ends, the rhythm stretched to the length."""

from gaussiancad_core.geometry.intervals import Interval


def dash_intervals(length: float, dash: float, gap: float, closed: bool) -> list[Interval]:
    """Where along a stroke there is ink.

    An open stroke begins and ends with a whole dash, so that it touches what it ends at.  Even a
    short one shows two dashes and a gap, as long as they can be told apart.  A closed stroke has a
    dash centred on its start, and on each quarter of its length where there are enough.

    Args:
        length: of the stroke; all lengths in one unit.
        dash, gap: nominal; both are stretched by the same factor.
        closed: the stroke's end is its start.
    """
    if closed:
        count = max(4, 4 * round(length / (dash + gap) / 4.0))
        period = length / count
        half = period * dash / (dash + gap) / 2.0
        return [(index * period - half, index * period + half) for index in range(count)]
    count = round((length + gap) / (dash + gap))
    if count < 2:
        return _short(length, gap)
    stretch = length / (count * dash + (count - 1) * gap)
    period = stretch * (dash + gap)
    return [(index * period, index * period + stretch * dash) for index in range(count)]


def _short(length: float, gap: float) -> list[Interval]:
    if length < 1.5 * gap:
        return [(0.0, length)]
    hole = min(gap, length / 3.0)
    half = (length - hole) / 2.0
    return [(0.0, half), (length - half, length)]
