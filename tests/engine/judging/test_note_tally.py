"""What notes of holes say, compared with the solid that was made."""

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.judging.faceted_solids import faceted_shape
from gaussiancad_core.judging.note_tally import kept_notes, tally
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from sample_parts.modelling import box, cone, cut, cylinder

_AT = (20.0, 15.0)
_BORE, _WIDE = (0.0, 0.0, 1.0, 1.0), (0.0, 2.0, 1.0, 3.0)


def _plate(*tools: TopoDS_Shape) -> TopoDS_Shape:
    """40 x 30 x 12 mm."""
    return cut(box((0.0, 0.0, 0.0), (40.0, 30.0, 12.0)), *tools)


def _cylinder(diameter: float, depth: float, at: tuple[float, float] = _AT) -> TopoDS_Shape:
    """Bored from above; a depth of 12 mm goes through."""
    low = 12.0 - depth if depth < 12.0 else -1.0
    return cylinder(Axis.Z, at, diameter / 2.0, low, 13.0)


def _noted(bore: float | None, wide: float = 5.7) -> NotedHole:
    steps = HoleStep(6.0, bore, (_BORE,)), HoleStep(10.0, wide, (_WIDE,))
    return NotedHole(Role.TOP, _AT, steps)


@pytest.mark.parametrize(
    ("hole", "kept"),
    [
        (_noted(None), {_BORE, _WIDE}),
        (_noted(None, 6.5), {_BORE}),
        (_noted(9.0), {_WIDE}),
        (_noted(9.0, 3.0), set()),
    ],
)
def test_a_note_is_kept_where_the_solid_is_as_it_says(hole: NotedHole, kept: set[object]) -> None:
    part = faceted_shape(_plate(_cylinder(6.0, 12.0), _cylinder(10.0, 5.7)))
    assert kept_notes(part, [hole]) == kept
    (row,) = tally(part, [hole])
    assert (row.agrees, row.count_otherwise) == (len(kept) == 2, int(len(kept) < 2))


def test_a_sink_in_the_place_of_a_counterbore_keeps_its_hole_alone() -> None:
    sunk = _plate(_cylinder(6.0, 12.0), cone(Axis.Z, _AT, (3.0, 5.0), 10.0, 12.0))
    assert kept_notes(faceted_shape(sunk), [_noted(None)]) == {_BORE}


def test_nothing_is_kept_where_there_is_no_hole() -> None:
    assert not kept_notes(faceted_shape(_plate()), [_noted(None), _noted(5.0)])
    assert not kept_notes(faceted_shape(_plate(_cylinder(20.0, 8.0))), [_noted(8.0)])


def test_a_blind_hole_is_none_that_goes_through() -> None:
    through = NotedHole(Role.TOP, _AT, (HoleStep(6.0),), "Ø6 THRU")
    (row,) = tally(faceted_shape(_plate(_cylinder(6.0, 8.0))), [through])
    assert row.count_otherwise == 1


def test_one_hole_that_is_otherwise_breaks_the_note_of_many() -> None:
    elsewhere = NotedHole(Role.TOP, (35.0, 25.0), _noted(None).steps)
    part = faceted_shape(_plate(_cylinder(6.0, 12.0), _cylinder(10.0, 5.7)))
    assert not kept_notes(part, [_noted(None), elsewhere])
    (row,) = tally(part, [_noted(None), elsewhere])
    assert (row.count_found, row.count_stated, row.count_otherwise) == (1, 2, 1)
    # Where the note is not kept is what is to be seen.
    assert row.at == (35.0, 25.0)


@pytest.mark.parametrize(("drilled", "found"), [(1, 1), (3, 3), (4, 3)])
def test_a_count_is_kept_by_holes_that_no_circle_was_found_for(drilled: int, found: int) -> None:
    places = [(8.0, 8.0), (20.0, 8.0), (32.0, 8.0), (8.0, 22.0)][:drilled]
    part = faceted_shape(_plate(*(_cylinder(6.0, 12.0, at) for at in places)))
    noted = NotedHole(Role.TOP, (8.0, 8.0), (HoleStep(6.0),), "3x Ø6 THRU")
    (row,) = tally(part, [noted])
    assert (row.count_found, row.count_stated, row.count_otherwise) == (found, 3, 0)
    assert row.agrees == (drilled >= 3)
