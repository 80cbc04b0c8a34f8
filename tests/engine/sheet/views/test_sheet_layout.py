import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError, UsageError
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.views import sheet_layout
from gaussiancad_core.sheet.views.role_score import Drawings, arrange
from gaussiancad_core.sheet.views.sheet_layout import Box, Layout, find_clusters, view_clusters


def _sheet(*boxes: tuple[int, int, int, int]) -> np.ndarray:
    ink = np.zeros((700, 1000), bool)
    for x0, y0, x1, y1 in boxes:
        ink[y0 : y1 + 1, [x0, x1]] = True
        ink[[y0, y1], x0 : x1 + 1] = True
    return ink


def _layout(ink: np.ndarray, given: dict[Role, Box], projection: Projection | None) -> Layout:
    return arrange(Drawings(view_clusters(ink, 0.0), ink), given, projection)


FRONT = (300, 300, 500, 400)
ABOVE = (300, 100, 500, 250)
BELOW = (300, 450, 500, 600)
RIGHT = (560, 300, 710, 400)
LEFT = (100, 300, 250, 400)


def _close(box: Box, expected: tuple[int, int, int, int]) -> bool:
    return bool(np.abs(np.array(box) - np.array(expected)).max() <= 1)


@pytest.mark.parametrize(
    ("boxes", "projection", "expected"),
    [
        ((FRONT, ABOVE, RIGHT), Projection.THIRD, {Role.TOP: ABOVE, Role.RIGHT: RIGHT}),
        ((FRONT, BELOW, RIGHT), Projection.FIRST, {Role.TOP: BELOW, Role.LEFT: RIGHT}),
        ((FRONT, BELOW, LEFT), Projection.THIRD, {Role.BOTTOM: BELOW, Role.LEFT: LEFT}),
        (
            (LEFT, RIGHT, FRONT, ABOVE, BELOW),
            Projection.THIRD,
            {Role.LEFT: LEFT, Role.RIGHT: RIGHT, Role.TOP: ABOVE, Role.BOTTOM: BELOW},
        ),
    ],
)
def test_roles_follow_from_place_and_projection(
    boxes: tuple, projection: Projection, expected: dict
) -> None:
    found = _layout(_sheet(*boxes), {}, projection)
    wanted = {Role.FRONT: FRONT, **expected}
    assert set(found.boxes) == set(wanted)
    assert all(_close(found.boxes[role], box) for role, box in wanted.items())
    assert (found.source, found.alternatives) == ("given", ())


@pytest.mark.parametrize(
    ("boxes", "expected", "projection"),
    [
        ((FRONT, ABOVE, RIGHT), {Role.TOP: ABOVE, Role.RIGHT: RIGHT}, Projection.THIRD),
        ((FRONT, ABOVE), {Role.TOP: ABOVE}, Projection.THIRD),
        ((FRONT, RIGHT), {Role.RIGHT: RIGHT}, Projection.THIRD),
        # A view below is from above where nobody tells the projection.
        ((FRONT, BELOW, RIGHT), {Role.TOP: BELOW, Role.LEFT: RIGHT}, Projection.FIRST),
        ((FRONT, BELOW, LEFT), {Role.TOP: BELOW, Role.RIGHT: LEFT}, Projection.FIRST),
    ],
)
def test_where_nobody_tells_the_projection_the_other_one_fits_as_well(
    boxes: tuple, expected: dict, projection: Projection
) -> None:
    found = _layout(_sheet(*boxes), {}, None)
    wanted = {Role.FRONT: FRONT, **expected}
    assert set(found.boxes) == set(wanted)
    assert all(_close(found.boxes[role], box) for role, box in wanted.items())
    assert (found.projection, found.source) == (projection, "default")
    assert found.alternatives == (projection.other,)


def test_views_from_above_and_below_tell_no_projection() -> None:
    found = _layout(_sheet(FRONT, ABOVE, BELOW, RIGHT), {}, None)
    assert found.projection is Projection.THIRD


def test_strokes_inside_a_view_belong_to_it() -> None:
    ink = _sheet(FRONT, ABOVE, RIGHT, (350, 330, 420, 370))
    assert len(_layout(ink, {}, None).boxes) == 3
    assert not _layout(ink, {}, None).left_out


