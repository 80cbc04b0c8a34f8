"""Three views of a solid by OpenCASCADE's own removal of hidden lines, in mm.

None of the engine's drawing is used for the lines, so that what both would do wrong in the same way
shows: the algorithm leaves pieces where it cut an edge, and repeats visible lines as hidden ones,
as programs do that are built on it; here pieces of one line or circle are joined, and of what is
both, or drawn twice, only one is kept, visible if it can be.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import atan2, cos, hypot, pi, sin

import numpy as np
import numpy.typing as npt
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepLib import BRepLib
from OCP.GeomAbs import GeomAbs_CurveType
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.HLRAlgo import HLRAlgo_Projector
from OCP.HLRBRep import HLRBRep_Algo, HLRBRep_HLRToShape
from OCP.TopoDS import TopoDS_Edge, TopoDS_Shape
from scipy.interpolate import CubicSpline
from shapely import LineString, Polygon
from shapely.ops import linemerge

from benchmarks.sheets.clean_sheets import ROLES
from gaussiancad_core.drawing.drawn_sheet import PartLines
from gaussiancad_core.geometry.intervals import Interval, subtract, unite, unite_on_circle
from gaussiancad_core.kernel.brep import bounding_box, edges_of
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

_SAME = 1e-4
"""mm by which pieces of one line or circle differ."""

_ANGLE = 1e-5
"""Radians by which they do."""

_LEAST = 1e-3
"""mm that a line or curve is at least long."""

_BIT = 0.3
"""mm that a line is at least long which the algorithm does not tell to be one."""

_CHAIN = 2e-3
"""mm between chains and what they run along."""

_CHORDS = 48
"""Of a curve that is neither straight nor round."""

_SMOOTH = 1e-3
"""Radians by which faces may bend where they meet without an edge."""

_GRAIN = 1e-2
"""mm of a curve that is left at least beside what runs along it."""

_UNDECIDED = 6
"""Visible pieces of a circle from which on it is hidden: behind a wall that it runs along, the
algorithm takes it for seen and unseen by turns."""

_STEP = 0.02
"""mm between points that tell where a circle is."""

_TELLING = 0.3
"""Radians that a chain turns by at least to tell a circle that nothing else does."""

Floats = npt.NDArray[np.float64]

_Lines = list[tuple[tuple[float, ...], list[Segment]]]
"""Segments by the angle and offset of the lines that they lie on."""

_Circles = list[tuple[tuple[float, ...], list[Arc]]]
"""Arcs by centre and radius."""


@dataclass(frozen=True)
class _Kind:
    """Where the algorithm keeps lines of a kind: sharp edges, and outlines of curved faces."""

    linetype: Linetype
    parts: Callable[[HLRBRep_HLRToShape], Sequence[TopoDS_Shape | None]]


_KINDS = (
    _Kind(Linetype.VISIBLE, lambda found: (found.VCompound(), found.OutLineVCompound())),
    _Kind(Linetype.HIDDEN, lambda found: (found.HCompound(), found.OutLineHCompound())),
)


def textbook_lines(shape: TopoDS_Shape) -> PartLines:
    """Front, top and right view of a solid in mm whose box starts at the origin."""
    # Tells the algorithm which edges are smooth: these are not drawn.
    BRepLib.EncodeRegularity_s(shape, _SMOOTH)
    views = {role: tuple(_joined(list(_pieces(shape, role)))) for role in ROLES}
    return PartLines(bounding_box(shape)[1], views)


def _pieces(shape: TopoDS_Shape, role: Role) -> Iterator[DrawnStroke]:
    """What the algorithm tells of a view, in mm of its plane (right, up)."""
    towards_viewer = (-float(value) for value in role.frame.look)
    right = (float(value) for value in role.frame.right)
    algorithm = HLRBRep_Algo()
    algorithm.Add(shape, 0)
    plane = gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(*towards_viewer), gp_Dir(*right))
    algorithm.Projector(HLRAlgo_Projector(plane))
    algorithm.Update()
    algorithm.Hide()
    found = HLRBRep_HLRToShape(algorithm)
    for kind in _KINDS:
        for part in kind.parts(found):
            if part is not None and not part.IsNull():
                BRepLib.BuildCurves3d_s(part)
                for edge in edges_of(part):
                    yield from _stroke(edge, kind.linetype)


def _stroke(edge: TopoDS_Edge, linetype: Linetype) -> Iterator[DrawnStroke]:
    """An edge that lies flat; none where it is no longer than a point."""
    curve = BRepAdaptor_Curve(edge)
    points = _places(curve)
    chord = points[-1] - points[0]
    if curve.GetType() == GeomAbs_CurveType.GeomAbs_Circle:
        circle = curve.Circle()
        centre = (circle.Location().X(), circle.Location().Y())
        # From its first point to its last, or the other way round if it is seen from behind.
        first = points[0] if circle.Axis().Direction().Z() > 0.0 else points[-1]
        start = atan2(first[1] - centre[1], first[0] - centre[0])
        turn = curve.LastParameter() - curve.FirstParameter()
        yield Arc(centre, circle.Radius(), start, min(turn, 2.0 * pi), linetype)
        return
    aside = chord[0] * (points - points[0])[:, 1] - chord[1] * (points - points[0])[:, 0]
    # A bit of a curve is straight, too.
    least = _LEAST if curve.GetType() == GeomAbs_CurveType.GeomAbs_Line else _BIT
    if hypot(*chord) > least and np.abs(aside).max() < _SAME * hypot(*chord):
        yield Segment(tuple(points[0].tolist()), tuple(points[-1].tolist()), linetype)
    elif np.hypot(*np.diff(points, axis=0).T).sum() > _LEAST:
        yield Polyline(tuple((x, y) for x, y in points.tolist()), linetype)


def _places(curve: BRepAdaptor_Curve) -> Floats:
    """Points (n, 2) along a curve in mm, those that the algorithm computed where it tells them.

    Of curves that are neither straight nor round it computes some points and joins them by chords.
    """
    if curve.GetType() == GeomAbs_CurveType.GeomAbs_BSplineCurve and curve.Degree() == 1:
        poles = curve.BSpline().Poles()
        corners = [(pole.X(), pole.Y()) for pole in poles]
        return np.array(corners)
    low, high = curve.FirstParameter(), curve.LastParameter()
    places = [curve.Value(value) for value in np.linspace(low, high, _CHORDS + 1)]
    return np.array([(place.X(), place.Y()) for place in places])


def _joined(pieces: Sequence[DrawnStroke]) -> Iterator[DrawnStroke]:
    """Pieces of one line or circle as one stroke; hidden only where nothing visible is."""
    lines: _Lines = []
    circles: _Circles = []
    chains = []
    for piece in pieces:
        if isinstance(piece, Segment):
            _sorted_in(lines, _line_of(piece), piece)
        elif isinstance(piece, Arc):
            _sorted_in(circles, (*piece.centre, piece.radius), piece)
    # Long chains tell their circle best.
    for piece in sorted(pieces, key=lambda this_piece: -this_piece.length):
        if isinstance(piece, Polyline) and not _taken_for_arc(piece, circles):
            chains.append(_smooth(piece))
    strokes = [*_of_lines(lines), *_of_circles(circles)]
    yield from strokes
    yield from _left(chains, strokes)


def _of_lines(lines: _Lines) -> Iterator[Segment]:
    for (angle, offset), segments in lines:
        along, across = np.array([cos(angle), sin(angle)]), np.array([-sin(angle), cos(angle)])
        spans = {
            kind.linetype: unite(
                (
                    _ordered(float(along @ segment.start), float(along @ segment.end))
                    for segment in segments
                    if segment.linetype is kind.linetype
                ),
                _SAME,
            )
            for kind in _KINDS
        }
        for linetype, (low, high) in _told(spans, _LEAST):
            start, end = (offset * across + place * along for place in (low, high))
            yield Segment(tuple(start.tolist()), tuple(end.tolist()), linetype)


def _of_circles(circles: _Circles) -> Iterator[Arc]:
    for (x, y, radius), arcs in circles:
        spans = {
            kind.linetype: unite_on_circle(
                (
                    (arc.start_angle, arc.start_angle + arc.sweep)
                    for arc in arcs
                    if arc.linetype is kind.linetype
                ),
                _ANGLE,
            )
            for kind in _KINDS
        }
        if len(spans[Linetype.VISIBLE]) > _UNDECIDED:
            whole = unite_on_circle([item for some in spans.values() for item in some], _ANGLE)
            spans = {Linetype.VISIBLE: [], Linetype.HIDDEN: whole}
        for linetype, (low, high) in _told(spans, _ANGLE, 2.0 * pi):
            yield Arc((x, y), radius, low, high - low, linetype)


def _taken_for_arc(chain: Polyline, circles: _Circles) -> bool:
    """Whether a chain's points lie on a circle: it is put to the arcs of that circle."""
    points = np.array(chain.points)
    known = [circle for circle, _ in circles]
    fitted = np.linalg.lstsq(np.c_[points, np.ones(len(points))], (points**2).sum(axis=1))[0]
    x, y = (0.5 * fitted[:2]).tolist()
    for circle in (*known, (x, y, float(fitted[2] + x * x + y * y) ** 0.5)):
        around = points - circle[:2]
        if np.abs(np.hypot(*around.T) - circle[2]).max() < _SAME:
            angles = np.unwrap(np.arctan2(around[:, 1], around[:, 0]))
            low, high = sorted((float(angles[0]), float(angles[-1])))
            if circle in known or high - low > _TELLING:
                _sorted_in(
                    circles, circle, Arc(circle[:2], circle[2], low, high - low, chain.linetype)
                )
                return True
    return False


