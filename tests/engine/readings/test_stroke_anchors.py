"""Whether two shapes are one: what is told quickly, beside all their points."""

import numpy as np

from gaussiancad_core.readings.reading_schema import StrokeEntry
from gaussiancad_core.readings.stroke_anchors import are_one, overlap, points_of
from gaussiancad_protocol.reading_kinds import StrokeKind

_NEAR_PX = 3.0


def _line(*ends: tuple[float, float]) -> StrokeEntry:
    return StrokeEntry(id="a", view="v", kind=StrokeKind.VISIBLE, line=ends)


def _plainly(stroke_entry: StrokeEntry, other: StrokeEntry) -> float:
    """The share of both that lies at the other, by all points."""
    first, last = points_of(stroke_entry), points_of(other)
    apart = np.hypot(*(first[:, None, :] - last[None, :, :]).transpose(2, 0, 1))
    steps = [np.hypot(*np.diff(points, axis=0).T).max() / 2.0 for points in (first, last)]
    return min(float((apart.min(axis) <= _NEAR_PX + steps[axis - 1]).mean()) for axis in (1, 0))


def test_lines_are_told_apart_as_their_points_are() -> None:
    lot = np.random.default_rng(7)
    ends = lot.uniform(0.0, 400.0, (60, 2, 2))
    moved = ends + lot.uniform(-8.0, 8.0, ends.shape)
    lines = [_line(*map(tuple, item.tolist())) for item in np.concatenate([ends, moved])]
    ones = 0
    for line in lines:
        for other in lines:
            share = _plainly(line, other)
            assert overlap(line, other) == share
            assert are_one(line, other) is (share > 0.999)
            ones += line is not other and share > 0.999
    assert ones
