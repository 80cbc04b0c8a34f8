"""Lines with little or no paper between them are read where they were drawn; wide ones stay one."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Linetype, Segment

Sketch = Any
"""The class that the fixture gives."""

H = Linetype.HIDDEN
RHYTHM = (12.0, 6.0)


@pytest.mark.parametrize(
    ("width", "apart", "begin"),
    [(2.0, 3.6, 60.0), (3.0, 3.9, 60.4), (3.0, 4.5, 60.7), (4.0, 5.2, 60.0), (2.0, 5.0, 60.4)],
)
def test_two_lines(sketch: Sketch, width: float, apart: float, begin: float) -> None:
    drawn = sketch(300, 240).box(20, 30, 260, 200, width)
    for x in (begin, begin + apart):
        drawn.line((x, 30.0), (x, 200.0), width)
    assert drawn.misread(0.3) == []


def test_two_slanted_lines(sketch: Sketch) -> None:
    drawn = sketch(300, 240).box(20, 20, 280, 220, 2.0).line((20, 30), (280, 130), 2.0)
    assert drawn.line((20, 34.5), (280, 134.5), 2.0).misread(0.5) == []


def test_three_lines_of_which_one_is_shorter(sketch: Sketch) -> None:
    drawn = sketch(300, 240).box(20, 30, 260, 200).line((68.8, 110), (260, 110))
    for x, end in ((60.3, 200.0), (64.5, 200.0), (68.8, 110.0)):
        drawn.line((x, 30.0), (x, end))
    assert drawn.misread(0.5) == []


def test_two_circles(sketch: Sketch) -> None:
    drawn = sketch(240, 240).box(20, 20, 220, 220)
    assert drawn.arc((120.3, 118.8), 60.2).arc((120.3, 118.8), 64.1).misread(0.2) == []


@pytest.mark.parametrize("width", [3.0, 4.5, 6.0])
def test_a_wide_line_stays_one(sketch: Sketch, width: float) -> None:
    assert sketch().box(20, 20, 180, 140).line((20, 60.3), (180, 60.3), width).misread() == []


@pytest.mark.parametrize(
    ("hidden", "apart", "begin"), [(3.0, 4.0, 60.0), (2.0, 4.0, 60.25), (3.0, 4.5, 60.6)]
)
def test_a_hidden_line_beside_a_visible_one(
    sketch: Sketch, hidden: float, apart: float, begin: float
) -> None:
    drawn = sketch(300, 240).box(20, 30, 260, 198).line((begin, 30), (begin, 198))
    for x in (begin + apart, 160.0):
        drawn.broken((x, 30), (x, 198), RHYTHM, hidden)
    assert drawn.misread(0.5) == []


@pytest.mark.parametrize(("apart", "phase"), [(3.6, 0.0), (3.6, 9.0), (4.0, 9.0), (5.0, 0.0)])
def test_two_hidden_lines(sketch: Sketch, apart: float, phase: float) -> None:
    drawn = sketch().box(20, 20, 180, 140).broken((20, 60.3), (182, 60.3), RHYTHM)
    drawn.broken((20 + phase, 60.3 + apart), (180, 60.3 + apart), RHYTHM)
    found = [stroke for stroke in drawn.strokes() if stroke.linetype is H]
    levels = sorted(stroke.start[1] - 0.5 for stroke in found)
    assert levels == pytest.approx([60.3, 60.3 + apart], abs=0.35)


def test_dashes_that_fill_each_others_gaps_are_hidden(sketch: Sketch) -> None:
    """They leave no gap; their pen tells."""
    drawn = sketch().box(20, 20, 180, 140).broken((20, 60), (182, 60), RHYTHM)
    drawn.broken((29, 60.6), (182, 60.6), RHYTHM).drawn.pop()
    for y in (40, 90):
        drawn.broken((20, y), (182, y), RHYTHM)
    for y in (75, 105, 120):
        drawn.line((20, y), (180, y))
    assert drawn.misread(2.1) == []


def _plate(sketch: Sketch, *levels: float, pen: float = 2.0) -> Any:  # noqa: ANN401
    drawn = sketch(320, 240).box(20, 20, 300, 220)
    for y in levels:
        drawn.broken((20, y), (302, y), RHYTHM, pen)
    return drawn


def _levels(drawn: Any) -> list[float]:  # noqa: ANN401
    """y of the long hidden lines."""
    ends = [stroke.sample(1e9)[[0, -1]] for stroke in drawn.strokes() if stroke.linetype is H]
    return sorted(float(points[:, 1].mean()) - 0.5 for points in ends if np.ptp(points[:, 0]) > 200)


@pytest.mark.parametrize(
    ("pen", "share"),
    [(2.0, 0.6), (2.0, 0.8), (2.0, 1.0), (1.4, 1.1), (1.4, 2.4), (2.0, 1.5), (2.6, 1.7), (2.6, 2.1),
     (3.2, 1.1), (3.2, 1.3), (3.2, 1.9), (3.2, 2.4)],
)  # fmt: skip
def test_twin_hidden_lines_whose_dashes_melt_or_nearly_do(
    sketch: Sketch, pen: float, share: float
) -> None:
    true = [50.0, 70.0, 90.0, 120.0 - share * pen / 2.0, 120.0 + share * pen / 2.0, 190.0]
    assert _levels(_plate(sketch, *true, pen=pen)) == pytest.approx(true, abs=0.25)


@pytest.mark.parametrize("apart", [3.0, 3.4])
def test_twin_hidden_lines_beside_an_edge(sketch: Sketch, apart: float) -> None:
    """It is near one of them, so that only the other one's dashes are measured."""
    true = [50.0, 70.0, 90.0, 120.0 - apart / 2.0, 120.0 + apart / 2.0, 190.0]
    drawn = _plate(sketch, *true).line((20.0, true[4] + 8.0), (300.0, true[4] + 8.0))
    assert _levels(drawn) == pytest.approx(true, abs=0.2)


