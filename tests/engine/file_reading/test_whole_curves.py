from itertools import pairwise
from time import process_time

import numpy as np
import pytest

from gaussiancad_core.file_reading.joined_arcs import joined_arcs
from gaussiancad_core.file_reading.joined_chords import once, with_whole_curves
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Pen

PEN = Pen(0.35, None, "visible")


def _strokes(*curves: Curve, pen: Pen = PEN) -> list[PaperStroke]:
    return [PaperStroke(curve, pen) for curve in curves]


def _chords(points: np.ndarray, pen: Pen = PEN) -> list[PaperStroke]:
    lines = (LineSegment((a, b), (c, d)) for (a, b), (c, d) in pairwise(points.tolist()))
    return _strokes(*lines, pen=pen)


def _ellipse(major: float, minor: float, tilt: float, turns: np.ndarray) -> np.ndarray:
    local = np.stack([major * np.cos(turns), minor * np.sin(turns)], axis=1)
    c, s = np.cos(tilt), np.sin(tilt)
    return np.array([100.0, 80.0]) + local @ np.array([[c, s], [-s, c]])


@pytest.mark.parametrize("count", [10, 24, 72, 120])
@pytest.mark.parametrize("radius", [0.8, 4.0, 40.0])
def test_chords_of_a_circle_are_one_circle(count: int, radius: float) -> None:
    points = _ellipse(radius, radius, 0.0, np.linspace(0.3, 0.3 + FULL_TURN, count + 1))
    points[-1] = points[0]
    (stroke,) = with_whole_curves(_chords(points))
    assert stroke.is_circle
    assert stroke.curve.radius == pytest.approx(radius, abs=1e-9)


@pytest.mark.parametrize("tilt", [0.0, 0.7, 2.0])
@pytest.mark.parametrize("axes", [(8.0, 5.66), (20.0, 4.0), (3.0, 2.0)])
def test_chords_of_an_ellipse_are_one_ellipse(axes: tuple[float, float], tilt: float) -> None:
    points = _ellipse(*axes, tilt, np.linspace(0.0, FULL_TURN, 73))
    points[-1] = points[0]
    (stroke,) = with_whole_curves(_chords(points))
    assert isinstance(stroke.curve, EllipticArc)
    assert stroke.curve.is_closed
    assert (stroke.curve.semi_major, stroke.curve.semi_minor) == pytest.approx(axes, abs=1e-6)
    assert stroke.curve.distances(points).max() < 1e-3


@pytest.mark.parametrize("sweep", [1.3, -2.0, 4.0])
def test_chords_of_a_piece_of_an_ellipse_are_that_piece(sweep: float) -> None:
    points = _ellipse(20.0, 9.0, 0.4, np.linspace(0.5, 0.5 + sweep, 40))
    (stroke,) = with_whole_curves(_chords(points))
    assert isinstance(stroke.curve, EllipticArc)
    assert stroke.curve.sweep == pytest.approx(abs(sweep), abs=1e-6)
    ends = {tuple(np.round(end, 6)) for end in stroke.ends}
    assert ends == {tuple(np.round(end, 6)) for end in points[[0, -1]]}


@pytest.mark.parametrize("corners", [3, 4, 5, 6, 8])
def test_a_polygon_of_few_corners_is_none(corners: int) -> None:
    round_one = _ellipse(20.0, 20.0, 0.0, np.linspace(0.0, FULL_TURN, corners + 1))
    long_one = _ellipse(20.0, 9.0, 0.0, np.linspace(0.0, FULL_TURN, corners + 1))
    for points in (round_one, long_one):
        points[-1] = points[0]
        found = with_whole_curves(_chords(points))
        assert len(found) == corners
        assert all(stroke.is_line for stroke in found)


def test_two_arcs_that_go_on_smoothly_are_no_ellipse() -> None:
    small = _ellipse(6.0, 6.0, 0.0, np.linspace(0.0, np.pi / 2, 19))
    # The larger one has the same tangent where the smaller one ends.
    large = _ellipse(18.0, 18.0, 0.0, np.linspace(np.pi / 2, np.pi, 19)) - (0.0, 12.0)
    found = with_whole_curves(_chords(np.concatenate([small, large[1:]])))
    assert [type(stroke.curve) for stroke in found] == [CircularArc] * 2
    assert sorted(stroke.curve.radius for stroke in found) == pytest.approx([6.0, 18.0], rel=1e-2)


