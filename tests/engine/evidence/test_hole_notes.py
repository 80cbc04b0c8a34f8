"""Notes of bores in the only view of a turned part."""

from types import SimpleNamespace

import pytest

from gaussiancad_core.evidence.hole_notes import hole_notes
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.writing.callouts import Callout, NoteKind
from gaussiancad_core.writing.note_texts import SheetNote

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
    assert found.used == {("\u00d88", _BOX)}


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
    assert not found.used


def test_a_circle_that_a_note_fits_is_its_hole() -> None:
    registered = _registered(Unseen(Axis.Y, about=Axis.X), _CROSS)
    (hole,) = hole_notes(registered, [_note(through=True)], ()).holes
    assert (hole.role, hole.centre) == (Role.FRONT, (75.0, 25.0))
