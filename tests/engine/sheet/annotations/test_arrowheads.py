"""Blots that are arrowheads, and those that are not."""

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.arrowheads import Arrowheads, mark_arrows
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.marks import Mark
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

LEVEL = Line((0.0, 50.0), (1.0, 0.0))
WRITING = [Mark(AnnotationKind.TEXT, (90.0, 30.0, 120.0, 44.0))]
LONG = InkedShape(LEVEL, (InkedRun(Run(20.0, 180.0), 2.0),))


@pytest.mark.parametrize(
    ("heads", "marked"),
    [
        ([(28.0, 50.0)], True),
        ([(60.0, 50.0), (140.0, 50.0)], True),
        # A blot where a stroke meets the middle of an edge.
        ([(100.0, 50.0)], False),
        ([(100.0, 58.0), (28.0, 58.0)], False),
    ],
)
def test_arrowheads_tell_dimension_lines(heads: list[tuple[float, float]], marked: bool) -> None:
    kinds: list[list[AnnotationKind | None]] = [[None]]
    told = Arrowheads(np.array(heads), np.full(len(heads), 4.0), np.full(len(heads), 4.0))
    mark_arrows([LONG], kinds, told, np.ones((100, 200), dtype=bool), 2.0, letters=WRITING)
    assert kinds == [[AnnotationKind.DIMENSION if marked else None]]


def _head(x: float, y: float, length: float, half: float) -> Arrowheads:
    return Arrowheads(np.array([[x, y]]), np.array([length]), np.array([half]))


def test_the_line_of_a_large_head_ends_behind_it() -> None:
    """A run goes on as far as the middle of a head that has no ridge."""
    shapes: list[InkedShape] = [LONG]
    kinds: list[list[AnnotationKind | None]] = [[None]]
    ink = np.ones((100, 220), dtype=bool)
    mark_arrows(shapes, kinds, _head(188.0, 50.0, 20.0, 4.0), ink, 2.0, letters=WRITING)
    assert kinds == [[AnnotationKind.DIMENSION]]
    assert shapes[0].runs[0].run == Run(20.0, 188.0)
    kinds = [[None]]
    mark_arrows([LONG], kinds, _head(198.0, 50.0, 20.0, 4.0), ink, 2.0, letters=WRITING)
    assert kinds == [[None]]


def test_a_blot_beside_a_line_is_no_head_of_it() -> None:
    """A leader's head touches the rounding at the end of an edge."""
    kinds: list[list[AnnotationKind | None]] = [[None]]
    ink = np.zeros((100, 220), dtype=bool)
    ink[49:60, 20:180] = True
    mark_arrows([LONG], kinds, _head(28.0, 51.0, 6.0, 4.0), ink, 2.0, letters=WRITING)
    assert kinds == [[None]]


@pytest.mark.parametrize(
    ("place", "half", "way", "told"),
    [
        (3.0, 2.2, (0.8, 0.6), False),
        (3.0, 3.5, (0.8, 0.6), True),
        (8.0, 2.2, (0.8, 0.6), True),
        (8.0, 2.2, (1.0, 0.0), False),
        (8.0, 3.5, (1.0, 0.0), True),
    ],
)
def test_small_blots_are_heads_within_slanted_lines(
    place: float, half: float, way: tuple[float, float], told: bool
) -> None:
    """At their ends, and on level ones, other strokes make them too."""
    line = Line((20.0, 20.0), way)
    shape = InkedShape(line, (InkedRun(Run(0.0, 100.0), 2.0),))
    kinds: list[list[AnnotationKind | None]] = [[None]]
    head = _head(*line.at(place), 3.0, half)
    mark_arrows([shape], kinds, head, np.ones((200, 220), dtype=bool), 2.0, letters=WRITING)
    assert (kinds == [[AnnotationKind.DIMENSION]]) is told


