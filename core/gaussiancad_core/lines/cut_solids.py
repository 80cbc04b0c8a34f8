"""Views of a part that was cut: full sections, half sections, broken-out sections (ISO 128-3).

What stands between the viewer and a plane, mostly the middle one, is cut away, everywhere or in
a region of the view.  Where the plane meets material, the drawing is hatched.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common, BRepAlgoAPI_Cut
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
from OCP.gp import gp_Pnt, gp_Vec
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape

from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.kernel.brep import bounding_box, tessellate
from gaussiancad_core.lines.hlr import LineDrawing, LineOptions
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import CutRegion, SectionKind, SectionRole
from gaussiancad_core.model.views import Linetype, Segment

Plane = npt.NDArray[np.float64]
"""(n, 2) mm in the plane of a view: right, up."""

_CHORD = 1e-3
"""Largest distance between a hatched area and its polygon, as a share of the longest extent."""

_WAVES, _DEPTH = 3, 0.04
"""Waves of a break line along each side of a broken-out region, and their depth as a share."""


@dataclass(frozen=True, eq=False)
class SectionView:
    """A view of a part that was cut.

    Attributes:
        strokes: the visible lines in mm of the view's plane.
        areas: cut material in the same plane.
    """

    strokes: tuple[DrawnStroke, ...]
    areas: shapely.Geometry

    def hatching(self, pitch: float, degrees: float = 45.0) -> tuple[Segment, ...]:
        """Parallel lines across the cut material.

        Args:
            pitch: mm from line to line.
            degrees: from the view's right towards its up.
        """
        if self.areas.is_empty:
            return ()
        way = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
        normal = np.array([-way[1], way[0]])
        x0, y0, x1, y1 = self.areas.bounds
        corners = np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])
        along, across = corners @ way, corners @ normal
        lines = [
            shapely.LineString([way * along.min() + normal * at, way * along.max() + normal * at])
            for at in np.arange(across.min() + pitch / 2, across.max(), pitch)
        ]
        pieces = [shapely.intersection(line, self.areas) for line in lines]
        flat = [part for piece in pieces for part in shapely.get_parts(piece)]
        return tuple(
            Segment(part.coords[0], part.coords[-1], Linetype.VISIBLE)
            for part in flat
            if part.geom_type == "LineString" and part.length > 0.0
        )


def section_view(
    shape: TopoDS_Shape,
    role: Role | SectionRole,
    openings: Sequence[CutRegion],
    options: LineOptions | None = None,
) -> SectionView:
    """Cut a part by planes, and draw what is left.

    Between neighbouring openings, and beside one, nothing is drawn but what is an edge of the part
    (ISO 128-3).

    Args:
        shape: solid in mm; its position is kept.
        role: the view that is cut; the planes are across its direction.
        openings: where, and how deep.
        options: which lines, how exactly.
    """
    low, high = bounding_box(shape)
    frame = role.frame
    axes = tuple(np.array(v, dtype=float) for v in (frame.right, frame.up, frame.look))
    corners = np.array([low, high])
    spans = np.array([np.sort(corners @ way) for way in axes])
    extent = float((high - low).max())
    around = shapely.box(*(spans[:2, 0] - extent), *(spans[:2, 1] + extent))
    left, areas, borders = shape, [], []
    for opening in openings:
        region = around if opening.region is None else opening.region.intersection(around)
        outline = np.array(region.exterior.coords)[:-1]
        plane = opening.at * frame.look_axis[1]
        flat = _face(outline, axes, plane)
        depth = plane - spans[2, 0] + extent
        removed = BRepPrimAPI_MakePrism(flat, gp_Vec(*(-depth * axes[2]).tolist())).Shape()
        left = BRepAlgoAPI_Cut(left, removed).Shape()
        areas.append(_areas(BRepAlgoAPI_Common(shape, flat).Shape(), axes[:2], extent))
        if opening.region is not None:
            borders += _borders(outline, spans)
    plain = role.role if isinstance(role, SectionRole) else role
    strokes = [s for s in LineDrawing(left, options).view(plain) if s.linetype is Linetype.VISIBLE]
    if borders:
        whole = LineDrawing(shape, options).view(plain)
        edges = [s for s in whole if s.linetype is Linetype.VISIBLE and _lies_on(s, borders)]
        strokes = [stroke for stroke in strokes if not _lies_on(stroke, borders)] + edges
    return SectionView(tuple(strokes), shapely.union_all(areas))


def openings_of(shape: TopoDS_Shape, role: Role, kind: SectionKind) -> tuple[CutRegion, ...]:
    """Where a view is cut open for a kind of section, by the plane through the part's middle."""
    low, high = bounding_box(shape)
    frame = role.frame
    corners = np.array([low, high])
    right, up = (np.sort(corners @ np.array(way, dtype=float)) for way in (frame.right, frame.up))
    axis = frame.look_axis[0].value
    middle = float(low[axis] + high[axis]) / 2.0
    if kind is SectionKind.FULL:
        return (CutRegion(middle),)
    return (CutRegion(middle, shapely.Polygon(_region(right, up, kind))),)


