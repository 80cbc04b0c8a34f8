"""What any solid would cost as slabs: how usual it is, by what a sketch is chosen by."""

import numpy as np
import numpy.typing as npt
from OCP.BRepClass3d import BRepClass3d_SolidClassifier
from OCP.gp import gp_Pnt
from OCP.TopAbs import TopAbs_State
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.reasoning.planes import IN_PLANE
from gaussiancad_core.sketch.choosing import energy_of
from gaussiancad_core.sketch.plan import Plan

_ON = 1e-6
"""mm within which a place is on the surface."""


def energy_as_slabs(shape: TopoDS_Shape, plan: Plan) -> float:
    """What a solid costs by a plan, mm, from whether it fills the middle of each region and slab.

    Args:
        shape: mm, in the model's axes.
        plan: regions and levels.
    """
    return energy_of(plan, _filled(shape, plan))


def _filled(shape: TopoDS_Shape, plan: Plan) -> npt.NDArray[np.bool_]:
    classifier = BRepClass3d_SolidClassifier(shape)
    levels = np.array(plan.levels)
    middles = (levels[1:] + levels[:-1]) / 2.0
    filled = np.zeros((len(plan.regions.polygons), len(middles)), dtype=bool)
    first, second = IN_PLANE[plan.axis]
    for number, own in enumerate(plan.regions.polygons):
        inside = own.representative_point()
        at = [0.0, 0.0, 0.0]
        at[first], at[second] = inside.x, inside.y
        for slab, height in enumerate(middles.tolist()):
            at[plan.axis.value] = height
            classifier.Perform(gp_Pnt(*at), _ON)
            filled[number, slab] = classifier.State() == TopAbs_State.TopAbs_IN
    return filled
