"""What bounds nothing on sheets whose lines are all of one width, and what looks as if it did."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.loose import (
    LooseRule,
    split_loose,
)
from gaussiancad_core.sheet.annotations.marks import Mask
from gaussiancad_core.sheet.annotations.separate import separate_annotations
from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

LEVEL = Line((0.0, 50.0), (1.0, 0.0))
LONG = InkedShape(LEVEL, (InkedRun(Run(20.0, 180.0), 2.0),))


@pytest.mark.parametrize(("gap", "kept"), [(0.0, True), (12.0, True), (30.0, False)])
def test_an_outline_that_faded_still_bounds_the_view(
    sketch: Sketch, gap: float, kept: bool
) -> None:
    drawn = sketch().line((20, 50), (180, 50), 2.0).line((20, 130), (180, 130), 2.0)
    drawn.line((20, 50), (20, 130), 2.0)
    drawn.line((180, 50), (180, 90 - gap / 2), 2.0).line((180, 90 + gap / 2), (180, 130), 2.0)
    ink = clean_sheet(drawn.grey).ink
    rule = LooseRule(16.0, everywhere=True, faded=19)
    _, kinds = split_loose([LONG], [[None]], ink, rule)
    assert (kinds == [[None]]) is kept


@pytest.mark.parametrize("closed", [True, False])
def test_what_only_gaps_shut_off_bounds_nothing_beside_closed_outlines(
    sketch: Sketch, closed: bool
) -> None:
    """A dimension line between extension lines that begin a small gap off the view."""
    drawn = sketch(300, 240).lines((100, 50), (260, 50), (260, 180), (100, 180), (100, 50))
    drawn.line((40, 50), (95, 50), 2.0).line((40, 180), (95, 180), 2.0)
    ink = clean_sheet(drawn.line((46, 50), (46, 180), 2.0).grey).ink
    line = InkedShape(Line((46.0, 0.0), (0.0, 1.0)), (InkedRun(Run(50.0, 180.0), 2.0),))
    edge = InkedShape(Line((100.0, 0.0), (0.0, 1.0)), (InkedRun(Run(50.0, 180.0), 2.0),))
    rule = LooseRule(16.0, everywhere=True, faded=19, closed=closed)
    shapes, kinds = split_loose([line, edge], [[None], [None]], ink, rule)
    told = [
        run.run.length
        for run, kind in zip(shapes[0].runs, kinds[0], strict=True)
        if kind is AnnotationKind.EXTENSION
    ]
    assert (sum(told) > 120.0) is closed
    assert kinds[1] == [None]


@pytest.mark.parametrize(("start", "kept"), [(20.0, True), (10.0, False)])
def test_an_edge_that_runs_out_within_a_view_stays(
    sketch: Sketch, start: float, kept: bool
) -> None:
    """It ends before the circle that it leads to; one that comes in over paper is none."""
    drawn = sketch(300, 200).lines((20, 20), (260, 20), (260, 160), (20, 160), (20, 20))
    drawn.line((180, 20), (180, 160), 2.0).arc((225, 90), 12.0, 2.0)
    ink = clean_sheet(drawn.line((start, 90), (205, 90), 2.0).grey).ink
    line = InkedShape(Line((0.0, 90.0), (1.0, 0.0)), (InkedRun(Run(start, 205.0), 2.0),))
    shapes, kinds = split_loose([line], [[None]], ink, LooseRule(16.0, everywhere=True, faded=5))
    assert (kinds[0][-1] is None) is kept
    assert shapes[0].runs[-1].run.end == 205.0


@pytest.mark.parametrize("held", [True, False])
def test_a_short_extension_line_is_told_by_its_dimension_line(sketch: Sketch, held: bool) -> None:
    """As short as a dash, above the edge of a view."""
    drawn = sketch(300, 240).lines((100, 90), (260, 90), (260, 180), (100, 180), (100, 90))
    ink = clean_sheet(drawn.line((140, 60), (140, 84), 2.0).grey).ink
    short = InkedShape(Line((140.0, 0.0), (0.0, 1.0)), (InkedRun(Run(60.0, 84.0), 2.0),))
    runs = InkedRun(Run(60.0, 100.0), 2.0), InkedRun(Run(116.0, 140.0 if held else 130.0), 2.0)
    line = InkedShape(Line((0.0, 63.0), (1.0, 0.0)), runs)
    told = [AnnotationKind.DIMENSION] * 2
    rule = LooseRule(32.0, everywhere=True, faded=5, closed=True)
    _, kinds = split_loose([short, line], [[None], told], ink, rule)
    assert kinds == [[AnnotationKind.EXTENSION if held else None], told]


def test_a_line_within_one_area_bounds_nothing(sketch: Sketch) -> None:
    drawn = sketch().line((10, 20), (190, 20), 2.0).line((10, 80), (190, 80), 2.0)
    drawn.line((10, 20), (10, 80), 2.0).line((190, 20), (190, 80), 2.0)
    ink = clean_sheet(drawn.line((20, 50), (180, 50), 2.0).grey).ink
    rule = LooseRule(16.0, everywhere=True, faded=5)
    _, kinds = split_loose([LONG], [[None]], ink, rule)
    assert set(kinds[0]) == {AnnotationKind.EXTENSION}


def test_extension_lines_that_gaps_shut_off_bound_nothing(sketch: Sketch) -> None:
    """Two that lead into a view, where a bore's edge all but closes what lies between them."""
    drawn = sketch(400, 400).line((60, 20), (220, 20), 2.0).line((60, 180), (220, 180), 2.0)
    drawn.line((60, 20), (60, 180), 2.0).line((220, 20), (220, 180), 2.0)
    drawn.line((10, 70), (140, 70), 2.0).line((10, 100), (140, 100), 2.0)
    drawn.line((152, 64), (152, 106), 2.0)
    ink = clean_sheet(drawn.grey).ink
    rule = LooseRule(16.0, everywhere=True, faded=19)
    line = InkedShape(Line((0.0, 70.0), (1.0, 0.0)), (InkedRun(Run(10.0, 140.0), 2.0),))
    shapes, kinds = split_loose([line], [[None]], ink, rule)
    kept = [own.run for own, kind in zip(shapes[0].runs, kinds[0], strict=True) if kind is None]
    # Where it crosses the outline, no one knows what is beside it.
    assert all(run.start > 50.0 and run.end < 70.0 for run in kept)


