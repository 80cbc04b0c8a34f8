"""Labels by those of the lines that a line meets."""

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape
from gaussiancad_core.sheet.labels.ink_classes import Evidence, InkClass
from gaussiancad_core.sheet.labels.line_decoding import LabelledRun
from gaussiancad_core.sheet.labels.line_relations import related
from gaussiancad_core.sheet.tracing.ink_runs import Run

WIDTH = 3.0

DOUBTFUL = InkClass.VISIBLE, 0.8


def piece(
    start: tuple[float, float], end: tuple[float, float], ink: InkClass, odds: float
) -> tuple[InkedShape, list[LabelledRun]]:
    """A straight line with a label, and log-odds against the rest."""
    way = np.subtract(end, start)
    length = float(np.hypot(*way))
    run = InkedRun(Run(0.0, length), WIDTH)
    log_p = np.full(len(InkClass), -9.0)
    is_part = ink in (InkClass.VISIBLE, InkClass.HIDDEN)
    log_p[ink] = -0.1
    log_p[InkClass.OTHER if is_part else InkClass.VISIBLE] = -0.1 - odds
    shape = InkedShape(Line(start, tuple(way / length)), (run,))
    return shape, [LabelledRun(run, ink, odds if is_part else -odds, log_p)]


def found(*pieces: tuple[InkedShape, list[LabelledRun]]) -> list[LabelledRun]:
    shapes, labelled = zip(*pieces, strict=True)
    return [item for each in related(shapes, list(labelled), WIDTH) for item in each]


def inks(*pieces: tuple[InkedShape, list[LabelledRun]]) -> list[InkClass]:
    return [item.ink for item in found(*pieces)]


CORNERS = [(0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0)]


def square(last: InkClass, odds: float) -> list[tuple[InkedShape, list[LabelledRun]]]:
    """Four lines around a square, the last one with another label."""
    kinds = [InkClass.VISIBLE] * 3 + [last]
    return [
        piece(CORNERS[k], CORNERS[(k + 1) % 4], kind, 4.0 if k < 3 else odds)
        for k, kind in enumerate(kinds)
    ]


BUMP = [(0.0, 20.0), (-30.0, 25.0), (-30.0, 55.0), (0.0, 60.0)]


def bump(*kinds: tuple[InkClass, float]) -> list[tuple[InkedShape, list[LabelledRun]]]:
    """Three lines that go round on one side of the square."""
    return [piece(BUMP[k], BUMP[k + 1], *kind) for k, kind in enumerate(kinds)]


STRAY, DASH = ((300.0, 300.0), (360.0, 330.0)), ((20.0, 40.0), (32.0, 40.0))
HALVES = [
    piece((0.0, 80.0), (0.0, 40.0), InkClass.OTHER, 1.0),
    piece((0.0, 40.0), (0.0, 0.0), InkClass.OTHER, 1.0),
]


@pytest.mark.parametrize(
    ("pieces", "wanted"),
    [
        (square(InkClass.OTHER, 1.0), InkClass.VISIBLE),
        (square(InkClass.DIMENSION, 4.0), InkClass.DIMENSION),
        ([*square(InkClass.OTHER, 1.0)[:3], *HALVES], InkClass.VISIBLE),
        ([*square(InkClass.VISIBLE, 4.0), piece(*STRAY, *DOUBTFUL)], InkClass.OTHER),
        ([*square(InkClass.VISIBLE, 4.0), piece(*STRAY, InkClass.VISIBLE, 4.0)], InkClass.VISIBLE),
        ([*square(InkClass.VISIBLE, 4.0), piece(*DASH, InkClass.HIDDEN, 1.5)], InkClass.HIDDEN),
    ],
    ids=["it closes an outline", "a sure one", "two close it together", "loose ends",
         "loose ends of a sure one", "dashes have loose ends"],
)  # fmt: skip
def test_a_line_is_what_those_that_it_meets_make_of_it(
    pieces: list[tuple[InkedShape, list[LabelledRun]]], wanted: InkClass
) -> None:
    kinds = inks(*pieces)
    assert kinds[-1] is wanted
    assert set(kinds[:3]) == {InkClass.VISIBLE}


@pytest.mark.parametrize("middle", [(InkClass.VISIBLE, 1.2), (InkClass.OTHER, 1.0)])
def test_annotation_has_no_corners_that_edges_have(middle: tuple[InkClass, float]) -> None:
    """A bump is an outline, though each of its lines may be annotation."""
    doubt = InkClass.OTHER, 1.0
    whole = [*square(InkClass.VISIBLE, 4.0), *bump(doubt, middle, doubt)]
    assert inks(*whole) == [InkClass.VISIBLE] * 7
    # What runs past its neighbour, as extension and dimension lines do, has none.
    past = [
        piece(BUMP[0], (-36.0, 26.0), *doubt),
        piece((-30.0, 15.0), (-30.0, 65.0), InkClass.OTHER, 1.0),
        piece((-36.0, 54.0), BUMP[3], *doubt),
    ]
    assert inks(*square(InkClass.VISIBLE, 4.0), *past)[4:] == [InkClass.OTHER] * 3


def test_who_turned_a_line_is_known_and_how_surely() -> None:
    *sides, last = found(*square(InkClass.DIMENSION, 1.0))
    assert {side.why for side in sides} == {Evidence.NETWORK}
    assert last.why is Evidence.LOOSE_END
    # Two loose ends and two corners of annotation less, against what its ink says.
    assert last.support == 2 * 6.0 + 2 * 2.0 - abs(last.evidence)
    *_, stray = found(*square(InkClass.VISIBLE, 4.0), piece((9.0, 9.0), (29.0, 9.0), *DOUBTFUL))
    assert (stray.ink, stray.why) == (InkClass.OTHER, Evidence.LOOSE_END)
    *_, last = found(*square(InkClass.PICTORIAL, 2.0))
    assert last.why is Evidence.FIGURE


def test_a_figure_is_of_one_kind() -> None:
    assert inks(*square(InkClass.PICTORIAL, 2.0)) == [InkClass.VISIBLE] * 4
    mostly = [piece(CORNERS[k], CORNERS[k + 1], InkClass.PICTORIAL, 4.0) for k in range(3)]
    mostly.append(piece(CORNERS[3], CORNERS[0], InkClass.VISIBLE, 1.0))
    assert inks(*mostly) == [InkClass.PICTORIAL] * 4


def test_nothing_is_related_to_nothing() -> None:
    assert related([], [], WIDTH) == []
