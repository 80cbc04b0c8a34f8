"""The visible and hidden lines of a solid in one view, by OpenCASCADE's exact algorithm.

``HLRBRep_Algo`` tells which part of each 3D edge is visible.  The strokes are then made from those
parts of the 3D edges and not from the algorithm's own 2D curves, which turn circles seen edge-on
and ellipses into splines.  Which smooth edges are lines of the drawing is decided from the normals
beside them (:mod:`gaussiancad_core.drawing.edges`): the algorithm reports silhouettes that run
along a seam as smooth or as sharp, whichever way the face was made.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepLib import BRepLib
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.HLRAlgo import HLRAlgo_Projector
from OCP.HLRBRep import HLRBRep_Algo, HLRBRep_HLRToShape, HLRBRep_TypeOfResultingEdge
from OCP.TopoDS import TopoDS_Edge, TopoDS_Shape

from gaussiancad_core.axes import Role, ViewFrame
from gaussiancad_core.drawing.brep import bounding_box, edges_of
from gaussiancad_core.drawing.cleanup import clean_strokes
from gaussiancad_core.drawing.edges import EdgeFacts, edge_facts, raw_curve
from gaussiancad_core.drawing.precision import Precision
from gaussiancad_core.drawing.projection import project_edge
from gaussiancad_core.drawing.rays import SightLines
from gaussiancad_core.drawing.recheck import rechecked
from gaussiancad_core.drawing.sightings import Witness
from gaussiancad_core.drawing.strokes import DrawnStroke
from gaussiancad_core.views import Linetype

_KINDS = (
    HLRBRep_TypeOfResultingEdge.HLRBRep_Sharp,
    HLRBRep_TypeOfResultingEdge.HLRBRep_Rg1Line,
    HLRBRep_TypeOfResultingEdge.HLRBRep_RgNLine,
    HLRBRep_TypeOfResultingEdge.HLRBRep_OutLine,
)

_BESIDE = 2e-5
"""Distance between a line and the sight lines beside it, as a share of the longest extent."""


@dataclass(frozen=True)
class LineOptions:
    """Which lines of a solid are drawn, and how exactly.

    Attributes:
        tangent_edges: draw smooth edges too (never the seams of closed surfaces).
        recheck: let sight lines decide anew what is visible.
        fit: largest distance between an edge and the line or circle that replaces it, as a share
            of the solid's longest extent; lines closer than that are one.
        chord: largest distance between a curve and its chain, as a share of the longest extent.
        fragment: strokes and gaps shorter than this share of the longest extent vanish.
    """

    tangent_edges: bool = False
    recheck: bool = True
    fit: float = 1e-6
    chord: float = 1e-5
    fragment: float = 2e-4

    def precision(self, extent: float) -> Precision:
        """The lengths in mm for a solid whose longest extent is ``extent`` mm."""
        return Precision(self.fit * extent, self.chord * extent, self.fragment * extent)


class LineDrawing:
    """The lines of one solid, view by view; the solid is analysed once.

    Args:
        shape: solid in mm.
        options: which lines, how exactly.
    """

    def __init__(self, shape: TopoDS_Shape, options: LineOptions | None = None) -> None:
        self._shape = shape
        self._options = options or LineOptions()
        box = bounding_box(shape)
        self._precision = self._options.precision(float((box[1] - box[0]).max()))
        self._facts: dict[int, list[EdgeFacts]] = {}
        # Held so that the identities of the curves stay unique.
        self._all_facts = edge_facts(shape)
        for facts in self._all_facts:
            self._facts.setdefault(id(facts.curve), []).append(facts)

    def view(self, role: Role) -> tuple[DrawnStroke, ...]:
        """The strokes of a view in its plane's millimetres (right, up)."""
        frame = role.frame
        look = np.array(frame.look, dtype=np.float64)
        strokes = []
        for edge, linetype in _hidden_line_edges(self._shape, frame):
            facts = self._origin(edge)
            if facts is not None and facts.smooth and not self._drawn(facts, look):
                continue
            stroke = project_edge(edge, frame, linetype, self._precision)
            if stroke is not None:
                strokes.append(stroke)
        found = clean_strokes(strokes, self._precision)
        if not self._options.recheck:
            return found
        extent = self._precision.fit / self._options.fit
        sight = SightLines(self._shape, frame, self._precision.fit)
        witness = Witness(sight, frame, _BESIDE * extent)
        checked = rechecked(
            found, witness, self._precision, self._options.tangent_edges
        )
        return clean_strokes(checked, self._precision)

    def _drawn(self, facts: EdgeFacts, look: np.ndarray) -> bool:
        tangent = self._options.tangent_edges and not facts.seam
        return tangent or facts.silhouette(look)

    def _origin(self, edge: TopoDS_Edge) -> EdgeFacts | None:
        """The solid's edge that a piece is cut from; None for silhouettes inside a face."""
        candidates = self._facts.get(id(raw_curve(edge)), [])
        if len(candidates) == 1:
            return candidates[0]
        return _containing(edge, candidates)


def _containing(edge: TopoDS_Edge, candidates: list[EdgeFacts]) -> EdgeFacts | None:
    piece = BRepAdaptor_Curve(edge)
    middle = (piece.FirstParameter() + piece.LastParameter()) / 2.0
    point = piece.Value(middle)
    for facts in candidates:
        # One curve may carry several edges, and one edge may stand at several places.
        inside = facts.first <= middle <= facts.last
        if (
            inside
            and BRepAdaptor_Curve(facts.edge).Value(middle).Distance(point) < 1e-6
        ):
            return facts
    return None


def draw_view(
    shape: TopoDS_Shape, role: Role, options: LineOptions | None = None
) -> tuple[DrawnStroke, ...]:
    """The visible and hidden strokes of a solid in one view, each line once.

    Args:
        shape: solid in mm; its position is kept.
        role: the view.
        options: which lines, how exactly.

    Returns:
        Strokes in mm of the view's plane: dot products with the frame's ``right`` and ``up``.
    """
    return LineDrawing(shape, options).view(role)


def _hidden_line_edges(
    shape: TopoDS_Shape, frame: ViewFrame
) -> Iterator[tuple[TopoDS_Edge, Linetype]]:
    """The pieces of 3D edges and silhouettes with their visibility."""
    algorithm = HLRBRep_Algo()
    algorithm.Add(shape)
    algorithm.Projector(_projector(frame))
    algorithm.Update()
    algorithm.Hide()
    result = HLRBRep_HLRToShape(algorithm)
    for linetype in Linetype:
        for kind in _KINDS:
            compound = result.CompoundOfEdges(kind, linetype is Linetype.VISIBLE, True)
            if compound is None or compound.IsNull():
                continue
            # Silhouettes come as curves on their surface.
            BRepLib.BuildCurves3d_s(compound)
            for edge in edges_of(compound):
                yield edge, linetype


def _projector(frame: ViewFrame) -> HLRAlgo_Projector:
    towards_viewer = gp_Dir(*(-float(value) for value in frame.look))
    right = gp_Dir(*(float(value) for value in frame.right))
    return HLRAlgo_Projector(gp_Ax2(gp_Pnt(0.0, 0.0, 0.0), towards_viewer, right))