@pytest.mark.parametrize("apart", [2.6, 3.4])
def test_of_twin_hidden_lines_the_longer_one_goes_on(sketch: Sketch, apart: float) -> None:
    drawn = _plate(sketch, 50.0, 70.0, 90.0, 120.0, 190.0)
    drawn.broken((22, 120 + apart), (140, 120 + apart), RHYTHM)
    assert _levels(drawn) == pytest.approx([50.0, 70.0, 90.0, 120.0, 190.0], abs=0.3)


def test_a_hidden_line_some_of_whose_ink_ran_is_one(sketch: Sketch) -> None:
    drawn = _plate(sketch, 50.0, 120.0, 190.0)
    for x in (20.0, 92.0, 164.0):
        drawn.ink((x, 120.8), (x + 12.0, 120.8), width=2.0)
    assert drawn.misread(2.1) == []


def test_where_pens_differ_no_hidden_line_is_two(sketch: Sketch) -> None:
    """Without a width that most dashes have, one wide line says nothing."""
    drawn = sketch(320, 240).box(20, 20, 300, 220)
    for k, width in enumerate((1.4, 2.0, 2.8, 3.6)):
        drawn.broken((20, 50 + 40 * k), (302, 50 + 40 * k), RHYTHM, width)
    assert len(_levels(drawn)) == 4


def test_a_line_that_is_visible_in_its_middle_is_one(sketch: Sketch) -> None:
    """A wide pen where it is visible, a narrow one where it is hidden."""
    drawn = _plate(sketch, 50.0, 120.0, 190.0).line((94, 120.4), (202, 120.4), 3.0)
    found = drawn.strokes()
    assert sum(stroke.linetype is Linetype.VISIBLE for stroke in found) == 5


@pytest.mark.parametrize("step", [2.2, 3.0])
@pytest.mark.parametrize("inwards", [True, False])
def test_a_step_of_two_px_parts_an_edge(sketch: Sketch, step: float, inwards: bool) -> None:
    middle, outer = (300.0 - step, 300.0) if inwards else (300.0, 300.0 - step)
    drawn = sketch(340, 290).lines((20, 20), (outer, 20), (outer, 90), (20, 90), width=4.0)
    drawn.lines((20, 20), (20, 260), (outer, 260), (outer, 190), (20, 190), width=4.0)
    drawn.line((middle, 90), (middle, 190), 4.0)
    found = [
        stroke.sample(1.0)[[0, -1]] - 0.5
        for stroke in drawn.strokes()
        if isinstance(stroke, Segment) and min(stroke.start[0], stroke.end[0]) > 290.0
    ]
    found.sort(key=lambda ends: ends[:, 1].mean())
    assert [ends[:, 0].mean() for ends in found] == pytest.approx([outer, middle, outer], abs=0.35)
    ends = [sorted(ends[:, 1]) for ends in found]
    assert np.array(ends) == pytest.approx(np.array([[20, 90], [90, 190], [190, 260]]), abs=2.5)


