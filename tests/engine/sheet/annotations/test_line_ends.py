"""Arrowheads go with their dimension lines, and so do extension lines that nothing explained."""

import cv2
import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.line_ends import (
    extension_lines,
    mark_doubled,
    mark_heads,
)
from gaussiancad_core.sheet.annotations.lines import Weights
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.ridges import ridge_points
from gaussiancad_core.sheet.runs import Run

EXTENSION = AnnotationKind.EXTENSION
WIDTH = 2.0
LEVEL = Line((0.0, 50.0), (1.0, 0.0))
DIMENSION = InkedShape(LEVEL, (InkedRun(Run(20.0, 140.0), WIDTH),))


def _arc(length: float, width: float | None, depth: float = 50.0) -> InkedShape:
    """The arc that touches a level line at x = 140 and comes from the left."""
    radius = 100.0
    end = 1.5 * np.pi * radius
    runs = (InkedRun(Run(end - length, end), width),)
    return InkedShape(Circle((140.0, depth + radius), radius), runs)


@pytest.mark.parametrize(
    ("arc", "kind"),
    [
        (_arc(14.0, None), EXTENSION),
        # Ink of its own: a rounded corner at which the dimension line ends.
        (_arc(14.0, WIDTH), None),
        # It leads on, or lies elsewhere.
        (_arc(40.0, None), None),
        (_arc(14.0, None, depth=80.0), None),
    ],
    ids=["head", "inked", "long", "elsewhere"],
)
def test_an_arrowheads_contour(arc: InkedShape, kind: AnnotationKind | None) -> None:
    kinds = [[EXTENSION], [None]]
    mark_heads([DIMENSION, arc], kinds, WIDTH)
    assert kinds == [[EXTENSION], [kind]]
    # By itself it is what it is.
    kinds = [[None], [None]]
    mark_heads([DIMENSION, arc], kinds, WIDTH)
    assert kinds == [[None], [None]]


def _sheet(*lines: tuple[tuple[int, int], tuple[int, int]]) -> CleanSheet:
    ink = np.zeros((120, 200), np.uint8)
    for start, end in lines:
        cv2.line(ink, start, end, 255, 2)
    weight = (ink / 255.0).astype(np.float32)
    return CleanSheet(weight > 0.5, weight, WIDTH, 0.0)


@pytest.mark.parametrize(
    ("upright", "limit", "found"),
    [
        (((140, 44), (140, 80)), 4.0, True),
        # It ends before the dimension line, or runs past its end.
        (((140, 60), (140, 96)), 4.0, False),
        (((150, 44), (150, 80)), 4.0, False),
        # Not square to it, or an edge by its width.
        (((140, 44), (160, 80)), 4.0, False),
        (((140, 44), (140, 80)), 1.0, False),
        # As short as a dash.
        (((140, 48), (140, 52)), 4.0, False),
    ],
    ids=["met", "apart", "beside", "slanted", "wide", "short"],
)
def test_an_extension_line_that_no_shape_explains(
    upright: tuple[tuple[int, int], tuple[int, int]], limit: float, found: bool
) -> None:
    sheet = _sheet(upright)
    ridges = ridge_points(sheet.weight, WIDTH)
    free = np.ones(len(ridges.points), dtype=bool)
    lines = extension_lines(sheet, (ridges, free), ([DIMENSION], [[EXTENSION]]), limit)
    assert len(lines) == found
    for shape in lines:
        assert abs(shape.geometry.direction[1]) == pytest.approx(1.0, abs=0.02)
        assert shape.runs[0].run.length == pytest.approx(37.0, abs=3.0)
    # What other shapes explain is not looked at.
    assert not extension_lines(sheet, (ridges, ~free), ([DIMENSION], [[EXTENSION]]), limit)


@pytest.mark.parametrize(
    ("cut", "gap", "across", "width", "marked"),
    [
        (70.0, 0.0, None, 3.6, True),
        # An edge ends at another one, is wider, or has a gap before its extension line.
        (70.0, 0.0, 24, 3.6, False),
        (70.0, 0.0, None, 4.4, False),
        (70.0, 4.0, None, 3.6, False),
    ],
    ids=["twice", "edge", "wide", "gap"],
)
def test_an_extension_line_that_is_drawn_twice_is_wider(
    cut: float, gap: float, across: int | None, width: float, marked: bool
) -> None:
    """Two dimensions from one corner have a line beside the other as far as the nearer one's."""
    upright = Line((100.0, 0.0), (0.0, 1.0))
    runs = InkedRun(Run(25.0, cut), width), InkedRun(Run(cut + gap, 110.0), 3.0)
    shapes = [DIMENSION, InkedShape(upright, runs)]
    kinds: list[list[AnnotationKind | None]] = [[EXTENSION], [None, EXTENSION]]
    # The outline is a gap before its end.
    lines = [((100, 25), (100, 110)), ((40, 18), (160, 18))]
    if across is not None:
        lines.append(((40, across), (160, across)))
    mark_doubled(shapes, kinds, _sheet(*lines).ink, Weights(4.0, 3.3), 12.0)
    assert kinds[1] == [EXTENSION if marked else None, EXTENSION]


@pytest.mark.parametrize(("apart", "marked"), [(8.0, False), (20.0, True)])
@pytest.mark.parametrize("turned", [False, True])
def test_an_edge_that_goes_on_in_dashes_is_no_extension_line(
    apart: float, marked: bool, turned: bool
) -> None:
    """Of an edge that leads to the paper an extension line is left, and behind what hides it dashes
    are: the first of them ends free."""
    spans = [(25.0 - apart - 12.0, 25.0 - apart, 3.0), (25.0, 70.0, 3.8), (70.0, 110.0, 2.0)]
    own: list[AnnotationKind | None] = [None, None, EXTENSION]
    if turned:
        spans = [(-end, -start, width) for start, end, width in reversed(spans)]
        own.reverse()
    upright = Line((100.0, 0.0), (0.0, -1.0 if turned else 1.0))
    runs = tuple(InkedRun(Run(start, end), width) for start, end, width in spans)
    kinds: list[list[AnnotationKind | None]] = [own]
    lines = ((100, 25), (100, 110)), ((100, int(13 - apart)), (100, int(25 - apart)))
    ink = _sheet(*lines).ink
    mark_doubled([InkedShape(upright, runs)], kinds, ink, Weights(4.0, 2.8), 12.0)
    assert kinds[0][1] is (EXTENSION if marked else None)


@pytest.mark.parametrize(("length", "marked"), [(12.0, False), (36.0, False), (80.0, True)])
def test_the_edge_that_an_extension_line_leaves_a_gap_to_is_no_dash(
    length: float, marked: bool
) -> None:
    spans = [(20.0 - 10.0 - length, 10.0, 3.9), (20.0, 65.0, 3.8), (65.0, 105.0, 2.0)]
    runs = tuple(InkedRun(Run(start, end), width) for start, end, width in spans)
    kinds: list[list[AnnotationKind | None]] = [[None, None, EXTENSION]]
    upright = Line((100.0, 90.0), (0.0, 1.0))
    ink = _sheet(((100, 110), (100, 195)), ((100, int(100 - length)), (100, 100))).ink
    mark_doubled([InkedShape(upright, runs)], kinds, ink, Weights(4.0, 2.8), 12.0)
    assert kinds[0][1] is (EXTENSION if marked else None)
