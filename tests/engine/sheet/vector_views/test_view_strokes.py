"""Hidden lines of a file: dashes that were drawn one by one are one line, lines are not."""

import pytest

from gaussiancad_core.files.vectors import StrokeRole, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.vector_views.view_strokes import strokes_of, tracks_and_gap

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
    assert _found(spans) == [pytest.approx(span) for span in expected]


@pytest.mark.parametrize(
    ("pattern", "whole"), [((24.0, 12.0), True), ((300.0, 100.0), False), ((), False)]
)
def test_lines_that_the_file_dashes_itself_keep_their_gaps(
    pattern: tuple[float, ...], whole: bool
) -> None:
    """Two spokes and the end of a third between them, behind a rim."""
    spans = [(0.0, 190.0), (268.0, 362.0), (440.0, 630.0)]
    assert (_found(spans, pattern) == [pytest.approx(span) for span in spans]) == whole


def test_a_dash_at_either_end_may_be_half_of_one() -> None:
    # Between lines of whole dashes one of three: the sheet tells how long gaps are.
    strokes = [
        VectorStroke(LineSegment((low, level), (high, level)), 2.0, (), StrokeRole.HIDDEN)
        for level, spans in (
            (10.0, [(k * 40.0, k * 40.0 + 31.0) for k in range(5)]),
            (50.0, [(0.0, 15.5), (24.0, 55.0), (63.5, 79.0)]),
        )
        for low, high in spans
    ]
    (tracks,), gap = tracks_and_gap([strokes])
    found = strokes_of(tracks, strokes, gap)
    assert sorted((s.start[1], *sorted((s.start[0], s.end[0]))) for s in found) == [
        pytest.approx((10.0, 0.0, 191.0)),
        pytest.approx((50.0, 0.0, 79.0)),
    ]


def _found(
    spans: list[tuple[float, float]], pattern: tuple[float, ...] = ()
) -> list[tuple[float, float]]:
    """Hidden lines as they are told of stretches of one line, ends in px along it."""
    strokes = [
        VectorStroke(
            LineSegment((10.0 + low, 30.0), (10.0 + high, 30.0)), 2.0, pattern, StrokeRole.HIDDEN
        )
        for low, high in spans
    ]
    (tracks,), gap = tracks_and_gap([strokes])
    found = strokes_of(tracks, strokes, gap)
    assert {stroke.linetype for stroke in found} == {Linetype.HIDDEN}
    ends = (sorted((stroke.start[0] - 10.0, stroke.end[0] - 10.0)) for stroke in found)
    return sorted((low, high) for low, high in ends)
