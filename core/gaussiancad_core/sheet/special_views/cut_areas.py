"""The areas of a sheet that are cut, told by the hatching in them (ISO 128-3)."""

from collections.abc import Sequence

import cv2
import numpy as np

from gaussiancad_core.files.vectors import VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.annotations.annotation_marks import Mask


def cut_areas(
    lines: Sequence[VectorStroke], centres: Sequence[VectorStroke], ink: Mask
) -> Mask | None:
    """(h, w) the areas between edges and centre lines in which hatching runs; nothing where there
    is none.

    Hatching of a half section ends at its centre line (ISO 128-3).
    """
    if not lines:
        return None
    x, y, width, height = cv2.boundingRect(ink.astype(np.uint8))
    # Around the ink one ring more is outside.
    low, high = np.maximum((x - 1, y - 1), 0), np.array((x + width + 1, y + height + 1))
    free = (~ink[low[1] : high[1], low[0] : high[0]]).astype(np.uint8)
    for centre in centres:
        if isinstance(centre.curve, LineSegment):
            start, end = (
                np.floor(at).astype(int) - low for at in (centre.curve.start, centre.curve.end)
            )
            cv2.line(free, start.tolist(), end.tolist(), 0)
    count, areas = cv2.connectedComponents(free, connectivity=4)
    # Its ends lie on the walls: no telling on which side.
    points = np.concatenate([stroke.curve.vertices(2.0)[1:-1] for stroke in lines])
    cells = np.floor(points).astype(int) - low
    cells = cells[((cells >= 0) & (cells < areas.shape[::-1])).all(axis=1)]
    is_cut = np.zeros(count, dtype=bool)
    is_cut[areas[cells[:, 1], cells[:, 0]]] = True
    is_cut[[0, areas[0, 0]]] = False
    found = np.zeros(ink.shape, dtype=bool)
    found[low[1] : high[1], low[0] : high[0]] = is_cut[areas]
    return found
