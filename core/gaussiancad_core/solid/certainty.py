"""What makes a solid's measures known: the step that a part is designed in, the sheet's numbers."""

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.supports import PartSupports
from gaussiancad_core.solid.round_measures import RoundMeasures, is_round
from gaussiancad_core.solid.told_certainty import ToldMeasures
from gaussiancad_core.solid.verify import Certainty

_TOLD = 0.02
"""Tolerances within which a coordinate is one that the sheet tells."""

_ASIDE = 3.0
"""Times the noise that numbers may have been moved by to become round, at least; at most where the
step is none that parts are designed in: they may have been round in another one."""


def certainties(
    supports: PartSupports, views: DrawnViews, shape: TopoDS_Shape
) -> tuple[bool, list[Certainty]]:
    """Whether all measures of a solid are known, and what makes some of them known.

    Args:
        supports: that it was made from.
        views: of these.
        shape: mm.
    """
    known, certain = False, []
    if supports.step is not None:
        own, scale = supports.step, supports.scale
        moved, aside = own.moved / scale, _ASIDE * views.noise
        reach = min(max(moved, aside), own.reach / scale)
        measures = RoundMeasures(own.length / scale, reach, supports.odd)
        usual = measures.is_usual
        # A number of a dimension may have been misread as a round one.
        if not supports.unread and (usual or moved <= aside):
            certain.append(measures)
            round_faces = usual and views.noise and is_round(shape, measures.step)
            known = supports.nominal or bool(round_faces)
    if supports.places is not None:
        places = supports.places.scaled(1.0 / supports.scale)
        certain.append(ToldMeasures(places, _TOLD * views.tolerance))
    return known, certain
