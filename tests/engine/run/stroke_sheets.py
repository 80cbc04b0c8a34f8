"""Sheets that consist of strokes, as a reading would have them."""

import itertools
from types import SimpleNamespace

import numpy as np

from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Linetype, Segment, View, ViewSet
from gaussiancad_core.sheet.labels.label_evidence import NO_LABELS
from gaussiancad_core.sheet.registration.view_registration import AxisExtents
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet, StrokesSource

SIZE = (40.0, 30.0, 20.0)


def chain(*points: tuple[float, float], linetype: Linetype = Linetype.VISIBLE) -> list[Segment]:
    """Segments from point to point."""
    return [Segment(a, b, linetype) for a, b in itertools.pairwise(points)]


def rectangle(width: float, height: float, x: float = 0.0, y: float = 0.0) -> list[Segment]:
    """Its four sides, from its lower left corner."""
    return chain((x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y))


def reading(
    strokes: dict[Role, list[Segment]],
    projection: Projection,
    source: StrokesSource = StrokesSource.RASTER,
    box: tuple[float, float, float, float] = (0.0, 0.0, 100.0, 100.0),
) -> ProjectedReading:
    """A part of :data:`SIZE` in views that all have the same box on the sheet."""
    mask, colour = np.zeros((2, 2), bool), np.zeros((2, 2, 3), np.uint8)
    views = tuple(
        View(role, box, tuple(stroke), mask, colour, (0.0, 0.0), 1.0)
        for role, stroke in strokes.items()
    )
    facts = {"dash": None, "source": source, "strokes": (), "tangents": (), "step": 0.0}
    drawn = tuple(SimpleNamespace(role=role, labels=NO_LABELS, **facts) for role in strokes)
    registered = RegisteredSheet(ViewSet(views, SIZE), {}, drawn, 0.02, AxisExtents({}, {}), 0)
    return ProjectedReading(registered, projection)
