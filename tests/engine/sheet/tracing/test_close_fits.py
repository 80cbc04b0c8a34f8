"""Lines close beside each other are read where they were drawn."""

from itertools import pairwise

import numpy as np
import pytest

from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke


def _upright(strokes: tuple[Stroke, ...]) -> list[float]:
    """x of upright lines in px whose centres are at integers."""
    return sorted(
        0.5 * (stroke.start[0] + stroke.end[0]) - 0.5
        for stroke in strokes
        if isinstance(stroke, Segment) and abs(stroke.start[0] - stroke.end[0]) < 2.0
    )


@pytest.mark.parametrize("begin", [60.0, 60.4, 60.7])
@pytest.mark.parametrize(("width", "apart"), [(2.0, 3.6), (3.0, 3.9), (3.0, 4.5), (4.0, 5.2)])
def test_two_lines_with_little_paper_between(
    sketch,  # noqa: ANN001
    width: float,
    apart: float,
    begin: float,
) -> None:
    drawing = sketch(300, 240)
    for x in (begin, begin + apart):
        drawing.line((x, 30.0), (x, 200.0), width)
    for y in (30.0, 200.0):
        drawing.line((20.0, y), (260.0, y), width)
    assert _upright(drawing.strokes()) == pytest.approx([begin, begin + apart], abs=0.15)


def test_three_lines_of_which_one_is_shorter(sketch) -> None:  # noqa: ANN001
    places = (60.3, 64.5, 68.8)
    drawing = sketch(300, 240)
    for x, end in zip(places, (200.0, 200.0, 110.0), strict=True):
        drawing.line((x, 30.0), (x, end), 3.0)
    for a, b in pairwise([(20.0, 200.0), (20.0, 30.0), (260.0, 30.0), (260.0, 200.0)]):
        drawing.line(a, b, 3.0)
    drawing.line((20.0, 200.0), (260.0, 200.0), 3.0).line((68.8, 110.0), (260.0, 110.0), 3.0)
    found = _upright(drawing.strokes())[1:4]
    assert found == pytest.approx(places, abs=0.15)


def test_two_circles_with_little_paper_between(sketch) -> None:  # noqa: ANN001
    box = [(20.0, 20.0), (220.0, 20.0), (220.0, 220.0), (20.0, 220.0), (20.0, 20.0)]
    drawing = sketch(240, 240).lines(*box)
    drawing.arc((120.3, 118.8), 60.2).arc((120.3, 118.8), 64.1)
    found = [stroke for stroke in drawing.strokes() if isinstance(stroke, Arc)]
    assert sorted(item.radius for item in found) == pytest.approx([60.2, 64.1], abs=0.08)
    centres = np.array([item.centre for item in found]) - 0.5
    assert centres == pytest.approx(np.array([(120.3, 118.8)] * 2), abs=0.08)


@pytest.mark.parametrize("begin", [60.0, 60.25, 60.6])
@pytest.mark.parametrize(("hidden", "apart"), [(3.0, 4.0), (2.0, 4.0), (3.0, 4.5)])
def test_a_hidden_line_beside_a_visible_one(
    sketch,  # noqa: ANN001
    hidden: float,
    apart: float,
    begin: float,
) -> None:
    drawing = sketch(300, 240).line((begin, 30.0), (begin, 200.0), 3.0)
    for y in (30.0, 200.0):
        drawing.line((20.0, y), (260.0, y), 3.0)
    for y in np.arange(30.0, 200.0, 18.0):
        for x in (begin + apart, 160.0):
            drawing.line((x, y), (x, min(y + 12.0, 200.0)), hidden)
    strokes = drawing.strokes()
    assert _upright(strokes) == pytest.approx([begin, begin + apart, 160.0], abs=0.1)
    assert [stroke.linetype for stroke in strokes].count(Linetype.HIDDEN) == 2