@pytest.mark.parametrize(
    ("before", "after", "kept"),
    [
        ((36.0, 48.0), (87.0, 99.0), True),
        # The dots of a centre line, dashes far away, and none on one side.
        ((42.0, 48.0), (87.0, 93.0), False),
        ((22.0, 34.0), (120.0, 132.0), False),
        ((36.0, 48.0), (160.0, 172.0), False),
    ],
    ids=["dashes", "dots", "far", "one"],
)
def test_dashes_that_a_crossing_stroke_joins_stay(
    sketch: Sketch, before: tuple[float, float], after: tuple[float, float], kept: bool
) -> None:
    """Two together are longer than what is known to be a dash, and part nothing."""
    drawn = sketch().line((10, 20), (190, 20), 2.0).line((10, 80), (190, 80), 2.0)
    drawn.line((10, 20), (10, 80), 2.0).line((190, 20), (190, 80), 2.0)
    pieces = before, (55.0, 80.0), after
    for start, end in pieces:
        drawn.line((start, 50), (end, 50), 2.0)
    runs = tuple(InkedRun(Run(start, end), 2.0) for start, end in pieces)
    rule = LooseRule(16.0, everywhere=True, faded=5)
    _, kinds = split_loose(
        [InkedShape(LEVEL, runs)], [[None] * 3], clean_sheet(drawn.grey).ink, rule
    )
    assert (AnnotationKind.EXTENSION not in kinds[0]) is kept


def _framed(sketch: Sketch) -> Sketch:
    """A view with closed outlines, on much more paper."""
    drawn = sketch(400, 400).line((60, 20), (220, 20), 2.0).line((60, 180), (220, 180), 2.0)
    return drawn.line((60, 20), (60, 180), 2.0).line((220, 20), (220, 180), 2.0)


def _kept(shape: InkedShape, ink: Mask) -> list[Run]:
    """What stays of a shape's runs on a sheet whose lines are of one width."""
    rule = LooseRule(16.0, everywhere=True, faded=19)
    shapes, kinds = split_loose([shape], [[None] * len(shape.runs)], ink, rule)
    pairs = zip(shapes[0].runs, kinds[0], strict=True)
    return [own.run for own, kind in pairs if kind is None]


def test_what_follows_an_extension_line_beyond_the_outline_is_one(sketch: Sketch) -> None:
    """The outline has cut its run in two, and another one all but closes an area with it."""
    drawn = _framed(sketch).line((10, 70), (140, 70), 2.0).line((10, 100), (140, 100), 2.0)
    ink = clean_sheet(drawn.line((152, 64), (152, 106), 2.0).grey).ink
    runs = (InkedRun(Run(10.0, 55.0), 2.0), InkedRun(Run(63.0, 140.0), 2.0))
    assert not _kept(InkedShape(Line((0.0, 70.0), (1.0, 0.0)), runs), ink)
    inner = InkedShape(Line((0.0, 70.0), (1.0, 0.0)), runs[1:])
    assert _kept(inner, ink)


