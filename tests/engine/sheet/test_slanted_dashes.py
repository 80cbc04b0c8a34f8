"""Short slanted hidden lines: cones of countersinks and tips of drills."""

import numpy as np
import pytest

from gaussiancad_core.views import Linetype, Segment, Stroke

_RHYTHM = (12.0, 6.0)
_LEFT, _RIGHT, _TOP = 182.0, 218.0, 60.0


def _block(sketch):  # noqa: ANN001, ANN202
    """A block with a dashed bore from its lower edge up to the height of ``_TOP``."""
    drawing = sketch(400, 300).lines((12, 12), (388, 12), (388, 288), (12, 288), (12, 12), width=3)
    drawing.broken((_LEFT, 288), (_LEFT, _TOP), _RHYTHM, 2.0)
    drawing.broken((_RIGHT, 288), (_RIGHT, _TOP), _RHYTHM, 2.0)
    return drawing.broken((_LEFT, _TOP), (_RIGHT, _TOP), _RHYTHM, 2.0)


def _slanted(strokes: tuple[Stroke, ...]) -> list[list[tuple[float, float]]]:
    """Ends of slanted hidden lines, in px whose centres are at integers, left ones first."""
    return sorted(
        sorted((x - 0.5, y - 0.5) for x, y in (stroke.start, stroke.end))
        for stroke in strokes
        if isinstance(stroke, Segment)
        and stroke.linetype is Linetype.HIDDEN
        and min(np.abs(np.subtract(stroke.end, stroke.start)) / stroke.length) > 0.15
    )


@pytest.mark.parametrize("away", [17.0, 14.0, 20.0])
def test_a_cone_of_one_dash_up_to_an_edge(sketch, away: float) -> None:  # noqa: ANN001
    """A dash from the corner, a gap, and what is left of a dash at the edge."""
    drawing = sketch(400, 300).lines((12, 12), (388, 12), (388, 288), (12, 288), (12, 12), width=3)
    top = 12.0 + away
    for x, out in ((_LEFT, -1.0), (_RIGHT, 1.0)):
        drawing.broken((x, top), (x, 288), _RHYTHM, 2.0)
        drawing.broken((x, top), (x + out * away, 12.0), _RHYTHM, 2.0)
    drawing.broken((_LEFT, top), (_RIGHT, top), _RHYTHM, 2.0)
    cones = [
        [(_LEFT - away, 12.0), (_LEFT, top)],
        [(_RIGHT, top), (_RIGHT + away, 12.0)],
    ]
    assert np.array(_slanted(drawing.strokes())) == pytest.approx(np.array(cones), abs=1.0)


@pytest.mark.parametrize("high", [14.0, 16.0, 18.0])
def test_the_tip_of_a_drill(sketch, high: float) -> None:  # noqa: ANN001
    tip = (0.5 * (_LEFT + _RIGHT), _TOP - high)
    drawing = _block(sketch)
    for corner in ((_LEFT, _TOP), (_RIGHT, _TOP)):
        # Drawn from the tip: what is left of the last dash is at the corner.
        way = np.subtract(corner, tip) / np.hypot(*np.subtract(corner, tip))
        drawing.line(tip, tuple(tip + 9.0 * way), 2.0)
        drawing.line(tuple(tip + 14.0 * way), corner, 2.0)
    sides = [[(_LEFT, _TOP), tip], [tip, (_RIGHT, _TOP)]]
    assert np.array(_slanted(drawing.strokes())) == pytest.approx(np.array(sides), abs=1.2)


@pytest.mark.parametrize(
    "blot", [None, ((250.0, 40.0), (256.0, 32.0)), ((100.0, 70.0), (109.0, 74.0))]
)
def test_other_ink_is_no_slant(sketch, blot) -> None:  # noqa: ANN001
    """Nothing, a speck that no straight way with ink leads to, and one far from any corner."""
    drawing = _block(sketch)
    if blot is not None:
        drawing.line(*blot, 2.0)
    corners = [(_LEFT, _TOP), (_RIGHT, _TOP)]
    ends = [end for slant in _slanted(drawing.strokes()) for end in slant]
    assert all(np.hypot(*np.subtract(end, corner)) > 20 for end in ends for corner in corners)


def test_specks_make_no_tip(sketch) -> None:  # noqa: ANN001
    """Dots of a centre line are about where the two sides of a tip would have their ink."""
    drawing = _block(sketch)
    for x in (_LEFT + 6.0, _RIGHT - 6.0):
        drawing.line((x - 1.5, _TOP - 6.0), (x + 1.5, _TOP - 6.0), 2.0)
    corners = [(_LEFT, _TOP), (_RIGHT, _TOP)]
    ends = [end for slant in _slanted(drawing.strokes()) for end in slant]
    assert all(np.hypot(*np.subtract(end, corner)) > 4 for end in ends for corner in corners)
