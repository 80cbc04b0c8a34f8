"""A reading with a person's corrections: what the machine read stays as it was elsewhere."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import hypot
from typing import Any

import cv2
import numpy as np
from msgspec.structs import replace as changed

from gaussiancad_core.evidence.projection_choice import opposite
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.length_units import MM_PER_INCH
from gaussiancad_core.readings.corrected_features import with_note, with_section
from gaussiancad_core.readings.correction_operations import (
    DimensionOperation,
    DrawOperation,
    EraseOperation,
    KindOperation,
    NoteOperation,
    Operation,
    ProjectionOperation,
    RegionOperation,
    ScaleOperation,
    SectionOperation,
    TangentEdgesOperation,
    Target,
    TraceOperation,
    UnitOperation,
    ViewOperation,
)
from gaussiancad_core.readings.reading_schema import (
    GIVEN,
    LINES,
    Box,
    DimensionEntry,
    Point,
    ReadProjection,
    ReadScale,
    ReadUnit,
    SheetReading,
    StrokeEntry,
    ViewEntry,
)
from gaussiancad_core.readings.stroke_anchors import are_one, box_of, matching, points_of
from gaussiancad_protocol.reading_kinds import DRAWN, StrokeKind, ViewRole

_PERSONAL = re.compile(r"p[0-9]{1,9}").fullmatch
"""Ids of strokes that a person drew."""

_OF_STROKES = (KindOperation, EraseOperation, RegionOperation, SectionOperation)

_MARGIN_PX = 3.0
"""px by which a stroke may reach beyond the box of its view."""


@dataclass(frozen=True)
class Corrected:
    """A reading after corrections.

    Attributes:
        reading: with those that found their place.
        unmatched: numbers, from 1, of operations whose target is no longer there.
    """

    reading: SheetReading
    unmatched: tuple[int, ...] = ()


Trace = Callable[[Point, Box], Mapping[str, Any] | None]
"""The stroke whose ink lies at a place, as the attribute of a :class:`StrokeEntry`, looked for in a
box; px of the sheet as stored."""


@dataclass(frozen=True)
class Ink:
    """What corrections ask of the sheet itself.

    Attributes:
        fill: reads the views that a person boxed and of which there are no strokes yet.
        trace: finds the stroke at a place.
    """

    fill: Callable[[SheetReading], SheetReading] = lambda reading: reading
    trace: Trace = lambda _at, _box: None


def corrected(
    reading: SheetReading, operations: Sequence[Operation], ink: Ink | None = None
) -> Corrected:
    """Apply operations to a reading, in their order; it counts those that found their place.

    Args:
        reading: of the sheet.
        operations: a person's.
        ink: asked before an operation that speaks of strokes; without it no ink is read.
    """
    found, ink = Corrected(reading), ink or Ink()
    for number, operation in enumerate(operations, start=1):
        if isinstance(operation, _OF_STROKES):
            found = replace(found, reading=ink.fill(found.reading))
        if isinstance(operation, TraceOperation):
            traced = _traced(found.reading, operation, ink.trace)
        elif isinstance(operation, ProjectionOperation):
            traced = _with_projection(found.reading, operation, _named(operations[: number - 1]))
        else:
            traced = _APPLIED[type(operation)](found.reading, operation)
        if traced is None:
            found = replace(found, unmatched=(*found.unmatched, number))
        else:
            found = replace(found, reading=changed(traced, corrected=1 + found.reading.corrected))
    return found


def _traced(reading: SheetReading, operation: TraceOperation, trace: Trace) -> SheetReading | None:
    view = next(
        (view_entry for view_entry in reading.views if view_entry.id == operation.view), None
    )
    shape = trace(operation.at, view.box) if view is not None else None
    if shape is None:
        return None
    return _drawn(reading, DrawOperation(view=operation.view, kind=operation.kind, **shape))


def _with_view(reading: SheetReading, operation: ViewOperation) -> SheetReading | None:
    known = next(
        (view_entry for view_entry in reading.views if view_entry.id == operation.id), None
    )
    box = operation.box or (known.box if known is not None else None)
    if box is None:
        return None
    views = [view_entry for view_entry in reading.views if view_entry.id != operation.id]
    source = known.source if known and known.source and operation.box is None else ""
    view = ViewEntry(
        id=operation.id,
        role=operation.role,
        box=box,
        kind=known.kind if known else "",
        source=source or GIVEN,
        dash=known.dash if known else None,
    )
    if operation.box is None:
        return changed(reading, views=(*views, view))
    # A group of lines in the box, or one that the box was cut out of, is no longer left out.
    views = [
        view_entry
        for view_entry in views
        if view_entry.kind != LINES or view_entry.used or not _nested(box, view_entry.box)
    ]
    strokes = tuple(_in_view(stroke, view.id, box) for stroke in reading.strokes)
    return changed(reading, views=(*views, view), strokes=strokes)


def _in_view(stroke: StrokeEntry, view: str, box: Box) -> StrokeEntry:
    this_box = box_of(stroke)
    inside = this_box is not None and _holds(box, this_box)
    if inside and (stroke.kind in DRAWN or stroke.view is not None):
        return changed(stroke, view=view)
    return changed(stroke, view=None) if stroke.view == view else stroke


def _nested(box: Box, pair: Box) -> bool:
    """Whether one of two boxes holds the other."""
    return _holds(box, pair) or _holds(pair, box)


def _holds(box: Box, pair: Box) -> bool:
    low = all(a - _MARGIN_PX <= b for a, b in zip(box[:2], pair[:2], strict=True))
    return low and all(b <= a + _MARGIN_PX for a, b in zip(box[2:], pair[2:], strict=True))


def _found(reading: SheetReading, target: Target) -> StrokeEntry | None:
    """The stroke that a person pointed at: by its id where it still runs there, else by place."""
    named = next((stroke for stroke in reading.strokes if stroke.id == target.id), None)
    if all(shape is None for shape in (target.line, target.arc, target.ellipse)):
        return named
    if named is not None and matching(target, [named]) is not None:
        return named
    return matching(target, reading.strokes)


def _with_kind(reading: SheetReading, operation: KindOperation) -> SheetReading | None:
    target = _found(reading, operation.target)
    if target is None:
        return None
    view = target.view
    if view is None and operation.to in DRAWN:
        view = _around(reading, target)
    stroke_entry = changed(
        target, kind=operation.to, view=view, confidence=1.0, source=GIVEN, why=None
    )
    return _with_stroke(reading, target, stroke_entry)


def _around(reading: SheetReading, stroke: StrokeEntry) -> str | None:
    """The view in whose box a stroke lies."""
    box = box_of(stroke)
    if box is None:
        return None
    return next((view.id for view in reading.views if view.used and _holds(view.box, box)), None)


def _with_stroke(
    reading: SheetReading, target: StrokeEntry, stroke_entry: StrokeEntry | None
) -> SheetReading:
    kept = (stroke if stroke is not target else stroke_entry for stroke in reading.strokes)
    return changed(reading, strokes=tuple(stroke for stroke in kept if stroke is not None))


def _erased(reading: SheetReading, operation: EraseOperation) -> SheetReading | None:
    target = _found(reading, operation.target)
    return None if target is None else _with_stroke(reading, target, None)


def _drawn(reading: SheetReading, operation: DrawOperation) -> SheetReading | None:
    if all(view.id != operation.view for view in reading.views):
        return None
    number = 1 + max(
        (int(stroke.id[1:]) for stroke in reading.strokes if _PERSONAL(stroke.id)), default=0
    )
    stroke_entry = StrokeEntry(
        id=f"p{number}",
        view=operation.view,
        kind=operation.kind,
        line=operation.line,
        arc=operation.arc,
        ellipse=operation.ellipse,
        source=GIVEN,
    )
    if box_of(stroke_entry) is None:
        return None
    # Drawn again over what was drawn before, it is no second line.
    twice = any(
        stroke.view == stroke_entry.view
        and stroke.kind is stroke_entry.kind
        and are_one(stroke_entry, stroke)
        for stroke in reading.strokes
        if stroke.source == GIVEN
    )
    return reading if twice else changed(reading, strokes=(*reading.strokes, stroke_entry))


def _with_dimension(reading: SheetReading, operation: DimensionOperation) -> SheetReading | None:
    known = next(
        (dimension for dimension in reading.dimensions if dimension.id == operation.id), None
    )
    if known is None:
        return None
    dimension_entry = _with_value(known, operation)
    return changed(
        reading,
        dimensions=tuple(dimension_entry if each is known else each for each in reading.dimensions),
    )


def _with_value(known: DimensionEntry, operation: DimensionOperation) -> DimensionEntry:
    share = 0.5 if known.type == "diameter" else 1.0
    digits = f"{operation.value_mm:.6f}".rstrip("0").partition(".")[2]
    measures = operation.measures or known.measures
    return changed(
        known,
        value_mm=operation.value_mm,
        measures=measures,
        told_mm=share * operation.value_mm if measures else None,
        digit_mm=share * 10.0 ** -len(digits) if measures else None,
        used=True,
    )


def _with_scale(reading: SheetReading, operation: ScaleOperation) -> SheetReading | None:
    scale = _given_scale(reading, operation)
    return None if scale is None else changed(reading, scale=scale)


def _given_scale(reading: SheetReading, operation: ScaleOperation) -> ReadScale | None:
    before = reading.scale
    if operation.axis is not None and operation.mm_per_px is None:
        if operation.length_mm is None:
            return None
        # An extent that the only view does not show tells no scale: that stays.
        known = before if is_unseen(reading, operation.axis) else ReadScale(source=GIVEN)
        return changed(known, axis=operation.axis, length_mm=operation.length_mm, points=None)
    per_px = operation.mm_per_px or _between_points(operation)
    if per_px is None:
        return None
    if before.axis is not None and is_unseen(reading, before.axis):
        # Nor does a scale tell that extent, which is the one length that is kept.
        return changed(before, source=GIVEN, mm_per_px=per_px)
    if operation.mm_per_px is not None:
        return ReadScale(source=GIVEN, mm_per_px=per_px)
    return ReadScale(
        source=GIVEN,
        mm_per_px=per_px,
        length_mm=operation.length_mm,
        points=operation.points,
    )


def _between_points(operation: ScaleOperation) -> float | None:
    """mm a px by the length between two points; None where they are one, or nothing is told."""
    if operation.points is None or operation.length_mm is None:
        return None
    (x0, y0), (x1, y1) = operation.points
    apart = hypot(x1 - x0, y1 - y0)
    return operation.length_mm / apart if apart >= 1.0 else None


def is_unseen(reading: SheetReading, axis: str) -> bool:
    """Whether the reading has one view, which looks along an axis."""
    known = {role.value: role for role in Role}
    roles = [known[view.role.value] for view in reading.views if view.role.value in known]
    return len(roles) == 1 and roles[0].frame.look_axis[0].name.lower() == axis


def _with_unit(reading: SheetReading, operation: UnitOperation) -> SheetReading:
    if reading.unit.value == operation.value:
        return changed(reading, unit=ReadUnit(value=operation.value, source=GIVEN))
    factor = MM_PER_INCH if operation.value == "in" else 1.0 / MM_PER_INCH
    scale = reading.scale
    if scale.source == "dimension" and scale.mm_per_px is not None:
        scale = changed(scale, mm_per_px=factor * scale.mm_per_px)
    return changed(
        reading,
        unit=ReadUnit(value=operation.value, source=GIVEN),
        scale=scale,
        dimensions=tuple(_times(dimension, factor) for dimension in reading.dimensions),
    )


def _times(dimension_entry: DimensionEntry, factor: float) -> DimensionEntry:
    lengths = {
        name: factor * value
        for name in ("value_mm", "mm_per_px", "told_mm", "digit_mm")
        if (value := getattr(dimension_entry, name)) is not None
    }
    return changed(dimension_entry, **lengths)


def _named(operations: Sequence[Operation]) -> set[str]:
    """Views of which a person said what they show."""
    return {operation.id for operation in operations if isinstance(operation, ViewOperation)}


def _with_projection(
    reading: SheetReading, operation: ProjectionOperation, named: set[str]
) -> SheetReading:
    """The same views under a projection: those beside the front are named anew, but for those that
    a person named."""
    projection = ReadProjection(value=operation.value, source=GIVEN)
    if reading.projection.value == operation.value:
        return changed(reading, projection=projection)
    views = tuple(
        view
        if view.id in named or view.source == GIVEN
        else changed(view, role=_opposite(view.role))
        for view in reading.views
    )
    return changed(reading, projection=projection, views=views)


def _opposite(role: ViewRole) -> ViewRole:
    principal = role.value in {this_role.value for this_role in Role}
    return ViewRole(opposite(Role(role.value)).value) if principal else role


def _with_tangent_edges(reading: SheetReading, operation: TangentEdgesOperation) -> SheetReading:
    """The same views on a sheet that does this with tangent edges.

    Where it leaves them out, what the machine took for tangent edges are edges.
    """
    found = changed(reading.tangent_edges, policy=operation.value, source=GIVEN)
    strokes = reading.strokes
    if operation.value == "left-out":
        strokes = tuple(
            changed(stroke, kind=StrokeKind.VISIBLE) if _is_read_tangent(stroke) else stroke
            for stroke in strokes
        )
    return changed(reading, tangent_edges=found, strokes=strokes)


def _is_read_tangent(stroke: StrokeEntry) -> bool:
    """Whether the machine took a line of a view for a tangent edge."""
    return stroke.kind is StrokeKind.TANGENT and stroke.view is not None and stroke.source != GIVEN


def _with_region(reading: SheetReading, operation: RegionOperation) -> SheetReading:
    polygon = np.array(operation.polygon, np.float32).reshape(-1, 1, 2)
    stated = {"kind": operation.kind, "confidence": 1.0, "source": GIVEN, "why": None}
    return changed(
        reading,
        strokes=tuple(
            changed(stroke, **stated) if _is_within(polygon, stroke) else stroke
            for stroke in reading.strokes
        ),
    )


def _is_within(polygon: np.ndarray, stroke_entry: StrokeEntry) -> bool:
    points = points_of(stroke_entry)
    return len(points) > 0 and all(
        cv2.pointPolygonTest(polygon, (float(x), float(y)), False) >= 0 for x, y in points
    )


# Each takes operations of the type that it stands beside.
_APPLIED: dict[type, Callable[[SheetReading, Any], SheetReading | None]] = {
    ViewOperation: _with_view,
    KindOperation: _with_kind,
    EraseOperation: _erased,
    DrawOperation: _drawn,
    DimensionOperation: _with_dimension,
    ScaleOperation: _with_scale,
    UnitOperation: _with_unit,
    TangentEdgesOperation: _with_tangent_edges,
    RegionOperation: _with_region,
    SectionOperation: with_section,
    NoteOperation: with_note,
}
