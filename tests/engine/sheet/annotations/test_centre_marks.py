"""Centre marks are told by their places; edges through a circle's centre stay."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.centre_marks import mark_centre_marks
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.separate import separate_annotations
from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

CENTRE = (200.0, 160.0)


def _arm(drawn: Sketch, turn: float, near: float, far: float) -> Sketch:
    """A line from one distance from the centre to another, in a direction in quarter turns."""
    way = np.array([np.cos(turn * np.pi / 2), np.sin(turn * np.pi / 2)])
    return drawn.line(tuple(CENTRE + near * way), tuple(CENTRE + far * way))


def _plate(sketch: Sketch) -> Sketch:
    sides = [(120.0, 90.0), (280.0, 90.0), (280.0, 230.0), (120.0, 230.0), (120.0, 90.0)]
    return sketch(400, 320).lines(*sides).arc(CENTRE, 40.0)


@pytest.mark.parametrize("arms", [(), (0, 1, 2, 3), (1, 3)])
@pytest.mark.parametrize("turned", [0.0, 0.3])
def test_a_mark_goes_and_the_circle_stays(sketch: Sketch, arms: tuple, turned: float) -> None:
    plain = _plate(sketch)
    drawn = _plate(sketch)
    for turn in (0.0, 1.0):
        _arm(drawn, turn + turned, -12.0, 12.0)
    for turn in arms:
        _arm(drawn, turn + turned, 24.0, 52.0)
    separated = separate_annotations(clean_sheet(drawn.grey))
    kinds = [mark.kind for mark in separated.marks]
    assert kinds == [AnnotationKind.CENTRE_LINE] * (2 + len(arms))
    left, wanted = separated.part.weight > 0.5, plain.weight > 0.5
    marked = (drawn.weight > 0.5) & ~wanted
    # A dot stays where the cross's lines meet, and the arms within the circle's fringe.
    assert (left & marked).sum() <= 24 + 24 * len(arms)
    assert (left & wanted).sum() > 0.99 * wanted.sum()


@pytest.mark.parametrize(("across", "gone"), [(14.0, True), (20.0, True), (22.0, False)])
def test_a_cross_in_a_small_circle_ends_freely_before_it(
    sketch: Sketch, across: float, gone: bool
) -> None:
    """Between the two are a few px of paper; what runs up to the circle are edges."""
    sides = [(120.0, 90.0), (280.0, 90.0), (280.0, 230.0), (120.0, 230.0), (120.0, 90.0)]
    drawn = sketch(400, 320).lines(*sides, width=4.0).arc(CENTRE, 13.5, 4.0)
    for way in ((0.5 * across, 0.0), (0.0, 0.5 * across)):
        ends = np.subtract(CENTRE, way), np.add(CENTRE, way)
        drawn.line(tuple(ends[0].tolist()), tuple(ends[1].tolist()), 4.0)
    kinds = [mark.kind for mark in separate_annotations(clean_sheet(drawn.grey)).marks]
    assert kinds == [AnnotationKind.CENTRE_LINE] * (2 if gone else 0)


def test_a_cross_as_large_as_its_circle_is_told_by_its_arms(sketch: Sketch) -> None:
    drawn = _plate(sketch).arc(CENTRE, 22.0)
    for turn in (0.0, 1.0):
        _arm(drawn, turn, -22.0, 22.0)
    for turn in range(4):
        _arm(drawn, turn, 40.0, 60.0)
    separated = separate_annotations(clean_sheet(drawn.grey))
    assert [mark.kind for mark in separated.marks] == [AnnotationKind.CENTRE_LINE] * 6


@pytest.mark.parametrize("told", [0, 3, 4])
def test_a_cross_as_large_as_its_circle_is_told_by_dots(sketch: Sketch, told: int) -> None:
    """Its arms are led beyond the circle by its own size, and begin at twice that."""
    drawn = sketch(400, 320).lines(
        (120.0, 90.0), (280.0, 90.0), (280.0, 230.0), (120.0, 230.0), (120.0, 90.0)
    )
    drawn.arc(CENTRE, 26.5)
    for turn in (0.0, 1.0):
        _arm(drawn, turn, -25.0, 25.0)
    for turn in range(told):
        _arm(drawn, turn, 50.0, 51.5)
    separated = separate_annotations(clean_sheet(drawn.grey))
    kinds = [mark.kind for mark in separated.marks]
    assert kinds.count(AnnotationKind.CENTRE_LINE) == (2 if told else 0)


def test_halves_of_a_mark_that_lie_beside_each_other(sketch: Sketch) -> None:
    """Drawn on whole pixels, lines that run to the right and to the left are one px apart, and the
    circle is another px off."""
    drawn = sketch(400, 320).lines(
        (120.0, 90.0), (280.0, 90.0), (280.0, 230.0), (120.0, 230.0), (120.0, 90.0)
    )
    drawn.arc((CENTRE[0] - 1.1, CENTRE[1] - 0.9), 40.0)
    for near, far in ((0.0, 12.0), (24.0, 52.0)):
        for turn in range(4):
            way = np.array([np.cos(turn * np.pi / 2), np.sin(turn * np.pi / 2)])
            aside = 0.5 * way[::-1]
            drawn.line(tuple(CENTRE + near * way + aside), tuple(CENTRE + far * way + aside))
    marks = separate_annotations(clean_sheet(drawn.grey)).marks
    assert len(marks) >= 6
    assert all(mark.kind is AnnotationKind.CENTRE_LINE for mark in marks)


@pytest.mark.parametrize("width", [2.0, 3.0])
@pytest.mark.parametrize("reach", [39.0, 60.0])
def test_a_narrow_cross_may_end_anywhere(sketch: Sketch, width: float, reach: float) -> None:
    """At its circle, or beside an edge; hidden lines on the sheet are as narrow, and broken.

    One as wide as edges goes where its other ends are free.
    """
    drawn = _plate(sketch).line((268.0, 90.0), (268.0, 230.0))
    if reach > 40.0:
        drawn.line((200.0 - reach - 3.0, 90.0), (200.0 - reach - 3.0, 230.0))
    for turn in (0.0, 1.0):
        way = reach * np.array([np.cos(turn * np.pi / 2), np.sin(turn * np.pi / 2)])
        drawn.line(tuple(CENTRE - way), tuple(CENTRE + way), width)
    for y in (104.0, 216.0):
        drawn.broken((130.0, y), (256.0, y), (12.0, 6.0), 2.0)
    marks = separate_annotations(clean_sheet(drawn.grey), by_weight=False).marks
    kinds = [mark.kind for mark in marks]
    assert kinds == [AnnotationKind.CENTRE_LINE] * (2 if width < 3.0 or reach > 40.0 else 0)


@pytest.mark.parametrize("broken", [False, True])
def test_one_line_that_is_told_tells_the_other(sketch: Sketch, broken: bool) -> None:
    """A pen tells it, or a rhythm; where the other line crosses, a pale one may break."""
    drawn = _arm(_arm(_plate(sketch), 0.0, -6.0, 6.0), 1.0, -6.0, 6.0)
    level = [(-6.0, -3.0), (3.0, 6.0)] if broken else [(-6.0, 6.0)]
    shapes = [
        InkedShape(Circle(CENTRE, 40.0), (InkedRun(Run(0.0, 251.0), 3.0),)),
        InkedShape(Line(CENTRE, (1.0, 0.0)), tuple(InkedRun(Run(a, b), 3.0) for a, b in level)),
        InkedShape(Line(CENTRE, (0.0, 1.0)), (InkedRun(Run(-6.0, 6.0), 1.5),)),
    ]
    kinds = [[None], [None] * len(level), [AnnotationKind.EXTENSION]]
    mark_centre_marks(shapes, kinds, clean_sheet(drawn.grey))
    centre = AnnotationKind.CENTRE_LINE
    assert kinds == [[None], [centre] * len(level), [centre]]


@pytest.mark.parametrize("edge", ["to the circle", "off the centre", "alone", "uneven"])
def test_edges_stay(sketch: Sketch, edge: str) -> None:
    drawn = _plate(sketch)
    if edge == "to the circle":
        _arm(_arm(drawn, 0.0, -40.0, 40.0), 1.0, -40.0, 40.0)
    elif edge == "off the centre":
        drawn.line((188.0, 165.0), (212.0, 165.0)).line((205.0, 153.0), (205.0, 177.0))
    elif edge == "alone":
        _arm(drawn, 0.0, -12.0, 12.0)
    else:
        _arm(_arm(drawn, 0.0, -12.0, 20.0), 1.0, -12.0, 12.0)
    sheet = clean_sheet(drawn.grey)
    separated = separate_annotations(sheet)
    assert separated.marks == ()
    assert np.array_equal(separated.part.weight, sheet.weight)


DASHES = ((-56.0, -10.0), (20.0, 56.0))
"""px from the centre: dashes that begin at one end of a mark, the short one among other ink."""


@pytest.mark.parametrize("ends", ["free", "shorter", "at an edge"])
def test_an_uneven_mark_ends_alike_on_all_sides(sketch: Sketch, ends: str) -> None:
    """It runs beyond its circle, and nothing but its ends is even."""
    drawn = _plate(sketch).arc(CENTRE, 40.0)
    for turn in (0.0, 1.0):
        for near, far in DASHES:
            longest = 46.0 if ends == "shorter" and turn else 56.0
            if near < longest:
                _arm(drawn, turn, max(near, -longest), min(far, longest))
    if ends == "at an edge":
        drawn.line((260.0, 100.0), (260.0, 220.0))
    separated = separate_annotations(clean_sheet(drawn.grey))
    own = [mark for mark in separated.marks if mark.kind is AnnotationKind.CENTRE_LINE]
    assert len(own) == (4 if ends == "free" else 0)