@pytest.mark.parametrize(("at", "told"), [(0.0, False), (8.0, True)])
def test_where_edges_meet_at_a_flat_angle_there_is_no_head(at: float, told: bool) -> None:
    """A slanted edge that passes into an upright one on a level one, or a leader."""
    way = (0.12, -0.9928)
    slanted = InkedShape(Line((100.0, 100.0), way), (InkedRun(Run(-10.0, 300.0), 3.0),))
    level = InkedShape(Line((0.0, 100.0), (1.0, 0.0)), (InkedRun(Run(20.0, 180.0), 3.0),))
    upright = InkedShape(Line((100.0, 100.0), (0.0, 1.0)), (InkedRun(Run(-4.0, 90.0), 3.0),))
    kinds: list[list[AnnotationKind | None]] = [[None], [None], [None]]
    ink = np.ones((220, 220), dtype=bool)
    head = _head(100.0 + at * way[0], 100.0 + at * way[1], 2.0, 3.0)
    mark_arrows([slanted, level, upright], kinds, head, ink, 3.0, letters=WRITING)
    assert kinds == [[AnnotationKind.DIMENSION if told else None], [None], [None]]


@pytest.mark.parametrize(
    ("writing", "heads", "told"),
    [
        (WRITING, 1, True),
        ([], 1, False),
        ([Mark(AnnotationKind.TEXT, (80.0, 300.0, 120.0, 314.0))], 1, False),
        ([], 2, True),
    ],
)
def test_one_head_alone_has_writing_near_its_line(
    writing: list[Mark], heads: int, told: bool
) -> None:
    middles = np.array([(28.0, 50.0), (172.0, 50.0)])[:heads]
    found = Arrowheads(middles, np.full(heads, 4.0), np.full(heads, 4.0))
    kinds: list[list[AnnotationKind | None]] = [[None]]
    mark_arrows([LONG], kinds, found, np.ones((100, 200), dtype=bool), 2.0, letters=writing)
    assert kinds == [[AnnotationKind.DIMENSION if told else None]]


@pytest.mark.parametrize(("near", "told"), [(True, True), (False, False)])
def test_two_small_blots_have_writing_near_their_line(near: bool, told: bool) -> None:
    """Three strokes that meet on a slanted edge make such blots, on sheets without dimensions."""
    line = Line((20.0, 20.0), (0.8, 0.6))
    shape = InkedShape(line, (InkedRun(Run(0.0, 100.0), 2.0),))
    blots = Arrowheads(
        np.array([line.at(30.0), line.at(70.0)]), np.array([2.0, 2.0]), np.array([2.2, 2.2])
    )
    writing = [Mark(AnnotationKind.TEXT, (60.0, 20.0, 90.0, 34.0) if near else (0.0, 180, 30, 194))]
    kinds: list[list[AnnotationKind | None]] = [[None]]
    mark_arrows([shape], kinds, blots, np.ones((200, 220), dtype=bool), 2.0, letters=writing)
    assert kinds == [[AnnotationKind.DIMENSION if told else None]]


@pytest.mark.parametrize("rows", [1, 2])
def test_a_dot_is_the_head_of_the_line_that_ends_at_it(rows: int) -> None:
    """The extension line goes on beyond it, and may go on from an edge without a gap."""
    shapes = [
        InkedShape(Line((0.0, y), (1.0, 0.0)), (InkedRun(Run(20.0, 100.5), 3.0),))
        for y in (50.0, 80.0)[:rows]
    ]
    upright = InkedShape(Line((100.0, 0.0), (0.0, 1.0)), (InkedRun(Run(42.0, 190.0), 3.0),))
    dots = Arrowheads(
        np.array([(100.0, 50.0), (100.0, 80.0)])[:rows], np.full(rows, 5.0), np.full(rows, 6.0)
    )
    kinds: list[list[AnnotationKind | None]] = [[None] for _ in range(rows + 1)]
    ink = np.ones((200, 200), dtype=bool)
    mark_arrows([*shapes, upright], kinds, dots, ink, 3.0, letters=WRITING)
    assert kinds == [[AnnotationKind.DIMENSION]] * rows + [[None]]
