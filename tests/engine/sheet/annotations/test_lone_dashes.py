"""Single dashes between edges are hidden lines; extension lines end free."""

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.lines import Weights
from gaussiancad_core.sheet.annotations.lone_dashes import spare_free_dashes, spare_lone_dashes
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

EXTENSION = AnnotationKind.EXTENSION
WEIGHTS, WIDTH = Weights(3.0, 2.4), 2.4


def _level(y: float, *pieces: tuple[float, float], width: float) -> InkedShape:
    line = Line((0.0, y), (1.0, 0.0))
    return InkedShape(line, tuple(InkedRun(Run(a, b), width) for a, b in pieces))


def _upright(x: float, *pieces: tuple[float, float]) -> InkedShape:
    line = Line((x, 0.0), (0.0, 1.0))
    return InkedShape(line, tuple(InkedRun(Run(a, b), 1.8) for a, b in pieces))


DASHES = _level(200.0, *((18.0 * k, 18.0 * k + 12.0) for k in range(8)), width=1.8)
"""Tells the rhythm: dashes of 12 px at gaps of 6."""

PLATE = [_level(50.0, (20.0, 180.0), width=3.0), _level(71.0, (20.0, 180.0), width=3.0)]


@pytest.mark.parametrize(
    ("pieces", "spared"),
    [
        # Through a plate: one dash, a gap, and a stub that is too short to be a run.
        ([(51.0, 63.0)], True),
        # It ends before the other edge is near, or begins at none, or is longer than a dash.
        ([(42.0, 49.0)], False),
        ([(80.0, 92.0)], False),
        ([(71.0, 95.0)], False),
        # Another run is beside it: the rhythm tells.
        ([(51.0, 60.0), (63.0, 68.0)], False),
    ],
    ids=["plate", "beyond", "elsewhere", "long", "row"],
)
def test_a_dash_between_two_edges(pieces: list[tuple[float, float]], spared: bool) -> None:
    shapes = [*PLATE, DASHES, _upright(100.0, *pieces)]
    kinds = [[None] * len(shape.runs) for shape in shapes[:-1]] + [[EXTENSION] * len(pieces)]
    ink = np.zeros((220, 220), bool)
    ink[49:52, 20:180] = ink[70:73, 20:180] = True
    # The stub at the other edge.
    ink[68:70, 99:102] = True
    spare_lone_dashes(shapes, kinds, ink, WEIGHTS, WIDTH)
    assert kinds[-1] == [None if spared else EXTENSION] * len(pieces)
    # Without edges nothing is bounded.
    kinds[-1] = [EXTENSION] * len(pieces)
    spare_lone_dashes(shapes[2:], kinds[2:], ink, WEIGHTS, WIDTH)
    assert kinds[-1] == [EXTENSION] * len(pieces)


def test_a_sheet_without_dashes_has_none_to_spare() -> None:
    """Runs that were cut where their width changes lie side by side, as dashes without gaps."""
    cut = [_upright(60.0 + 9.0 * k, (51.0, 63.0), (63.0, 71.0), (71.0, 84.0)) for k in range(3)]
    shapes = [*PLATE, *cut, _upright(110.0, (51.0, 60.0))]
    kinds = [[None] * len(shape.runs) for shape in shapes[:-1]] + [[EXTENSION]]
    spare_lone_dashes(shapes, kinds, np.zeros((220, 220), bool), WEIGHTS, WIDTH)
    assert kinds[-1] == [EXTENSION]


@pytest.mark.parametrize("beside", ["nothing", "annotation", "no corner"])
def test_a_slanted_dash_that_begins_at_a_hidden_corner(beside: str) -> None:
    """That of a countersink; a stroke of an arrowhead has others beside it."""
    x = 100.0 if beside != "no corner" else 110.0
    row = _level(120.0, *((x + 18.0 * k, x + 12.0 + 18.0 * k) for k in range(3)), width=1.8)
    half = 0.5**0.5
    slanted = InkedShape(Line((101.0, 121.0), (half, half)), (InkedRun(Run(-14.0, 0.0), 1.8),))
    shapes = [*PLATE, DASHES, row, slanted]
    kinds = [[None] * len(shape.runs) for shape in shapes[:-1]] + [[EXTENSION]]
    if beside == "annotation":
        shapes.append(_upright(91.0, (80.0, 112.0)))
        kinds.append([EXTENSION])
    spare_lone_dashes(shapes, kinds, np.zeros((220, 220), bool), WEIGHTS, WIDTH)
    assert kinds[len(PLATE) + 2] == [None if beside == "nothing" else EXTENSION]


