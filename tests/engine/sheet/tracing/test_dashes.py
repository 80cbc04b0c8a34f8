"""Hidden lines: what belongs to one, up to where it goes, and what only looks like dashes."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Arc, Linetype, Segment

Sketch = Any
"""The class that the fixture gives."""

H = Linetype.HIDDEN
RHYTHM = (12.0, 6.0)
LEFT, RIGHT = 182.0, 206.0


def _plate(sketch: Sketch, width: float = 2.5) -> Any:  # noqa: ANN401
    """An outline with an edge at x = 200 and a dashed line that tells the rhythm."""
    drawn = sketch(400, 300).box(12, 12, 388, 288, width).line((200, 12), (200, 288), width)
    return drawn.broken((250, 60), (388, 60), RHYTHM, 1.5)


@pytest.mark.parametrize("first", [29, 31])
def test_lines_go_on_behind_an_edge_to_the_next(sketch: Sketch, first: int) -> None:
    """The bore of a chamfered ring: 2 px of a dash show at both edges, or 4 at one."""
    drawn = sketch(240, 160).box(20, 20, 162, 120).line((150, 20), (150, 120))
    for y in (50.5, 90.5):
        for x in range(first, 160, 13):
            drawn.ink((x - 0.5, y), (min(x + 8, 163) - 0.5, y), width=2.0)
        drawn.shows(Segment((20.5, y + 0.5), (162.5, y + 0.5), H))
    assert drawn.misread() == []


@pytest.mark.parametrize("blot", [False, True])
def test_without_dashes_beyond_an_edge_lines_end_at_it(sketch: Sketch, blot: bool) -> None:
    drawn = sketch(240, 160).box(20, 20, 162, 120).line((150, 20), (150, 120))
    for y in (50.0, 90.0):
        drawn.broken((20, y), (152, y), RHYTHM)
        if blot:
            drawn.ink((156, y - 6.0), (156, y - 3.0), width=3.0)
    assert drawn.misread(3.0) == []


def test_sides_that_end_at_circles_go_on_behind_the_inner_one(sketch: Sketch) -> None:
    """As where a cross bore passes the circle of a chamfer."""
    drawn = sketch(200, 200).arc((100.0, 100.0), 70.0).arc((100.0, 100.0), 60.0)
    for x in (94.0, 106.0):
        drawn.ink((x, 30), (x, 37), width=2.0).ink((x, 170), (x, 163), width=2.0)
        for y in np.arange(43.0, 157.0, 15.0):
            drawn.ink((x, y), (x, y + 9.0), width=2.0)
    found = [stroke for stroke in drawn.strokes() if stroke.linetype is H]
    assert [stroke.length for stroke in found] == [pytest.approx(139.5, abs=1.5)] * 2


def _pockets(sketch: Sketch, *lefts: float) -> Any:  # noqa: ANN401
    """Pockets below a box's upper side: their sides begin with a gap, the bottom with a dash."""
    drawn = sketch(400, 200).box(20, 40, 380, 160, 2.0)
    for left in lefts:
        for x in (left, left + 44.0):
            drawn.ink((x, 47), (x, 62), width=2.0).ink((x, 77), (x, 92), width=2.0)
            drawn.shows(Segment((x + 0.5, 40.5), (x + 0.5, 92.5), H))
        drawn.ink((left, 92), (left + 14.0, 92), width=2.0)
        drawn.ink((left + 30.0, 92), (left + 44.0, 92), width=2.0)
        drawn.shows(Segment((left + 0.5, 92.5), (left + 44.5, 92.5), H))
    return drawn


def test_pairs_of_dashes_tell_the_rhythm(sketch: Sketch) -> None:
    assert _pockets(sketch, 60.0, 200.0).misread(1.0) == []


def test_edges_on_one_line_are_no_dashes(sketch: Sketch) -> None:
    drawn = sketch(400, 200).box(20, 20, 380, 180, 2.0)
    for top in (60.0, 100.0):
        for left in (60.0, 90.0, 200.0, 320.0):
            drawn.box(left, top, left + 15, top + 22, 2.0)
    assert drawn.misread() == []


