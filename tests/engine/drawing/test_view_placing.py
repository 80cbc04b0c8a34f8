from itertools import combinations, permutations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.drawing.view_placing import check_roles, place_views
from gaussiancad_core.errors import UsageError
from gaussiancad_core.model.axes import Projection, Role

SIZE = np.array([80.0, 50.0, 60.0])
FRONT, TOP, RIGHT, LEFT, BOTTOM, REAR = (
    Role.FRONT,
    Role.TOP,
    Role.RIGHT,
    Role.LEFT,
    Role.BOTTOM,
    Role.REAR,
)
STYLE = SheetStyle()


def _boxes(
    roles: tuple[Role, ...], projection: Projection
) -> dict[Role, tuple[float, float, float, float]]:
    return {place.role: place.box for place in place_views(SIZE, roles, projection, STYLE)}


@pytest.mark.parametrize(
    ("projection", "above", "role"),
    [(Projection.THIRD, TOP, RIGHT), (Projection.FIRST, BOTTOM, LEFT)],
)
def test_what_stands_above_and_right_of_the_front_view(
    projection: Projection, above: Role, role: Role
) -> None:
    boxes = _boxes((FRONT, above, role), projection)
    front = boxes[FRONT]
    assert boxes[above][3] < front[1]
    assert boxes[role][0] > front[2]
    assert (boxes[above][0], boxes[above][2]) == (front[0], front[2])
    assert (boxes[role][1], boxes[role][3]) == (front[1], front[3])


@pytest.mark.parametrize(
    ("projection", "below", "role"),
    [(Projection.FIRST, TOP, RIGHT), (Projection.THIRD, BOTTOM, LEFT)],
)
def test_what_stands_below_and_left_of_the_front_view(
    projection: Projection, below: Role, role: Role
) -> None:
    boxes = _boxes((FRONT, below, role), projection)
    assert boxes[below][1] > boxes[FRONT][3]
    assert boxes[role][2] < boxes[FRONT][0]


@pytest.mark.parametrize("projection", Projection)
def test_the_rear_view_stands_at_the_far_right(projection: Projection) -> None:
    boxes = _boxes(tuple(Role), projection)
    assert boxes[REAR][0] > max(box[2] for role, box in boxes.items() if role is not REAR)


@given(
    st.tuples(*[st.floats(0.5, 500.0)] * 3),
    st.sets(st.sampled_from(Role), min_size=2),
    st.sampled_from(Projection),
)
def test_any_set_of_views_is_centred_fills_the_sheet_and_lines_up(
    size: tuple[float, float, float], chosen: set[Role], projection: Projection
) -> None:
    roles = tuple(sorted(chosen, key=lambda role: role.value))
    try:
        places = place_views(np.array(size), roles, projection, STYLE)
    except UsageError as error:
        assert error.code == "sheet-too-small"
        return
    boxes = np.array([place.box for place in places])
    low, high = boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)
    np.testing.assert_allclose(low + high, [STYLE.width, STYLE.height])
    slack = low - STYLE.margin
    assert np.all(slack >= -1e-6)
    assert slack.min() < 1e-6
    for one, other in combinations(places, 2):
        same = [
            a == b
            for a, b in zip(one.role.slot(projection), other.role.slot(projection), strict=True)
        ]
        if same[0]:
            assert (one.box[0], one.box[2]) == (other.box[0], other.box[2])
        if same[1]:
            assert (one.box[1], one.box[3]) == (other.box[1], other.box[3])
        apart = max(
            max(one.box[k], other.box[k]) - min(one.box[k + 2], other.box[k + 2]) for k in (0, 1)
        )
        assert apart >= STYLE.view_gap - 1e-6


@pytest.mark.parametrize("role", Role)
def test_the_offset_maps_the_part_into_its_box(role: Role) -> None:
    other = FRONT if role is not FRONT else TOP
    place = next(
        p for p in place_views(SIZE, (role, other), Projection.THIRD, STYLE) if p.role is role
    )
    corners = np.array([(x, y, z) for x in (0, 80) for y in (0, 50) for z in (0, 60)])
    plane = corners @ np.array([role.frame.right, role.frame.up]).T
    px = np.array(place.offset) + place.scale * plane * [1.0, -1.0]
    np.testing.assert_allclose([*px.min(axis=0), *px.max(axis=0)], place.box, atol=1e-9)


def test_a_given_scale_is_kept() -> None:
    style = SheetStyle(mm_per_pixel=0.25)
    place = place_views(SIZE, (FRONT, TOP), Projection.THIRD, style)[0]
    assert place.scale == 4.0
    assert place.box[2] - place.box[0] == pytest.approx(320.0)


@pytest.mark.parametrize(
    "style", [SheetStyle(mm_per_pixel=0.01), SheetStyle(width=100, height=100)]
)
def test_views_that_do_not_fit_are_told(style: SheetStyle) -> None:
    with pytest.raises(UsageError) as caught:
        place_views(SIZE, (FRONT, TOP), Projection.THIRD, style)
    assert caught.value.code == "sheet-too-small"


@pytest.mark.parametrize(
    ("roles", "code"),
    [
        ((FRONT,), "views-count"),
        ((), "views-count"),
        ((FRONT, TOP, FRONT), "views-repeat"),
    ],
)
def test_impossible_sets_of_views_are_told(roles: tuple[Role, ...], code: str) -> None:
    with pytest.raises(UsageError) as caught:
        place_views(SIZE, roles, Projection.THIRD, STYLE)
    assert caught.value.code == code


def test_the_order_of_the_roles_does_not_matter() -> None:
    for order in permutations((FRONT, TOP, LEFT)):
        check_roles(order)
        assert _boxes(order, Projection.FIRST) == _boxes((FRONT, TOP, LEFT), Projection.FIRST)


@pytest.mark.parametrize("projection", list(Projection))
@pytest.mark.parametrize("corner", [(0.0, 0.0), (300.0, 200.0), (700.0, 500.0), (1000.0, 150.0)])
def test_no_view_enters_the_corner_that_stays_free(
    projection: Projection, corner: tuple[float, float]
) -> None:
    free = place_views(SIZE, (FRONT, TOP, RIGHT), projection, STYLE)
    kept = place_views(SIZE, (FRONT, TOP, RIGHT), projection, STYLE, corner)
    left, top = STYLE.width - corner[0], STYLE.height - corner[1]
    for place in kept:
        assert place.box[2] <= left + 1e-9 or place.box[3] <= top + 1e-9
        assert min(place.box) >= STYLE.margin - 1e-9
    if not any(place.box[2] > left and place.box[3] > top for place in free):
        assert kept == free
    assert kept[0].scale <= free[0].scale


def test_a_corner_that_leaves_no_room_is_told() -> None:
    with pytest.raises(UsageError) as caught:
        place_views(SIZE, (FRONT, TOP, RIGHT), Projection.THIRD, STYLE, (1900.0, 1070.0))
    assert caught.value.code == "sheet-too-small"
    assert "1920 x 1080" in caught.value.message
