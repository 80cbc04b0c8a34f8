"""Whether two solids are the same, as far as their places are known."""

from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import FLOOR_MM
from gaussiancad_core.kernel.brep import area, subshapes, volume
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES


def same_solid(one: TopoDS_Shape, other: TopoDS_Shape, apart: float = FLOOR_MM) -> bool:
    """Whether two solids fill the same space, but for layers thinner than a distance.

    A body that one of them has alone is as thick as twice its volume over its area: a layer's
    thickness, a third of a cube's edge.  However small it is, it makes another solid.

    Args:
        one, other: mm, in place.
        apart: mm.
    """
    # A layer all around changes the volume by no more.
    if abs(volume(one) - volume(other)) > apart * max(area(one), area(other)):
        return False
    try:
        return all(_are_layers(*pair, apart) for pair in ((one, other), (other, one)))
    except KERNEL_FAILURES:
        return False


def _are_layers(one: TopoDS_Shape, other: TopoDS_Shape, apart: float) -> bool:
    """Whether all that one solid has alone is thinner than a distance."""
    cut = BRepAlgoAPI_Cut(one, other)
    if not cut.IsDone():
        return False
    bodies = subshapes(cut.Shape(), TopAbs_ShapeEnum.TopAbs_SOLID)
    return all(2.0 * abs(volume(body)) <= apart * area(body) for body in bodies)
