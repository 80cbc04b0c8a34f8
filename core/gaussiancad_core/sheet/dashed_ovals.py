"""Hidden rests of ellipses whose visible part is known.

Of a rod's slanted end the farther half of the rim is hidden.  Its dashes are short, and drawn with
another pen half a pixel beside the ellipse that the visible half tells: they do not count as its
ink, and are traced as short lines, each by itself.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import tau

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.runs import Rhythm
from gaussiancad_core.views import Ellipse, Linetype, Segment, Stroke

_BESIDE = 1.6
"""px beside the ellipse within which all of a dash lies."""

_TELLING = np.radians(80.0)
"""Turn of a visible part that tells where the rest of its ellipse is."""

_OPEN = 0.2
"""Radians that are open at least for something to be hidden there."""

_FEWEST, _INKED = 3, 0.3
"""Dashes of a hidden rest, and the share of it that they cover, at least."""

_LOST = 2
"""Dashes that may be lost between two others."""

_OVER = 3.0
"""px by which a dash may reach into the visible part."""

_MOST = 0.75
"""Share of the open part from which all of it is hidden: beside an outline that the ellipse touches
its dashes are not seen."""

_ALONG, _APART = 60.0, 6.0
"""px along an ellipse from its end to where it touches a line, and from the end to the line, at
most."""

_CONFIDENCE = 0.9

_Span = tuple[float, float]


def with_dashed_rests(strokes: Sequence[Stroke], rhythm: Rhythm) -> list[Stroke]:
    """The strokes with one hidden ellipse in place of the dashes along the rest of a visible one.

    Args:
        strokes: of a view, px.
        rhythm: of the sheet's dashes, px.
    """
    found = list(strokes)
    for oval in strokes:
        if not isinstance(oval, Ellipse) or oval.linetype is not Linetype.VISIBLE:
            continue
        if not _TELLING <= oval.sweep <= tau - _OPEN:
            continue
        spans = {
            number: span
            for number, stroke in enumerate(found)
            if stroke.linetype is Linetype.HIDDEN and (span := _span(stroke, oval)) is not None
        }
        for row in _rows(spans, rhythm.gap + _LOST * (rhythm.dash + rhythm.gap)):
            own = [spans[number] for number in row]
            low, high = own[0][0], max(high for _, high in own)
            inked = sum(high - low for low, high in own)
            whole = inked >= _MOST * (oval.whole.around - oval.length)
            if whole or (len(row) >= _FEWEST and inked >= _INKED * (high - low)):
                shown, rest = _parted(oval, (low, high), rhythm.gap + _OVER, strokes)
                found = [stroke for number, stroke in enumerate(found) if number not in row]
                found = [shown if stroke is oval else stroke for stroke in found] + [rest]
                break
    return found


def _span(stroke: Stroke, oval: Ellipse) -> _Span | None:
    """Where a stroke lies along the open part of an ellipse, in px from where the visible part
    ends; None if it lies elsewhere."""
    whole = oval.whole
    points = stroke.sample(1.0)
    if np.abs(whole.distances(points)).max() > _BESIDE:
        return None
    open_from = whole.lengths(np.array([oval.start]))[0] + oval.length
    along: npt.NDArray[np.float64] = (whole.positions(points) - open_from) % whole.around
    free = whole.around - oval.length
    along = np.where(along > free + oval.length / 2.0, along - whole.around, along)
    low, high = float(along.min()), float(along.max())
    return (low, high) if low >= -_OVER and high <= free + _OVER else None


def _rows(spans: dict[int, _Span], gap: float) -> list[list[int]]:
    """Numbers of the spans in their order, in rows without wider gaps."""
    rows: list[list[int]] = []
    reach = -np.inf
    for number in sorted(spans, key=lambda own: spans[own]):
        low, high = spans[number]
        if rows and low - reach <= gap:
            rows[-1].append(number)
        else:
            rows.append([number])
        reach = max(reach, high)
    return rows


def _parted(
    oval: Ellipse, span: _Span, gap: float, strokes: Sequence[Stroke]
) -> tuple[Ellipse, Ellipse]:
    """The visible and the hidden part of an ellipse whose dashes have a span.

    Where it touches a line, as the outline of its rod, one begins where the other ends: there the
    first dashes are no narrower than the outline beside them.
    """
    whole = oval.whole
    start = float(whole.lengths(np.array([oval.start]))[0])
    end, free = start + oval.length, whole.around - oval.length
    all_hidden = span[1] - span[0] >= _MOST * free
    first, last = end + span[0], end + span[1]
    if all_hidden or span[0] <= gap:
        first = end = _touched(oval, end, strokes)
    if all_hidden or span[1] >= free - gap:
        start = _touched(oval, start, strokes)
        last = start + whole.around
    shown = _piece(oval, start, end)
    hidden = _piece(oval, first, last)
    return shown, replace(hidden, linetype=Linetype.HIDDEN, confidence=_CONFIDENCE)


def _touched(oval: Ellipse, end: float, strokes: Sequence[Stroke]) -> float:
    """Where an ellipse touches a line beside one of its ends, or that end; a length along it."""
    whole = oval.whole
    around = end + np.arange(-_ALONG, _ALONG + 0.25, 0.25)
    points, ways = whole.points_at(around), whole.tangents_at(around)
    middle = len(around) // 2
    for line in strokes:
        if not isinstance(line, Segment) or line.linetype is not Linetype.VISIBLE:
            continue
        way = np.subtract(line.end, line.start) / line.length
        off = points - np.array(line.start)
        beside = np.abs(off[:, 0] * way[1] - off[:, 1] * way[0])
        place = int(np.abs(ways[:, 0] * way[1] - ways[:, 1] * way[0]).argmin())
        along = float(off[place] @ way)
        met = -_OVER <= along <= line.length + _OVER
        if met and beside[place] <= _BESIDE and beside[middle] <= _APART:
            return float(around[place])
    return end


def _piece(oval: Ellipse, low: float, high: float) -> Ellipse:
    """The ellipse between two lengths along it."""
    first, last = oval.whole.parameters(np.array([low, high]))
    return replace(oval, start=float(first % tau), sweep=float(last - first))
