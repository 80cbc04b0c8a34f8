"""Which drawing is which view: told by places, by extents, and by lines at the same places."""

import pytest
from engine.views.plain_views import drawn

from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView
from gaussiancad_core.views.role_search import arranged_views

WIDE, DEEP, HIGH = 75.0, 30.0, 50.0
"""mm of the part."""

ACROSS, AWAY, UP = (20.0, 47.5), (11.0,), (15.0, 32.5)
"""mm of its edges along its axes, from its left, its front, and its top."""

BACK = tuple(DEEP - item for item in AWAY)
"""The same from its back."""

THIRD, FIRST = 1e3, -1e3


def front(kind: DrawingKind = DrawingKind.PLAIN) -> DrawnView:
    return drawn((25, 75), (WIDE, HIGH), ACROSS, UP, kind=kind)


def roles(*views: DrawnView, third: float = 0.0) -> dict[Role, DrawnView]:
    ranking = arranged_views(views, third)
    assert ranking is not None
    assert not any(placed.turn for placed in ranking.best.placed.values())
    return {placed.role: views[number] for number, placed in ranking.best.placed.items()}


@pytest.mark.parametrize("projection", list(Projection))
def test_a_side_view_that_was_dragged_up_is_one(projection: Projection) -> None:
    above = 37 if projection is Projection.THIRD else 150
    views = front(), drawn((25, above), (WIDE, DEEP), ACROSS, BACK)
    is_third = projection is Projection.THIRD
    # What is near lies to the left of a right view, and to the right of a left view.
    side = drawn((175, 42), (DEEP, HIGH), AWAY if is_third else BACK, UP)
    found = roles(*views, side, third=THIRD if is_third else FIRST)
    wanted = Role.RIGHT if is_third else Role.LEFT
    assert found == {Role.FRONT: views[0], Role.TOP: views[1], wanted: side}


def test_the_rear_view_has_its_lines_the_other_way_round() -> None:
    views = front(), drawn((25, 37), (WIDE, DEEP), ACROSS, BACK)
    rear = drawn((200, 25), (WIDE, HIGH), [WIDE - item for item in ACROSS], UP)
    assert roles(*views, rear)[Role.REAR] is rear


def test_two_drawings_of_other_parts_do_not_belong_together() -> None:
    views = front(), drawn((175, 10), (WIDE + 7.5, DEEP), (30.0,), AWAY)
    assert len(roles(*views)) == 1


def test_traced_views_may_differ_by_a_pixel_or_two_and_no_more() -> None:
    for more, count in ((0.5, 2), (2.5, 1)):
        top = drawn((25, 37), (WIDE + more, DEEP), ACROSS, AWAY, rough=0.5)
        assert len(roles(front(), top)) == count


def test_a_section_stands_for_the_view_between_two_others() -> None:
    cut = front(DrawingKind.SECTION)
    above = drawn((25, 25), (WIDE, DEEP), ACROSS, BACK)
    below = drawn((25, 150), (WIDE, DEEP), ACROSS, AWAY)
    found = roles(cut, above, below, third=THIRD)
    assert found == {Role.FRONT: cut, Role.TOP: above, Role.BOTTOM: below}


def test_a_section_stands_for_no_view_whose_direction_another_one_has() -> None:
    views = front(), drawn((125, 75), (DEEP, HIGH), AWAY, UP)
    cut = drawn((170, 75), (DEEP, HIGH), AWAY, UP, kind=DrawingKind.SECTION)
    assert roles(*views, cut, third=THIRD) == {Role.FRONT: views[0], Role.RIGHT: views[1]}


def test_all_drawings_around_an_edge_view_are_its_views() -> None:
    edge = drawn((25, 100), (WIDE, DEEP), ACROSS, BACK)
    above = drawn((25, 25), (WIDE, HIGH), ACROSS, UP)
    below = drawn((25, 150), (WIDE, HIGH), ACROSS, [HIGH - item for item in UP])
    assert roles(above, below, edge) == {Role.FRONT: edge, Role.TOP: above, Role.BOTTOM: below}


def test_left_and_right_views_that_mirror_each_other_are_no_front_and_rear() -> None:
    views = (
        drawn((75, 75), (WIDE, HIGH), ACROSS, UP),
        drawn((75, 25), (WIDE, DEEP), ACROSS, BACK),
    )
    right = drawn((162, 75), (DEEP, HIGH), (5, 11, 17.5), (5, *UP))
    left = drawn((25, 75), (DEEP, HIGH), (12.5, 19, 25), (5, *UP))
    found = roles(*views, right, left, third=THIRD)
    assert found == {
        Role.FRONT: views[0],
        Role.TOP: views[1],
        Role.RIGHT: right,
        Role.LEFT: left,
    }


def test_a_section_between_a_view_and_its_plan_is_not_the_plan() -> None:
    views = front(), drawn((25, 175), (WIDE, DEEP), ACROSS, BACK)
    between = drawn((25, 135), (WIDE, DEEP), (10, *ACROSS), AWAY, kind=DrawingKind.SECTION)
    assert roles(*views, between, third=FIRST) == {Role.FRONT: views[0], Role.TOP: views[1]}


def test_a_section_beside_the_views_makes_no_rear_view_of_the_front_view() -> None:
    views = (
        front(),
        drawn((25, 25), (WIDE, DEEP), ACROSS, BACK),
        drawn((112, 75), (DEEP, HIGH), AWAY, UP),
    )
    neighbour = drawn((155, 75), (WIDE, HIGH), ACROSS, UP, kind=DrawingKind.SECTION)
    found = roles(*views, neighbour)
    assert found == {Role.FRONT: views[0], Role.TOP: views[1], Role.RIGHT: views[2]}
