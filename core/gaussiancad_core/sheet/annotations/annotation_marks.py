"""What was found on a sheet that is not the part."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.reading_options import Box

Mask = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class Mark:
    """One annotation.

    Attributes:
        kind: what it is.
        box: around it, px of the upright sheet.
        line: its two ends where it is a straight line.
    """

    kind: AnnotationKind
    box: Box
    line: tuple[tuple[float, float], tuple[float, float]] | None = None


def line_mark(kind: AnnotationKind, start: tuple[float, float], end: tuple[float, float]) -> Mark:
    """A mark that is a line between two points in px."""
    box = (
        min(start[0], end[0]),
        min(start[1], end[1]),
        max(start[0], end[0]),
        max(start[1], end[1]),
    )
    return Mark(kind, box, (start, end))


def values_at(
    areas: npt.NDArray[np.generic], points: npt.NDArray[np.float64]
) -> npt.NDArray[np.generic]:
    """(n,) what a picture (h, w) has at points (n, 2) px, its border continued."""
    columns = np.clip(np.rint(points[:, 0]).astype(int), 0, areas.shape[1] - 1)
    rows = np.clip(np.rint(points[:, 1]).astype(int), 0, areas.shape[0] - 1)
    return areas[rows, columns]
