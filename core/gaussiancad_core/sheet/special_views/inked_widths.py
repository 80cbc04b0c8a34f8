"""How wide the ink of a picture's strokes is, and which are clearly thinner than the edges."""

from collections.abc import Iterable

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.views import Linetype, Stroke
from gaussiancad_core.sheet.annotations.annotation_marks import values_at
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import ReadView

_NARROW = 0.8
"""Width of thin lines in that of wide ones at most: half of it (ISO 128-2), or a step of the series
of pens."""

_STEP, _ACROSS = 2.0, 0.25
"""px between places along a stroke, and across it."""

_REACH = 1.5
"""Widths of the sheet's lines to either side of a stroke within which its ink lies."""

_INKED = 0.3
"""Darkness at the middle of a stroke from which there is ink, and no gap between dashes."""


class InkedWidths:
    """The widths of the strokes of views.

    Args:
        sheet: the ink that they were read from.
        views: px of that.
    """

    def __init__(self, sheet: CleanSheet, views: Iterable[ReadView]) -> None:
        self._sheet = sheet
        self._of_edges = {
            view.role: self._of_longest(view.strokes)
            for view in views
            if view.source is StrokesSource.RASTER
        }

    def is_thin(self, view: ReadView, stroke: Stroke) -> bool:
        """Whether a stroke of a picture is clearly thinner than most edges of its view."""
        wide = self._of_edges.get(view.role)
        return wide is not None and self.width(stroke) <= _NARROW * wide

    def width(self, stroke: Stroke) -> float:
        """px of ink across a stroke, the median along it; 0 where there is none."""
        points = stroke.sample(_STEP)
        middles, ways = (points[1:] + points[:-1]) / 2.0, np.diff(points, axis=0)
        lengths = np.hypot(*ways.T)
        middles, ways, lengths = (each[lengths > 0.0] for each in (middles, ways, lengths))
        normals = np.stack([-ways[:, 1], ways[:, 0]], axis=1) / lengths[:, None]
        reach = _REACH * self._sheet.stroke_width
        offsets = np.arange(-reach, reach + _ACROSS, _ACROSS)
        places = middles[:, None] + offsets[None, :, None] * normals[:, None]
        ink = _weights(self._sheet, places.reshape(-1, 2)).reshape(len(middles), -1)
        is_inked = ink[:, len(offsets) // 2] >= _INKED
        return float(np.median(ink[is_inked].sum(axis=1))) * _ACROSS if is_inked.any() else 0.0

    def _of_longest(self, strokes: Iterable[Stroke]) -> float:
        """The width that half of the length of all visible strokes has at least; 0 of none."""
        visible = [stroke for stroke in strokes if stroke.linetype is Linetype.VISIBLE]
        if not visible:
            return 0.0
        widths = np.array([self.width(stroke) for stroke in visible])
        order = np.argsort(widths)
        lengths = np.cumsum(np.array([stroke.length for stroke in visible])[order])
        return float(widths[order][np.searchsorted(lengths, lengths[-1] / 2.0)])


def _weights(sheet: CleanSheet, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """(n,) darkness at points (n, 2) px; pixel centres lie at .5."""
    return np.asarray(values_at(sheet.weight, points - 0.5), dtype=np.float64)