@pytest.mark.parametrize("angle", [0.0, 0.3, 1.2])
def test_a_row_of_dashes_is_one_line(sketch: Sketch, angle: float) -> None:
    along = np.array([np.cos(angle), np.sin(angle)])
    start = np.array([60.0, 60.0])
    drawn = sketch(400, 400).box(20, 20, 380, 380)
    drawn.broken(tuple(start), tuple(start + 240.0 * along), (24, 12))
    assert drawn.misread(1.5) == []


@pytest.mark.parametrize("rise", [20.0, 30.0])
def test_a_line_across_dashes_at_a_flat_angle_joins_none(sketch: Sketch, rise: float) -> None:
    drawn = sketch().box(20, 20, 180, 140).broken((20, 80), (182, 80), RHYTHM)
    assert drawn.line((20, 80 - rise), (180, 80 + rise)).misread(2.1) == []


@pytest.mark.parametrize("degrees", [9.0, 13.0])
def test_a_slanted_line_takes_no_dash_that_it_crosses(sketch: Sketch, degrees: float) -> None:
    """Its own ink ends far before them."""
    slope = float(np.tan(np.radians(degrees)))
    drawn = sketch(400, 200).box(20, 20, 380, 180).broken((20, 60), (374, 60), RHYTHM)
    drawn.line((220.0, 20), (220.0, 180)).line((220, 60 + 130 * slope), (380, 60 + 290 * slope))
    assert drawn.misread(6.5) == []


def test_a_stroke_across_the_course_of_a_hidden_line_is_no_piece_of_it(sketch: Sketch) -> None:
    """At eleven degrees, as a shallow roof beside a hidden edge."""
    drawn = sketch(400, 300).box(12, 12, 388, 288, 2.5).line((250, 12), (250, 288), 2.5)
    drawn.broken((12, 100), (250, 100), RHYTHM, 1.5)
    drawn.lines((250, 92), (330, 107.5), (330, 200), (250, 215), width=2.5)
    assert drawn.misread(5.0) == []


def test_a_short_hidden_leg_is_told_by_its_corners(sketch: Sketch) -> None:
    """A pocket 13 px deep: its short sides are a tick at the corner, a gap, and a tick."""
    drawn = _plate(sketch).broken((187, 100), (187, 202), RHYTHM, 1.5)
    for y in (100, 202):
        drawn.ink((187, y), (191, y), width=1.5).ink((196, y), (200, y), width=1.5)
        drawn.shows(Segment((187.5, y + 0.5), (200.5, y + 0.5), H))
    assert drawn.misread(1.0) == []


def test_a_wide_gap_between_two_corners_parts_a_hidden_line(sketch: Sketch) -> None:
    drawn = _plate(sketch)
    for y in (100, 113):
        drawn.broken((12, y), (150, y), RHYTHM, 1.5)
    drawn.broken((150, 100), (150, 52), RHYTHM, 1.5).broken((150, 113), (150, 161), RHYTHM, 1.5)
    assert drawn.misread(2.0) == []


@pytest.mark.parametrize("grey", [1.0, 0.45])
def test_even_dashes_across_levels_are_one_line(sketch: Sketch, grey: float) -> None:
    drawn, pale = sketch(320, 200).box(20, 30, 300, 166), sketch(320, 200)
    for x in (60, 120, 180, 240):
        pale.broken((x, 38), (x, 158), (8.0, 8.0))
        drawn.shows(Segment((x + 0.5, 30.5), (x + 0.5, 166.5), H))
    drawn.weight = np.maximum(drawn.weight, np.float32(grey) * pale.weight)
    assert drawn.line((20, 96), (300, 96)).misread(1.5) == []


def test_the_last_dash_of_a_line_may_lie_across_two_others(sketch: Sketch) -> None:
    drawn, bottom = sketch(400, 300).box(12, 12, 388, 288, 2.5), 96.0
    drawn.broken((120, 12), (120, bottom), RHYTHM, 2.5)
    drawn.broken((12, bottom - 8.0), (388, bottom - 8.0), RHYTHM, 2.5)
    drawn.broken((120, bottom), (276, bottom), RHYTHM, 2.5)
    (upright,) = (
        stroke
        for stroke in drawn.strokes()
        if stroke.linetype is H and abs(stroke.start[0] - stroke.end[0]) < 1.0
    )
    assert max(upright.start[1], upright.end[1]) == pytest.approx(bottom + 0.5, abs=1.0)


