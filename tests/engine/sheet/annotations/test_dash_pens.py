"""Dashes of a middle pen are no extension lines, where three pens were used."""

import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.dash_pens import spare_by_pen
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.lines import Weights
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

EXTENSION, CENTRE = AnnotationKind.EXTENSION, AnnotationKind.CENTRE_LINE
WEIGHTS, WIDTH = Weights(3.0, 2.2), 2.4
NARROW = 1.4


def _shape(*pieces: tuple[float, float, float]) -> InkedShape:
    line = Line((0.0, 50.0), (1.0, 0.0))
    return InkedShape(line, tuple(InkedRun(Run(a, b), width) for a, b, width in pieces))


def _sheet(hidden: float, narrow: tuple[float, ...]) -> tuple[list, list]:
    """Dashes of 12 px at gaps of 6 with one pen, and long narrow lines of some widths."""
    dashes = _shape(*((18.0 * k, 18.0 * k + 12.0, hidden) for k in range(8)))
    lines = [_shape((0.0, 90.0, width)) for width in narrow]
    return [dashes, *lines], [[None] * 8, *([EXTENSION] for _ in lines)]


@pytest.mark.parametrize(
    ("run", "spared"),
    [
        ((100.0, 112.0, 1.95), True),
        # Two dashes that a stroke across their gap joins.
        ((100.0, 130.0, 1.95), True),
        # As narrow as a dimension line, as long as one, or of unknown width.
        ((100.0, 112.0, 1.45), False),
        ((100.0, 180.0, 1.95), False),
        ((100.0, 112.0, None), False),
        # A dot.
        ((100.0, 104.0, 1.95), False),
    ],
    ids=["dash", "two", "narrow", "long", "covered", "dot"],
)
def test_a_piece_as_long_as_a_dash_and_as_wide(
    run: tuple[float, float, float], spared: bool
) -> None:
    for kind, expected in ((EXTENSION, None if spared else EXTENSION), (CENTRE, CENTRE)):
        shapes, kinds = _sheet(2.0, (NARROW,) * 8)
        shapes.append(_shape(run))
        kinds.append([kind])
        spare_by_pen(shapes, kinds, WEIGHTS, WIDTH)
        assert kinds[-1] == [expected]
        # Nothing else changes.
        assert kinds[:-1] == _sheet(2.0, (NARROW,) * 8)[1]


@pytest.mark.parametrize(
    ("hidden", "narrow"),
    [
        (1.5, (NARROW,) * 8),  # one pen for both
        (2.0, (NARROW,) * 3),  # too few lines to know their pen
        (2.0, (*(NARROW,) * 6, 2.1, 2.1)),  # narrow lines of many widths
    ],
    ids=["one", "few", "many"],
)
def test_where_the_pens_are_not_told_apart_nothing_is_spared(
    hidden: float, narrow: tuple[float, ...]
) -> None:
    shapes, kinds = _sheet(hidden, narrow)
    shapes.append(_shape((100.0, 112.0, 1.95)))
    kinds.append([EXTENSION])
    before = [list(own) for own in kinds]
    spare_by_pen(shapes, kinds, WEIGHTS, WIDTH)
    assert kinds == before
