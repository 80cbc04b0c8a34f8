"""The types of ``corrections.json``: what a person says of a reading, one operation after another.

Places are px of the sheet as stored.  A target is an id and where that stroke ran, so that it is
found again in a new reading of the same sheet.
"""

from typing import Annotated, Literal

from msgspec import Meta, Struct

from gaussiancad_core.readings.reading_schema import (
    ArcShape,
    Box,
    CircleShape,
    EllipseShape,
    LineShape,
    Measured,
    Point,
    Size,
    Text,
)
from gaussiancad_protocol.reading_kinds import StrokeKind, ViewRole

CORRECTIONS_SCHEMA = "gaussiancad-corrections/1"


class Target(Struct, frozen=True, kw_only=True, omit_defaults=True):
    """A stroke: its id, and its shape when it was pointed at."""

    id: Text
    line: LineShape | None = None
    arc: ArcShape | None = None
    ellipse: EllipseShape | None = None


class ViewOperation(Struct, frozen=True, kw_only=True, tag_field="op", tag="view"):
    """A view has this role, and all lines in the box are its; with a new id it is a new one."""

    id: Text
    role: ViewRole
    box: Box | None = None


class KindOperation(Struct, frozen=True, kw_only=True, tag_field="op", tag="kind"):
    """A stroke stands for something else."""

    target: Target
    to: StrokeKind


class EraseOperation(Struct, frozen=True, kw_only=True, tag_field="op", tag="erase"):
    """There is no such stroke."""

    target: Target


class DrawOperation(
    Struct, frozen=True, kw_only=True, omit_defaults=True, tag_field="op", tag="draw"
):
    """There is a stroke: one of line, arc and ellipse."""

    view: Text
    kind: StrokeKind
    line: LineShape | None = None
    arc: ArcShape | None = None
    ellipse: EllipseShape | None = None


class DimensionOperation(
    Struct, frozen=True, kw_only=True, omit_defaults=True, tag_field="op", tag="dimension"
):
    """A dimension gives another length, or measures something else."""

    id: Text
    value_mm: Size
    measures: Measured | None = None


class ScaleOperation(
    Struct, frozen=True, kw_only=True, omit_defaults=True, tag_field="op", tag="scale"
):
    """The scale: mm a px, the length between two points, or the part's extent along an axis."""

    mm_per_px: Size | None = None
    points: tuple[Point, Point] | None = None
    axis: Literal["x", "y", "z"] | None = None
    length_mm: Size | None = None


class UnitOperation(Struct, frozen=True, kw_only=True, tag_field="op", tag="unit"):
    """The unit of numbers that do not name theirs."""

    value: Literal["mm", "in"]


class ProjectionOperation(Struct, frozen=True, kw_only=True, tag_field="op", tag="projection"):
    """First or third angle."""

    value: Literal["first", "third"]


class TangentEdgesOperation(Struct, frozen=True, kw_only=True, tag_field="op", tag="tangent_edges"):
    """Lines where faces meet smoothly are drawn as other edges are, thin, or left out."""

    value: Literal["drawn", "thin", "left-out"]


class RegionOperation(Struct, frozen=True, kw_only=True, tag_field="op", tag="region"):
    """All strokes within a polygon stand for this."""

    polygon: Annotated[tuple[Point, ...], Meta(min_length=3, max_length=1000)]
    kind: StrokeKind


class TraceOperation(Struct, frozen=True, kw_only=True, tag_field="op", tag="trace"):
    """There is the stroke whose ink lies at a place, and it stands for this."""

    view: Text
    at: Point
    kind: StrokeKind


class SectionOperation(
    Struct, frozen=True, kw_only=True, omit_defaults=True, tag_field="op", tag="section"
):
    """A section shows what is cut along a line in another view: two ends, or corners of steps.

    ``looks`` says in which direction where the section's role does not.
    """

    id: Text
    in_view: Text
    line: Annotated[tuple[Point, ...], Meta(min_length=2, max_length=100)]
    looks: ViewRole | None = None


class NoteOperation(
    Struct, frozen=True, kw_only=True, omit_defaults=True, tag_field="op", tag="note"
):
    """The hole of a circle goes ``through``, or is so deep; one of both."""

    circle: CircleShape
    through: bool = False
    depth_mm: Size | None = None


Operation = (
    ViewOperation
    | KindOperation
    | EraseOperation
    | DrawOperation
    | DimensionOperation
    | ScaleOperation
    | UnitOperation
    | ProjectionOperation
    | TangentEdgesOperation
    | RegionOperation
    | TraceOperation
    | SectionOperation
    | NoteOperation
)


class Corrections(Struct, frozen=True, kw_only=True):
    """All of ``corrections.json``."""

    schema: Literal["gaussiancad-corrections/1"]
    sheet_sha256: Text
    ops: Annotated[tuple[Operation, ...], Meta(max_length=100_000)] = ()
