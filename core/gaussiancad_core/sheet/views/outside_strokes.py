"""Strokes with paper on both sides: what is left of annotations beside a view.

An edge of the part has the part on one side at least.  Remains of extension lines and arrowheads
reach out of the filled outline, and are as thin as a line.
"""

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.views import Linetype, Segment, Stroke
from gaussiancad_core.sheet.picture_noise import MEETING, ON_LINE, ONE_PLACE
from gaussiancad_core.sheet.registration.view_masks import Outline
from gaussiancad_core.sheet.votes import HALF

_BESIDE_PX = 1.5
"""px beside a stroke's axis at which either side is looked at: edges are as near to each other."""

_LEAST_PX = 3.0
"""px by which the end of an edge sticks out at least, to be cut off."""

_NEAR_PX = 3.0
"""px from where a stroke begins to stick out to where it meets another, at most."""

_SAME_PX = 0.1
"""px between the ends of two strokes at most that were brought to the corner that they make."""

_CORNER_PX = 14.0
"""px up to which a corner lies outside of an outline that was closed before it."""

_DOUBTFUL = 0.15
"""Share of all strokes up to which some are outside: beyond, it is the outline that is wrong."""

Floats = npt.NDArray[np.float64]


def without_outside(strokes: tuple[Stroke, ...], outline: Outline) -> tuple[Stroke, ...]:
    """The strokes of a view without those outside of it, straight ones cut where they stick out.

    Args:
        strokes: in px of the sheet.
        outline: of the view.
    """
    kept: list[Stroke] = []
    removed = total = 0.0
    for stroke in strokes:
        points = stroke.sample(1.0)
        out = _is_outside(points, outline)
        total += stroke.length
        if out.mean() >= HALF:
            removed += stroke.length
            continue
        left = _cut(stroke, out, strokes) if isinstance(stroke, Segment) else stroke
        removed += stroke.length - left.length
        kept.append(left)
    return tuple(kept) if removed <= _DOUBTFUL * total else strokes


def _is_outside(points: Floats, outline: Outline) -> npt.NDArray[np.bool_]:
    """(n,) at which of the points (n, 2) along a stroke both of its sides are outside."""
    along = np.gradient(points, axis=0)
    along /= np.maximum(np.hypot(*along.T), 1e-9)[:, None]
    aside = _BESIDE_PX * np.stack([-along[:, 1], along[:, 0]], axis=1)
    sides = [_depth(points + way * aside, outline) for way in (-1.0, 1.0)]
    return np.maximum(*sides) < -ON_LINE


def _depth(points: Floats, outline: Outline) -> Floats:
    """(n,) px inside the outline, negative outside, at points (n, 2) px of the sheet."""
    factor = float(outline.supersampling)
    places = (points - outline.offset) * factor - 0.5
    x, y = places.astype(np.float32).T
    depth = cv2.remap(
        outline.depth,
        x.reshape(1, -1),
        y.reshape(1, -1),
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )
    return depth[0].astype(np.float64) / factor


def _cut(stroke: Segment, out: npt.NDArray[np.bool_], others: Sequence[Stroke]) -> Segment:
    """A segment without the ends that are outside; it ends where it meets one of the others."""
    inside = np.flatnonzero(~out)
    step = stroke.length / (len(out) - 1)
    first, last = float(inside[0]) * step, float(inside[-1]) * step
    cut_first = first >= _LEAST_PX and not _is_corner(stroke.start, first, stroke, others)
    beyond = stroke.length - last
    cut_last = beyond >= _LEAST_PX and not _is_corner(stroke.end, beyond, stroke, others)
    if not cut_first and not cut_last:
        return stroke
    met = _met(stroke, others)
    start = _nearest(met, first) if cut_first else 0.0
    end = _nearest(met, last) if cut_last else stroke.length
    origin = np.array(stroke.start)
    way = (np.array(stroke.end) - origin) / stroke.length
    (x0, y0), (x1, y1) = ((float(v) for v in origin + at * way) for at in (start, end))
    return replace(stroke, start=(x0, y0), end=(x1, y1))


def _is_corner(
    end: tuple[float, float], beyond: float, stroke: Segment, others: Sequence[Stroke]
) -> bool:
    """Whether an end outside is a corner that two edges make, both of which ended short of it."""
    edge = stroke.linetype is Linetype.VISIBLE
    return (
        edge
        and beyond <= _CORNER_PX
        and any(
            np.hypot(*np.subtract(end, its)) <= _SAME_PX
            for other in others
            if other is not stroke
            and isinstance(other, Segment)
            and other.linetype is Linetype.VISIBLE
            for its in (other.start, other.end)
        )
    )


def _met(stroke: Segment, others: Sequence[Stroke]) -> Floats:
    """(n,) px from a segment's start at which its line meets other segments."""
    origin, end = np.array(stroke.start), np.array(stroke.end)
    way = (end - origin) / stroke.length
    found = []
    for other in others:
        if other is stroke or not isinstance(other, Segment):
            continue
        first, second = np.array(other.start) - origin, np.array(other.end) - origin
        before = float(way[0] * first[1] - way[1] * first[0])
        after = float(way[0] * second[1] - way[1] * second[0])
        # What ends on the line a little before it meets it, too.
        if abs(after - before) > MEETING * other.length and min(before, after) < ONE_PLACE:
            share = np.clip(before / (before - after), 0.0, 1.0)
            place = first + share * (second - first)
            if abs(float(way[0] * place[1] - way[1] * place[0])) < ONE_PLACE:
                found.append(float(place @ way))
    return np.array(found)


def _nearest(met: Floats, place: float) -> float:
    """The place at which others are met that is nearest to one, if any is near."""
    near = met[np.abs(met - place) <= _NEAR_PX]
    return float(near[np.argmin(np.abs(near - place))]) if len(near) else place
