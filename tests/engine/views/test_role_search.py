"""Where views look from: extents are a must, all else adds to the odds."""

import itertools

import pytest
from engine.recognition.labels_of_files import reading_of

from gaussiancad_core.files.vectors import StrokeRole, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.recognition.stroke_reading import StrokeReading
from gaussiancad_core.views.drawn_groups import DrawingKind
from gaussiancad_core.views.role_search import Placed, arranged_views, shown_axes

Place = tuple[float, float]


def _closed(*corners: Place) -> list[VectorStroke]:
    return [
        VectorStroke(LineSegment(a, b), 4.0) for a, b in itertools.pairwise([*corners, corners[0]])
    ]


def _box(x: float, y: float, w: float, h: float) -> list[VectorStroke]:
    return _closed((x, y), (x + w, y), (x + w, y + h), (x, y + h))


def _line(start: Place, end: Place, *, hidden: bool = False) -> VectorStroke:
    if hidden:
        return VectorStroke(LineSegment(start, end), 2.0, (8.0, 4.0), StrokeRole.HIDDEN)
    return VectorStroke(LineSegment(start, end), 4.0)


def _front(x: float, y: float) -> list[VectorStroke]:
    """An L of 240 x 120 px, 40 px high on its right."""
    places = (0, 0), (100, 0), (100, 80), (240, 80), (240, 120), (0, 120)
    return _closed(*((x + dx, y + dy) for dx, dy in places))


def _side(x: float, y: float, *, hidden: bool) -> list[VectorStroke]:
    """The L from its side, 160 px wide: the step is seen from where it is open."""
    return [*_box(x, y, 160, 120), _line((x, y + 80), (x + 160, y + 80), hidden=hidden)]


def _plan(x: float, y: float) -> list[VectorStroke]:
    return [*_box(x, y, 240, 160), _line((x + 100, y), (x + 100, y + 160))]


def _roles(reading: StrokeReading, scale: float) -> dict[tuple[int, int], Placed]:
    """The place of each view that has a role, px of its box's corner."""
    assert reading.ranking is not None
    return {
        (round(reading.views[n].box[0] * scale), round(reading.views[n].box[1] * scale)): placed
        for n, placed in reading.ranking.best.placed.items()
    }


@pytest.mark.parametrize(
    ("hidden", "projection", "role"),
    [(False, Projection.THIRD, Role.RIGHT), (True, Projection.FIRST, Role.LEFT)],
)
def test_a_step_that_only_one_side_sees_tells_the_projection(
    hidden: bool, projection: Projection, role: Role
) -> None:
    reading, scale = reading_of([*_front(200, 300), *_side(560, 300, hidden=hidden)])
    assert _roles(reading, scale) == {(200, 300): Placed(Role.FRONT), (560, 300): Placed(role)}
    assert reading.ranking is not None
    assert reading.ranking.best.projection is projection
    assert reading.ranking.other_projection > 1.0


def test_it_overrules_what_is_said_with_less_weight() -> None:
    reading, _ = reading_of([*_front(200, 300), *_side(560, 300, hidden=True)])
    said = arranged_views(reading.views, third_angle=1.0)
    assert said is not None
    assert said.best.projection is Projection.FIRST


def test_a_view_out_of_line_has_its_role_by_extents_and_levels() -> None:
    strokes = [*_front(200, 300), *_plan(200, 80), *_side(620, 500, hidden=False)]
    reading, scale = reading_of(strokes)
    assert {place: placed.role for place, placed in _roles(reading, scale).items()} == {
        (200, 300): Role.FRONT,
        (200, 80): Role.TOP,
        (620, 500): Role.RIGHT,
    }


def test_views_that_are_not_as_long_as_each_other_show_no_common_axis() -> None:
    reading, scale = reading_of([*_front(200, 300), *_box(560, 300, 160, 110)])
    assert len(_roles(reading, scale)) == 1


def test_a_block_with_nothing_on_it_leaves_the_projection_open() -> None:
    reading, _ = reading_of([*_box(200, 300, 240, 120), *_box(560, 300, 160, 120)])
    assert reading.ranking is not None
    assert reading.ranking.other_projection < 1.0


def test_a_role_that_somebody_gave_holds() -> None:
    reading, scale = reading_of([*_front(200, 300), *_side(560, 300, hidden=False)])
    (number,) = (n for n, view in enumerate(reading.views) if view.box[0] * scale > 500)
    found = arranged_views(reading.views, fixed={number: Role.FRONT})
    assert found is not None
    assert found.best.placed[number] == Placed(Role.FRONT)


def test_a_section_stands_for_no_view_where_a_plain_one_looks_along_its_axis() -> None:
    hatching = [_line((620.0 + x, 420.0), (660.0 + x, 380.0)) for x in range(0, 176, 16)]
    hatching = [VectorStroke(stroke.curve, 1.0) for stroke in hatching]
    plan, section = _plan(200, 80), [*_front(600, 300), *hatching]
    reading, scale = reading_of([*_front(200, 300), *plan, *section])
    assert (600, 300) not in _roles(reading, scale)
    assert DrawingKind.SECTION in {view.kind for view in reading.views}


@pytest.mark.parametrize("role", Role)
def test_four_quarter_turns_are_none(role: Role) -> None:
    assert shown_axes(Placed(role, 4)) == shown_axes(Placed(role))
    (across, way), (down, up) = shown_axes(Placed(role))
    turned = shown_axes(Placed(role, 1))
    assert turned == ((down, up), (across, -way))
