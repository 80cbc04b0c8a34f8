"""How a sketched part is put together, as data: ``construction.json``.

Levels, slabs with their outlines, and holes, each with the numbers of the sheet that fix it and the
strokes along which it lies: what a body needs that one can edit.
"""

from dataclasses import asdict, dataclass
from typing import Any

from gaussiancad_core.geometry.outline_edges import OutlineEdge

DIGITS = 6
"""Decimal places of its numbers."""

SCHEMA = "gaussiancad-construction/1"

Point = tuple[float, float]


@dataclass(frozen=True)
class Source:
    """A stroke that something lies along.

    Attributes:
        view: of the stroke.
        start, end: mm in the view, right and up.
    """

    view: str
    start: Point
    end: Point


@dataclass(frozen=True)
class Level:
    """A plane across the axis.

    Attributes:
        at: mm along it.
        numbers: of the sheet, mm, that reach to it.
        strokes: of views from beside that lie in it.
    """

    at: float
    numbers: tuple[float, ...]
    strokes: tuple[Source, ...]


@dataclass(frozen=True)
class Loop:
    """A closed outline.

    Attributes:
        edges: in their order; mm in the plane across the axis, its coordinates in the order x, y,
            z.
        is_hole: whether it lies within the material.
        numbers: of the sheet, mm, that lie along it.
        strokes: of views along the axis that it lies along.
    """

    edges: tuple[OutlineEdge, ...]
    is_hole: bool
    numbers: tuple[float, ...]
    strokes: tuple[Source, ...]


@dataclass(frozen=True)
class SlabLoops:
    """A layer of material.

    Attributes:
        low, high: mm along the axis.
        loops: of its pieces.
    """

    low: float
    high: float
    loops: tuple[Loop, ...]


@dataclass(frozen=True)
class Hole:
    """A round hole along the axis.

    Attributes:
        centre: mm in the plane.
        diameter: mm.
        low, high: mm along the axis.
        is_through: whether nothing is above or below it.
        numbers: of the sheet, mm, that tell its diameter.
    """

    centre: Point
    diameter: float
    low: float
    high: float
    is_through: bool
    numbers: tuple[float, ...]


@dataclass(frozen=True)
class Countersink:
    """A cone of 90 degrees at the rim of a hole.

    Attributes:
        centre: mm in the plane.
        diameter: mm, of its outer circle.
        hole: mm, of the hole.
        at: mm along the axis, of its outer circle.
        is_top: whether it opens towards larger coordinates.
    """

    centre: Point
    diameter: float
    hole: float
    at: float
    is_top: bool


@dataclass(frozen=True)
class SideHole:
    """A round hole along another axis than the slabs'.

    Attributes:
        axis: along it: x, y or z.
        centre: mm in the plane across that, its coordinates in the order x, y, z.
        diameter: mm.
        low, high: mm along it; None of an end at which it is open.
        depth: mm from where it enters the material, as a note says; None where the ends tell it.
        numbers: of the sheet, mm, that tell its diameter.
        stroke: its circle; start and end are the centre.
    """

    axis: str
    centre: Point
    diameter: float
    low: float | None
    high: float | None
    depth: float | None
    numbers: tuple[float, ...]
    stroke: Source


@dataclass(frozen=True)
class Turning:
    """What is turned off a part.

    Attributes:
        centre: mm in the plane across the axis, of what it is turned about.
        edges: around it; their coordinates are mm along the axis, and away from the centre.
    """

    centre: Point
    edges: tuple[OutlineEdge, ...]


@dataclass(frozen=True)
class Break:
    """A chamfer or rounding around a face.

    Attributes:
        at: mm along the axis, of the face.
        width: mm that it takes away from the face.
        height: mm along the axis, negative towards smaller coordinates.
        is_round: whether it is a rounding.
    """

    at: float
    width: float
    height: float
    is_round: bool


@dataclass(frozen=True)
class Construction:
    """The part.

    Attributes:
        axis: across the slabs: x, y or z.
        energy: mm of line, and what counts as much, that it leaves unexplained.
        levels: from the lowest.
        slabs: from the lowest.
        holes: of those.
        countersinks: of holes.
        breaks: of edges, put on last.
        turned: off the solid of the slabs, after these.
        cross_holes: cut out last.
    """

    axis: str
    energy: float
    levels: tuple[Level, ...]
    slabs: tuple[SlabLoops, ...]
    holes: tuple[Hole, ...]
    countersinks: tuple[Countersink, ...] = ()
    breaks: tuple[Break, ...] = ()
    turned: tuple[Turning, ...] = ()
    cross_holes: tuple[SideHole, ...] = ()

    def as_json(self) -> dict[str, Any]:
        """As plain values."""
        values = asdict(self)
        for slab, entry in zip(self.slabs, values["slabs"], strict=True):
            for loop, outline in zip(slab.loops, entry["loops"], strict=True):
                outline["edges"] = [_edge_values(edge) for edge in loop.edges]
        for turning, entry in zip(self.turned, values["turned"], strict=True):
            entry["edges"] = [_edge_values(edge) for edge in turning.edges]
        return {"schema": SCHEMA, **values}


def _edge_values(edge: OutlineEdge) -> dict[str, Any]:
    """An edge's ends and, of an arc, its circle and the place halfway along it."""
    ends = {"start": edge.start, "end": edge.end}
    if edge.circle is None:
        return {**ends, "centre": None, "radius": None, "middle": None}
    middle = [round(value, DIGITS) for value in edge.middle]
    return {**ends, "centre": edge.circle.centre, "radius": edge.circle.radius, "middle": middle}