def test_a_leader_across_a_view_bounds_nothing(sketch: Sketch) -> None:
    """From edge to edge it parts the view in two, as a diameter's line does."""
    way = np.array([0.8, 0.6])
    start, end = np.array([20.0, 10.0]), np.array([20.0, 10.0]) + 226.0 * way
    ink = clean_sheet(_framed(sketch).line(tuple(start), tuple(end), 2.0).grey).ink
    line = Line((20.0, 10.0), (0.8, 0.6))
    leader = InkedShape(line, (InkedRun(Run(0.0, 226.0), 2.0),))
    # Where it crosses the outline, no one knows what is beside it.
    assert sum(run.length for run in _kept(leader, ink)) < 20.0
    edge = InkedShape(line, (InkedRun(Run(50.0, 226.0), 2.0),))
    assert sum(run.length for run in _kept(edge, ink)) > 150.0


def test_an_extension_line_that_ends_before_a_pocket_bounds_nothing(sketch: Sketch) -> None:
    """Its gap is so narrow that it all but closes an area with another one."""
    drawn = _framed(sketch).line((10, 70), (135, 70), 2.0).line((10, 100), (140, 100), 2.0)
    ink = clean_sheet(drawn.line((140, 60), (140, 110), 2.0).grey).ink
    line = InkedShape(Line((0.0, 70.0), (1.0, 0.0)), (InkedRun(Run(10.0, 135.0), 2.0),))
    assert sum(run.length for run in _kept(line, ink)) < 12.0
    edge = InkedShape(Line((0.0, 100.0), (1.0, 0.0)), (InkedRun(Run(10.0, 140.0), 2.0),))
    assert sum(run.length for run in _kept(edge, ink)) > 60.0


def test_an_edge_with_a_gap_in_line_with_an_extension_line_bounds_the_view(
    sketch: Sketch,
) -> None:
    """On a copy: the gap is narrower than what opens an outline."""
    drawn = sketch(400, 400).line((60, 20), (220, 20), 2.0).line((60, 20), (60, 180), 2.0)
    drawn.line((220, 20), (220, 180), 2.0).line((60, 180), (70, 180), 2.0)
    drawn.line((74, 180), (220, 180), 2.0).line((226, 180), (280, 180), 2.0)
    ink = clean_sheet(drawn.grey).ink
    runs = (InkedRun(Run(74.0, 220.0), 2.0), InkedRun(Run(226.0, 280.0), 2.0))
    edge = InkedShape(Line((0.0, 180.0), (1.0, 0.0)), runs)
    assert sum(run.length for run in _kept(edge, ink)) == pytest.approx(146.0, abs=8.0)


def test_an_edge_that_ends_in_a_rounding_bounds_the_view(sketch: Sketch) -> None:
    """An extension line goes on from its other end."""
    drawn = sketch(400, 400).line((60, 20), (200, 20), 2.0).line((60, 180), (220, 180), 2.0)
    drawn.line((60, 20), (60, 180), 2.0).line((220, 40), (220, 180), 2.0)
    ink = clean_sheet(drawn.arc((200, 40), 20.0, 2.0, -np.pi / 2, np.pi / 2).grey).ink
    ink |= clean_sheet(sketch(400, 400).line((220, 180), (220, 240), 2.0).grey).ink
    edge = InkedShape(Line((220.0, 0.0), (0.0, 1.0)), (InkedRun(Run(38.0, 240.0), 2.0),))
    assert sum(run.length for run in _kept(edge, ink)) > 130.0


@pytest.mark.parametrize("degrees", [27, 35, 45, 60, 65])
def test_sharp_corners_do_not_stick_out(sketch: Sketch, degrees: int) -> None:
    """At its tip either edge of a wedge has the same paper on both of its sides."""
    height = 120.0
    width = height * float(np.tan(np.radians(degrees)))
    corners = [(120.0, 90.0), (120.0, 210.0), (120.0 + width, 210.0), (120.0, 90.0)]
    sheet = clean_sheet(sketch(500, 480).lines(*corners).grey)
    separated = separate_annotations(sheet)
    assert separated.marks == ()
    assert np.array_equal(separated.part.weight, sheet.weight)


@pytest.mark.parametrize("short", [0.0, 4.0, 7.0])
def test_an_outline_whose_lines_end_short_of_the_corners_bounds_the_view(
    sketch: Sketch, short: float
) -> None:
    corners = [(40, 40), (140, 40), (140, 180), (420, 180), (420, 260), (40, 260)]
    drawn = sketch(900, 700)
    for start, end in pairwise([*corners, corners[0]]):
        along = np.sign(np.subtract(end, start)) * short
        drawn.line(tuple(start + along), tuple(end - along), 3.0)
    # A line that is too long sticks out, and is no annotation for all that.
    drawn.line((420, 180), (420, 175), 3.0)
    assert separate_annotations(clean_sheet(drawn.grey)).marks == ()
