"""Which drawings of a picture are its views, where nothing is known of them but their ink."""

from pathlib import Path

import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError, UsageError
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.recognition.picture_layout import Stated, _upright, picture_layout
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.labels.labelled_ink import separate_by_labels
from gaussiancad_core.sheet.labels.plain_labels import plain_labels
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.views.role_search import Arrangement, Placed, Ranking

Corners = tuple[int, int, int, int]

FRONT, ABOVE, BELOW = (300, 300, 500, 400), (300, 100, 500, 250), (300, 450, 500, 600)
RIGHT, LEFT = (560, 300, 710, 400), (100, 300, 250, 400)


def _opened(*boxes: Corners) -> OpenedSheet:
    grey = np.full((700, 1000), 255, np.uint8)
    for x0, y0, x1, y1 in boxes:
        for x in (x0, x1):
            grey[y0 - 1 : y1 + 2, x - 1 : x + 2] = 0
        for y in (y0, y1):
            grey[y - 1 : y + 2, x0 - 1 : x1 + 2] = 0
    return OpenedSheet(SheetImage(Path("sheet.png"), grey, ""), 0)


def _layout(
    *boxes: Corners,
    given: dict[Role, Box] | None = None,
    projection: Projection | None = None,
) -> Layout:
    sheet = _opened(*boxes)
    separated = SeparatedSheet(sheet.clean, ())
    return picture_layout(sheet, separated, Stated(given or {}, projection))[1]


def _shows(layout: Layout, expected: dict[Role, Corners]) -> bool:
    return set(layout.boxes) == set(expected) and all(
        np.abs(np.subtract(layout.boxes[role], box)).max() <= 3 for role, box in expected.items()
    )


@pytest.mark.parametrize(
    ("boxes", "projection", "expected"),
    [
        ((FRONT, ABOVE, RIGHT), Projection.THIRD, {Role.TOP: ABOVE, Role.RIGHT: RIGHT}),
        ((FRONT, BELOW, RIGHT), Projection.FIRST, {Role.TOP: BELOW, Role.LEFT: RIGHT}),
        ((FRONT, BELOW, LEFT), Projection.THIRD, {Role.BOTTOM: BELOW, Role.LEFT: LEFT}),
    ],
)
def test_roles_follow_from_place_and_projection(
    boxes: tuple[Corners, ...], projection: Projection, expected: dict[Role, Corners]
) -> None:
    found = _layout(*boxes, projection=projection)
    assert _shows(found, {Role.FRONT: FRONT, **expected})
    assert (found.source, found.alternatives) == ("given", ())


@pytest.mark.parametrize(
    ("boxes", "expected", "projection"),
    [
        ((FRONT, ABOVE, RIGHT), {Role.TOP: ABOVE, Role.RIGHT: RIGHT}, Projection.THIRD),
        ((FRONT, BELOW, RIGHT), {Role.TOP: BELOW, Role.LEFT: RIGHT}, Projection.FIRST),
    ],
)
def test_where_nobody_tells_the_projection_the_other_one_fits_as_well(
    boxes: tuple[Corners, ...], expected: dict[Role, Corners], projection: Projection
) -> None:
    found = _layout(*boxes)
    assert _shows(found, {Role.FRONT: FRONT, **expected})
    assert (found.projection, found.source) == (projection, "default")
    assert found.alternatives == (projection.other,)


def test_other_lines_are_left_out_and_told() -> None:
    found = _layout(FRONT, ABOVE, RIGHT, (800, 500, 970, 540))
    assert len(found.boxes) == 3 and len(found.left_out) == 1


def test_boxes_name_views_wherever_they_stand() -> None:
    given = {Role.REAR: (290.0, 290.0, 510.0, 410.0), Role.LEFT: (550.0, 290.0, 720.0, 410.0)}
    assert _shows(_layout(FRONT, RIGHT, ABOVE, given=given), {Role.REAR: FRONT, Role.LEFT: RIGHT})
    with pytest.raises(UsageError) as caught:
        _layout(FRONT, RIGHT, given={Role.TOP: (0.0, 0.0, 50.0, 50.0)})
    assert caught.value.code == "empty-view-box"


def test_one_view_alone_is_called_the_front_view() -> None:
    assert _shows(_layout(FRONT), {Role.FRONT: FRONT})


def test_drawings_apart_are_no_arrangement_of_views() -> None:
    with pytest.raises(NoModelError) as caught:
        _layout(FRONT, (600, 420, 800, 600))
    assert caught.value.code == "views-not-aligned"


def test_slivers_beside_a_large_drawing_are_no_views() -> None:
    slivers = (700, 180, 714, 240), (700, 300, 714, 400)
    with pytest.raises(NoModelError) as caught:
        _layout((90, 140, 420, 460), *slivers)
    assert caught.value.code == "views-not-aligned"


def test_a_line_that_sticks_out_is_cut_off_where_views_belong_together_without_it() -> None:
    sheet = _opened(FRONT, ABOVE, RIGHT)
    # Rests of a dimension: two lines side by side, so that no cut across them is a single one.
    for y in (348, 356):
        sheet.image.grey[y - 1 : y + 2, 200:300] = 0
    separated = separate_by_labels(sheet.clean, plain_labels(sheet.clean))
    left, layout = picture_layout(sheet, separated, Stated({}, Projection.THIRD))
    assert _shows(layout, {Role.FRONT: FRONT, Role.TOP: ABOVE, Role.RIGHT: RIGHT})
    assert not left.part.ink[:, 200:290].any()


def test_views_that_are_read_stand_upright() -> None:
    front, turned, top = Placed(Role.FRONT), Placed(Role.LEFT, 3), Placed(Role.TOP)
    best = Arrangement({0: front, 1: turned}, Projection.THIRD, 20.0)
    alike = Arrangement({1: front, 0: top}, Projection.THIRD, 18.5)
    unlike = Arrangement({1: front, 0: top}, Projection.THIRD, 12.0)
    assert _upright(best, Ranking(best, (alike, unlike))) is alike
    assert _upright(alike, Ranking(alike, (best,))) is alike
    # What is turned is left out where nothing else is as likely.
    alone = _upright(best, Ranking(best, (unlike,)))
    assert alone is not None and alone.placed == {0: front}
