import numpy as np
import pytest

from gaussiancad_core.lines.line_points import LinePoints, lines_of_strokes
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.views import Arc, Linetype, Segment


def test_points_stand_for_the_whole_length() -> None:
    strokes = [
        Segment((0, 0), (10, 0), Linetype.VISIBLE),
        Arc((3, 3), 2.0, 0.3, 1.1, Linetype.HIDDEN),
        Polyline(((0, 0), (3, 4), (3, 10)), Linetype.HIDDEN),
    ]
    lines = lines_of_strokes(strokes, 0.3)
    assert lines.visible.lengths.sum() == pytest.approx(10.0)
    assert lines.hidden.lengths.sum() == pytest.approx(2.2 + 11.0)
    assert lines.visible.lengths.max() <= 0.3
    assert lines.visible.points[:, 0].mean() == pytest.approx(5.0)
    on_arc = np.linalg.norm(lines.hidden.points - [3, 3], axis=1)
    assert (np.isclose(on_arc, 2.0)).sum() >= 8


def test_a_stroke_shorter_than_the_step_is_its_middle() -> None:
    lines = lines_of_strokes([Segment((1, 1), (1.1, 1), Linetype.VISIBLE)], 5.0)
    assert lines.visible.points == pytest.approx(np.array([[1.05, 1.0]]))
    assert lines.visible.lengths == pytest.approx([0.1])


def test_near_includes_its_bound() -> None:
    ones, others = (
        LinePoints(np.array(points, dtype=float), np.ones(len(points)))
        for points in ([[0, 0], [3, 0], [9, 9]], [[0, 2], [3, 2.001]])
    )
    assert ones.near(others, 2.0).tolist() == [True, False, False]


def test_empty_sets() -> None:
    empty = LinePoints(np.zeros((0, 2)), np.zeros(0))
    one = LinePoints(np.zeros((1, 2)), np.ones(1))
    assert one.near(empty, 1.0).tolist() == [False]
    assert empty.near(one, 1.0).shape == (0,)
    assert empty.share(np.zeros(0, dtype=bool)) == 1.0
