"""Edges in the plane z = 0 as SVG path data; arcs stay arcs, free curves become Bézier curves."""

import math

import FreeCAD
import Part

_TOLERANCE_MM = 1e-3
_MOST_SEGMENTS = 200
_ARC_PIECES = 4
"""SVG cannot draw a whole turn as one arc."""

_SHORTEST_MM = 1e-6
_STRAIGHT_MM = 1e-5
_SAMPLES = 16
"""Pieces in which an edge is looked at; even, so that a whole circle's far point is met."""


def edge_path(edge: Part.Edge, origin: tuple[float, float]) -> str:
    """SVG path data of an edge; empty if it has no length.

    Args:
        edge: y points down the sheet.
        origin: is added to its points, in mm.
    """
    if edge.Length < _SHORTEST_MM:
        return ""
    curve = edge.Curve
    ends = _straight_ends(edge)
    if ends is not None:
        return f"M{_at(ends[0], origin)}L{_at(ends[1], origin)}"
    if isinstance(curve, Part.Circle):
        return _arcs(edge, origin, (curve.Radius, curve.Radius, 0.0))
    if isinstance(curve, Part.Ellipse):
        tilt = math.degrees(math.atan2(curve.XAxis.y, curve.XAxis.x))
        return _arcs(edge, origin, (curve.MajorRadius, curve.MinorRadius, tilt))
    return _beziers(edge, origin)


def _at(point: FreeCAD.Vector, origin: tuple[float, float]) -> str:
    return f"{point.x + origin[0]:.9g} {point.y + origin[1]:.9g}"


def _straight_ends(edge: Part.Edge) -> tuple[FreeCAD.Vector, FreeCAD.Vector] | None:
    """Both ends of an edge that is straight, such as a circle seen from the side; else None."""
    step = (edge.LastParameter - edge.FirstParameter) / _SAMPLES
    points = [edge.valueAt(edge.FirstParameter + index * step) for index in range(_SAMPLES + 1)]
    far = max(points, key=lambda point: (point - points[0]).Length)
    way = far - points[0]
    if way.Length < _SHORTEST_MM:
        return None
    way.normalize()
    along = [(point - points[0]).dot(way) for point in points]
    away = (
        (point - points[0] - way * reach).Length for point, reach in zip(points, along, strict=True)
    )
    if max(away) > _STRAIGHT_MM:
        return None
    return points[0] + way * min(along), points[0] + way * max(along)


def _arcs(edge: Part.Edge, origin: tuple[float, float], shape: tuple[float, float, float]) -> str:
    """Arcs through points of a circle's or ellipse's edge."""
    first, last = edge.FirstParameter, edge.LastParameter
    step = (last - first) / _ARC_PIECES
    points = [edge.valueAt(first + index * step) for index in range(_ARC_PIECES + 1)]
    (a, b, c) = points[:3]
    # Turning from x towards y is what SVG calls the positive direction.
    turning = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x)
    flags = f"0 {int(turning > 0.0)}"
    radii = "{:.9g} {:.9g} {:.9g}".format(*shape)
    data = "".join(f"A{radii} {flags} {_at(point, origin)}" for point in points[1:])
    return f"M{_at(points[0], origin)}{data}"


def _beziers(edge: Part.Edge, origin: tuple[float, float]) -> str:
    """Cubic Bézier curves along any other edge."""
    spline = edge.Curve.toBSpline(edge.FirstParameter, edge.LastParameter)
    if spline.isRational() or spline.Degree > 3:
        spline = spline.approximateBSpline(_TOLERANCE_MM, _MOST_SEGMENTS, 3)
    data = ""
    for bezier in spline.toBezier():
        bezier.increase(3)
        poles = bezier.getPoles()
        start = "" if data else f"M{_at(poles[0], origin)}"
        data += start + "C" + " ".join(_at(pole, origin) for pole in poles[1:])
    return data
