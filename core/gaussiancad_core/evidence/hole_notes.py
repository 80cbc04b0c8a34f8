"""Notes at holes, put to the circles that they speak of."""

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby, takewhile

import numpy as np

from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.sheet.picture_noise import ONE_PLACE
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_core.writing.callout_words import is_typical
from gaussiancad_core.writing.callouts import NoteKind
from gaussiancad_core.writing.note_texts import GOING_ON, WIDER, SheetNote, gap_below
from gaussiancad_core.writing.scale_agreement import ReadDimension
from gaussiancad_protocol.codes import Code

_SAME = 0.02
"""Share by which a circle's diameter may differ from the one in a note."""

_SAID_PX = 3.0
"""px of the sheet by which a circle may differ from the one that a person pointed at."""

_MINOR = 0.75
"""Diameter of the core hole of a thread as a share of the nominal one, at least (ISO 724)."""

_HOLES = (NoteKind.DIAMETER, NoteKind.THREAD)


@dataclass(frozen=True)
class HoleNotes:
    """What notes say of holes.

    Attributes:
        holes: those whose circles were found.
        doubts: (code, sentence) of notes that do not fit what is drawn.
    """

    holes: tuple[NotedHole, ...]
    doubts: tuple[tuple[str, str], ...]


def hole_notes(
    registered: RegisteredSheet,
    notes: Sequence[SheetNote],
    dimensions: Sequence[ReadDimension],
) -> HoleNotes:
    """The holes that notes speak of.

    A note belongs to the circle that its leader points at; without one to those of its diameter, if
    one view alone has as many as it says.  In the only view of a turned part one that belongs to
    none speaks of a bore along the axis.

    Args:
        registered: the views.
        notes: of the sheet.
        dimensions: those with a circle tell which one a text points at.
    """
    pointed = {
        (dimension.text, dimension.box): (dimension.place,)
        for dimension in dimensions
        if isinstance(dimension.place, Arc)
    }
    circles = _circles(registered)
    holes: list[NotedHole] = []
    doubts: list[tuple[str, str]] = []
    taken: set[tuple[Role, Arc]] = set()
    groups = [sheet_notes for sheet_notes in _groups(notes) if _states_depth(sheet_notes)]
    # What is wider somewhere is told from what is not, and one hole from many.
    # What a person says goes before all.
    groups.sort(
        key=lambda sheet_notes: (
            sheet_notes[0].circle is None,
            len(sheet_notes) < 2,
            sheet_notes[0].callout.count,
        )
    )
    for group in groups:
        first = group[0]
        at = first.pointed or pointed.get((first.text, first.box), ())
        role, arcs = (
            _pointed_at(first.circle, circles)
            if first.circle is not None
            else _meant(group, circles, at, taken, registered.mm_per_pixel)
        )
        if role is None:
            holes += _bores(registered, group)
            continue
        count = first.callout.count
        if count > 1 and len(arcs) != count:
            doubts.append(
                (
                    Code.NOTE_COUNT,
                    Message(
                        "the note {note!r} speaks of {count} holes, and the {view} view has "
                        "{found} of that kind: all of them were taken to be meant",
                        note=first.text,
                        count=count,
                        view=role,
                        found=len(arcs),
                    ),
                )
            )
        taken.update((role, circle) for circle in arcs)
        noted = (_noted(registered, role, circle, group) for circle in arcs)
        holes += [hole for hole in noted if hole.steps]
    return HoleNotes(tuple(holes), tuple(doubts))


def _states_depth(group: Sequence[SheetNote]) -> bool:
    first = group[0]
    named = first.value_mm is not None or first.circle is not None
    is_hole = first.callout.kind in _HOLES and named
    return is_hole and any(note.depth_mm is not None or note.callout.through for note in group)


def _groups(notes: Sequence[SheetNote]) -> Iterator[list[SheetNote]]:
    """Notes of one text, with the lines right below that go on."""
    texts = [
        list(sheet_notes)
        for _, sheet_notes in groupby(notes, key=lambda note: (note.text, note.box))
    ]
    below: dict[int, int] = {}
    for index, sheet_notes in enumerate(texts):
        if sheet_notes[0].callout.kind not in GOING_ON:
            continue
        gaps = [
            (gap, other)
            for other, above in enumerate(texts)
            if other != index and (gap := gap_below(above[-1].box, sheet_notes[0])) is not None
        ]
        if gaps:
            below[min(gaps)[1]] = index
    for first in sorted(set(range(len(texts))) - set(below.values())):
        group, number = list(texts[first]), below.get(first)
        while number is not None:
            for note in texts[number]:
                group = _continued(group, note)
            number = below.get(number)
        yield group


def _continued(group: list[SheetNote], note: SheetNote) -> list[SheetNote]:
    """The notes of one call-out with a further one, a depth in what it is the depth of as well."""
    last = group[-1]
    lacks = last.depth_mm is None and not last.callout.through
    if note.callout.kind is NoteKind.DEPTH and last.callout.kind is not NoteKind.DEPTH and lacks:
        said = replace(last.callout, depth=note.callout.value, through=note.callout.through)
        group = [*group[:-1], replace(last, callout=said, depth_mm=note.value_mm)]
    return [*group, note]


