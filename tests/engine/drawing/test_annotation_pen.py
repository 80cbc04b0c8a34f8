import numpy as np
import pytest

from gaussiancad_core.drawing.annotation_pen import Direction, Pen, Room
from gaussiancad_core.drawing.sheet_style import SheetStyle

PEN = Pen.of(SheetStyle(annotation_width=1.5, text_height=20.0))


def test_an_arrowhead_points_from_its_tail_to_its_tip() -> None:
    tip, left, right = np.array(PEN.arrowhead((30.0, 40.0), (0.0, 0.0)))
    np.testing.assert_allclose(tip, (30.0, 40.0))
    back = (left + right) / 2.0
    np.testing.assert_allclose(tip - back, PEN.arrow * np.array([0.6, 0.8]))
    assert (left - right) @ (tip - back) == pytest.approx(0.0, abs=1e-9)
    # Half of its opening angle: ISO 129-1 has 15 to 30 degrees for the whole.
    angle = 2.0 * np.degrees(np.arctan2(np.hypot(*(left - right)) / 2.0, PEN.arrow))
    assert 15.0 <= angle <= 30.0


def test_rows_of_dimensions_do_not_touch() -> None:
    text_top = PEN.gap + PEN.height
    assert PEN.pitch > text_top + PEN.overshoot
    assert PEN.first > text_top


def test_directions_map_along_and_across() -> None:
    horizontal, vertical = Direction
    assert horizontal.point(3.0, 5.0) == (3.0, 5.0)
    assert vertical.point(3.0, 5.0) == (5.0, 3.0)
    assert (horizontal.other, vertical.other) == (vertical, horizontal)
    assert vertical.box((1.0, 2.0), (7.0, 9.0)) == (7.0, 1.0, 9.0, 2.0)
    assert vertical.span((7.0, 1.0, 9.0, 2.0)) == (1.0, 2.0)
    assert vertical.segment((1.0, 7.0), (2.0, 9.0)).start == (7.0, 1.0)


def test_room_is_what_is_inside_and_not_taken() -> None:
    room = Room((0.0, 0.0, 100.0, 80.0), [(40.0, 30.0, 60.0, 50.0)])
    assert room.free((0.0, 0.0, 100.0, 30.0))
    assert not room.free((0.0, 0.0, 100.0, 30.1))
    assert not room.free((-0.1, 0.0, 10.0, 10.0))
    assert not room.free((61.0, 31.0, 70.0, 40.0), clearance=1.5)
    assert room.free((61.0, 31.0, 70.0, 40.0), clearance=1.0)
    room.take((61.0, 31.0, 70.0, 40.0))
    assert not room.free((65.0, 35.0, 66.0, 36.0))


def test_lines_are_boxes_without_width() -> None:
    room = Room((0.0, 0.0, 100.0, 80.0), [(40.0, 30.0, 60.0, 50.0)])
    assert room.touched((50.0, 0.0, 50.0, 40.0))
    assert not room.touched((60.0, 0.0, 60.0, 80.0))
