"""The areas of a sheet that are cut, told by the hatching in them (ISO 128-3)."""

from collections.abc import Sequence

import cv2
import numpy as np

from gaussiancad_core.files.vectors import Line, VectorStroke
from gaussiancad_core.sheet.annotations.marks import Mask

_COVERED = 0.75
"""Share of an area that is near its hatching at least, if it is hatched as a whole."""

_REACH = 0.75
"""Pitches from a line of a hatching up to which it tells."""


def cut_areas(
    lines: Sequence[VectorStroke], centres: Sequence[VectorStroke], ink: Mask
) -> Mask | None:
    """(h, w) the areas between edges and centre lines in which hatching runs; nothing where there
    is none.

    Where hatching fills an area in part only, it ends at a centre line (ISO 128-3): what is hatched
    ends with it.
    """
    if not lines:
        return None
    free = (~ink).astype(np.uint8)
    for own in centres:
        if isinstance(own.curve, Line):
            start, end = (
                tuple(np.floor(at).astype(int).tolist()) for at in (own.curve.start, own.curve.end)
            )
            cv2.line(free, start, end, 0)
    _, areas = cv2.connectedComponents(free, connectivity=4)
    points = np.concatenate([stroke.curve.sample(2.0) for stroke in lines])
    columns, rows = np.clip(np.floor(points).astype(int), 0, np.array(ink.shape)[::-1] - 1).T
    hatched = np.unique(areas[rows, columns])
    hatched = hatched[(hatched != 0) & (hatched != areas[0, 0])]
    found = np.isin(areas, hatched)
    reach = 2 * round(_REACH * _pitch(lines)) + 1
    drawn = np.zeros(ink.shape, np.uint8)
    drawn[rows, columns] = 1
    near = cv2.morphologyEx(drawn, cv2.MORPH_CLOSE, np.ones((reach, reach), np.uint8)) > 0
    count = int(areas.max()) + 1
    covered = np.bincount(areas[near], minlength=count) / np.bincount(areas.ravel())
    partly = [number for number in hatched if covered[number] < _COVERED]
    return found & (near | ~np.isin(areas, partly))


def _pitch(lines: Sequence[VectorStroke]) -> float:
    """px between neighbouring lines of a hatching, most often."""
    ends = np.array([(own.curve.start, own.curve.end) for own in lines if _is_line(own)])
    if len(ends) < 2:
        return 0.0
    ways = ends[:, 1] - ends[:, 0]
    way = ways[np.hypot(*ways.T).argmax()]
    normal = np.array([-way[1], way[0]]) / np.hypot(*way)
    apart = np.diff(np.sort(ends[:, 0] @ normal))
    apart = apart[apart > 1.0]
    return float(np.median(apart)) if len(apart) else 0.0


def _is_line(stroke: VectorStroke) -> bool:
    return isinstance(stroke.curve, Line)
