"""What leaders leave at the circles that they point at."""

from typing import Any

import cv2
import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds, Told, erased
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.leader_tips import mark_leaders, with_clear_tips
from gaussiancad_core.sheet.annotations.marks import Mark
from gaussiancad_core.sheet.clean import CleanSheet, clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

WIDTH = 3.0
CENTRE = np.array([150.0, 150.0])
OUTER, INNER = 80.0, 50.0
AWAY = np.array([0.6, -0.8])
"""From the centre to the leader's word."""


def _sheet(sketch: Sketch, *more: tuple[tuple[float, float], tuple[float, float]]) -> CleanSheet:
    drawn = (
        sketch(320, 320)
        .arc(tuple(CENTRE), OUTER, width=WIDTH)
        .arc(tuple(CENTRE), INNER, width=WIDTH)
    )
    drawn.line(tuple(CENTRE + INNER * AWAY), tuple(CENTRE + 150 * AWAY), WIDTH)
    for start, end in more:
        drawn.line(start, end, WIDTH)
    return clean_sheet(drawn.grey)


def _told(sheet: CleanSheet, from_centre: float, *lines: InkedShape) -> Told:
    """Both circles, the leader from 150 px off their centre as far as it is known, and more."""
    circles = [
        InkedShape(Circle(tuple(CENTRE), r), (InkedRun(Run(0.0, 2 * np.pi * r), WIDTH),))
        for r in (OUTER, INNER)
    ]
    leader = InkedShape(
        Line(tuple(CENTRE), tuple(AWAY)), (InkedRun(Run(from_centre, 150.0), WIDTH),)
    )
    kinds = [[None], [None], [AnnotationKind.EXTENSION], *([None] for _ in lines)]
    return Told([*circles, leader, *lines], kinds, np.zeros(sheet.ink.shape, bool))


def _left(sheet: CleanSheet, told: Told) -> np.ndarray:
    """(h, w) bool, ink that is left and lies on neither circle."""
    told = with_clear_tips(told, sheet.ink, sheet.stroke_width)
    left = erased(sheet, told).ink
    rings = np.zeros(left.shape, np.uint8)
    for radius in (OUTER, INNER):
        cv2.circle(rings, (150, 150), round(radius), 1, 9)
    return left & (rings == 0)


def _barb(angle: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """A barb of an arrowhead at the inner circle, turned from the leader by an angle in degrees."""
    turn = np.radians(angle)
    way = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]) @ AWAY
    tip = CENTRE + INNER * AWAY
    return tuple(tip), tuple(tip + 20.0 * way)


def _line(ends: tuple[tuple[float, float], tuple[float, float]]) -> InkedShape:
    start, end = map(np.array, ends)
    length = float(np.hypot(*(end - start)))
    return InkedShape(
        Line(tuple(start), tuple((end - start) / length)), (InkedRun(Run(0.0, length), WIDTH),)
    )


@pytest.mark.parametrize(
    "angles", [(), (-14.0, 14.0), (45.0, 225.0)], ids=["bare", "open", "stroke"]
)
def test_a_leader_across_a_wider_circle_goes_with_its_head(
    sketch: Sketch, angles: tuple[float, ...]
) -> None:
    barbs = [_barb(angle) for angle in angles]
    sheet = _sheet(sketch, *barbs)
    # It is known as far as the wider circle only, and no barb is.
    told = _told(sheet, OUTER, *map(_line, barbs))
    assert not _left(sheet, told).any()


def test_curves_of_a_head_go_too(sketch: Sketch) -> None:
    barbs = [_barb(14.0), _barb(-14.0)]
    sheet = _sheet(sketch, *barbs)
    told = _told(sheet, INNER + 25.0)
    for start, end in barbs:
        for share in np.linspace(0.0, 1.0, 40):
            x, y = np.rint(np.array(start) * (1 - share) + np.array(end) * share).astype(int)
            told.unexplained[y, x] = True
    assert not _left(sheet, told).any()


def test_an_edge_at_the_tip_stays(sketch: Sketch) -> None:
    tip = CENTRE + INNER * AWAY
    edge = (tuple(tip), (float(tip[0]), float(tip[1]) + 80.0))
    sheet = _sheet(sketch, edge)
    left = _left(sheet, _told(sheet, OUTER, _line(edge)))
    column = round(float(tip[0]))
    assert left[round(float(tip[1])) + 20 : round(float(tip[1])) + 65, column].all()


def test_a_line_that_passes_the_centre_by_is_no_leader_to_it(sketch: Sketch) -> None:
    sheet = _sheet(sketch)
    told = _told(sheet, OUTER)
    beside = Line(tuple(CENTRE + np.array([8.0, 6.0])), tuple(AWAY))
    told.shapes[2] = InkedShape(beside, told.shapes[2].runs)
    assert with_clear_tips(told, sheet.ink, sheet.stroke_width) is told


def test_edges_in_line_with_level_ones_stay(sketch: Sketch) -> None:
    drawn = sketch(320, 320).arc(tuple(CENTRE), OUTER, width=WIDTH)
    drawn.line((230.0, 150.0), (310.0, 150.0), WIDTH)
    sheet = clean_sheet(drawn.grey)
    told = _told(sheet, OUTER)
    told.shapes[2] = InkedShape(Line(tuple(CENTRE), (1.0, 0.0)), told.shapes[2].runs)
    assert with_clear_tips(told, sheet.ink, sheet.stroke_width) is told


WRITING = Mark(AnnotationKind.TEXT, (245.0, 60.0, 290.0, 78.0))
"""Above the shoulder of the leader below."""


@pytest.mark.parametrize(
    ("letters", "aside", "kind"),
    [((WRITING,), 0.0, AnnotationKind.LEADER), ((), 0.0, None), ((WRITING,), 9.0, None)],
)
def test_a_line_from_a_shoulder_under_writing_to_a_circle_is_a_leader(
    sketch: Sketch, letters: tuple[Mark, ...], aside: float, kind: AnnotationKind | None
) -> None:
    """Across a circle, and as wide as an edge by its head; not if it passes the centre by."""
    aims_at = CENTRE + aside * np.array([0.8, 0.6])
    knee, tip = aims_at + 88.0 * AWAY, aims_at + INNER * AWAY
    drawn = sketch(320, 320).arc(tuple(CENTRE), OUTER, width=WIDTH)
    drawn.arc(tuple(CENTRE), INNER, width=WIDTH).line(tuple(knee), tuple(tip), WIDTH)
    sheet = clean_sheet(drawn.line(tuple(knee), (300.0, knee[1]), 2.0).grey)
    circles = [Circle(tuple(CENTRE), radius) for radius in (OUTER, INNER)]
    shoulder = Line((0.0, float(knee[1])), (1.0, 0.0)), Run(float(knee[0]), 300.0), 2.0
    leader = Line(tuple(aims_at), tuple(AWAY)), Run(INNER, 88.0), WIDTH
    whole = [(circle, Run(0.0, circle.around), WIDTH) for circle in circles]
    shapes = [InkedShape(at, (InkedRun(run, w),)) for at, run, w in (*whole, shoulder, leader)]
    kinds: Kinds = [[None], [None], [AnnotationKind.EXTENSION], [None]]
    mark_leaders(shapes, kinds, letters, sheet.ink, WIDTH)
    assert kinds == [[None], [None], [AnnotationKind.EXTENSION], [kind]]
