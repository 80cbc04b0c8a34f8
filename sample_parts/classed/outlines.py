"""Outlines with rounded corners, and the solids and tools that are made of them.

An outline is a closed polygon of corners (x, y, radius); an arc of the radius, tangent to both
sides, replaces a corner.  Its plane's coordinates are those of
:mod:`sample_parts.modelling`; all lengths are millimetres.
"""

from collections.abc import Callable, Iterable, Sequence

import numpy as np
import numpy.typing as npt
from OCP.BRepAlgoAPI import BRepAlgoAPI_BooleanOperation
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeEdge,
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakePolygon,
    BRepBuilderAPI_MakeSolid,
    BRepBuilderAPI_MakeWire,
    BRepBuilderAPI_Sewing,
)
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism, BRepPrimAPI_MakeRevol
from OCP.collections import List_TopoDS_Shape
from OCP.GC import GC_MakeArcOfCircle
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Vec
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.kernel.brep import subshapes, volume
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import Point2, Point3

Floats = npt.NDArray[np.float64]
Corner = tuple[float, float, float]
Outline = Sequence[Corner]

_TURN_STEP = np.radians(6.0)
"""Angle between points along an arc of a sampled outline."""

_SAME = 1e-9
"""Points closer than this are one."""


def sharp(points: Iterable[Point2]) -> list[Corner]:
    """The outline of a polygon."""
    return [(float(x), float(y), 0.0) for x, y in points]


def rectangle(low: Point2, high: Point2, radius: float = 0.0) -> list[Corner]:
    """A rectangle; with half its width as radius it is a slot with round ends."""
    (x0, y0), (x1, y1) = low, high
    return [(x0, y0, radius), (x1, y0, radius), (x1, y1, radius), (x0, y1, radius)]


def regular(centre: Point2, radius: float, count: int, first: float = 0.0) -> list[Corner]:
    """A regular polygon with its corners on a circle, the first at an angle in radians."""
    angles = first + 2.0 * np.pi * np.arange(count) / count
    return sharp(
        (centre[0] + radius * float(np.cos(a)), centre[1] + radius * float(np.sin(a)))
        for a in angles
    )


def extruded(axis: Axis, outline: Outline, start: float, end: float) -> TopoDS_Shape:
    """An outline across an axis, extruded from ``start`` to ``end``."""
    face = _face(outline, lambda x, y: _across(axis, (x, y), start))
    way = np.zeros(3)
    way[axis.value] = end - start
    return BRepPrimAPI_MakePrism(face, gp_Vec(*way.tolist())).Shape()


def turned(axis: Axis, centre: Point2, profile: Outline) -> TopoDS_Shape:
    """A closed profile of corners (along, radius from the axis, rounding) turned once around."""
    face = _face(
        profile, lambda along, radius: _across(axis, (centre[0] + radius, centre[1]), along)
    )
    way = np.zeros(3)
    way[axis.value] = 1.0
    line = gp_Ax1(_across(axis, centre, 0.0), gp_Dir(*way.tolist()))
    return BRepPrimAPI_MakeRevol(face, line).Shape()


def convex(points: Sequence[Point3]) -> TopoDS_Shape:
    """The convex hull of four or more points as a solid with one face for each of its planes."""
    from scipy.spatial import ConvexHull

    hull = ConvexHull(np.array(points, dtype=np.float64))
    corners = hull.points[hull.vertices]
    planes: list[Floats] = []
    for plane in hull.equations:
        if not any(np.allclose(plane, known, atol=1e-9) for known in planes):
            planes.append(plane)
    sewing = BRepBuilderAPI_Sewing(1e-6)
    for plane in planes:
        on = corners[np.abs(corners @ plane[:3] + plane[3]) < 1e-7 * np.ptp(corners)]
        sewing.Add(_polygon(_around(on, plane[:3])))
    sewing.Perform()
    shells = subshapes(sewing.SewedShape(), TopAbs_ShapeEnum.TopAbs_SHELL)
    solid = BRepBuilderAPI_MakeSolid(TopoDS.Shell(shells[0])).Solid()
    return solid if volume(solid) > 0.0 else solid.Reversed()


