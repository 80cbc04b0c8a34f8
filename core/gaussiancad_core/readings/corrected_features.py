"""What a person says of features: where a section cuts, and how deep a hole is."""

from math import hypot

import numpy as np
from msgspec.structs import replace as changed

from gaussiancad_core.model.axes import Role
from gaussiancad_core.readings.correction_operations import NoteOperation, SectionOperation
from gaussiancad_core.readings.reading_schema import (
    LARGEST,
    Box,
    NoteEntry,
    Point,
    SectionEntry,
    SheetReading,
)
from gaussiancad_core.writing.callouts import NoteKind

_ROLES = {role.value: role for role in Role}

_SAME_PX = 2.0
"""px within which two circles are one hole."""


def with_section(reading: SheetReading, operation: SectionOperation) -> SheetReading | None:
    """The reading with the cutting line of a section; None where one of the views is missing, or
    the line's view does not show where the section cuts."""
    views = {view.id: view for view in reading.views}
    section, cut_in = views.get(operation.id), views.get(operation.in_view)
    if section is None or cut_in is None:
        return None
    looks = operation.looks or section.looks or section.role
    seen, shown = _ROLES.get(looks.value), _ROLES.get(cut_in.role.value)
    way = _way(seen, shown) if seen and shown else None
    if way is None:
        return None
    if operation.looks is not None:
        views[section.id] = changed(section, looks=operation.looks)
    known = next(
        (
            section_entry
            for section_entry in reading.sections
            if _meet(section_entry.box, section.box)
        ),
        None,
    )
    line = operation.line
    this_section_entry = SectionEntry(
        label=known.label if known is not None else "",
        box=section.box,
        in_view=cut_in.role,
        line=(line[0], line[-1]),
        way=way,
        straight=len(line) == 2,
        path=line if len(line) > 2 else (),
        looks=looks,
    )
    rest = tuple(each for each in reading.sections if each is not known)
    return changed(reading, views=tuple(views.values()), sections=(*rest, this_section_entry))


def with_note(reading: SheetReading, operation: NoteOperation) -> SheetReading | None:
    """The reading with a hole's depth in place of what was said of it before; None where the
    operation says neither that it goes through nor how deep it is."""
    if operation.through == (operation.depth_mm is not None):
        return None
    x, y, radius = operation.circle
    x0, y0, x1, y1 = (max(-LARGEST, min(LARGEST, value)) for value in _around(x, y, radius))
    note_entry = NoteEntry(
        text="THRU" if operation.through else f"depth {operation.depth_mm:g}",
        kind=NoteKind.DIAMETER,
        box=(x0, y0, x1, y1),
        depth_mm=operation.depth_mm,
        through=operation.through,
        circle=operation.circle,
    )
    rest = (each for each in reading.notes if not _is_of(each, operation.circle))
    return changed(reading, notes=(*rest, note_entry))


def _around(x: float, y: float, radius: float) -> Box:
    return x - radius, y - radius, x + radius, y + radius


def _is_of(note: NoteEntry, circle: tuple[float, float, float]) -> bool:
    return note.circle is not None and all(
        abs(one - other) <= _SAME_PX for one, other in zip(note.circle, circle, strict=True)
    )


def _way(seen: Role, shown: Role) -> Point | None:
    """px, of length 1: where a view looks, in the plane of another; None where that looks along."""
    look = np.array(seen.frame.look)
    right, up = look @ np.array(shown.frame.right), look @ np.array(shown.frame.up)
    return (float(right), float(-up)) if hypot(right, up) > 0.5 else None


def _meet(one: Box, other: Box) -> bool:
    return all(max(one[n], other[n]) <= min(one[n + 2], other[n + 2]) for n in (0, 1))
