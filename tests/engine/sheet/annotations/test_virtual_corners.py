"""Extension lines that meet in the corner that a rounding has cut off."""

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.virtual_corners import mark_virtual_corners
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

EXTENSION = AnnotationKind.EXTENSION
WIDTH = 3.0
RADIUS = 40.0


def _corner(beyond: float) -> tuple[list[InkedShape], list[list[AnnotationKind | None]]]:
    """The left lower corner (100, 300) of a plate, its rounding, and lines that lead beyond it."""
    level = InkedShape(
        Line((100.0, 300.0), (1.0, 0.0)),
        (InkedRun(Run(-beyond, 0.0), WIDTH), InkedRun(Run(0.0, 400.0), WIDTH)),
    )
    upright = InkedShape(
        Line((100.0, 300.0), (0.0, 1.0)),
        (InkedRun(Run(-200.0, 0.0), WIDTH), InkedRun(Run(0.0, beyond), WIDTH)),
    )
    start = RADIUS * np.pi / 2
    arc = InkedShape(
        Circle((100.0 + RADIUS, 300.0 - RADIUS), RADIUS),
        (InkedRun(Run(start, 2.0 * start), WIDTH),),
    )
    return [level, upright, arc], [[EXTENSION, None], [None, EXTENSION], [None]]


def _told(
    shape: InkedShape, own: list[AnnotationKind | None], kind: AnnotationKind | None
) -> list[tuple[float, float]]:
    pairs = zip(shape.runs, own, strict=True)
    return [(run.run.start, run.run.end) for run, told in pairs if told is kind]


def test_the_way_to_the_corner_is_the_extension_lines() -> None:
    shapes, kinds = _corner(60.0)
    mark_virtual_corners(shapes, kinds, WIDTH)
    assert _told(shapes[0], kinds[0], None) == [(pytest.approx(RADIUS), 400.0)]
    assert _told(shapes[0], kinds[0], EXTENSION) == [(-60.0, 0.0), (0.0, pytest.approx(RADIUS))]
    assert _told(shapes[1], kinds[1], None) == [(-200.0, pytest.approx(-RADIUS))]
    assert kinds[2] == [None]


def test_a_corner_behind_a_rounding_stays() -> None:
    """No line leads on beyond it on one side."""
    shapes, kinds = _corner(60.0)
    shapes[1] = InkedShape(shapes[1].geometry, shapes[1].runs[:1])
    kinds[1] = [None]
    mark_virtual_corners(shapes, kinds, WIDTH)
    assert _told(shapes[0], kinds[0], None) == [(0.0, 400.0)]
    assert kinds[1] == [None]


def test_a_circle_that_touches_both_lines_elsewhere_is_no_rounding() -> None:
    shapes, kinds = _corner(60.0)
    shapes[2] = InkedShape(shapes[2].geometry, (InkedRun(Run(0.0, RADIUS), WIDTH),))
    mark_virtual_corners(shapes, kinds, WIDTH)
    assert _told(shapes[0], kinds[0], None) == [(0.0, 400.0)]
