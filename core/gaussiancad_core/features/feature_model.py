"""Features of a part, in the order in which they are made."""

from dataclasses import dataclass

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.frames import Frame, Vector
from gaussiancad_core.features.loops import Loop


@dataclass(frozen=True)
class Sketch:
    """Closed outlines in a plane.

    Attributes:
        frame: directions of the plane.
        height: mm from the origin along the frame's normal.
        loops: the outer one first, counter-clockwise; those of holes clockwise.
    """

    frame: Frame
    height: float
    loops: tuple[Loop, ...]


@dataclass(frozen=True)
class Extrusion:
    """A sketch moved along its normal: a pad, or a pocket.

    Attributes:
        sketch: what is moved.
        length: mm along the normal; negative the other way.
        adds: whether it is material (a pad), or taken away (a pocket).
    """

    sketch: Sketch
    length: float
    adds: bool


@dataclass(frozen=True)
class Turning:
    """A sketch turned once around an axis in its plane: a revolution, or a groove.

    Attributes:
        sketch: what is turned, on one side of the axis.
        point, direction: of the axis; mm, in the sketch's coordinates.
        adds: whether it is material, or taken away.
    """

    sketch: Sketch
    point: tuple[float, float]
    direction: tuple[float, float]
    adds: bool


@dataclass(frozen=True)
class Sink:
    """What widens a hole where it enters.

    Attributes:
        diameter: mm, at the face.
        depth: mm, of a counterbore; 0 of a countersink.
        angle: degrees between the sides of a countersink; 0 of a counterbore.
    """

    diameter: float
    depth: float
    angle: float


@dataclass(frozen=True)
class Holes:
    """Like round holes that enter the same plane.

    Attributes:
        frame: directions of the plane that they enter.
        height: mm of that plane along the frame's normal.
        centres: mm in the plane.
        is_downward: whether they go against the normal.
        diameter: mm.
        depth: mm from the plane to the end of the cylinder; None of a hole that goes through.
        tip: degrees between the sides of the cone at its end; 0 of a flat end.
        sink: at its mouth; None of a plain one.
    """

    frame: Frame
    height: float
    centres: tuple[tuple[float, float], ...]
    is_downward: bool
    diameter: float
    depth: float | None
    tip: float = 0.0
    sink: Sink | None = None


@dataclass(frozen=True)
class EdgeBreak:
    """Like fillets or chamfers along edges.

    Attributes:
        places: mm, a point on each edge of what was made before.
        size: mm, the radius of fillets, the legs of chamfers.
        is_round: whether they are fillets.
    """

    places: tuple[Vector, ...]
    size: float
    is_round: bool


Feature = Extrusion | Turning | Holes | EdgeBreak


@dataclass(frozen=True, eq=False)
class FeatureList:
    """A solid by its features.

    Attributes:
        features: in the order in which they are made.
        base: what they stand over where they do not make up the solid alone; mm.
    """

    features: tuple[Feature, ...]
    base: TopoDS_Shape | None = None

    @property
    def is_whole(self) -> bool:
        """Whether the features make up the solid."""
        return self.base is None
