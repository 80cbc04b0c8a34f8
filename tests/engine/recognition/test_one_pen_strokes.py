"""Where a file has one pen, what strokes stand for is told by how they meet alone."""

import itertools
import math
from math import tau

import pytest
from engine.recognition.labels_of_files import labels_of, reading_of

from gaussiancad_core.files.vectors import VectorStroke, VectorText
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet_model.labelled_strokes import Label

Place = tuple[float, float]

_PEN = 2.0


def _lines(*ends: tuple[float, float, float, float]) -> list[VectorStroke]:
    return [VectorStroke(LineSegment((a, b), (c, d)), _PEN) for a, b, c, d in ends]


def _chain(*places: Place) -> list[VectorStroke]:
    return [VectorStroke(LineSegment(a, b), _PEN) for a, b in itertools.pairwise(places)]


def _box(x: float, y: float, w: float, h: float) -> list[VectorStroke]:
    return _chain((x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y))


def _circle(x: float, y: float, radius: float) -> VectorStroke:
    return VectorStroke(CircularArc((x, y), radius, 0.0, tau), _PEN)


def _head(x: float, y: float, way: float) -> list[VectorStroke]:
    """An arrowhead with its tip at a place, level."""
    back = x - 10.0 * way
    return _chain((x, y), (back, y - 3.0), (back, y + 3.0), (x, y))


def _dot(x: float, y: float, radius: float = 5.0) -> list[VectorStroke]:
    """An octagon filled with triangles from one of its corners."""
    angles = [0.125 * tau * k for k in range(9)]
    corners = [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]
    fan = [VectorStroke(LineSegment(corners[0], corner), _PEN) for corner in corners[2:7]]
    return _chain(*corners) + fan


def test_extension_lines_from_an_outline_are_none_of_it() -> None:
    part = _box(300, 300, 200, 100)
    extensions = _lines((300, 300, 300, 240), (500, 300, 500, 240))
    dimension = _lines((300, 250, 500, 250)) + _head(300, 250, -1) + _head(500, 250, 1)
    reading, scale = reading_of(part + extensions + dimension)
    labels = labels_of(part + extensions + dimension)
    assert labels[:7] == [Label.EDGE] * 4 + [Label.EXTENSION] * 2 + [Label.DIMENSION]
    (view,) = reading.views
    assert [v * scale for v in view.box] == pytest.approx([300, 300, 500, 400])


def test_an_edge_from_which_a_dimension_is_taken_is_no_extension_line() -> None:
    """It goes on beyond the head's tip as one does, and ends at a corner."""
    part = _box(300, 300, 200, 100)
    head = _chain((310, 300), (307, 310), (313, 310), (310, 300))
    dimension = _lines((310, 330, 310, 300)) + head
    assert labels_of(part + dimension)[:5] == [Label.EDGE] * 4 + [Label.DIMENSION]


@pytest.mark.parametrize("gap", [0.0, 0.7])
def test_outlines_close_across_a_hair(gap: float) -> None:
    """0.09 mm: as much as an arc is off that was fitted to a free curve."""
    half = CircularArc((500.0, 350.0), 50.0, -0.25 * tau, 0.5 * tau)
    part = _lines(
        (500 - gap, 300, 300, 300), (300, 300 + gap, 300, 400), (300, 400, 500 - gap, 400)
    )
    assert labels_of([*part, VectorStroke(half, _PEN)]) == [Label.EDGE] * 4


def test_a_circle_that_all_but_closes_is_one() -> None:
    nearly = VectorStroke(CircularArc((400.0, 350.0), 60.0, 0.0, tau - 0.01), _PEN)
    hole = _circle(400, 350, 20)
    assert labels_of([nearly, hole]) == [Label.EDGE] * 2


def test_centre_lines_out_of_a_circle_are_none_of_the_part() -> None:
    part = [*_box(300, 300, 200, 100), _circle(400, 350, 20)]
    cross = _lines((370, 350, 436, 350), (400, 310, 400, 374))
    assert labels_of(part + cross) == [Label.EDGE] * 5 + [Label.OTHER] * 2