def _circles(registered: RegisteredSheet) -> dict[Role, list[Arc]]:
    """The whole visible circles of views that are not cut, each once."""
    found: dict[Role, list[Arc]] = {}
    for view in registered.drawn:
        arcs = found.setdefault(view.role, [])
        for stroke in view.strokes if not view.hatched else ():
            if isinstance(stroke, Arc) and stroke.is_full and stroke.linetype is Linetype.VISIBLE:
                arcs.append(stroke)
    return found


def _pointed_at(
    circle: Arc, circles: Mapping[Role, Sequence[Arc]]
) -> tuple[Role | None, list[Arc]]:
    """The view with a circle that a person pointed at; no view where it is there no more."""
    for role, arcs in circles.items():
        for each in arcs:
            if max(_apart(circle, each), abs(circle.radius - each.radius)) <= _SAID_PX:
                return role, [each]
    return None, []


def _meant(
    group: Sequence[SheetNote],
    circles: Mapping[Role, Sequence[Arc]],
    pointed: Sequence[Arc],
    taken: Container[tuple[Role, Arc]],
    scale: float,
) -> tuple[Role | None, list[Arc]]:
    """The view and the circles that a note speaks of; no view where that is not certain."""
    first, *wider = group
    by_role = {
        role: found
        for role, arcs in circles.items()
        if (
            found := [
                each
                for each in arcs
                if _fits(first, each, scale)
                and (role, each) not in taken
                and all(_is_around(more, each, arcs, scale) for more in wider)
            ]
        )
    }
    count, typical = first.callout.count, is_typical(first.text)
    if not wider:
        by_role = {
            role: _plain(arcs, circles[role]) if len(arcs) > count and not typical else arcs
            for role, arcs in by_role.items()
        }
    for role, this_arcs in by_role.items():
        at = [each for each in this_arcs if any(_apart(arc, each) <= ONE_PLACE for arc in pointed)]
        if at:
            if len(pointed) > 1:
                return role, at
            return role, at[:1] if count == 1 and not typical else this_arcs
    roles = [role for role, arcs in by_role.items() if len(arcs) == count or (typical and arcs)]
    return (roles[0], by_role[roles[0]]) if len(roles) == 1 else (None, [])


def _plain(arcs: Sequence[Arc], others: Sequence[Arc]) -> list[Arc]:
    """Those of some circles that no wider one is around: all of them where none is so."""
    found = [
        each
        for each in arcs
        if not any(
            other.radius > each.radius and _apart(each, other) <= ONE_PLACE for other in others
        )
    ]
    return found or list(arcs)


def _is_around(note: SheetNote, circle: Arc, others: Sequence[Arc], scale: float) -> bool:
    """Whether what a note says to be wider is drawn around a circle."""
    return note.callout.kind not in WIDER or any(
        _apart(circle, other) <= ONE_PLACE and _fits(note, other, scale) for other in others
    )


def _fits(note: SheetNote, circle: Arc, scale: float) -> bool:
    drawn, said = 2.0 * circle.radius * scale, note.value_mm
    if said is None:
        return False
    slack = max(_SAME * said, ONE_PLACE * scale)
    if note.callout.kind is NoteKind.THREAD:
        return _MINOR * said - slack <= drawn <= said + slack
    return abs(drawn - said) <= slack


def _apart(one: Arc, other: Arc) -> float:
    return float(np.hypot(*np.subtract(one.centre, other.centre)))


def _bores(registered: RegisteredSheet, group: Sequence[SheetNote]) -> Iterator[NotedHole]:
    """The bore through a turned part of which the only view does not show the circle: how deep
    another one is, and from which end, no note tells."""
    about = registered.unseen.about if registered.unseen is not None else None
    first = group[0]
    if about is None or first.value_mm is None or first.callout.count > 1:
        return
    if first.callout.through:
        role = next(this_role for this_role in Role if this_role.frame.look_axis[0] is about)
        along = role.frame.right_axis, role.frame.up_axis
        right, up = (sign * registered.views.size[axis.value] / 2.0 for axis, sign in along)
        yield NotedHole(
            role, (right, up), (HoleStep(first.value_mm, None, (first.box,)),), first.text
        )


def _noted(
    registered: RegisteredSheet, role: Role, circle: Arc, group: Sequence[SheetNote]
) -> NotedHole:
    right, up = registered.placements[role].to_plane(np.array([circle.centre]))[0].tolist()
    steps = []
    kinds = [sheet_note.callout.kind for sheet_note in group]
    # A thread says how deep its core is where nothing else does.
    cored = NoteKind.DIAMETER in kinds or any(view.has_hidden_lines for view in registered.drawn)
    for number, sheet_note in enumerate(group):
        kind = sheet_note.callout.kind
        of_thread = kind is NoteKind.THREAD and cored and not sheet_note.callout.through
        if kind is NoteKind.DEPTH or of_thread:
            continue
        diameter = (
            2.0 * circle.radius * registered.mm_per_pixel if not number else sheet_note.value_mm
        )
        deep = sheet_note.depth_mm
        if diameter is not None and (deep is not None or sheet_note.callout.through):
            said = takewhile(lambda each: each.callout.kind is NoteKind.DEPTH, group[number + 1 :])
            boxes = sheet_note.box, *(each.box for each in said)
            steps.append(HoleStep(diameter, deep, boxes))
    steps.sort(key=lambda step: step.diameter)
    return NotedHole(role, (right, up), tuple(steps), group[0].text)