def test_a_frame_around_the_views_is_none() -> None:
    sheet_layout = _layout(_sheet(FRONT, ABOVE, RIGHT, (10, 10, 990, 690)), {}, None)
    assert _close(sheet_layout.boxes[Role.FRONT], FRONT)
    assert len(sheet_layout.boxes) == 3


def test_in_free_space_what_goes_around_all_is_an_outline() -> None:
    around, holes = (10, 10, 990, 690), ((100, 100, 160, 160), (800, 100, 860, 160))
    ink = _sheet(around, *holes)
    (box,) = find_clusters(ink, has_paper=False)
    assert _close(box, around)
    assert all(
        any(_close(find_cluster, hole) for hole in holes) for find_cluster in find_clusters(ink)
    )


def test_other_lines_are_left_out_and_told() -> None:
    sheet_layout = _layout(_sheet(FRONT, ABOVE, RIGHT, (800, 500, 960, 560)), {}, None)
    assert len(sheet_layout.boxes) == 3
    assert len(sheet_layout.left_out) == 1 and _close(
        sheet_layout.left_out[0], (800, 500, 960, 560)
    )


def test_boxes_name_views_wherever_they_stand() -> None:
    given = {Role.REAR: (290, 290, 510, 410), Role.LEFT: (550, 290, 720, 410)}
    sheet_layout = _layout(_sheet(FRONT, RIGHT, ABOVE), given, None)
    assert set(sheet_layout.boxes) == {Role.REAR, Role.LEFT}
    assert _close(sheet_layout.boxes[Role.REAR], FRONT)
    with pytest.raises(UsageError) as caught:
        _layout(_sheet(FRONT, RIGHT), {Role.TOP: (0, 0, 50, 50)}, None)
    assert caught.value.code == "empty-view-box"


@pytest.mark.parametrize(
    ("boxes", "code"),
    [
        ((), "no-views"),
        ((FRONT,), "one-view"),
        ((FRONT, (600, 420, 800, 600)), "views-not-aligned"),
    ],
)
def test_what_is_no_arrangement_of_views(boxes: tuple, code: str) -> None:
    with pytest.raises(NoModelError) as caught:
        _layout(_sheet(*boxes), {}, None)
    assert caught.value.code == code


@pytest.mark.parametrize(("short", "joined"), [(5, True), (9, True), (20, False)])
def test_a_side_that_ends_short_of_all_others_belongs_to_its_view(short: int, joined: bool) -> None:
    ink = _sheet(ABOVE, RIGHT)
    x0, y0, x1, y1 = FRONT
    ink[y0 : y1 + 1, x0] = True
    ink[[y0, y1], x0 : x1 - short] = True
    ink[y0 + short : y1 - short, x1] = True
    sheet_layout = _layout(ink, {}, Projection.THIRD)
    assert (
        Role.FRONT in sheet_layout.boxes and _close(sheet_layout.boxes[Role.FRONT], FRONT)
    ) is joined


def test_a_line_beside_an_edge_is_no_side_of_the_view() -> None:
    ink = _sheet(FRONT, ABOVE, RIGHT)
    x0, y0, _, y1 = FRONT
    ink[y0 + 5 : y1 - 5, x0 - 10] = True
    sheet_layout = _layout(ink, {}, Projection.THIRD)
    assert _close(sheet_layout.boxes[Role.FRONT], FRONT)


def _overlap(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def test_boxes_are_united_until_none_overlaps_another() -> None:
    lot = np.random.default_rng(0)
    corners = lot.integers(0, 300, (300, 2)).astype(float)
    sizes = lot.integers(1, 12, (300, 2))
    boxes = [(x, y, x + w, y + h) for (x, y), (w, h) in zip(corners, sizes, strict=True)]
    united = sheet_layout._merge_overlapping(boxes)
    pairs = [(a, b) for a in united for b in united if a is not b]
    assert not any(_overlap(a, b) for a, b in pairs)
    assert all(any(sheet_layout._contains(item, box) for item in united) for box in boxes)
    assert 10 < len(united) < 300
    assert sheet_layout._merge_overlapping([]) == []