@pytest.mark.parametrize("met", ["level", "upright"])
def test_an_upright_dash_that_leaves_a_hidden_corner(met: str) -> None:
    """Of the end of a pocket one dash is seen, and a gap before the edge above."""
    row = _level(120.0, *((100.0 + 18.0 * k, 112.0 + 18.0 * k) for k in range(3)), width=1.8)
    if met == "upright":
        row = _upright(100.0, *((121.0 + 18.0 * k, 133.0 + 18.0 * k) for k in range(3)))
    shapes = [*PLATE, DASHES, row, _upright(100.5, (108.0, 120.0))]
    kinds = [[None] * len(shape.runs) for shape in shapes[:-1]] + [[EXTENSION]]
    spare_lone_dashes(shapes, kinds, np.zeros((220, 220), bool), WEIGHTS, WIDTH)
    assert kinds[-1] == [None if met == "level" else EXTENSION]


@pytest.mark.parametrize("beside", [False, True])
def test_two_dashes_that_leave_one_hidden_corner(beside: bool) -> None:
    """Of a countersink and of its bore one dash each is seen; where an arrowhead's line is beside
    both of them, they are its strokes.  The upright one leans as a dash of whole pixels may."""
    row = _level(120.0, *((100.0 + 18.0 * k, 112.0 + 18.0 * k) for k in range(3)), width=1.8)
    half, lean = 0.5**0.5, 0.03
    ways = (-half, -half), (lean, (1.0 - lean**2) ** 0.5)
    two = [InkedShape(Line((99.0, 120.5), way), (InkedRun(Run(0.0, 11.0), 1.8),)) for way in ways]
    shapes = [*PLATE, DASHES, row, *two]
    kinds = [[None] * len(shape.runs) for shape in shapes[:-2]] + [[EXTENSION], [EXTENSION]]
    if beside:
        shapes.append(_level(121.0, (60.0, 99.0), width=1.8))
        kinds.append([EXTENSION])
    spare_lone_dashes(shapes, kinds, np.zeros((220, 220), bool), WEIGHTS, WIDTH)
    assert kinds[4:6] == [[EXTENSION if beside else None]] * 2


def test_a_centre_mark_as_wide_as_edges_is_no_dash() -> None:
    """Its own ends would be those of an edge."""
    centre = AnnotationKind.CENTRE_LINE
    shapes = [*PLATE, DASHES, _level(120.0, (94.0, 106.0), width=3.0)]
    kinds = [[None] * len(shape.runs) for shape in shapes[:-1]] + [[centre]]
    spare_lone_dashes(shapes, kinds, np.zeros((220, 220), bool), WEIGHTS, WIDTH)
    assert kinds[-1] == [centre]


@pytest.mark.parametrize(
    ("length", "crossed", "spared"),
    [(22.0, False, True), (22.0, True, False), (40.0, False, False)],
)
def test_a_piece_of_ink_that_touches_nothing_is_two_dashes(
    length: float, crossed: bool, spared: bool
) -> None:
    """Where a dashed circle closes its last dash goes on as its first."""
    shapes = [DASHES, _upright(100.0, (60.0, 60.0 + length))]
    kinds: list[list[AnnotationKind | None]] = [[None] * len(DASHES.runs), [EXTENSION]]
    ink = np.zeros((220, 220), bool)
    ink[60 : 61 + int(length), 99:101] = True
    if crossed:
        ink[64:66, 80:180] = True
    spare_free_dashes(shapes, kinds, ink, 1.8)
    assert kinds[1] == [None if spared else EXTENSION]


@pytest.mark.parametrize(("length", "cross"), [(5.0, False), (10.0, True)])
def test_the_dots_and_the_cross_of_a_centre_mark_are_no_dashes(length: float, cross: bool) -> None:
    """They touch nothing within a circle that is larger than they."""
    shapes = [DASHES, _upright(100.0, (60.0, 60.0 + length))]
    kinds: list[list[AnnotationKind | None]] = [[None] * len(DASHES.runs), [EXTENSION]]
    ink = np.zeros((220, 220), bool)
    ink[60 : 61 + int(length), 99:102] = True
    if cross:
        ink[64:67, 95:106] = True
    spare_free_dashes(shapes, kinds, ink, 1.8)
    assert kinds[1] == [EXTENSION]


@pytest.mark.parametrize(
    ("leg", "ahead", "spared"), [(13, True, True), (13, False, False), (24, True, False)]
)
def test_the_corner_of_a_hidden_pocket_is_no_extension_line(
    leg: int, ahead: bool, spared: bool
) -> None:
    """Its level edge is a dash and a stub that is too short to be a run: nothing else is there of
    it.  It hangs on the upright edge's last dash."""
    shapes = [DASHES, _upright(60.0, (20.0, 32.0), (40.0, 40.0 + leg))]
    shapes.append(_level(40.0, (60.0, 60.0 + leg), width=1.8))
    kinds: list[list[AnnotationKind | None]] = [[None] * len(DASHES.runs), [None] * 2, [EXTENSION]]
    ink = np.zeros((220, 220), bool)
    ink[20:33, 59:61] = ink[40 : 41 + leg, 59:61] = ink[40:42, 59 : 61 + leg] = True
    ink[46 + leg : 60 + leg, 59:61] = True
    if ahead:
        ink[40:42, 67 + leg : 71 + leg] = True
    spare_free_dashes(shapes, kinds, ink, 1.8)
    assert kinds[2] == [None if spared else EXTENSION]
