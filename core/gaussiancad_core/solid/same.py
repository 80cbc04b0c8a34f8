"""Whether two solids are the same."""

from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.brep import volume
from gaussiancad_core.drawing.kernel_failures import KERNEL_FAILURES

_VOLUME = 1e-5
"""Relative difference of volumes below which they are equal."""

_PLACE = 1e-4
"""The same for centres of mass, relative to the cube root of the volume."""


def same_solid(one: TopoDS_Shape, other: TopoDS_Shape) -> bool:
    """Whether two solids fill the same space; both are in mm and in place."""
    first, second = _properties(one), _properties(other)
    size = abs(first.Mass())
    if abs(first.Mass() - second.Mass()) > _VOLUME * size:
        return False
    if first.CentreOfMass().Distance(second.CentreOfMass()) > _PLACE * size ** (1.0 / 3.0):
        return False
    try:
        common = BRepAlgoAPI_Common(one, other)
        common.Build()
        return abs(volume(common.Shape()) - size) <= 10.0 * _VOLUME * size
    except KERNEL_FAILURES:
        return False


def _properties(shape: TopoDS_Shape) -> GProp_GProps:
    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties)
    return properties
