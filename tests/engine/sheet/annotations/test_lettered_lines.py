"""Dimension lines whose heads are lost, and edges under writing."""

from typing import Any

import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.lettered_lines import mark_lettered
from gaussiancad_core.sheet.annotations.marks import Mark
from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

NUMBER = (85.0, 40.0, 115.0, 54.0)


def _marked(
    sketch: Sketch, word: Box, beyond: float = 8.0, kind: AnnotationKind = AnnotationKind.TEXT
) -> bool:
    """A level line at y = 60 from 40 to 160, strokes across both of its ends that lead up to y = 20
    or down from y = 100, and go on beyond it for some px."""
    drawn = sketch().line((40, 60), (160, 60), 3.0)
    drawn.line((40, 60 - beyond), (40, 100), 3.0).line((160, 60 - beyond), (160, 100), 3.0)
    shape = InkedShape(Line((0.0, 60.0), (1.0, 0.0)), (InkedRun(Run(40.0, 160.0), 3.0),))
    kinds: list[list[AnnotationKind | None]] = [[None]]
    mark_lettered([shape], kinds, [Mark(kind, word)], clean_sheet(drawn.grey).ink, 3.0)
    return kinds == [[AnnotationKind.DIMENSION]]


def test_a_number_above_its_middle_tells_a_dimension_line(sketch: Sketch) -> None:
    assert _marked(sketch, NUMBER)


def test_an_edge_between_corners_is_none(sketch: Sketch) -> None:
    assert not _marked(sketch, NUMBER, beyond=0.0)


@pytest.mark.parametrize(
    "word",
    [
        # Beside the middle, far above, below, longer than the line.
        (45.0, 40.0, 75.0, 54.0),
        (85.0, 20.0, 115.0, 34.0),
        (85.0, 66.0, 115.0, 80.0),
        (30.0, 40.0, 170.0, 54.0),
    ],
)
def test_writing_elsewhere_says_nothing(sketch: Sketch, word: Box) -> None:
    assert not _marked(sketch, word)


def test_an_upright_line_has_its_number_on_the_left(sketch: Sketch) -> None:
    drawn = sketch().line((60, 30), (60, 130), 3.0)
    drawn.line((50, 30), (150, 30), 3.0).line((50, 130), (150, 130), 3.0)
    ink = clean_sheet(drawn.grey).ink
    shape = InkedShape(Line((60.0, 0.0), (0.0, 1.0)), (InkedRun(Run(30.0, 130.0), 3.0),))
    for word, told in (((40.0, 65.0, 54.0, 95.0), True), ((66.0, 65.0, 80.0, 95.0), False)):
        kinds: list[list[AnnotationKind | None]] = [[None]]
        mark_lettered([shape], kinds, [Mark(AnnotationKind.TEXT, word)], ink, 3.0)
        assert (kinds == [[AnnotationKind.DIMENSION]]) is told


@pytest.mark.parametrize("upright", [False, True])
@pytest.mark.parametrize(
    ("word", "told"),
    [
        ((87.0, 53.0, 113.0, 67.0), True),
        # Right above the line, at one of its pieces, far too small for the blank.
        ((87.0, 40.0, 113.0, 54.0), False),
        ((50.0, 53.0, 76.0, 67.0), False),
        ((99.0, 59.0, 101.0, 61.0), False),
    ],
)
def test_a_line_broken_for_its_number_is_a_dimension_line(
    sketch: Sketch, word: Box, told: bool, upright: bool
) -> None:
    """Without any heads, or with strokes across its ends."""
    ends = (
        ((40, 60), (82, 60)),
        ((118, 60), (160, 60)),
        ((40, 52), (40, 100)),
        ((160, 52), (160, 90)),
    )
    drawn = sketch()
    for start, end in ends:
        drawn.line(*((start[::-1], end[::-1]) if upright else (start, end)), 3.0)
    line = Line((60.0, 0.0), (0.0, 1.0)) if upright else Line((0.0, 60.0), (1.0, 0.0))
    runs = InkedRun(Run(40.0, 82.0), 3.0), InkedRun(Run(118.0, 160.0), 3.0)
    kinds: list[list[AnnotationKind | None]] = [[None, None]]
    box = (word[1], word[0], word[3], word[2]) if upright else word
    text = [Mark(AnnotationKind.TEXT, box)]
    mark_lettered([InkedShape(line, runs)], kinds, text, clean_sheet(drawn.grey).ink, 3.0)
    assert kinds == [[AnnotationKind.DIMENSION] * 2 if told else [None, None]]


def test_an_edge_behind_writing_ends_at_corners(sketch: Sketch) -> None:
    """A program that leaves paper around a note breaks the edge that runs behind it."""
    drawn = sketch().line((40, 60), (82, 60), 3.0).line((118, 60), (160, 60), 3.0)
    drawn.line((40, 60), (40, 100), 3.0).line((160, 60), (160, 100), 3.0)
    runs = InkedRun(Run(40.0, 82.0), 3.0), InkedRun(Run(118.0, 160.0), 3.0)
    shape = InkedShape(Line((0.0, 60.0), (1.0, 0.0)), runs)
    kinds: list[list[AnnotationKind | None]] = [[None, None]]
    text = [Mark(AnnotationKind.TEXT, (87.0, 53.0, 113.0, 67.0))]
    mark_lettered([shape], kinds, text, clean_sheet(drawn.grey).ink, 3.0)
    assert kinds == [[None, None]]


@pytest.mark.parametrize(
    ("corner", "word", "told"),
    [
        (False, (85.0, 40.0, 115.0, 54.0), True),
        # Both ends meet other edges; the word is far above, or elsewhere.
        (True, (85.0, 40.0, 115.0, 54.0), False),
        (False, (85.0, 20.0, 115.0, 34.0), False),
        (False, (150.0, 40.0, 180.0, 54.0), False),
    ],
)
def test_the_shoulder_of_a_leader_ends_free(
    sketch: Sketch, corner: bool, word: Box, told: bool
) -> None:
    drawn = sketch().line((82, 60), (118, 60), 2.0).line((82, 60), (50, 100), 2.0)
    if corner:
        drawn.line((118, 60), (118, 100), 2.0)
    shape = InkedShape(Line((0.0, 60.0), (1.0, 0.0)), (InkedRun(Run(82.0, 118.0), 2.0),))
    kinds: list[list[AnnotationKind | None]] = [[None]]
    text = [Mark(AnnotationKind.TEXT, word)]
    mark_lettered([shape], kinds, text, clean_sheet(drawn.grey).ink, 2.0)
    assert kinds == [[AnnotationKind.LEADER if told else None]]
