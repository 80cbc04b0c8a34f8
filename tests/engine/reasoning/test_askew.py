"""Dashes that were read askew."""

import pytest

from gaussiancad_core.axes import Role
from gaussiancad_core.reasoning.askew import without_askew_dashes
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.views import Linetype, Segment

_LINE = Segment((0.0, 10.0), (40.0, 10.0), Linetype.HIDDEN)
_TOLERANCE = 0.1


def _left(dash: Segment, line: Segment = _LINE) -> bool:
    views = DrawnViews({Role.FRONT: (line, dash)}, (40.0, 40.0, 40.0), _TOLERANCE)
    (_, *rest) = without_askew_dashes(views).strokes[Role.FRONT]
    return rest == [dash]


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_dash_that_leaves_its_line_a_little_goes(way: float) -> None:
    assert not _left(Segment((12.0, 10.0), (12.7, 10.0 + way * 0.15), Linetype.HIDDEN))
    # Lines on a slope have dashes, too.
    slope = Segment((0.0, 0.0), (30.0, 30.0), Linetype.HIDDEN)
    assert not _left(Segment((12.0, 12.0), (12.6 + way * 0.2, 12.6), Linetype.HIDDEN), slope)


@pytest.mark.parametrize(
    "stroke",
    [
        Segment((12.0, 10.0), (13.4, 10.15), Linetype.HIDDEN),
        Segment((12.0, 10.0), (12.7, 10.25), Linetype.HIDDEN),
        Segment((12.0, 10.0), (12.15, 10.15), Linetype.HIDDEN),
        Segment((12.0, 10.15), (12.7, 10.15), Linetype.HIDDEN),
        Segment((41.0, 10.0), (41.7, 10.15), Linetype.HIDDEN),
        Segment((12.0, 11.0), (12.7, 11.15), Linetype.HIDDEN),
    ],
    ids=["long", "far", "steep", "parallel", "beyond", "elsewhere"],
)
def test_other_strokes_stay(stroke: Segment) -> None:
    assert _left(stroke)
