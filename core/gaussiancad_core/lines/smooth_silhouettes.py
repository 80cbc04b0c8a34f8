"""Silhouettes inside faces: where a curved surface turns away from the viewer.

OpenCASCADE's hidden-line algorithm traces them in its first step; its second step, which hides, is
not run (:mod:`gaussiancad_core.lines.hlr` says why).
"""

from OCP.BRepLib import BRepLib
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.HLRAlgo import HLRAlgo_Projector
from OCP.HLRBRep import HLRBRep_Algo, HLRBRep_HLRToShape, HLRBRep_TypeOfResultingEdge
from OCP.TopoDS import TopoDS_Edge, TopoDS_Shape

from gaussiancad_core.kernel.brep import edges_of
from gaussiancad_core.kernel.solid_edges import raw_curve
from gaussiancad_core.model.axes import ViewFrame


def silhouettes(shape: TopoDS_Shape, frame: ViewFrame) -> list[TopoDS_Edge]:
    """The silhouettes of a solid's faces as 3D edges, without those along the faces' borders.

    Args:
        shape: solid in mm.
        frame: the view.
    """
    algorithm = HLRBRep_Algo()
    algorithm.Add(shape)
    algorithm.Projector(_projector(frame))
    algorithm.Update()
    result = HLRBRep_HLRToShape(algorithm)
    outlines = result.CompoundOfEdges(HLRBRep_TypeOfResultingEdge.HLRBRep_OutLine, True, True)
    if outlines is None or outlines.IsNull():
        return []
    # The outlines also hold pieces of the solid's edges, which lie on the very same curve objects.
    known = [raw_curve(edge) for edge in edges_of(shape)]
    identities = {id(curve) for curve in known}
    inner = [edge for edge in edges_of(outlines) if id(raw_curve(edge)) not in identities]
    for edge in inner:
        # Silhouettes come as curves on their surface.
        BRepLib.BuildCurve3d_s(edge)
    return inner


def _projector(frame: ViewFrame) -> HLRAlgo_Projector:
    towards_viewer = gp_Dir(*(-float(value) for value in frame.look))
    right = gp_Dir(*(float(value) for value in frame.right))
    return HLRAlgo_Projector(gp_Ax2(gp_Pnt(0.0, 0.0, 0.0), towards_viewer, right))