def _region(
    right: npt.NDArray[np.float64], up: npt.NDArray[np.float64], kind: SectionKind
) -> Plane:
    """The corners of the region of a view that is cut open."""
    (x0, x1), (y0, y1) = right, up
    width, height = x1 - x0, y1 - y0
    if kind is SectionKind.BROKEN_OUT:
        return _wavy(x0 + 0.6 * width, x1 + 0.1 * width, y0 - 0.1 * height, y0 + 0.45 * height)
    start, end = 0.5 * (x0 + x1), x1 + 0.1 * width
    bottom, top = y0 - 0.1 * height, y1 + 0.1 * height
    return np.array([[start, bottom], [end, bottom], [end, top], [start, top]])


def _wavy(x0: float, x1: float, y0: float, y1: float) -> Plane:
    """A rectangle whose left and upper sides are waves."""
    shares = np.linspace(0.0, 1.0, 24 * _WAVES + 1)
    swing = _DEPTH * np.sin(2.0 * np.pi * _WAVES * shares)
    side = np.stack([x0 + (x1 - x0) * swing, y0 + (y1 - y0) * shares], axis=1)
    head = np.stack([x0 + (x1 - x0) * shares, y1 + (y1 - y0) * swing], axis=1)
    return np.concatenate([side, head[1:], [[x1, y0]]])


def _face(region: Plane, axes: tuple[npt.NDArray[np.float64], ...], depth: float) -> TopoDS_Face:
    """A region of a view as a face at a depth along its direction."""
    right, up, look = axes
    polygon = BRepBuilderAPI_MakePolygon()
    for x, y in region:
        polygon.Add(gp_Pnt(*(x * right + y * up + depth * look).tolist()))
    polygon.Close()
    return BRepBuilderAPI_MakeFace(polygon.Wire()).Face()


def _areas(
    faces: TopoDS_Shape, axes: tuple[npt.NDArray[np.float64], ...], extent: float
) -> shapely.Geometry:
    vertices, triangles = tessellate(faces, _CHORD * extent)
    if not len(triangles):
        return shapely.Polygon()
    plane = np.stack([vertices @ axis for axis in axes], axis=1)
    return shapely.union_all(shapely.polygons(plane[triangles]))


def _borders(outline: Plane, spans: npt.NDArray[np.float64]) -> list[tuple[int, float]]:
    """Sides of a region that are parallel to an axis and run through the view: which coordinate
    they have in common, and its value."""
    found = []
    for one, other in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        for index in (0, 1):
            if one[index] == other[index] and spans[index, 0] < one[index] < spans[index, 1]:
                found.append((index, float(one[index])))
    return found


def _lies_on(stroke: DrawnStroke, borders: Sequence[tuple[int, float]]) -> bool:
    if not isinstance(stroke, Segment):
        return False
    ends = stroke.start, stroke.end
    return any(
        max(abs(end[index] - at) for end in ends) < COMPUTED * max(1.0, abs(at))
        for index, at in borders
    )