@pytest.mark.parametrize(("apart", "degrees"), [(1.2, 45.0), (1.6, 30.0)])
def test_two_slants_a_px_off_one_course(sketch: Sketch, apart: float, degrees: float) -> None:
    """The longer one does not pull the other to its own course."""
    way = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    origin, normal = np.array([30.3, 40.2]), np.array([-way[1], way[0]])
    drawn = sketch(420, 420)
    for start, end, off in ((0.0, 90.0, 0.0), (220.0, 275.0, apart)):
        ends = [tuple(origin + at * way + off * normal) for at in (start, end)]
        drawn.line(*ends, 2.6)
    assert drawn.misread(0.6) == []


def test_steps_and_notches_of_an_outline(sketch: Sketch) -> None:
    """Eight px down in a lower edge, and a corner taken off."""
    drawn = sketch().lines(
        (30, 30), (153, 30), (153, 38.5), (170, 38.5), (170, 120), (110, 120), (110, 112),
        (30, 112), (30, 30),
    )  # fmt: skip
    assert drawn.misread() == []


@pytest.mark.parametrize(("width", "apart"), [(2.0, 4.6), (3.0, 5.6), (4.0, 6.6), (3.0, 10.0)])
def test_the_bottom_of_a_groove_with_little_paper_across(
    sketch: Sketch, width: float, apart: float
) -> None:
    drawn = sketch().box(20, 20, 180, 120, width).line((60, 20), (60, 120), width)
    drawn.line((60 + apart, 20), (60 + apart, 120), width)
    assert drawn.line((60.0, 70.3), (60 + apart, 70.3), width).misread() == []


@pytest.mark.parametrize("ink", [[(60, 70), (64, 70)], [(60, 66), (64, 71), (68, 66)]])
def test_ink_between_two_lines_that_joins_them_nowhere_is_no_line(
    sketch: Sketch, ink: list[tuple[float, float]]
) -> None:
    drawn = sketch().box(20, 20, 180, 120, 2.7).line((60, 20), (60, 120), 2.7)
    drawn.line((68, 20), (68, 120), 2.7).ink(*ink, width=2.7)
    assert drawn.misread() == []


def test_a_line_between_two_others_is_hidden_where_its_pen_tells(sketch: Sketch) -> None:
    drawn = (
        sketch(320, 240).box(20, 20, 300, 220).line((60, 20), (60, 220)).line((68, 20), (68, 220))
    )
    for y in (40, 150, 190):
        drawn.broken((100, y), (298, y), RHYTHM, 1.6)
    drawn.ink((60, 66), (68, 74), width=1.6).shows(Segment((60.5, 66.5), (68.5, 74.5), H))
    assert drawn.line((60, 110), (68, 118)).misread(2.5) == []


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_box_with_loose_corners_ends_at_them_and_is_filled(sketch: Sketch, seed: int) -> None:
    off = np.random.default_rng(seed).choice([-4.0, -3.0, 0.0, 3.0, 4.0], (4, 2))
    corners = np.array([(60.0, 50.0), (340.0, 50.0), (340.0, 240.0), (60.0, 240.0)])
    drawn = sketch(400, 300)
    for (first, last), start, end in zip(off, corners, np.roll(corners, -1, 0), strict=True):
        way = np.sign(end - start)
        drawn.ink(tuple(start - first * way), tuple(end + last * way))
        drawn.shows(Segment(tuple(start + 0.5), tuple(end + 0.5), Linetype.VISIBLE))
    assert drawn.misread(4.0) == []
    outline = drawn.view().closed
    area = outline.mask.sum() / outline.supersampling**2
    assert area == pytest.approx(280.0 * 190.0, rel=0.02)
