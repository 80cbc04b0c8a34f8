"""Solids of profiles: turned around an axis, or swept along one.

The outline of what is material in a plane is swept line by line and arc by arc.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeEdge,
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakeWire,
)
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism, BRepPrimAPI_MakeRevol
from OCP.GC import GC_MakeArcOfCircle
from OCP.gp import gp_Ax1, gp_Ax2, gp_Circ, gp_Dir, gp_Pnt, gp_Vec
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Shape, TopoDS_Wire

from gaussiancad_core.coordinates.stroke_finder import LINKS
from gaussiancad_core.geometry.outline_edges import OutlineEdge
from gaussiancad_core.geometry.points import to_point
from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.geometry.whole_curves import line_through, meetings
from gaussiancad_core.kernel.booleans import unified
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.model.views import Arc

_FLAT = 1e-5
"""Height of an arc over its chord, as a share of its radius, up to which that stands for it."""

_CLEARLY = 0.1
"""Sine of the angle from which two curves cross each other clearly."""

Point = tuple[float, float]
Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Profile:
    """Material in a plane.

    Attributes:
        area: a polygon; its corners lie on the strokes.
        arcs: strokes that are round.
        near: distance within which a corner lies on a stroke.
    """

    area: shapely.Polygon
    arcs: tuple[Arc, ...]
    near: float


def turned(profile: Profile, axis: Axis, centre: Point = (0.0, 0.0)) -> TopoDS_Shape:
    """A profile turned once around an axis; its first coordinate runs along it, its second is the
    distance from it.

    Args:
        profile: whose distances are not negative.
        axis: of the model.
        centre: where it is, in the coordinates of the model's two other axes, in their order.
    """
    first, second = IN_PLANE[axis]

    def place(point: Point) -> gp_Pnt:
        at = [0.0, 0.0, 0.0]
        at[axis.value] = point[0]
        at[first], at[second] = centre[0] + point[1], centre[1]
        return gp_Pnt(*at)

    way = [0.0, 0.0, 0.0]
    way[axis.value] = 1.0
    face = _face(profile, place)
    return unified(BRepPrimAPI_MakeRevol(face, gp_Ax1(place((0.0, 0.0)), gp_Dir(*way))).Shape())


def prism(profile: Profile, axis: Axis, between: tuple[float, float]) -> TopoDS_Shape:
    """A profile across an axis as a prism along it.

    Args:
        profile: in the coordinates of the model's two other axes, in their order.
        axis: of the model.
        between: where the prism begins and ends along it.
    """
    low, high = between
    first, second = IN_PLANE[axis]

    def place(point: Point) -> gp_Pnt:
        at = [low, low, low]
        at[first], at[second] = point
        return gp_Pnt(*at)

    way = [0.0, 0.0, 0.0]
    way[axis.value] = high - low
    return BRepPrimAPI_MakePrism(_face(profile, place), gp_Vec(*way)).Shape()


def _face(profile: Profile, place: Callable[[Point], gp_Pnt]) -> TopoDS_Face:
    rings = [profile.area.exterior, *profile.area.interiors]
    outer, *holes = (_wire(np.array(ring.coords)[:-1], profile, place) for ring in rings)
    made = BRepBuilderAPI_MakeFace(outer, True)
    for hole in holes:
        made.Add(hole)
    return made.Face()


def _wire(ring: Floats, profile: Profile, place: Callable[[Point], gp_Pnt]) -> TopoDS_Wire:
    """The edges of a ring of corners: arcs where they lie on one, else lines."""
    made = BRepBuilderAPI_MakeWire()
    runs = _runs_of(ring, profile)
    if (circle := _whole(runs)) is not None:
        made.Add(BRepBuilderAPI_MakeEdge(_circle(circle, ring, place)).Edge())
        return made.Wire()
    for edge, between in _edges(runs):
        made.Add(edge_shape(edge, between, place))
    return made.Wire()


def edge_shape(edge: OutlineEdge, between: Point, place: Callable[[Point], gp_Pnt]) -> TopoDS_Edge:
    """An edge that is no whole circle, in space.

    Args:
        edge: of a plane.
        between: where an arc runs between its ends, which may lie a little beside its circle.
        place: where a point of the plane lies.
    """
    start, end = place(edge.start), place(edge.end)
    if edge.circle is None:
        return BRepBuilderAPI_MakeEdge(start, end).Edge()
    curve = GC_MakeArcOfCircle(start, place(between), end).Value()
    return BRepBuilderAPI_MakeEdge(curve).Edge()


def edges_of(ring: Floats, profile: Profile) -> list[OutlineEdge]:
    """The edges that a ring of corners has in the solid, in order.

    Args:
        ring: (n, 2) corners of the profile's area, the first not repeated.
        profile: with the arcs.
    """
    return [edge for edge, _ in _edges(_runs_of(ring, profile))]


def _edges(runs: Sequence[tuple[Floats, Arc | None]]) -> list[tuple[OutlineEdge, Point]]:
    """Edges along runs of corners, each with a place between its ends."""
    found = []
    for run, arc in runs:
        # A short stretch may have none left between the curves beside it.
        if np.hypot(*(run[-1] - run[0])) < COMPUTED:
            continue
        start, end = to_point(run[0]), to_point(run[-1])
        if arc is None or (middle := _middle(run, arc)) is None:
            edge = OutlineEdge(start, end)
            found.append((edge, edge.middle))
        else:
            (ax, ay), (bx, by) = middle - run[0], run[-1] - run[0]
            edge = OutlineEdge(start, end, arc.carrier, bool(ax * by > ay * bx))
            found.append((edge, to_point(middle)))
    return found


def _whole(runs: Sequence[tuple[Floats, Arc | None]]) -> Arc | None:
    """The circle that all runs of a ring lie on; None where there is none."""
    arc = runs[0][1]
    return arc if arc is not None and all(other is arc for _, other in runs) else None


def _circle(arc: Arc, ring: Floats, place: Callable[[Point], gp_Pnt]) -> gp_Circ:
    """A whole circle that runs as its ring does: round holes the other way than outlines."""
    centre = place(arc.centre)
    is_ccw = shapely.LinearRing(ring).is_ccw
    right, up = (
        gp_Vec(centre, place((arc.centre[0] + x, arc.centre[1] + y)))
        for x, y in ((1.0, 0.0), (0.0, 1.0))
    )
    normal = right.Crossed(up) if is_ccw else up.Crossed(right)
    return gp_Circ(gp_Ax2(centre, gp_Dir(normal), gp_Dir(right)), arc.radius)


def _middle(run: Floats, arc: Arc) -> Floats | None:
    """(2,) a place of an arc between the ends of a run along it; None where that is straight."""
    off = (run[len(run) // 2] if len(run) > 2 else run.mean(axis=0)) - arc.centre
    away = float(np.hypot(*off))
    if away == 0.0 or (len(run) == 2 and abs(arc.radius - away) <= _FLAT * arc.radius):
        return None
    return np.array(arc.centre) + off * (arc.radius / away)


def _runs_of(ring: Floats, profile: Profile) -> list[tuple[Floats, Arc | None]]:
    """Stretches of a ring's corners that are one line or lie on one arc, with that.

    Args:
        ring: (n, 2) corners of the profile's area, the first not repeated.
        profile: with the arcs.
    """
    following = np.roll(ring, -1, axis=0)
    kinds = [_arc_of(one, other, profile) for one, other in zip(ring, following, strict=True)]
    ways = following - ring
    ways = ways / np.hypot(*ways.T)[:, None]
    count = len(ring)

    def begins(index: int) -> bool:
        before = index - 1
        if kinds[index] != kinds[before]:
            return True
        turn = ways[before][0] * ways[index][1] - ways[before][1] * ways[index][0]
        return kinds[index] is None and abs(turn) > COMPUTED

    starts = [index for index in range(count) if begins(index)] or [0]
    if len(starts) == 1:
        # What closes in itself has two pieces.
        starts.append(starts[0] + count // 2)
    found = []
    for start, end in zip(starts, [*starts[1:], starts[0] + count], strict=True):
        values = ring[np.arange(start, end + 1) % count]
        kind = kinds[start % count]
        found.append((values, None if kind is None else profile.arcs[kind]))
    for index, (row, arc) in enumerate(found):
        before, other = found[index - 1]
        if arc is not other:
            before[-1] = row[0] = _corner((before[-2:], other), (row[:2], arc), profile.near)
    return found


def _corner(
    one: tuple[Floats, Arc | None], other: tuple[Floats, Arc | None], near: float
) -> Floats:
    """(2,) where two stretches meet: on both their curves, where these cross each other clearly.

    Args:
        one: (2, 2) its last corners, and its arc.
        other: (2, 2) its first corners, and its arc.
        near: distance of that from the corner at most.
    """
    corner = other[0][0]
    ways = [_way(points, arc, corner) for points, arc in (one, other)]
    if abs(ways[0][0] * ways[1][1] - ways[0][1] * ways[1][0]) < _CLEARLY:
        return corner
    curves = [
        line_through(to_point(points[0]), to_point(points[1])) if arc is None else arc.carrier
        for points, arc in (one, other)
    ]
    places = np.array(meetings(*curves)).reshape(-1, 2)
    away = np.hypot(*(places - corner).T)
    return places[away.argmin()] if len(places) and away.min() <= near else corner


def _way(points: Floats, arc: Arc | None, at: Floats) -> Floats:
    """(2,) the way along a stretch at one of its ends, of length 1."""
    way = points[1] - points[0] if arc is None else (at - arc.centre)[::-1] * (-1.0, 1.0)
    return way / max(float(np.hypot(*way)), 1e-12)


def _arc_of(one: Floats, other: Floats, profile: Profile) -> int | None:
    """Number of the arc that both ends of a chord lie on, next to each other: of several that touch
    each other there, the one that they lie on best."""
    chord = float(np.hypot(*(other - one)))
    offsets = [
        float(np.abs(np.hypot(*(np.array([one, other]) - arc.centre).T) - arc.radius).max())
        for arc in profile.arcs
    ]
    found = [
        number
        for number, (arc, off) in enumerate(zip(profile.arcs, offsets, strict=True))
        if off <= profile.near and chord < 4.0 * np.pi * arc.radius / LINKS
    ]
    return min(found, key=offsets.__getitem__, default=None)
