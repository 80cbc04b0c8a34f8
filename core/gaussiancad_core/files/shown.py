"""Which strokes of a file its picture shows: layers may be off, and what lies beyond the sheet."""

import numpy as np

from gaussiancad_core.files.content import PAPER_LEVEL, Grey
from gaussiancad_core.files.vectors import VectorStroke

SHOWN = 0.3
"""Share of a stroke that shows at least: the gaps of dashes do not, and nothing of a layer that is
off, or of what is clipped or covered."""

_MOST_SAMPLES = 5000
"""Points at which a stroke is looked for in the picture."""


def shown_share(stroke: VectorStroke, grey: Grey) -> float:
    """Share of the points along a stroke at which the picture shows anything.

    Points off the sheet count as blank, those in the gaps of dashes too.
    """
    points = stroke.curve.vertices(max(1.0, stroke.curve.length / _MOST_SAMPLES))
    points = points[np.isfinite(points).all(axis=1)]
    cells = np.floor(np.clip(points, -1.0, max(grey.shape) + 1.0)).astype(int)
    height, width = grey.shape
    inside = ((cells >= 0) & (cells < [width, height])).all(axis=1)
    columns, rows = cells[inside].T
    return float((grey[rows, columns] < PAPER_LEVEL).sum()) / max(len(points), 1)