def test_lines_beside_an_arc_stay_lines() -> None:
    arc = _ellipse(10.0, 10.0, 0.0, np.linspace(-np.pi / 2, np.pi / 2, 31))
    points = np.concatenate([[[40.0, 70.0]], arc, [[40.0, 90.0]]])
    found = with_whole_curves(_chords(points))
    lines = [stroke.curve.length for stroke in found if stroke.is_line]
    assert sorted(type(stroke.curve).__name__ for stroke in found) == [
        "CircularArc",
        "LineSegment",
        "LineSegment",
    ]
    assert lines == pytest.approx([60.0, 60.0])


def test_chords_of_another_pen_are_another_curve() -> None:
    points = _ellipse(10.0, 10.0, 0.0, np.linspace(0.0, np.pi, 31))
    half = _chords(points[:16]) + _chords(points[15:], Pen(0.18, None, "thin"))
    assert len(with_whole_curves(half)) == 2


@pytest.mark.parametrize("pieces", [2, 3, 4, 7])
@pytest.mark.parametrize("start", [0.0, 1.0, 6.0])
def test_arcs_that_follow_each_other_are_one(pieces: int, start: float) -> None:
    whole = CircularArc((30.0, 20.0), 12.0, start, FULL_TURN)
    step = whole.length / pieces
    arcs = [whole.part(n * step, (n + 1) * step) for n in range(pieces)]
    (circle,) = joined_arcs(_strokes(*arcs[::-1]))
    assert circle.is_circle
    (arc,) = joined_arcs(_strokes(*arcs[1:])) if pieces > 2 else joined_arcs(_strokes(arcs[1]))
    assert arc.curve.sweep == pytest.approx(FULL_TURN * (pieces - 1) / pieces)
    assert np.allclose(arc.ends, [arcs[1].vertices(1.0)[0], arcs[-1].vertices(1.0)[-1]])


def test_halves_of_an_ellipse_are_one_whichever_way_its_axes_are_told() -> None:
    one = EllipticArc((30.0, 20.0), 12.0, 5.0, 0.3, 0.0, np.pi)
    for other in (
        EllipticArc((30.0, 20.0), 12.0, 5.0, 0.3, np.pi, np.pi),
        EllipticArc((30.0, 20.0), 12.0, 5.0, 0.3 + np.pi, 0.0, np.pi),
    ):
        (whole,) = joined_arcs(_strokes(one, other))
        assert isinstance(whole.curve, EllipticArc)
        assert whole.curve.is_closed


def test_arcs_that_do_not_meet_or_are_of_other_circles_stay() -> None:
    arcs = [
        CircularArc((30.0, 20.0), 12.0, 0.0, 1.0),
        CircularArc((30.0, 20.0), 12.0, 1.2, 1.0),
        CircularArc((30.0, 20.0), 12.5, 1.0, 1.0),
        CircularArc((30.3, 20.0), 12.0, 1.0, 1.0),
    ]
    assert len(joined_arcs(_strokes(*arcs))) == len(arcs)


def test_lines_drawn_twice_are_there_once() -> None:
    line = LineSegment((0.0, 0.0), (10.0, 5.0))
    back = LineSegment(line.end, line.start)
    thin = _strokes(line, pen=Pen(0.18, None, "thin"))
    assert len(once([*_strokes(line, back, line), *thin])) == 2


def test_rays_from_one_place_cost_no_more_than_lines() -> None:
    turns = np.linspace(0.0, FULL_TURN, 5001)[:-1]
    rays = _strokes(
        *(LineSegment((0.0, 0.0), (50.0 * np.cos(t), 50.0 * np.sin(t))) for t in turns.tolist())
    )
    begins = process_time()
    assert len(with_whole_curves(rays)) == len(rays)
    assert process_time() - begins < 10.0
