import numpy as np
import pytest

from gaussiancad_core.sheet.views import sheet_layout
from gaussiancad_core.sheet.views.sheet_layout import Box, find_clusters


def _sheet(*boxes: tuple[int, int, int, int]) -> np.ndarray:
    ink = np.zeros((700, 1000), bool)
    for x0, y0, x1, y1 in boxes:
        ink[y0 : y1 + 1, [x0, x1]] = True
        ink[[y0, y1], x0 : x1 + 1] = True
    return ink


FRONT = (300, 300, 500, 400)
ABOVE = (300, 100, 500, 250)
BELOW = (300, 450, 500, 600)
RIGHT = (560, 300, 710, 400)
LEFT = (100, 300, 250, 400)


def _close(box: Box, expected: tuple[int, int, int, int]) -> bool:
    return bool(np.abs(np.array(box) - np.array(expected)).max() <= 1)


def test_strokes_inside_a_view_belong_to_it() -> None:
    assert len(find_clusters(_sheet(FRONT, ABOVE, RIGHT, (350, 330, 420, 370)))) == 3


def test_a_frame_around_the_views_is_none() -> None:
    found = find_clusters(_sheet(FRONT, ABOVE, RIGHT, (10, 10, 990, 690)))
    assert len(found) == 3 and any(_close(box, FRONT) for box in found)


def test_in_free_space_what_goes_around_all_is_an_outline() -> None:
    around, holes = (10, 10, 990, 690), ((100, 100, 160, 160), (800, 100, 860, 160))
    ink = _sheet(around, *holes)
    (box,) = find_clusters(ink, has_paper=False)
    assert _close(box, around)
    assert all(
        any(_close(find_cluster, hole) for hole in holes) for find_cluster in find_clusters(ink)
    )


@pytest.mark.parametrize(("short", "joined"), [(5, True), (9, True), (20, False)])
def test_a_side_that_ends_short_of_all_others_belongs_to_its_view(short: int, joined: bool) -> None:
    ink = _sheet(ABOVE, RIGHT)
    x0, y0, x1, y1 = FRONT
    ink[y0 : y1 + 1, x0] = True
    ink[[y0, y1], x0 : x1 - short] = True
    ink[y0 + short : y1 - short, x1] = True
    assert any(_close(box, FRONT) for box in find_clusters(ink)) is joined


def test_a_line_beside_an_edge_is_no_side_of_the_view() -> None:
    ink = _sheet(FRONT, ABOVE, RIGHT)
    x0, y0, _, y1 = FRONT
    ink[y0 + 5 : y1 - 5, x0 - 10] = True
    assert any(_close(box, FRONT) for box in find_clusters(ink))


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
