"""Which drawing is which view: told by places, by extents, and by lines at the same places."""

from collections.abc import Sequence

import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.views.role_score import Drawings, arrange

WIDE, DEEP, HIGH = 300, 120, 200
"""px of the part."""

ACROSS, AWAY, UP = (80, 190), (45,), (60, 130)
"""px of its edges along its axes, from its left, its front, and its top."""


def drawn(
    ink: np.ndarray, at: tuple[int, int], size: tuple[int, int], *edges: Sequence[int]
) -> Box:
    """Draw a view: its outline, upright lines, level lines."""
    (x, y), (width, height), (upright, level) = at, size, edges
    for column in (0, width - 1, *upright):
        ink[y : y + height, x + column] = True
    for row in (0, height - 1, *level):
        ink[y + row, x : x + width] = True
    return float(x), float(y), float(x + width), float(y + height)


def front(ink: np.ndarray) -> Box:
    return drawn(ink, (100, 300), (WIDE, HIGH), ACROSS, UP)


def sheet() -> np.ndarray:
    return np.zeros((900, 1200), dtype=bool)


def roles(ink: np.ndarray, *boxes: Box, projection: Projection | None = None) -> dict[Role, Box]:
    return arrange(Drawings(boxes, ink), {}, projection).boxes


@pytest.mark.parametrize("projection", list(Projection))
def test_a_side_view_that_was_dragged_up_is_one(projection: Projection) -> None:
    ink = sheet()
    above = 150 if projection is Projection.THIRD else 600
    views = front(ink), drawn(ink, (100, above), (WIDE, DEEP), ACROSS, AWAY)
    side = drawn(ink, (700, 170), (DEEP, HIGH), AWAY, UP)
    role = Role.RIGHT if projection is Projection.THIRD else Role.LEFT
    found = roles(ink, *views, side, projection=projection)
    assert found[Role.FRONT] == views[0] and found[role] == side
    assert len(found) == 3


def test_a_loose_view_below_is_the_top_view_in_first_angle() -> None:
    ink = sheet()
    views = front(ink), drawn(ink, (600, 300), (DEEP, HIGH), AWAY, UP)
    below = drawn(ink, (180, 600), (WIDE, DEEP), ACROSS, AWAY)
    found = arrange(Drawings([*views, below], ink), {}, None)
    assert found.boxes == {Role.FRONT: views[0], Role.LEFT: views[1], Role.TOP: below}
    assert (found.projection, found.source) == (Projection.FIRST, "default")
    assert found.alternatives == (Projection.THIRD,)


def test_a_drawing_as_high_with_its_lines_elsewhere_is_none() -> None:
    ink = sheet()
    views = front(ink), drawn(ink, (100, 150), (WIDE, DEEP), ACROSS, AWAY)
    other = drawn(ink, (700, 170), (DEEP, HIGH), (), (25, 95))
    assert set(roles(ink, *views, other, projection=Projection.THIRD)) == {Role.FRONT, Role.TOP}


def test_one_extent_without_any_line_is_no_witness() -> None:
    ink = sheet()
    views = front(ink), drawn(ink, (100, 150), (WIDE, DEEP), ACROSS, AWAY)
    plain = drawn(ink, (700, 170), (77, HIGH), (), ())
    assert plain not in roles(ink, *views, plain).values()


def test_the_rear_view_has_its_lines_the_other_way_round() -> None:
    ink = sheet()
    views = front(ink), drawn(ink, (100, 150), (WIDE, DEEP), ACROSS, AWAY)
    turned = [WIDE - 1 - item for item in ACROSS]
    rear = drawn(ink, (800, 100), (WIDE, HIGH), turned, UP)
    assert roles(ink, *views, rear)[Role.REAR] == rear


def test_two_views_that_stand_anywhere_belong_together() -> None:
    ink = sheet()
    views = front(ink), drawn(ink, (700, 40), (WIDE, DEEP), ACROSS, AWAY)
    assert roles(ink, *views) == {Role.FRONT: views[0], Role.TOP: views[1]}


def test_where_nothing_is_in_line_all_drawings_belong_together_or_none() -> None:
    ink = sheet()
    views = front(ink), drawn(ink, (700, 40), (WIDE, DEEP), ACROSS, AWAY)
    other = drawn(ink, (700, 600), (150, 90), (40,), ())
    with pytest.raises(NoModelError):
        roles(ink, *views, other)


def test_two_drawings_of_other_parts_do_not() -> None:
    ink = sheet()
    views = front(ink), drawn(ink, (700, 40), (WIDE + 30, DEEP), (120,), AWAY)
    with pytest.raises(NoModelError) as caught:
        roles(ink, *views)
    assert caught.value.code == "views-not-aligned"


