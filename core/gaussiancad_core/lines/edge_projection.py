"""A 3D edge seen along an axis: a segment, an arc or a chain, as exact as the edge itself."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.GCPnts import GCPnts_TangentialDeflection
from OCP.GeomAbs import GeomAbs_CurveType
from OCP.gp import gp_Pnt
from OCP.TopoDS import TopoDS_Edge

from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.axes import ViewFrame
from gaussiancad_core.model.views import Arc, Linetype, Segment

_DENSE = 65
_ANGULAR = 0.05
_DISTINCT = 1e-3
_SECTIONS = 24
_GOLDEN = (np.sqrt(5.0) - 1.0) / 2.0


def project_edge(
    edge: TopoDS_Edge, frame: ViewFrame, linetype: Linetype, precision: Precision
) -> DrawnStroke | None:
    """The stroke of one edge in a view's plane (right, up) in mm; None where it is a point."""
    curve = BRepAdaptor_Curve(edge)
    plane = np.array([frame.right, frame.up], dtype=np.float64)
    is_line = curve.GetType() == GeomAbs_CurveType.GeomAbs_Line
    count = 2 if is_line else _DENSE
    parameters = np.linspace(curve.FirstParameter(), curve.LastParameter(), count)
    points = _all_flat(curve, plane, parameters)
    if np.ptp(points, axis=0).max() < precision.fit:
        return None
    if is_line:
        return Segment(_pair(points[0]), _pair(points[-1]), linetype)
    straight = _straight(curve, plane, parameters, points, precision.fit)
    if straight is not None:
        return Segment(*straight, linetype)
    if curve.GetType() == GeomAbs_CurveType.GeomAbs_Circle:
        circle = curve.Circle()
        axis = circle.Axis().Direction()
        if abs(np.dot(frame.look, (axis.X(), axis.Y(), axis.Z()))) > 1.0 - 1e-12:
            centre = circle.Location()
            flat = plane @ np.array([centre.X(), centre.Y(), centre.Z()])
            low, high = _angles(points, flat)
            return _arc(flat, circle.Radius(), low, high, linetype)
    fitted = _circle_through(points, precision.fit)
    if fitted is not None:
        low, high = _refined_angles(curve, plane, parameters, points, fitted[0])
        return _arc(*fitted, low, high, linetype)
    return _chain(curve, plane, linetype, precision.chord)


def _flat(
    curve: BRepAdaptor_Curve, plane: npt.NDArray[np.float64], parameter: float
) -> npt.NDArray[np.float64]:
    point: gp_Pnt = curve.Value(float(parameter))
    return plane @ np.array([point.X(), point.Y(), point.Z()])


def _all_flat(
    curve: BRepAdaptor_Curve,
    plane: npt.NDArray[np.float64],
    parameters: npt.NDArray[np.float64],
) -> npt.NDArray[np.float64]:
    """(n, 2) the points of a curve at parameters (n,)."""
    found = (curve.Value(at) for at in parameters.tolist())
    return np.array([(point.X(), point.Y(), point.Z()) for point in found]) @ plane.T


def _pair(point: npt.NDArray[np.float64]) -> tuple[float, float]:
    return float(point[0]), float(point[1])


def _straight(
    curve: BRepAdaptor_Curve,
    plane: npt.NDArray[np.float64],
    parameters: npt.NDArray[np.float64],
    points: npt.NDArray[np.float64],
    fit: float,
) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """The ends of a curve that is seen edge-on; it may run back and forth along its line."""
    centre = points.mean(axis=0)
    _, _, axes = np.linalg.svd(points - centre, full_matrices=False)
    direction = axes[0]
    for axis in (0, 1):
        # Rounding must not turn what is parallel to an axis.
        if abs(direction[1 - axis]) < 1e-9:
            direction = np.eye(2)[axis]
    normal = np.array([-direction[1], direction[0]])
    off = (points - centre) @ normal
    if np.abs(off).max() > fit:
        return None

    def along(at: float) -> float:
        return float((_flat(curve, plane, at) - centre) @ direction)

    if curve.GetType() == GeomAbs_CurveType.GeomAbs_Circle:
        parameters = _with_turning_points(curve, direction @ plane, parameters)
        positions = [along(at) for at in parameters]
        low, high = min(positions), max(positions)
        return _pair(centre + low * direction), _pair(centre + high * direction)
    low = -_largest(lambda at: -along(at), parameters)
    high = _largest(along, parameters)
    return _pair(centre + low * direction), _pair(centre + high * direction)


