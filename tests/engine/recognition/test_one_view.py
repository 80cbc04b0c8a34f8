"""What a sheet of one view says of the axis that it does not show."""

from types import SimpleNamespace

import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.processes.events import Progress, Silence
from gaussiancad_core.recognition.one_view import shown_extents, unseen_extent_of
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.registration.view_masks import Outline
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.writing.callouts import Callout, NoteKind
from gaussiancad_core.writing.dimension_texts import Span
from gaussiancad_core.writing.note_texts import SheetNote
from gaussiancad_core.writing.numbers import Sign
from gaussiancad_core.writing.scale_agreement import ReadDimension
from gaussiancad_core.writing.sheet_scale import ScaleSource, SheetScale

_BOX = (100.0, 50.0, 300.0, 150.0)
_KNOWN = ReadingOptions(mm_per_pixel=0.5)


def _lines(*ends: tuple[float, float, float, float]) -> tuple[Segment, ...]:
    return tuple(Segment((a, b), (c, d), Linetype.VISIBLE) for a, b, c, d in ends)


_SIDES = _lines((100, 50, 300, 50), (300, 50, 300, 150), (300, 150, 100, 150), (100, 150, 100, 50))
_SHOULDER = _lines((200, 50, 200, 150))
_BORE = _lines((200, 90, 300, 90))


def _view(*strokes: Segment, opened: bool = False) -> ReadView:
    depth = np.full((200, 400), -1.0, np.float32)
    depth[50:150, 100:300] = 1.0
    half = ((100.0, 50.0), (300.0, 50.0), (300.0, 100.0), (100.0, 100.0))
    outline = Outline(depth, (), 1, (0.0, 0.0))
    return ReadView(Role.FRONT, _BOX, strokes, outline, opened=half if opened else ())


def _scale(*places: Span) -> SheetScale:
    dimensions = tuple(
        ReadDimension("50", 50.0, (0.0, 0.0, 1.0, 1.0), 0.5, True, Sign.DIAMETER, place)
        for place in places
    )
    return SheetScale(0.5, ScaleSource.DIMENSION, dimensions)


_UPRIGHT = Span(False, 50.0, 150.0)
_LEVEL = Span(True, 100.0, 300.0)


def _notes() -> RunNotes:
    return RunNotes(Report("", {}), Progress(Silence(), 1))


def _thick(value: float) -> SheetNote:
    callout = Callout(NoteKind.THICKNESS, value)
    return SheetNote("t", (0.0, 0.0, 1.0, 1.0), callout, value, None)


def _told(
    view: ReadView,
    scale: SheetScale,
    options: ReadingOptions = _KNOWN,
    notes: tuple[SheetNote, ...] = (),
) -> Unseen | None:
    run = _notes()
    found = unseen_extent_of((view,), scale, notes, options, run)
    assert [reason.code for reason in run.report.reasons] == ["second-view-assumed"]
    return found


def test_a_note_tells_the_thickness() -> None:
    assert _told(_view(*_SIDES), _scale(), notes=(_thick(3.0),)) == Unseen(Axis.Y, 3.0)


def test_what_the_user_says_goes_before_a_note_and_diameters() -> None:
    options = ReadingOptions(lengths=((Axis.Y, 7.0),), mm_per_pixel=0.5)
    view = _view(*_SIDES)
    assert _told(view, _scale(_UPRIGHT), options, (_thick(3.0),)) == Unseen(Axis.Y, 7.0)


@pytest.mark.parametrize(("place", "about"), [(_UPRIGHT, Axis.X), (_LEVEL, Axis.Z)])
def test_a_diameter_across_the_axis_tells_a_turned_part(place: Span, about: Axis) -> None:
    assert _told(_view(*_SIDES), _scale(place)) == Unseen(Axis.Y, about=about)


def test_a_view_that_is_not_alike_on_both_sides_is_not_turned() -> None:
    with pytest.raises(NoModelError) as raised:
        _told(_view(*_SIDES, *_BORE), _scale(_UPRIGHT))
    assert raised.value.code == "one-view"


def test_the_outline_of_a_half_section_is_alike() -> None:
    view = _view(*_SIDES, *_SHOULDER, *_BORE, opened=True)
    assert _told(view, _scale(_UPRIGHT)) == Unseen(Axis.Y, about=Axis.X)


@pytest.mark.parametrize(
    ("options", "notes", "case"),
    [
        (_KNOWN, (), None),
        (ReadingOptions(), (_thick(3.0),), "scale"),
        (ReadingOptions(lengths=((Axis.Y, 3.0),)), (), "scale"),
    ],
)
def test_without_a_thickness_or_a_scale_one_view_is_no_part(
    options: ReadingOptions, notes: tuple[SheetNote, ...], case: str | None
) -> None:
    with pytest.raises(NoModelError) as raised:
        unseen_extent_of((_view(*_SIDES),), _scale(), notes, options, _notes())
    assert raised.value.code == "one-view"
    args = raised.value.message.args
    assert (args["axis"], args.get("case")) == ("y", case)


def test_of_two_views_nothing_is_asked() -> None:
    views = (_view(*_SIDES), SimpleNamespace(role=Role.TOP, box=(0.0, 0.0, 7.0, 8.0)))
    assert unseen_extent_of(views, None, (), ReadingOptions(), _notes()) is None
    assert set(shown_extents(views)) == set(Axis)
    assert set(shown_extents(views[:1])) == {Axis.X, Axis.Z}


def test_of_two_lengths_one_is_the_scale_and_one_the_thickness() -> None:
    options = ReadingOptions(lengths=((Axis.Y, 3.0), (Axis.X, 80.0)))
    views = (_view(*_SIDES),)
    assert unseen_extent_of(views, _scale(), (), options, _notes()) == Unseen(Axis.Y, 3.0)
    assert options.scaling_length(shown_extents(views)) == (Axis.X, 80.0)
