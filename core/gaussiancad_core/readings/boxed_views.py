"""Views that a person boxed, with the strokes that are read in them."""

from collections.abc import Callable

from msgspec.structs import replace as changed

from gaussiancad_core.model.axes import Role
from gaussiancad_core.readings.reading_schema import Box, SheetReading, StrokeEntry, ViewEntry
from gaussiancad_core.readings.reading_shapes import stored_ring
from gaussiancad_core.readings.stroke_certainty import read_entry, view_certainty
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_protocol.reading_kinds import DRAWN

Reread = Callable[[tuple[tuple[Role, Box], ...]], tuple[ReadView, ...]]
"""Reads the views in boxes that a person named, px of the sheet as stored."""

_ROLES = {role.value: role for role in Role}


def with_read_views(reading: SheetReading, reread: Reread, turn: Turn) -> SheetReading:
    """The reading with strokes in the principal views that have none.

    Args:
        reading: of the sheet.
        reread: reads views; asked only where some have no strokes.
        turn: of the sheet.

    Raises:
        UsageError, NoModelError: a box holds nothing to read.
    """
    drawn = {stroke.view for stroke in reading.strokes if stroke.kind in DRAWN}
    empty = [
        (_ROLES[view.role.value], view)
        for view in reading.views
        if view.role.value in _ROLES and view.id not in drawn
    ]
    known = {stroke.view for stroke in reading.strokes}
    empty = [(role, view) for role, view in empty if view.id not in known]
    if not empty:
        return reading
    boxes = tuple((role, view.box) for role, view in empty)
    found = {read_view.role: read_view for read_view in reread(boxes)}
    strokes = [*reading.strokes]
    views = {view_entry.id: view_entry for view_entry in reading.views}
    for role, view in empty:
        this_view = found[role]
        strokes += _entries(view, this_view, turn)
        views[view.id] = changed(
            view,
            source=this_view.source.value,
            dash=this_view.dash,
            step=this_view.step,
            hatch=tuple(stored_ring(ring, turn) for ring in this_view.hatched),
            opened=stored_ring(this_view.opened, turn),
        )
    return changed(reading, strokes=tuple(strokes), views=tuple(views.values()))


def _entries(view: ViewEntry, read_view: ReadView, turn: Turn) -> list[StrokeEntry]:
    return [
        read_entry(f"{view.id}:{number}", view.id, stroke, turn, stated)
        for number, (stroke, stated) in enumerate(view_certainty(read_view), start=1)
    ]