def test_a_section_stands_for_the_view_between_two_others() -> None:
    ink = sheet()
    cut = front(ink)
    above = drawn(ink, (100, 100), (WIDE, DEEP), ACROSS, AWAY)
    below = drawn(ink, (100, 600), (WIDE, DEEP), ACROSS, [DEEP - 1 - item for item in AWAY])
    found = arrange(Drawings([cut, above, below], ink, {cut}), {}, Projection.THIRD)
    assert found.boxes == {Role.FRONT: cut, Role.TOP: above, Role.BOTTOM: below}


@pytest.mark.parametrize("is_cut", [False, True])
def test_a_section_stands_for_no_view_whose_direction_another_one_has(is_cut: bool) -> None:
    ink = sheet()
    views = front(ink), drawn(ink, (500, 300), (DEEP, HIGH), AWAY, UP)
    left = drawn(ink, (680, 300), (DEEP, HIGH), AWAY, UP)
    drawings = Drawings([*views, left], ink, {left} if is_cut else ())
    found = arrange(drawings, {}, Projection.THIRD)
    assert found.boxes[Role.FRONT] == views[0] and found.boxes[Role.RIGHT] == views[1]
    assert left not in found.boxes.values() or not is_cut


def test_all_drawings_around_an_edge_view_are_its_views() -> None:
    ink = sheet()
    edge = drawn(ink, (100, 400), (WIDE, DEEP), ACROSS, AWAY)
    above = drawn(ink, (100, 100), (WIDE, HIGH), ACROSS, UP)
    below = drawn(ink, (100, 600), (WIDE, HIGH), ACROSS, [HIGH - 1 - item for item in UP])
    assert roles(ink, above, below, edge) == {
        Role.FRONT: edge,
        Role.TOP: above,
        Role.BOTTOM: below,
    }


def test_left_and_right_views_that_mirror_each_other_are_no_front_and_rear() -> None:
    ink = sheet()
    views = (
        drawn(ink, (300, 300), (WIDE, HIGH), ACROSS, UP),
        drawn(ink, (300, 100), (WIDE, DEEP), ACROSS, AWAY),
    )
    right = drawn(ink, (650, 300), (DEEP, HIGH), (20, 45, 70), (20, *UP))
    left = drawn(ink, (100, 300), (DEEP, HIGH), (49, 74, 99), (20, *UP))
    assert roles(ink, *views, right, left, projection=Projection.THIRD) == {
        Role.FRONT: views[0],
        Role.TOP: views[1],
        Role.RIGHT: right,
        Role.LEFT: left,
    }


def test_of_two_ways_to_leave_one_drawing_out_the_one_with_three_directions_counts() -> None:
    """Two edge views above and below a plan, and a side view beside the lower one."""
    ink = sheet()
    plan = drawn(ink, (100, 250), (WIDE, HIGH), ACROSS, UP)
    above = drawn(ink, (100, 80), (WIDE, DEEP), ACROSS, AWAY)
    below = drawn(ink, (100, 500), (WIDE, DEEP), ACROSS, AWAY)
    side = drawn(ink, (450, 500), (HIGH, DEEP), [HIGH - 1 - item for item in UP], AWAY)
    found = roles(ink, plan, above, below, side, projection=Projection.THIRD)
    assert found == {Role.FRONT: below, Role.TOP: plan, Role.RIGHT: side}


def test_a_section_between_a_view_and_its_plan_is_not_the_plan() -> None:
    ink = sheet()
    views = front(ink), drawn(ink, (100, 700), (WIDE, DEEP), ACROSS, AWAY)
    between = drawn(ink, (100, 540), (WIDE, DEEP), (40, *ACROSS), AWAY)
    found = arrange(Drawings([*views, between], ink, {between}), {}, Projection.FIRST)
    assert found.boxes == {Role.FRONT: views[0], Role.TOP: views[1]}


def test_a_section_beside_the_views_makes_no_rear_view_of_the_front_view() -> None:
    ink = sheet()
    views = (
        front(ink),
        drawn(ink, (100, 100), (WIDE, DEEP), ACROSS, AWAY),
        drawn(ink, (450, 300), (DEEP, HIGH), AWAY, UP),
    )
    neighbour = drawn(ink, (620, 300), (WIDE, HIGH), ACROSS, UP)
    found = arrange(Drawings([*views, neighbour], ink, {neighbour}), {}, None)
    assert found.boxes == {Role.FRONT: views[0], Role.TOP: views[1], Role.RIGHT: views[2]}
    assert found.left_out == (neighbour,)