def test_many_extension_lines_that_begin_at_an_edge_leave_it_one() -> None:
    part = _box(300, 300, 200, 100)
    extensions = _lines(*((x, 300, x, 250) for x in range(310, 500, 10)))
    labels = labels_of(part + extensions)
    assert labels[:4] == [Label.EDGE] * 4
    assert Label.EDGE not in labels[4:]


def test_a_diameter_sign_is_no_hole() -> None:
    part, sign = _box(300, 300, 200, 100), _circle(600, 250, 8)
    bar = _lines((595, 262, 605, 238))
    assert labels_of([*part, sign, *bar]) == [Label.EDGE] * 4 + [Label.TEXT] * 2


def test_a_hole_with_two_slanted_centre_lines_is_no_diameter_sign() -> None:
    part, hole = _box(300, 300, 200, 100), _circle(400, 350, 8)
    cross = _lines((391, 341, 409, 359), (391, 359, 409, 341))
    assert labels_of([*part, hole, *cross])[:5] == [Label.EDGE] * 5


def test_dots_tell_dimension_and_extension_lines() -> None:
    part = _box(300, 300, 200, 100)
    extensions = _lines((300, 300, 300, 240), (400, 320, 400, 240), (500, 300, 500, 240))
    dots = [item for x in (300, 400, 500) for item in _dot(x, 250)]
    dimension = _lines((305, 250, 395, 250), (405, 250, 495, 250))
    labels = labels_of(part + extensions + dimension + dots)
    assert labels[:9] == [Label.EDGE] * 4 + [Label.EXTENSION] * 3 + [Label.DIMENSION] * 2
    assert labels[9:] == [Label.ARROW] * len(dots)


def test_chamfers_beside_hatching_are_edges() -> None:
    """They are parallel to it, but go from corner to corner."""
    corners = [(310, 300), (490, 300), (500, 310), (500, 400), (310, 400), (300, 390), (300, 310)]
    part = _chain(*corners, corners[0])
    hatching = _lines(*((x, 300, x + 40, 340) for x in (320, 340, 360, 380, 400, 420)))
    floor = _lines((300, 340, 500, 340))
    labels = labels_of(part + floor + hatching)
    assert labels == [Label.EDGE] * 8 + [Label.HATCH] * 6


def test_a_whole_dash_between_two_cut_ones_is_a_hidden_line() -> None:
    part = _box(300, 300, 200, 100)
    dashes = _lines((400, 310, 400, 322), (400, 330, 400, 355), (400, 363, 400, 375))
    assert labels_of(part + dashes)[4:] == [Label.HIDDEN] * 3


def test_pieces_of_an_edge_within_a_text_are_the_edge() -> None:
    """A program writes it in pieces, and its text lies over some of them."""
    places = [(x, 300.0) for x in range(300, 504, 4)]
    part = _chain(*places, (500, 400), (300, 400), (300, 300))
    number = VectorText("12", (396.0, 290.0, 424.0, 310.0))
    assert labels_of(part, number) == [Label.EDGE] * len(part)


def _up(x: float, y: float) -> list[VectorStroke]:
    """A dimension line with its tip at a place, from below."""
    return _chain((x, y), (x - 3, y + 10), (x + 3, y + 10), (x, y)) + _lines((x, y + 30, x, y))


def test_extension_lines_of_one_row_do_not_hold_each_other() -> None:
    """The first ends on the second, and both begin where others do, in the middles of holes."""
    part = [*_box(300, 300, 200, 100), _circle(340, 350, 10), _circle(460, 350, 10)]
    row = _lines((340, 350, 490, 350), (460, 350, 520, 350))
    columns = _lines((340, 350, 340, 240), (460, 350, 460, 240))
    dimensions = _up(480, 350) + _up(510, 350) + _lines((340, 250, 460, 250))
    dimensions += _head(340, 250, -1) + _head(460, 250, 1)
    labels = labels_of(part + row + columns + dimensions)
    assert labels[:10] == [Label.EDGE] * 6 + [Label.EXTENSION] * 4