def frustum(
    axis: Axis, lower: Sequence[Point2], upper: Sequence[Point2], ends: Point2
) -> TopoDS_Shape:
    """The hull of two convex polygons across an axis, at its two ``ends``."""
    placed = []
    for polygon, end in ((lower, ends[0]), (upper, ends[1])):
        for x, y in polygon:
            coordinates = [x, y]
            coordinates.insert(axis.value, end)
            placed.append((coordinates[0], coordinates[1], coordinates[2]))
    return convex(placed)


def combined(
    operation: type[BRepAlgoAPI_BooleanOperation],
    shape: TopoDS_Shape,
    tools: Sequence[TopoDS_Shape],
) -> TopoDS_Shape:
    """A Boolean with all tools at once: many times faster than one after the other."""
    lists = List_TopoDS_Shape(), List_TopoDS_Shape()
    lists[0].Append(shape)
    for tool in tools:
        lists[1].Append(tool)
    work = operation()
    work.SetArguments(lists[0])
    work.SetTools(lists[1])
    work.Build()
    return work.Shape()


def sampled(outline: Outline) -> Floats:
    """(n, 2) corners and points along the arcs of an outline."""
    points: list[Floats] = []
    for entry, arc, leave in _rounded(outline):
        if arc is None:
            points.append(entry[None])
            continue
        centre, radius = arc
        first = float(np.arctan2(*(entry - centre)[::-1]))
        sweep = float(np.arctan2(*(leave - centre)[::-1])) - first
        sweep = (sweep + np.pi) % (2.0 * np.pi) - np.pi
        angles = first + np.linspace(0.0, sweep, 2 + int(abs(sweep) / _TURN_STEP))
        points.append(centre + radius * np.stack([np.cos(angles), np.sin(angles)], 1))
    return np.concatenate(points)


def _rounded(outline: Outline) -> list[tuple[Floats, tuple[Floats, float] | None, Floats]]:
    """For each corner: where its arc begins, the arc's centre and radius, where it ends."""
    corners = np.array([corner[:2] for corner in outline], dtype=np.float64)
    found: list[tuple[Floats, tuple[Floats, float] | None, Floats]] = []
    for index, (corner, (*_, radius)) in enumerate(zip(corners, outline, strict=True)):
        if radius <= 0.0:
            found.append((corner, None, corner))
            continue
        ways = [corners[index - 1] - corner, corners[(index + 1) % len(corners)] - corner]
        before, after = (way / np.hypot(*way) for way in ways)
        half = 0.5 * np.arccos(np.clip(before @ after, -1.0, 1.0))
        middle = (before + after) / np.hypot(*(before + after))
        reach = radius / np.tan(half)
        centre = corner + radius / np.sin(half) * middle
        found.append((corner + reach * before, (centre, float(radius)), corner + reach * after))
    return found


def _face(outline: Outline, place: Callable[[float, float], gp_Pnt]) -> TopoDS_Face:
    wire = BRepBuilderAPI_MakeWire()
    rounded = _rounded(outline)
    for index, (entry, arc, leave) in enumerate(rounded):
        if arc is not None:
            centre, radius = arc
            outward = np.array(outline[index][:2]) - centre
            middle = centre + radius * outward / np.hypot(*outward)
            points = [place(*point.tolist()) for point in (entry, middle, leave)]
            wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(*points).Value()).Edge())
        following = rounded[(index + 1) % len(rounded)][0]
        if np.hypot(*(following - leave)) > _SAME:
            ends = [place(*point.tolist()) for point in (leave, following)]
            wire.Add(BRepBuilderAPI_MakeEdge(*ends).Edge())
    return BRepBuilderAPI_MakeFace(wire.Wire(), True).Face()


def _across(axis: Axis, flat: Point2, along: float) -> gp_Pnt:
    coordinates = [float(flat[0]), float(flat[1])]
    coordinates.insert(axis.value, float(along))
    return gp_Pnt(*coordinates)


def _around(points: Floats, normal: Floats) -> Floats:
    """Points of a convex face in their order around it, seen against the normal."""
    first = points[0] - points.mean(axis=0)
    first /= np.linalg.norm(first)
    second = np.cross(normal, first)
    away = points - points.mean(axis=0)
    return points[np.argsort(np.arctan2(away @ second, away @ first))]


def _polygon(points: Floats) -> TopoDS_Face:
    polygon = BRepBuilderAPI_MakePolygon()
    for point in points.tolist():
        polygon.Add(gp_Pnt(*point))
    polygon.Close()
    return BRepBuilderAPI_MakeFace(polygon.Wire(), True).Face()
