"""Centre marks that free ones of the same sheet tell."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.mark_forms import FreeMark, learned_form, whole_forms
from gaussiancad_core.sheet.annotations.separate import SeparatedSheet, separate_annotations
from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle

Sketch = Any
"""The class that the fixture gives."""

FREE, TOUCHED = (120.0, 160.0), (330.0, 160.0)
RADIUS, CROSS, INNER, OUTER = 40.0, 12.0, 24.0, 52.0


def _mark(drawn: Sketch, centre: tuple[float, float]) -> Sketch:
    x, y = centre
    for near, far in ((-CROSS, CROSS), (INNER, OUTER), (-OUTER, -INNER)):
        drawn.line((x + near, y), (x + far, y)).line((x, y + near), (x, y + far))
    return drawn


def _plate(sketch: Sketch, right: float) -> Sketch:
    """A plate with two bores, its right side at some x."""
    sides = [(40.0, 60.0), (right, 60.0), (right, 260.0), (40.0, 260.0), (40.0, 60.0)]
    drawn = sketch(480, 320).lines(*sides)
    return drawn.arc(FREE, RADIUS).arc(TOUCHED, RADIUS)


def _wrong(separated: SeparatedSheet, wanted: np.ndarray) -> tuple[int, float]:
    """Ink that is left beside the part's, and the share of the part's that is gone."""
    left = separated.part.weight > 0.5
    return int((left & ~wanted).sum()), float((wanted & ~left).sum() / wanted.sum())


@pytest.mark.parametrize("right", [382.0, 376.0], ids=["ends at an edge", "ends beyond an edge"])
def test_an_arm_that_ends_at_an_edge_goes(sketch: Sketch, right: float) -> None:
    wanted = _plate(sketch, right).weight > 0.5
    drawn = _mark(_mark(_plate(sketch, right), FREE), TOUCHED)
    separated = separate_annotations(clean_sheet(drawn.grey))
    assert {mark.kind for mark in separated.marks} == {AnnotationKind.CENTRE_LINE}
    beside, gone = _wrong(separated, wanted)
    # Dots where the crosses' lines meet, and where arms leave the circles' fringe and the edge.
    assert beside <= 260
    assert gone < 0.01


def test_an_edge_that_goes_on_from_an_arm_stays(sketch: Sketch) -> None:
    edge = (TOUCHED[0] + OUTER, 160.0), (430.0, 160.0)
    wanted = _plate(sketch, 430.0).line(*edge).weight > 0.5
    drawn = _mark(_mark(_plate(sketch, 430.0).line(*edge), FREE), TOUCHED)
    beside, gone = _wrong(separate_annotations(clean_sheet(drawn.grey)), wanted)
    assert beside <= 260
    assert gone < 0.01


def test_arms_of_neighbours_that_run_into_each_other_go(sketch: Sketch) -> None:
    near = (FREE[0] + 95.0, FREE[1])
    sides = [(60.0, 90.0), (280.0, 90.0), (280.0, 230.0), (60.0, 230.0), (60.0, 90.0)]
    plain = sketch(480, 320).lines(*sides).arc(FREE, RADIUS).arc(near, RADIUS)
    wanted = plain.weight > 0.5
    separated = separate_annotations(clean_sheet(_mark(_mark(plain, FREE), near).grey))
    beside, gone = _wrong(separated, wanted)
    assert beside <= 260
    assert gone < 0.01


def test_an_edge_through_the_centre_that_fills_a_gap_stays(sketch: Sketch) -> None:
    drawn = _mark(_plate(sketch, 430.0), FREE)
    edge = (TOUCHED[0], 60.0), (TOUCHED[0], 260.0)
    level = (TOUCHED[0] - RADIUS, 160.0), (TOUCHED[0] + RADIUS, 160.0)
    wanted = _plate(sketch, 430.0).line(*edge).line(*level).weight > 0.5
    separated = separate_annotations(clean_sheet(drawn.line(*edge).line(*level).grey))
    assert _wrong(separated, wanted)[1] < 0.01


def _whole(drawn: Sketch, centre: tuple[float, float], end: float) -> Sketch:
    x, y = centre
    return drawn.line((x - end, y), (x + end, y)).line((x, y - end), (x, y + end))


def test_a_cross_without_gaps_that_ends_at_edges_goes(sketch: Sketch) -> None:
    # Its right and its upper end lie on the round outline, the others free.
    x, y = TOUCHED
    low, high, top = x - 46.0, x + 34.0, y + 4.0
    plain = sketch(480, 320).arc((x - 6.0, top), 40.0, start=np.pi, sweep=np.pi)
    plain = plain.lines(
        (high, top), (high, 260.0), (40.0, 260.0), (40.0, 90.0), (low, 90.0), (low, top)
    )
    plain = plain.arc(FREE, 14.0).arc(TOUCHED, 16.0)
    wanted = plain.weight > 0.5
    drawn = _whole(_whole(plain, FREE, 14.0 + 18.0), TOUCHED, 16.0 + 18.0)
    beside, gone = _wrong(separate_annotations(clean_sheet(drawn.grey)), wanted)
    assert beside <= 160
    assert gone < 0.01


def test_edges_across_a_circle_that_go_on_stay(sketch: Sketch) -> None:
    sides = [(40.0, 60.0), (440.0, 60.0), (440.0, 260.0), (40.0, 260.0), (40.0, 60.0)]
    plain = sketch(480, 320).lines(*sides).arc(FREE, 14.0).arc(TOUCHED, 14.0)
    x, y = TOUCHED
    plain = plain.line((x, 60.0), (x, 260.0)).line((x - 32.0, y), (x + 32.0, y))
    wanted = plain.weight > 0.5
    drawn = _whole(plain, FREE, 32.0)
    assert _wrong(separate_annotations(clean_sheet(drawn.grey)), wanted)[1] < 0.03


def test_whole_marks_lead_beyond_one_of_the_circles_around_their_centre() -> None:
    inner, outer, wide = (Circle((5.0, 5.0), radius) for radius in (8.0, 14.0, 60.0))
    marks = [FreeMark(inner, 32.0), FreeMark(Circle((90.0, 5.0), 13.5), 32.0)]
    overs = [form.over for form in whole_forms(marks, [inner, outer, wide])]
    assert overs == pytest.approx([18.0, 24.0])
    assert whole_forms([_free(30.0, 12.0)], [Circle((0.0, 0.0), 30.0)]) == []


def _free(radius: float, over: float, cross: float = CROSS) -> FreeMark:
    return FreeMark(Circle((0.0, 0.0), radius), cross, INNER, radius + over)


def test_the_form_of_most_marks() -> None:
    form = learned_form([_free(30.0, 12.0), _free(40.0, 12.4), _free(50.0, 11.6)])
    assert (form.cross, form.inner, form.over) == pytest.approx((CROSS, INNER, 12.0))
    # Around two circles an arm leads beyond the larger one: the smaller one's says nothing.
    form = learned_form([_free(20.0, 32.0), _free(40.0, 12.0), _free(50.0, 12.0)])
    assert form.over == pytest.approx(12.0)


def test_marks_that_tell_no_form() -> None:
    assert learned_form([]) is None
    assert learned_form([FreeMark(Circle((0.0, 0.0), 30.0), CROSS)]) is None
    assert learned_form([_free(20.0, 10.0), _free(40.0, 30.0)]) is None
    # Arms that end within their circle.
    assert learned_form([_free(60.0, -20.0)]) is None
