"""The types of ``reading.json``, px of the sheet as stored (y down), angles in radians from x to y.

Every type is one object of the file, its attributes the object's keys; what is ``None`` or empty
may be left out.
"""

from typing import Annotated, Any, Final, Literal

import msgspec
from msgspec import Meta, Struct

from gaussiancad_core.model.length_units import LEAST_MM, LONGEST_MM
from gaussiancad_core.sheet.labels.ink_classes import Evidence
from gaussiancad_core.writing.callouts import NoteKind
from gaussiancad_protocol.reading_kinds import StrokeKind, ViewRole

SCHEMA: Final = "gaussiancad-reading/1"

LINES = "lines"
"""Kind of a group of lines that belongs to no view and has no name."""

GIVEN: Final = "given"
"""Source of what a person said."""

LARGEST = LONGEST_MM
"""px from the sheet's corner up to which places are taken, and mm of lengths."""

Number = Annotated[float, Meta(ge=-LARGEST, le=LARGEST)]
Size = Annotated[float, Meta(ge=LEAST_MM, le=LARGEST)]
Share = Annotated[float, Meta(ge=0.0, le=1.0)]
Sweep = Annotated[float, Meta(gt=0.0, le=6.2831854)]
Text = Annotated[str, Meta(max_length=1000)]
Sentence = Annotated[str, Meta(max_length=10000)]

Point = tuple[Number, Number]
Box = tuple[Number, Number, Number, Number]
"""x0, y0, x1, y1."""

LineShape = tuple[Point, Point]
CircleShape = tuple[Number, Number, Size]
"""Centre and radius."""
ArcShape = tuple[Number, Number, Size, Number, Sweep]
"""Centre, radius, start and sweep of an arc."""
EllipseShape = tuple[Number, Number, Size, Size, Number, Number, Sweep]
"""Centre, semi-axes (the larger first), rotation, start and sweep of the parameter."""


class ReadSheet(Struct, frozen=True, kw_only=True):
    """The sheet: the SHA-256 of its file, its page, px, and by how many radians it lies turned."""

    sha256: Text
    page: Annotated[int, Meta(ge=1)] = 1
    size: tuple[int, int] | None = None
    turn: Number = 0.0


class ReadProjection(Struct, frozen=True, kw_only=True):
    """First or third angle, how that is known, and what else it may be."""

    value: Literal["first", "third"]
    source: Literal["given", "symbol", "inferred", "default"]
    alternatives: tuple[Literal["first", "third"], ...] = ()


class ReadTangentEdges(Struct, frozen=True, kw_only=True):
    """What the sheet does with tangent edges, and how that is known.

    Attributes:
        policy: whether they are drawn as other edges are, thin, or left out.
        source: ``inferred`` from the views, ``given`` by a person; ``default`` where nothing tells.
        drawn, thin, left_out: places of views at which a tangent edge has a wide line, a thin one,
            or none.
    """

    policy: Literal["drawn", "thin", "left-out", "unknown"] = "unknown"
    source: Literal["inferred", "given", "default"] = "default"
    drawn: Annotated[int, Meta(ge=0)] = 0
    thin: Annotated[int, Meta(ge=0)] = 0
    left_out: Annotated[int, Meta(ge=0)] = 0


class ReadUnit(Struct, frozen=True, kw_only=True):
    """The unit of numbers that do not name theirs."""

    value: Literal["mm", "in"] = "mm"
    source: Text = "default"


