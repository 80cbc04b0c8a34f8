"""The areas of a sheet that are cut, told by the hatching in them (ISO 128-3)."""

from collections.abc import Sequence

import cv2
import numpy as np

from gaussiancad_core.files.vectors import Line, VectorStroke
from gaussiancad_core.sheet.annotations.marks import Mask


def cut_areas(
    lines: Sequence[VectorStroke], centres: Sequence[VectorStroke], ink: Mask
) -> Mask | None:
    """(h, w) the areas between edges and centre lines in which hatching runs; nothing where there
    is none.

    Hatching of a half section ends at its centre line (ISO 128-3).
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
    # Its ends lie on the walls: no telling on which side.
    points = np.concatenate([stroke.curve.sample(2.0)[1:-1] for stroke in lines])
    columns, rows = np.clip(np.floor(points).astype(int), 0, np.array(ink.shape)[::-1] - 1).T
    hatched = np.unique(areas[rows, columns])
    hatched = hatched[(hatched != 0) & (hatched != areas[0, 0])]
    return np.isin(areas, hatched)