@pytest.mark.parametrize("seen", [(92.0, 108.0), (94.0, 106.0), (100.0, 100.0)])
def test_hidden_lines_meet_in_a_corner_where_neither_has_ink(
    sketch: Sketch, seen: tuple[float, float]
) -> None:
    """The gap of one or of both is at their corner, as programs leave it."""
    drawn = sketch(240, 240).box(20, 20, 220, 220)
    drawn.broken((seen[0], 100), (20, 100), RHYTHM).broken((100, seen[1]), (100, 220), RHYTHM)
    found = [stroke for stroke in drawn.strokes() if stroke.linetype is H]
    ends = np.array([place for stroke in found for place in (stroke.start, stroke.end)])
    assert np.sort(np.hypot(*(ends - 100.5).T))[:2] == pytest.approx(0.0, abs=0.7)
    assert len(found) == 2


@pytest.mark.parametrize("mirrored", [False, True])
def test_a_line_is_hidden_from_where_another_meets_it(sketch: Sketch, mirrored: bool) -> None:
    """Its first dash has no gap before it."""
    drawn = sketch(300, 200).box(20, 20, 280, 180)

    def x(at: float) -> float:
        return 300.0 - at if mirrored else at

    drawn.line((x(20), 100), (x(120), 100)).line((x(120), 20), (x(120), 100))
    drawn.broken((x(120), 100), (x(276), 100), RHYTHM, 3.0)
    drawn.broken((20, 140), (278, 140), RHYTHM, 3.0)
    assert drawn.misread(4.1) == []


def test_dashes_of_a_line_and_of_an_arc_that_leaves_it_are_no_visible_line(sketch: Sketch) -> None:
    drawn = sketch(420, 260).box(20, 20, 400, 240).broken((100, 60), (400, 60), RHYTHM, 3.0)
    for k in range(8):
        drawn.arc((100.0, 160.0), 100.0, 3.0, 1.5 * np.pi - k * 0.18 - 0.12, 0.12)
        drawn.drawn.pop()
    assert sum(stroke.linetype is Linetype.VISIBLE for stroke in drawn.strokes()) == 4


@pytest.mark.parametrize("deep", [6.3, 8.1])
def test_a_shallow_hidden_step_behind_an_edge(sketch: Sketch, deep: float) -> None:
    """Its sides are shorter than a dash: all their ink is one piece."""
    y = 50.5 + deep
    drawn = (
        sketch(400, 280)
        .box(60, 50, 340, 220)
        .inked(
            Segment((120.4, y), (263.7, y), H),
            Segment((120.4, 50.5), (120.4, y), H),
            Segment((263.7, 50.5), (263.7, y), H),
        )
    )
    assert drawn.misread(1.0) == []


@pytest.mark.parametrize("deep", [13.5, 15.5])
def test_an_edge_that_goes_on_hidden_down_to_a_corner(sketch: Sketch, deep: float) -> None:
    """A visible edge ends above it: what is drawn below is no dash of that."""
    y = 130.5 + deep
    drawn = sketch(400, 280).box(60, 50, 340, 220).line((60, 130), (340, 130))
    drawn.line((200, 50), (200, 130))
    below = Segment((60.5, y), (200.5, y), H), Segment((200.5, 130.5), (200.5, y), H)
    drawn.inked(*below, hidden=3.0)
    assert drawn.misread(1.0) == []


def _block(sketch: Sketch, top: float) -> Any:  # noqa: ANN401
    """A block with a bore of dashed lines from its lower edge up to a height."""
    drawn = sketch(400, 300).box(12, 12, 388, 288)
    for x in (LEFT, RIGHT, 300.0):
        drawn.broken((x, top), (x, 288), RHYTHM, 2.0)
    return drawn.broken((LEFT, top), (RIGHT, top), (9.0, 6.0), 2.0)


def _slanted(drawn: Any) -> np.ndarray:  # noqa: ANN401
    """(n, 2, 2) ends of slanted hidden lines, left ones first, px whose centres are at integers."""
    ends = [
        sorted((x - 0.5, y - 0.5) for x, y in (stroke.start, stroke.end))
        for stroke in drawn.strokes()
        if isinstance(stroke, Segment)
        and stroke.linetype is H
        and min(np.abs(np.subtract(stroke.end, stroke.start)) / stroke.length) > 0.15
    ]
    return np.array(sorted(ends)).reshape(-1, 2, 2)