def _smooth(chain: Polyline) -> Polyline:
    """A chain of finer chords through the same points."""
    points = np.array(chain.points)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    closed = bool(np.hypot(*(points[-1] - points[0])) < _SAME)
    points[-1] = points[0] if closed else points[-1]
    spline = CubicSpline(along, points, bc_type="periodic" if closed else "not-a-knot")
    fine = spline(np.linspace(0.0, along[-1], _CHORDS * 2 + 1)).tolist()
    return replace(chain, points=tuple((x, y) for x, y in fine))


def _left(chains: list[Polyline], others: Sequence[DrawnStroke]) -> Iterator[Polyline]:
    """What of chains runs along nothing else; the visible and the longest ones come first."""
    ink = {kind.linetype: Polygon() for kind in _KINDS}
    for stroke in others:
        ink[stroke.linetype] |= _line(stroke).buffer(_CHAIN)
    for chain in sorted(
        chains, key=lambda this_chain: (this_chain.linetype is Linetype.HIDDEN, -this_chain.length)
    ):
        # A hidden curve is not drawn along a visible one either.
        taken = ink[Linetype.VISIBLE] | ink[chain.linetype]
        left = _line(chain).difference(taken)
        left = linemerge(left) if left.geom_type == "MultiLineString" else left
        for piece in getattr(left, "geoms", [left]):
            if piece.length > _GRAIN:
                yield Polyline(tuple((x, y) for x, y in piece.coords), chain.linetype)
        ink[chain.linetype] |= _line(chain).buffer(_CHAIN)


