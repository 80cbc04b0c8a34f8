"""The edges of a solid, seen along a direction: the straight lines and circles of a plane.

Coordinates are in hundredths of the part's longest extent, the units of
:mod:`gaussiancad_core.model.projection_planes`.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import hypot

import numpy as np
import numpy.typing as npt
from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_CurveType
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face

from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval
from gaussiancad_core.features.frames import Frame
from gaussiancad_core.features.solid_faces import Kind, SolidFace, u_range
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.geometry.whole_curves import Circle, Line, LineOrCircle, line_through
from gaussiancad_core.kernel.brep import edges_of
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype

Points = npt.NDArray[np.float64]

SAME = 5e-5
"""Units within which two curves are one, and a point is on a curve."""

_ALONG_A_CURVE = 65
"""Points of a curved edge that are looked at."""


@dataclass(frozen=True)
class Stretch:
    """A piece of a curve.

    Attributes:
        curve: that it lies on; units.
        low, high: parameters; of circles from 0 to 2 pi.
    """

    curve: LineOrCircle
    low: float
    high: float


def stretches_along(edges: Iterable[TopoDS_Edge], frame: Frame) -> list[Stretch]:
    """What a view along a frame's normal shows of straight and circular edges.

    Args:
        edges: of a solid; those that are neither straight nor circles seen face-on or edge-on
            show nothing.
        frame: its plane.
    """
    found: list[Stretch] = []
    for edge in edges:
        found.extend(_stretches(BRepAdaptor_Curve(edge), frame))
    return found


def stretches_of_walls(faces: Iterable[SolidFace], frame: Frame) -> list[Stretch]:
    """What a view along a frame's normal shows of faces that run along it: planes and cylinders,
    edge-on, whatever their edges are.

    Args:
        faces: of a solid.
        frame: the view's plane.
    """
    normal = np.array(frame.normal)
    found: list[Stretch] = []
    for face in faces:
        lean = abs(float(face.direction @ normal))
        if face.kind is Kind.PLANE and lean < COMPUTED:
            seen = frame.project(_edge_points(face.face))[:, :2]
            along = seen @ _direction(seen)
            ends = (seen[int(along.argmin())], seen[int(along.argmax())])
            made = segment(*((float(x), float(y)) for x, y in ends))
            found += [] if made is None else [made]
        elif face.kind is Kind.CYLINDER and lean > 1.0 - COMPUTED:
            low, high = u_range(face)
            surface = BRepAdaptor_Surface(face.face)
            places = [surface.Value(low + share * (high - low), 0.0) for share in (0.0, 0.5, 1.0)]
            points = frame.project(np.array([[p.X(), p.Y(), p.Z()] for p in places]))
            start, middle, end = ((float(x), float(y)) for x, y, _ in points)
            centre = frame.project(face.point[None])[0, :2]
            found += arc((float(centre[0]), float(centre[1])), face.radius, (start, end), middle)
    return found


def _edge_points(face: TopoDS_Face) -> Points:
    """(n, 3) points along the edges of a face."""
    found = []
    for edge in edges_of(face):
        curve = BRepAdaptor_Curve(edge)
        low, high = curve.FirstParameter(), curve.LastParameter()
        count = 2 if curve.GetType() == GeomAbs_CurveType.GeomAbs_Line else _ALONG_A_CURVE
        for at in np.linspace(low, high, count):
            point = curve.Value(float(at))
            found.append((point.X(), point.Y(), point.Z()))
    return np.array(found)


def supports_of(stretches: Iterable[Stretch]) -> list[Carrier]:
    """Stretches by the curves that they lie on; curves within :data:`SAME` of each other are
    one."""
    found: list[tuple[LineOrCircle, list[Interval]]] = []
    for stretch in sorted(stretches, key=lambda one: -_length(one)):
        for curve, spans in found:
            if _is_same(curve, stretch):
                spans.extend(_spans(curve, stretch))
                break
        else:
            found.append((stretch.curve, list(_spans(stretch.curve, stretch))))
    return [Carrier(curve, {Role.FRONT: tuple(spans)}) for curve, spans in found]


def segment(start: Point, end: Point) -> Stretch | None:
    """The straight stretch between two points; None where they are one."""
    if hypot(end[0] - start[0], end[1] - start[1]) < SAME:
        return None
    curve = line_through(start, end, COMPUTED)
    low, high = sorted((curve.parameter(start), curve.parameter(end)))
    return Stretch(curve, low, high)


def arc(centre: Point, radius: float, ends: tuple[Point, Point], middle: Point) -> list[Stretch]:
    """The stretches, one or two, of the arc from end to end through a point; the whole circle
    where both ends are one, nothing where it is a point."""
    if radius < SAME:
        return []
    circle = Circle(centre, radius)
    start, end, between = (circle.parameter(point) for point in (*ends, middle))
    if hypot(ends[0][0] - ends[1][0], ends[0][1] - ends[1][1]) < SAME:
        return [Stretch(circle, 0.0, FULL_TURN)]
    if not _is_between(start, between, end):
        start, end = end, start
    if start < end:
        return [Stretch(circle, start, end)]
    pieces = [Stretch(circle, start, FULL_TURN), Stretch(circle, 0.0, end)]
    return [piece for piece in pieces if _length(piece) > SAME]


def _stretches(curve: BRepAdaptor_Curve, frame: Frame) -> Iterator[Stretch]:
    low, high = curve.FirstParameter(), curve.LastParameter()
    places = [curve.Value(low + share * (high - low)) for share in (0.0, 0.5, 1.0)]
    points = frame.project(np.array([[p.X(), p.Y(), p.Z()] for p in places]))
    start, middle, end = (tuple(point[:2].tolist()) for point in points)
    if curve.GetType() == GeomAbs_CurveType.GeomAbs_Line:
        if (made := segment(start, end)) is not None:
            yield made
        return
    if curve.GetType() != GeomAbs_CurveType.GeomAbs_Circle:
        return
    circle = curve.Circle()
    axis = circle.Axis().Direction()
    lean = abs(float(np.array([axis.X(), axis.Y(), axis.Z()]) @ np.array(frame.normal)))
    at = circle.Location()
    centre = frame.project(np.array([[at.X(), at.Y(), at.Z()]]))[0, :2]
    if lean > 1.0 - COMPUTED:
        yield from arc(tuple(centre.tolist()), circle.Radius(), (start, end), middle)
    elif lean < COMPUTED:
        # Edge-on it is a straight stretch, between the extremes that the arc reaches.
        span = np.linspace(low, high, _ALONG_A_CURVE)
        seen = [curve.Value(float(t)) for t in span]
        flat = frame.project(np.array([[p.X(), p.Y(), p.Z()] for p in seen]))[:, :2]
        along = flat @ _direction(flat)
        ends = flat[int(along.argmin())], flat[int(along.argmax())]
        if (made := segment(*(tuple(point.tolist()) for point in ends))) is not None:
            yield made


def _direction(points: Points) -> Points:
    """(2,) unit vector along which points are spread."""
    away = points - points[0]
    farthest = away[int(np.hypot(*away.T).argmax())]
    return farthest / max(float(np.hypot(*farthest)), 1e-12)


def _is_between(start: float, angle: float, end: float) -> bool:
    """Whether an angle is met on the way up from one to another."""
    return (angle - start) % FULL_TURN <= (end - start) % FULL_TURN


def _length(stretch: Stretch) -> float:
    return (stretch.high - stretch.low) * stretch.curve.speed


def _is_same(curve: LineOrCircle, stretch: Stretch) -> bool:
    """Whether a stretch lies on a curve."""
    other = stretch.curve
    if isinstance(curve, Circle):
        return (
            isinstance(other, Circle)
            and hypot(curve.centre[0] - other.centre[0], curve.centre[1] - other.centre[1]) < SAME
            and abs(curve.radius - other.radius) < SAME
        )
    if not isinstance(other, Line):
        return False
    return all(curve.distance(other.at(at)) < SAME for at in (stretch.low, stretch.high))


def _spans(curve: LineOrCircle, stretch: Stretch) -> Iterator[Interval]:
    """A stretch by the parameters of the curve that it lies on."""
    if isinstance(curve, Circle):
        low, high = stretch.low, stretch.high
    else:
        ends = (stretch.curve.at(at) for at in (stretch.low, stretch.high))
        low, high = sorted(curve.parameter(point) for point in ends)
    yield Interval(low, high, Linetype.VISIBLE, 1.0)
