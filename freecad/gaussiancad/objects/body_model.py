"""What makes a body: sketches on planes, and features of them, as data.

Lengths are in mm, angles in degrees.  Points of a sketch are (x, y) along the right and the up of
its plane; the length of an extrusion runs along the normal, a negative one against it.
"""

from dataclasses import dataclass
from pathlib import Path

ON_SHEET = "sheet"
"""Source of a number that somebody wrote on the drawing."""

Point = tuple[float, float]
Triple = tuple[float, float, float]


@dataclass(frozen=True)
class Plane:
    """Where a sketch lies.

    Attributes:
        name: of the origin plane whose directions these are, ``XY``, ``XZ`` or ``YZ``; empty of an
            oblique one.
        right, up, normal: unit vectors.
        offset: mm along the normal, from the origin.
    """

    name: str
    right: Triple
    up: Triple
    normal: Triple
    offset: float


@dataclass(frozen=True)
class Curve:
    """A line, an arc or a circle of a sketch.

    Attributes:
        kind: ``line``, ``arc`` or ``circle``.
        start, end: of a line or an arc, mm.
        centre, radius: of an arc or a circle, mm.
        counterclockwise: which way an arc runs from its start to its end.
    """

    kind: str
    start: Point = (0.0, 0.0)
    end: Point = (0.0, 0.0)
    centre: Point = (0.0, 0.0)
    radius: float = 0.0
    counterclockwise: bool = True


@dataclass(frozen=True)
class Condition:
    """A constraint of a sketch.

    Attributes:
        kind: such as ``coincident`` or ``distance-x``.
        of: (number of a curve, ``start``, ``end``, ``centre`` or empty for the whole curve); of the
            curve -1 the start is the origin.
        value: mm; None where the kind has none.
        name: of the number, or empty.
        source: ``sheet`` of a number that the drawing tells, ``measured`` of others.
    """

    kind: str
    of: tuple[tuple[int, str], ...]
    value: float | None = None
    name: str = ""
    source: str = ""


@dataclass(frozen=True)
class Number:
    """A number that a feature has outside of its sketch.

    Attributes:
        name: of the feature's property in FreeCAD, such as ``Length``.
        value: mm.
        source: ``sheet`` of a number that the drawing tells, ``measured`` of others.
    """

    name: str
    value: float
    source: str


@dataclass(frozen=True)
class Support:
    """A face of an earlier feature that a sketch, or the far end of a feature, lies in.

    Attributes:
        feature: its name.
        side: ``start``, ``end``, or ``wall`` of one that an edge of its sketch sweeps.
        dimensions: of a wall, names of the sketch's numbers whose sum tells where it is along the
            normal of what stands there, each with 1 or -1; None where no numbers do.
    """

    feature: str
    side: str
    dimensions: tuple[tuple[str, int], ...] | None = None


@dataclass(frozen=True)
class PlaneSketch:
    """Closed outlines on a plane; without conditions they stay as they are."""

    plane: Plane
    curves: tuple[Curve, ...]
    conditions: tuple[Condition, ...] = ()


@dataclass(frozen=True)
class Extrusion:
    """A pad or a pocket: an outline moved along its plane's normal by a length in mm.

    Attributes:
        stands_on, ends_at: the faces that its sketch and its far end lie in, or None.
    """

    kind: str
    name: str
    sketch: PlaneSketch
    length: float
    numbers: tuple[Number, ...] = ()
    stands_on: Support | None = None
    ends_at: Support | None = None


@dataclass(frozen=True)
class Turning:
    """A revolution or a groove: an outline in a full turn about a line of its plane, through the
    point along the direction."""

    kind: str
    name: str
    sketch: PlaneSketch
    point: Point
    direction: Point
    numbers: tuple[Number, ...] = ()


@dataclass(frozen=True)
class Sink:
    """What widens a hole at its mouth: a counterbore with a depth in mm, or a countersink with an
    angle in degrees; the other one is 0."""

    diameter: float
    depth: float
    degrees: float


@dataclass(frozen=True)
class Holes:
    """Like holes that begin on one plane.

    Attributes:
        kind, name: of the feature.
        sketch: a circle for each hole.
        downward: whether they are drilled against the plane's normal.
        diameter: mm.
        depth: mm from the plane to the end of the cylinder; None through all.
        tip_degrees: of the drill's point; 0 of a flat end.
        sink: at the mouth, or None.
        numbers: of these, those of which it is known where they are from.
        stands_on, ends_at: the faces that their sketch and their far end lie in, or None.
    """

    kind: str
    name: str
    sketch: PlaneSketch
    downward: bool
    diameter: float
    depth: float | None
    tip_degrees: float
    sink: Sink | None
    numbers: tuple[Number, ...] = ()
    stands_on: Support | None = None
    ends_at: Support | None = None


@dataclass(frozen=True)
class EdgeBreak:
    """A fillet of a radius or a chamfer of a width in mm, on the edges at some places."""

    kind: str
    name: str
    size: float
    places: tuple[Triple, ...]
    numbers: tuple[Number, ...] = ()


Feature = Extrusion | Turning | Holes | EdgeBreak


@dataclass(frozen=True)
class SolidFeatures:
    """What makes a solid.

    Attributes:
        features: in the order in which they are made.
        base: STEP file of a solid that the features stand over, or None.
    """

    features: tuple[Feature, ...]
    base: Path | None = None

    @property
    def conditions(self) -> tuple[Condition, ...]:
        """Those of all sketches."""
        sketches = [f.sketch for f in self.features if not isinstance(f, EdgeBreak)]
        return tuple(condition for sketch in sketches for condition in sketch.conditions)