def _line(stroke: DrawnStroke) -> LineString:
    return LineString(stroke.points if isinstance(stroke, Polyline) else stroke.sample(_STEP))


def _told(
    spans: dict[Linetype, list[Interval]], least: float, turn: float | None = None
) -> Iterator[tuple[Linetype, Interval]]:
    """The visible spans, and what of the hidden ones is not visible, on a line or a circle."""
    visible, hidden = spans[Linetype.VISIBLE], spans[Linetype.HIDDEN]
    taken = list(visible)
    if turn is not None:
        taken = [(low + k * turn, high + k * turn) for low, high in visible for k in (-1, 0, 1)]
    left = subtract(hidden, taken)
    for linetype, item in ((Linetype.VISIBLE, visible), (Linetype.HIDDEN, left)):
        yield from ((linetype, (low, high)) for low, high in item if high - low > least)


def _line_of(segment: Segment) -> tuple[float, float]:
    """Angle in [0, pi) and distance from the origin of the line that a segment lies on."""
    (x, y), (u, v) = segment.start, segment.end
    angle = atan2(v - y, u - x) % pi
    angle = 0.0 if pi - angle < _ANGLE else angle
    return angle, cos(angle) * y - sin(angle) * x


def _sorted_in(groups: list, key: tuple[float, ...], piece: Segment | Arc) -> None:
    """Put a piece to those of the same line or circle."""
    for other, item in groups:
        if max(abs(one - two) for one, two in zip(key, other, strict=True)) < _SAME:
            item.append(piece)
            return
    groups.append((key, [piece]))


def _ordered(one: float, other: float) -> Interval:
    return (one, other) if one <= other else (other, one)
