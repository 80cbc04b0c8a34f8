"""The visible and hidden lines of a solid in one view.

Lines are the projections of the solid's sharp edges, of smooth edges along which the surface turns
away from the viewer, and of the silhouettes inside its faces.  Each is projected as a whole, so
that a circle stays a circle, and then cut where others meet it; exact sight lines beside each piece
decide whether it is visible (:mod:`gaussiancad_core.lines.visible_intervals`).

OpenCASCADE's ``HLRBRep_Algo`` would do all of this.  It is used for the silhouettes only, because
what it calls visible is now and then wrong: silhouettes along a cylinder's seam come as smooth
edges, hidden lines repeat visible ones, and lines where cylinders meet cylinders or slants get the
wrong kind.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.TopoDS import TopoDS_Edge, TopoDS_Shape

from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.kernel.solid_edges import EdgeFacts, edge_facts
from gaussiancad_core.kernel.solid_rays import SolidRays
from gaussiancad_core.lines.coverage import StrokeIndex
from gaussiancad_core.lines.edge_projection import project_edge
from gaussiancad_core.lines.single_lines import clean_strokes, distinct_strokes
from gaussiancad_core.lines.smooth_silhouettes import silhouettes
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.lines.traced_silhouettes import SplineSilhouettes
from gaussiancad_core.lines.visibility import RayTest
from gaussiancad_core.lines.visible_intervals import ProjectedLine, decided
from gaussiancad_core.model.axes import Role, ViewFrame
from gaussiancad_core.model.views import Linetype

_BESIDE = 2e-5
"""Distance between a line and the sight lines beside it, as a share of the longest extent."""


@dataclass(frozen=True)
class LineOptions:
    """Which lines of a solid are drawn, and how exactly.

    Attributes:
        tangent_edges: draw smooth edges too (never the seams of closed surfaces).
        fit: largest distance between an edge and the line or circle that replaces it, as a share
            of the solid's longest extent; lines closer than that are one.
        chord: largest distance between a curve and its chain, as a share of the longest extent.
        cover: chains closer to another line than this share of the longest extent are that line.
        fragment: strokes and gaps shorter than this share of the longest extent vanish.
    """

    tangent_edges: bool = False
    fit: float = 1e-6
    chord: float = 5e-6
    cover: float = 1e-4
    fragment: float = 2e-4

    def precision(self, extent: float) -> Precision:
        """The lengths in mm for a solid whose longest extent is ``extent`` mm."""
        return Precision(
            *(extent * share for share in (self.fit, self.chord, self.cover, self.fragment))
        )


class LineDrawing:
    """The lines of one solid, view by view; the solid's edges and splines are analysed once.

    Args:
        shape: solid in mm; its position is kept.
        options: which lines, how exactly.
    """

    def __init__(self, shape: TopoDS_Shape, options: LineOptions | None = None) -> None:
        self._shape = shape
        self._options = options or LineOptions()
        box = bounding_box(shape)
        self._extent = float((box[1] - box[0]).max())
        self._precision = self._options.precision(self._extent)
        self._facts = edge_facts(shape)
        self._splines = SplineSilhouettes(shape)

    def view(self, role: Role) -> tuple[DrawnStroke, ...]:
        """The strokes of a view in its plane's millimetres (right, up), each line once."""
        return self.seen(role.frame)

    def seen(self, frame: ViewFrame) -> tuple[DrawnStroke, ...]:
        """The same for any direction of view."""
        sight = SolidRays(self._shape, frame, self._precision.fit)
        witness = RayTest(sight, frame, _BESIDE * self._extent)
        lines = self._lines(frame)
        drawn = decided(lines, witness, self._precision, self._options.tangent_edges)
        return clean_strokes(drawn, self._precision)

    def _lines(self, frame: ViewFrame) -> list[ProjectedLine]:
        """What may be drawn in a view, each line once."""
        singles: list[ProjectedLine] = []
        for edge in self._edges(frame):
            stroke = project_edge(edge, frame, Linetype.VISIBLE, self._precision)
            if stroke is not None:
                singles.append(ProjectedLine(stroke, BRep_Tool.Tolerance_s(edge)))
        chains = self._splines.view(frame, self._precision.chord)
        singles += [ProjectedLine(chain, 0.0) for chain in chains]
        # Sight lines stand closer to a line than two lines have to be to count as one in the end.
        exact = replace(self._precision, cover=_BESIDE * self._extent)
        strokes = distinct_strokes((line.stroke for line in singles), exact)
        loose = [line for line in singles if line.slack > self._precision.fit]
        return with_slack(strokes, loose, exact.cover)

    def _edges(self, frame: ViewFrame) -> list[TopoDS_Edge]:
        """The edges and silhouettes that may be lines of a view."""
        look = np.array(frame.look, dtype=np.float64)
        edges = [facts.edge for facts in self._facts if self._may_show(facts, look)]
        return edges + silhouettes(self._shape, frame)

    def _may_show(self, facts: EdgeFacts, look: np.ndarray) -> bool:
        if not facts.smooth:
            return True
        tangent = self._options.tangent_edges and not facts.seam
        return tangent or facts.silhouette(look)


def with_slack(
    strokes: Sequence[DrawnStroke], loose: Sequence[ProjectedLine], tolerance: float
) -> list[ProjectedLine]:
    """The strokes as lines, with the slack of the loosest edges that they run along.

    Args:
        strokes: merged strokes, in mm.
        loose: lines of single edges whose slack counts.
        tolerance: mm; an edge that comes closer at the stroke's middle is one of the stroke's.
    """
    index = StrokeIndex(line.stroke for line in loose)
    slack = {id(line.stroke): line.slack for line in loose}
    lines = []
    for stroke in strokes:
        middle = stroke.points_at(np.array([0.438 * stroke.length]))
        items = [
            slack[id(other)]
            for other in index.near(stroke, tolerance)
            if other.distances(middle)[0] <= tolerance
        ]
        lines.append(ProjectedLine(stroke, max(items, default=0.0)))
    return lines


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
