"""Hidden lines of a file: dashes that were drawn one by one are one line, lines are not."""

import pytest

from gaussiancad_core.sheet.files.vectors import Line, StrokeRole, VectorStroke
from gaussiancad_core.sheet.vector_views.tracks import EXACT, tracks_of
from gaussiancad_core.sheet.vector_views.view_strokes import strokes_of
from gaussiancad_core.views import Linetype

_DASHES = [(k * 9.0, k * 9.0 + 6.0) for k in range(6)]


@pytest.mark.parametrize(
    ("spans", "expected"),
    [
        (_DASHES, [(0.0, 51.0)]),
        ([*_DASHES[:5], (45.0, 47.0)], [(0.0, 47.0)]),
        (
            [(0.0, 36.0), (81.0, 570.0), (615.0, 658.0)],
            [(0.0, 36.0), (81.0, 570.0), (615.0, 658.0)],
        ),
        ([(0.0, 6.0), (20.0, 26.0), (40.0, 46.0)], [(0.0, 6.0), (20.0, 26.0), (40.0, 46.0)]),
    ],
    ids=["dashes", "a short last dash", "lines with gaps as long as the shortest", "far apart"],
)
def test_dashes_are_one_line(
    spans: list[tuple[float, float]], expected: list[tuple[float, float]]
) -> None:
    strokes = [
        VectorStroke(Line((10.0 + low, 30.0), (10.0 + high, 30.0)), 2.0, role=StrokeRole.HIDDEN)
        for low, high in spans
    ]
    found = strokes_of(tracks_of(strokes, EXACT), strokes, None)
    assert {stroke.linetype for stroke in found} == {Linetype.HIDDEN}
    ends = sorted(sorted((stroke.start[0], stroke.end[0])) for stroke in found)
    assert ends == [pytest.approx((10.0 + low, 10.0 + high)) for low, high in expected]
