"""How well the measures of a solid are known: a bound that nineteen of twenty faces keep.

The shape of a part and its measures are two questions.  What the lines of a picture tell of the
place of a face is a matter of pixels: views contradict each other by some hundredths of one, and a
line may run beside the solid's.  Numbers on the sheet tell the places that follow from them but for
their rounding; measures that are multiples of the step in which the part was designed are exact.
"""

from dataclasses import dataclass
from enum import Enum

import numpy as np
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape

from gaussiancad_core.coordinates.carriers import PartCarriers
from gaussiancad_core.evidence.drawn_views import EXACT_TOLERANCE, FLOOR_MM, DrawnViews
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.sheet.votes import NEARLY_ALL
from gaussiancad_core.solid.known_faces import KnownMeasures, axes_of, is_known
from gaussiancad_core.solid.known_measures import DimensionEvidence, RoundMeasures
from gaussiancad_core.solid.verify import Verification

_ROUNDED = 0.5
"""Error of a rounded number, in its last digit, at most."""

_TOLD = 0.02
"""Tolerances within which a coordinate is one that the sheet tells."""

_ASIDE = 3.0
"""Times the noise that numbers may have been moved by to become round, at least; at most where the
step is none that parts are designed in: they may have been round in another one."""


class MeasureSource(Enum):
    """What tells the measures."""

    NUMBERS = "numbers"
    DRAWING = "drawing"
    MIXED = "mixed"


@dataclass(frozen=True)
class Measures:
    """How well the places of a solid's faces are known.

    Attributes:
        uncertainty: mm; 95 % of the faces lie no farther from where they belong.
        by_axis: the same of the faces whose place a coordinate along x, y or z tells.
        source: whether numbers on the sheet tell the places, the drawing does, or both.
    """

    uncertainty: float
    by_axis: tuple[float, float, float]
    source: MeasureSource


@dataclass(frozen=True)
class _Told:
    """What makes some measures known, and the mm by which these may still be off."""

    known: KnownMeasures
    bound: float
    by_numbers: bool


def measures_of(
    shape: TopoDS_Shape, carriers: PartCarriers, views: DrawnViews, verification: Verification
) -> Measures:
    """How well the measures of a solid are known.

    Args:
        shape: mm.
        carriers: that it was made from.
        views: of these.
        verification: how the solid's lines lie beside those of the views.
    """
    least = max(FLOOR_MM, EXACT_TOLERANCE * max(views.size))
    drawn = max(least, views.bound)
    if not views.noise:
        # Lines of a file are where they belong but for how far they contradict each other.
        drawn = max(drawn, verification.spread, verification.misfit)
    sources = _sources(carriers, views, least)
    faces = faces_of(shape)
    places = [_place(face, sources, drawn) for face in faces]
    bounds = np.array([bound for bound, _ in places])
    along = np.array([axes_of(face) for face in faces])
    x, y, z = (_most(bounds[along[:, k]], drawn) for k in range(3))
    counted = np.array([by_numbers for _, by_numbers in places])
    source = MeasureSource.MIXED if counted.any() else MeasureSource.DRAWING
    if counted.mean() >= NEARLY_ALL:
        source = MeasureSource.NUMBERS
    return Measures(_most(bounds, drawn), (x, y, z), source)


def _sources(carriers: PartCarriers, views: DrawnViews, least: float) -> list[_Told]:
    """What makes measures known: the step that the part is designed in, the sheet's numbers."""
    found = []
    if carriers.step is not None:
        step, scale = carriers.step, carriers.scale
        moved, aside = step.moved / scale, _ASIDE * views.noise
        # Lines of a file have no noise; what it was rounded by moves them nevertheless.
        reach = min(max(moved, aside or views.bound), step.reach / scale)
        measures = RoundMeasures(step.length / scale, reach, carriers.odd)
        # A number of a dimension may have been misread as a round one.
        likely = not carriers.unread and (measures.is_usual or moved <= aside)
        if carriers.nominal or (likely and not measures.is_chance):
            found.append(_Told(measures, least, by_numbers=False))
    if carriers.places is not None:
        places = carriers.places.scaled(1.0 / carriers.scale)
        stated_measures = DimensionEvidence(places, _TOLD * views.tolerance)
        found.append(_Told(stated_measures, max(least, _ROUNDED * places.digit), by_numbers=True))
    return found


def _place(face: TopoDS_Face, sources: list[_Told], drawn: float) -> tuple[float, bool]:
    """mm by which a face may be off, and whether numbers on the sheet tell its place."""
    this_sources = [source for source in sources if is_known(face, source.known)]
    bound = min((stated.bound for stated in this_sources), default=drawn)
    return min(bound, drawn), any(stated.by_numbers for stated in this_sources)


def _most(bounds: np.ndarray, otherwise: float) -> float:
    """The bound that enough of the faces keep."""
    if not len(bounds):
        return otherwise
    return float(np.quantile(bounds, NEARLY_ALL, method="higher"))