@pytest.mark.parametrize(
    ("top", "sides"),
    [
        (20.5, [((LEFT - 8.5, 12.0), (LEFT, 20.5)), ((RIGHT, 20.5), (RIGHT + 8.5, 12.0))]),
        (23.0, [((LEFT - 11, 12.0), (LEFT, 23.0)), ((RIGHT, 23.0), (RIGHT + 11, 12.0))]),
        (60.0, [((LEFT, 60.0), (194.0, 53.1)), ((194.0, 53.1), (RIGHT, 60.0))]),
        (60.0, [((LEFT, 60.0), (194.0, 48.0)), ((194.0, 48.0), (RIGHT, 60.0))]),
        (20.5, []),
        (60.0, []),
    ],
    ids=["chamfer", "wide chamfer", "flat tip", "tip", "right under an edge", "flat bottom"],
)
def test_the_end_of_a_bore(
    sketch: Sketch, top: float, sides: list[tuple[tuple[float, float], tuple[float, float]]]
) -> None:
    drawn = _block(sketch, top)
    for start, end in np.array(sides).reshape(-1, 2, 2):
        for first, last in ((0.0, 1.0 / 3.0), (2.0 / 3.0, 1.0)):
            ends = (tuple(start + share * (end - start)) for share in (first, last))
            drawn.ink(*ends, width=2.0)
    assert _slanted(drawn) == pytest.approx(np.array(sides).reshape(-1, 2, 2), abs=1.2)


@pytest.mark.parametrize("away", [8.0, 10.0])
def test_pale_chamfers_between_two_edges(sketch: Sketch, away: float) -> None:
    """Pale dashes right beside edges are not raised as others are."""
    top = 12.0 + away
    drawn, pale = (
        sketch(400, 300).box(12, 12, 388, 288).line((12, top), (388, top)),
        sketch(400, 300),
    )
    for x in (LEFT, RIGHT, 300.0):
        pale.broken((x, top + 6.0), (x, 288), RHYTHM, 2.0)
    cones = [((LEFT - away, 12.0), (LEFT, top)), ((RIGHT, top), (RIGHT + away, 12.0))]
    for start, end in cones:
        pale.line(start, end, 2.0)
    drawn.weight = np.maximum(drawn.weight, np.float32(0.45) * pale.weight)
    assert _slanted(drawn) == pytest.approx(np.array(cones), abs=1.2)


def test_chamfers_longer_than_short_dashes(sketch: Sketch) -> None:
    """Most of what is drawn of them is in the ink of other strokes all the same."""
    drawn, top = sketch(400, 300).box(12, 12, 388, 288), 19.0
    drawn.broken((LEFT, top), (RIGHT + 2.0, top), (5.0, 4.0), 2.0)
    for x in (LEFT, RIGHT):
        drawn.broken((x, top), (x, 288), (5.0, 4.0), 2.0)
    cones = [((LEFT - 7.0, 12.0), (LEFT, top)), ((RIGHT, top), (RIGHT + 7.0, 12.0))]
    for start, end in (cones[0][::-1], cones[1]):
        drawn.broken(start, end, (5.0, 4.0), 2.0)
    assert _slanted(drawn) == pytest.approx(np.array(cones), abs=1.2)


def test_no_arc_is_made_of_a_row_that_other_strokes_cross(sketch: Sketch) -> None:
    drawn = _plate(sketch)
    for y in (100, 118, 136):
        drawn.broken((12, y), (192, y), RHYTHM, 1.5)
    assert not [stroke for stroke in drawn.strokes() if isinstance(stroke, Arc)]


@pytest.mark.parametrize(("dash", "gap"), [(12, 6), (40, 20)])
def test_thin_lines_of_long_dashes_are_one_stroke(sketch: Sketch, dash: int, gap: int) -> None:
    """As CAD programs draw them: a gap is ten times as wide as the line."""
    end = 40 + 10 * dash + 9 * gap
    drawn = sketch(700, 300).box(40, 40, end, 240, 2.0)
    for y in (100.0, 160.0):
        drawn.broken((40, y), (end, y), (dash, gap), 2.0)
    assert drawn.misread(1.0) == []
