"""Views out of line: told by extents, and by lines at the same places."""

from collections.abc import Sequence

import numpy as np
import pytest

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.sheet.arranging import Drawings, arrange
from gaussiancad_core.sheet.options import Box

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
    turned = [WIDE - 1 - own for own in ACROSS]
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