class ReadScale(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """mm a px, or the part's extent along an axis; neither where the sheet does not tell.  Both
    where no view shows the axis.

    Attributes:
        points: px of the sheet, between which a person told ``length_mm``.
    """

    source: Literal["given", "sheet", "dimension", "default"]
    mm_per_px: Size | None = None
    axis: Literal["x", "y", "z"] | None = None
    length_mm: Size | None = None
    points: tuple[Point, Point] | None = None


class ViewEntry(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """A view, or another group of lines.

    Attributes:
        id: by which strokes and corrections name it.
        role: what it shows.
        box: around its lines.
        kind: what it is, where that is no plain view: as in the report, or ``lines``.
        source: where its strokes come from, ``raster`` or ``vector``; ``given`` where a
            person said what it is.
        hidden_lines: ``drawn`` if it has some, ``none`` otherwise.
        used: whether it stands for a principal view.
        cut: around its hatching.
        dash: px up to which a hidden stroke may be one dash.
        step: px of the grid to which the file was rounded; 0 of exact files and of pictures.
        hatch: of a section the outlines of what is cut; an odd number of them surrounds it.
        opened: of a half or broken-out section the region that is cut open.
        looks: of a section beside plain views the direction in which it looks.
    """

    id: Text
    role: ViewRole
    box: Box
    kind: Text = ""
    source: Text = ""
    hidden_lines: Literal["drawn", "some", "none"] | None = None
    used: bool = True
    cut: Box | None = None
    dash: Number | None = None
    step: Number = 0.0
    hatch: tuple[tuple[Point, ...], ...] = ()
    opened: tuple[Point, ...] = ()
    looks: ViewRole | None = None


class SectionEntry(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """A section that the sheet names.

    Attributes:
        label: its letters.
        box: around it.
        in_view: role of the view that has its cutting line.
        line: where that runs.
        way: the direction in which its arrows point, of length 1.
        straight: whether the cut is one plane.
        path: corners of the line where it runs in steps; empty where these were not found.
        looks: the role that the arrows tell.
    """

    label: Text
    box: Box
    in_view: ViewRole | None = None
    line: LineShape | None = None
    way: Point | None = None
    straight: bool = True
    path: tuple[Point, ...] = ()
    looks: ViewRole | None = None


class Why(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """Why a stroke is of its kind.

    Attributes:
        by: what decided.
        otherwise: the kind that it would be if that is wrong.
        margin: log-odds of the kind from the stroke's own ink, of a part's edge against annotation
            or the other way round; negative where something else decided.
    """

    by: Evidence
    otherwise: StrokeKind | None = None
    margin: Number | None = None


class StrokeEntry(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """A stroke: one of ``line``, ``arc`` and ``ellipse``, or only a box.

    Attributes:
        id: by which corrections name it.
        view: the id of its view; None where it belongs to none.
        kind: what it stands for.
        line, arc, ellipse: where it runs.
        box: around what has no shape.
        confidence: how sure the kind is.
        source: ``given`` where a person drew it or said its kind.
        why: what tells the kind; nothing where a person does.
    """

    id: Text
    view: Text | None
    kind: StrokeKind
    line: LineShape | None = None
    arc: ArcShape | None = None
    ellipse: EllipseShape | None = None
    box: Box | None = None
    confidence: Share = 1.0
    source: Text = ""
    why: Why | None = None


class Measured(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """What a number measures: the span between two points, or a circle (centre and radius)."""

    span: tuple[Point, Point] | None = None
    circle: CircleShape | None = None


class DimensionEntry(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """A dimension.

    Attributes:
        id: by which corrections name it.
        text: as it was read.
        value_mm: that it gives.
        box: around the text.
        type: what kind of length it is.
        mm_per_px: that follows from it.
        used: whether the scale is taken from it.
        measures: what it was found to measure.
        told_mm: length of the span, or radius of the circle, that it gives.
        digit_mm: the last one that is told of that.
    """

    id: Text
    text: Text
    value_mm: Size
    box: Box
    type: Literal["linear", "diameter", "radius"] = "linear"
    mm_per_px: Size | None = None
    used: bool = False
    measures: Measured | None = None
    told_mm: Size | None = None
    digit_mm: Size | None = None


class NoteEntry(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """A text that says more of the part than a length.

    Attributes:
        text: as it was read.
        kind: what it speaks of.
        box: around it.
        value_mm: a length that it gives; degrees of an angle.
        count: of how many places it speaks.
        depth_mm: how deep what it names is.
        through: whether it says that it goes through.
        reference: whether the number is for reference only.
        circle: of the hole that it speaks of, where a person said so.
        points_at: circles that its leader, or its row's label in a hole table, points at.
    """

    text: Text
    kind: NoteKind
    box: Box
    value_mm: Number | None = None
    count: int = 1
    depth_mm: Number | None = None
    through: bool = False
    reference: bool = False
    circle: CircleShape | None = None
    points_at: tuple[CircleShape, ...] = ()


class Problem(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """What is in doubt, or missing, and what a person can do about it.

    Attributes:
        code: as in the report.
        message: a sentence.
        severity: ``refused`` where no part follows, ``doubt`` where it takes the word from one.
        at: boxes on the sheet.
        offers: corrections that may help, by their ``op``.
        args: the values in the message, by name.
    """

    code: Text
    message: Sentence
    severity: Literal["refused", "doubt", "warning"]
    at: tuple[Box, ...] = ()
    offers: tuple[Text, ...] = ()
    args: dict[Text, int | float | Sentence] = {}


class SheetReading(Struct, frozen=True, kw_only=True):
    """All of ``reading.json``; ``corrected`` is the number of a person's corrections in it."""

    schema: Literal["gaussiancad-reading/1"]
    sheet: ReadSheet
    projection: ReadProjection
    unit: ReadUnit
    scale: ReadScale
    views: tuple[ViewEntry, ...] = ()
    strokes: tuple[StrokeEntry, ...] = ()
    dimensions: tuple[DimensionEntry, ...] = ()
    notes: tuple[NoteEntry, ...] = ()
    sections: tuple[SectionEntry, ...] = ()
    problems: tuple[Problem, ...] = ()
    tangent_edges: ReadTangentEdges = ReadTangentEdges()
    corrected: Annotated[int, Meta(ge=0)] = 0
    engine: Text = ""

    def values(self) -> dict[str, Any]:
        """As JSON values."""
        return msgspec.to_builtins(self)
