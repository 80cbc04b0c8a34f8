"""Notes of holes, and the circles that they speak of."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from gaussiancad_core.evidence.hole_notes import hole_notes
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.writing.callouts import Callout, NoteKind
from gaussiancad_core.writing.note_texts import SheetNote, notes_of
from gaussiancad_core.writing.numbers import Unit
from gaussiancad_core.writing.sheet_texts import SheetText

_BOX = (0.0, 0.0, 40.0, 5.0)
_CROSS = Arc((250.0, 100.0), 8.0, 0.0, 6.283, Linetype.VISIBLE)


def _note(**said: object) -> SheetNote:
    callout = Callout(NoteKind.DIAMETER, 8.0, **said)
    return SheetNote("\u00d88", _BOX, callout, 8.0, callout.depth)


def _registered(unseen: Unseen | None, *strokes: Arc) -> SimpleNamespace:
    view = ReadView(Role.FRONT, (100.0, 50.0, 300.0, 150.0), strokes, None)
    plane = SimpleNamespace(to_plane=lambda points: 0.5 * (points - (100.0, 50.0)))
    views = SimpleNamespace(size=(100.0, 50.0, 50.0))
    return SimpleNamespace(
        drawn=(view,), views=views, mm_per_pixel=0.5, unseen=unseen, placements={Role.FRONT: plane}
    )


@pytest.mark.parametrize(
    ("about", "role", "centre"),
    [(Axis.X, Role.RIGHT, (25.0, 25.0)), (Axis.Z, Role.TOP, (50.0, 25.0))],
)
def test_a_bore_without_a_circle_is_along_the_axis(
    about: Axis, role: Role, centre: tuple[float, float]
) -> None:
    registered = _registered(Unseen(Axis.Y, about=about))
    found = hole_notes(registered, [_note(through=True)], ())
    assert found.holes == (NotedHole(role, centre, (HoleStep(8.0, None),), "\u00d88"),)
    assert found.holes[0].steps[0].notes == (_BOX,)


@pytest.mark.parametrize(
    ("unseen", "said"),
    [
        (None, {"through": True}),
        (Unseen(Axis.Y, 5.0), {"through": True}),
        (Unseen(Axis.Y, about=Axis.X), {"through": True, "count": 4}),
        (Unseen(Axis.Y, about=Axis.X), {"depth": 20.0}),
    ],
)
def test_no_bore_is_made_up(unseen: Unseen | None, said: dict[str, object]) -> None:
    found = hole_notes(_registered(unseen), [_note(**said)], ())
    assert not found.holes


def test_a_circle_that_a_note_fits_is_its_hole() -> None:
    registered = _registered(Unseen(Axis.Y, about=Axis.X), _CROSS)
    (hole,) = hole_notes(registered, [_note(through=True)], ()).holes
    assert (hole.role, hole.centre) == (Role.FRONT, (75.0, 25.0))


def _lines(*texts: str) -> tuple[SheetNote, ...]:
    """The notes of lines of text below each other."""
    below = (SheetText(text, (0.0, 8.0 * k, 40.0, 8.0 * k + 5.0)) for k, text in enumerate(texts))
    return notes_of(tuple(below), Unit.MILLIMETRE)


def _plate_with_counterbores(*centres: tuple[float, float]) -> SimpleNamespace:
    circles = (_circle(centre, radius) for centre in centres for radius in (5.5, 10.0))
    return _registered(Unseen(Axis.Y, 12.0), *circles)


def _circle(centre: tuple[float, float], radius: float) -> Arc:
    return Arc(centre, radius, 0.0, 6.283, Linetype.VISIBLE)


@pytest.mark.parametrize(
    "texts",
    [
        ("2 x 5.5 THRU ALL", "C'BORE 10 X 5.7 DP"),
        ("2 x \u00d85.5", "THRU", "CBORE \u00d810", "5.7 DEEP"),
        ("2x \u00d85.5 THRU \u2334 \u00d810 \u21a7 5.7",),
        ("\u00d85.5 durchgehend, 2 Stellen", "Zylindersenkung 10", "Tiefe 5.7"),
    ],
)
def test_lines_below_each_other_are_one_callout(texts: tuple[str, ...]) -> None:
    registered = _plate_with_counterbores((150.0, 100.0), (250.0, 100.0))
    notes = _lines(*texts)
    holes = hole_notes(registered, notes, ()).holes
    assert [hole.centre for hole in holes] == [(25.0, 25.0), (75.0, 25.0)]
    assert all(hole.steps == (HoleStep(5.5), HoleStep(10.0, 5.7)) for hole in holes)
    boxes = {box for step in holes[0].steps for box in step.notes}
    assert boxes == {note.box for note in notes}


def test_the_tip_of_a_leader_tells_the_hole() -> None:
    registered = _plate_with_counterbores((150.0, 100.0), (250.0, 100.0))
    (note,) = _lines("\u00d85.5 THRU")
    assert not hole_notes(registered, [note], ()).holes
    pointed = replace(note, pointed=(_circle((250.0, 100.0), 5.5),))
    (hole,) = hole_notes(registered, [pointed], ()).holes
    assert hole.centre == (75.0, 25.0)


def test_a_typical_hole_stands_for_all_of_its_kind() -> None:
    registered = _plate_with_counterbores((150.0, 100.0), (250.0, 100.0))
    found = hole_notes(registered, _lines("\u00d85.5 THRU TYP"), ())
    assert len(found.holes) == 2 and not found.doubts


def _threaded(*strokes: Arc | Segment) -> SimpleNamespace:
    return _registered(Unseen(Axis.Y, 40.0), _circle((150.0, 100.0), 6.8), *strokes)


def test_a_thread_tells_the_depth_of_its_core_where_nothing_else_does() -> None:
    (hole,) = hole_notes(_threaded(), _lines("M8 \u21a7 14"), ()).holes
    assert hole.steps == (HoleStep(6.8, 14.0),)
    drill = _lines("M8 \u21a7 14, \u00d86.8 \u21a7 20")
    (hole,) = hole_notes(_threaded(), drill, ()).holes
    assert hole.steps == (HoleStep(6.8, 20.0),)


def test_hidden_lines_tell_the_depth_of_a_threads_core() -> None:
    hidden = Segment((146.0, 60.0), (154.0, 60.0), Linetype.HIDDEN)
    assert not hole_notes(_threaded(hidden), _lines("M8 \u21a7 14"), ()).holes
    (hole,) = hole_notes(_threaded(hidden), _lines("M8 THRU"), ()).holes
    assert hole.steps == (HoleStep(6.8),)