def _with_turning_points(
    curve: BRepAdaptor_Curve,
    direction: npt.NDArray[np.float64],
    parameters: npt.NDArray[np.float64],
) -> npt.NDArray[np.float64]:
    """The ends of a circle's arc and where between them it turns back along a (3,) direction."""
    axes = curve.Circle().Position()
    towards = [
        float(direction @ np.array([axis.X(), axis.Y(), axis.Z()]))
        for axis in (axes.XDirection(), axes.YDirection())
    ]
    first, last = parameters[0], parameters[-1]
    turning = np.arctan2(towards[1], towards[0]) + np.pi * np.arange(-5, 6)
    turning = first + np.mod(turning - first, FULL_TURN)
    return np.concatenate([[first, last], turning[turning < last]])


def _largest(function: Callable[[float], float], parameters: npt.NDArray[np.float64]) -> float:
    """The maximum of a function over a range, by golden sections around its best sample."""
    values = [function(at) for at in parameters]
    best = int(np.argmax(values))
    low = parameters[max(0, best - 1)]
    high = parameters[min(len(parameters) - 1, best + 1)]
    for _ in range(_SECTIONS):
        first = high - _GOLDEN * (high - low)
        second = low + _GOLDEN * (high - low)
        if function(first) < function(second):
            low = first
        else:
            high = second
    return max(values[best], function((low + high) / 2.0))


def _circle_through(
    points: npt.NDArray[np.float64], fit: float
) -> tuple[npt.NDArray[np.float64], float] | None:
    """Centre and radius of the circle that all points lie on within ``fit``."""
    middle = points.mean(axis=0)
    local = points - middle
    system = np.column_stack([2.0 * local, np.ones(len(local))])
    solution, *_ = np.linalg.lstsq(system, (local**2).sum(axis=1), rcond=None)
    centre = solution[:2]
    radius = float(np.sqrt(max(0.0, solution[2] + centre @ centre)))
    size = float(np.ptp(points, axis=0).max())
    if radius == 0.0 or radius > 100.0 * size:
        return None
    if np.abs(np.hypot(*(local - centre).T) - radius).max() > fit:
        return None
    return middle + centre, radius


def _angles(
    points: npt.NDArray[np.float64], centre: npt.NDArray[np.float64]
) -> tuple[float, float]:
    angles = np.unwrap(np.arctan2(*(points - centre).T[::-1]))
    return float(angles.min()), float(angles.max())


def _refined_angles(
    curve: BRepAdaptor_Curve,
    plane: npt.NDArray[np.float64],
    parameters: npt.NDArray[np.float64],
    points: npt.NDArray[np.float64],
    centre: npt.NDArray[np.float64],
) -> tuple[float, float]:
    """The angles between which a curve runs, perhaps back and forth, along its circle."""
    low, high = _angles(points, centre)
    middle = (low + high) / 2.0

    def angle(at: float) -> float:
        offset = _flat(curve, plane, at) - centre
        return float((np.arctan2(offset[1], offset[0]) - middle + np.pi) % FULL_TURN)

    if high - low > FULL_TURN - 0.2:
        return low, high
    refined_low = -_largest(lambda at: -angle(at), parameters)
    return refined_low + middle - np.pi, _largest(angle, parameters) + middle - np.pi


def _arc(
    centre: npt.NDArray[np.float64],
    radius: float,
    low: float,
    high: float,
    linetype: Linetype,
) -> Arc:
    return Arc(_pair(centre), float(radius), low % FULL_TURN, min(high - low, FULL_TURN), linetype)


def _chain(
    curve: BRepAdaptor_Curve,
    plane: npt.NDArray[np.float64],
    linetype: Linetype,
    chord: float,
) -> Polyline:
    nodes = GCPnts_TangentialDeflection(curve, _ANGULAR, chord)
    points = [_flat(curve, plane, nodes.Parameter(index + 1)) for index in range(nodes.NbPoints())]
    distinct = [points[0]]
    for point in points[1:]:
        if np.abs(point - distinct[-1]).max() > _DISTINCT * chord:
            distinct.append(point)
    return Polyline(tuple(_pair(point) for point in distinct), linetype)
