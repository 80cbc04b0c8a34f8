import numpy as np
import pytest

from gaussiancad_core.files.beziers import curves_from_beziers, curves_from_path
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import Chain, LineSegment

TURN = 2 * np.pi


def _arc(centre: tuple, radius: float, start: float, sweep: float, pieces: int) -> list[np.ndarray]:
    """The usual Bézier curves of an arc."""
    step = sweep / pieces
    handle = 4 / 3 * np.tan(step / 4) * radius
    beziers = []
    for index in range(pieces):
        a, b = start + index * step, start + (index + 1) * step
        ends = [np.array(centre) + radius * np.array([np.cos(t), np.sin(t)]) for t in (a, b)]
        ways = [handle * np.array([-np.sin(t), np.cos(t)]) for t in (a, b)]
        beziers.append(np.array([ends[0], ends[0] + ways[0], ends[1] - ways[1], ends[1]]))
    return beziers


@pytest.mark.parametrize("sweep", [0.3, -0.3, 1.2, np.pi / 2, -2.0, np.pi, 5.0, TURN, -TURN])
@pytest.mark.parametrize("start", [0.0, 2.0])
def test_arcs_come_back_exactly(start: float, sweep: float) -> None:
    pieces = max(1, round(abs(sweep) / (np.pi / 2)))
    (curve,) = curves_from_beziers(_arc((300.0, 200.0), 150.0, start, sweep, pieces))
    assert isinstance(curve, CircularArc)
    assert np.allclose(curve.centre, (300.0, 200.0), atol=1e-6)
    assert curve.radius == pytest.approx(150.0, abs=1e-6)
    assert curve.sweep == pytest.approx(abs(sweep))
    if abs(sweep) < TURN:
        expected = start if sweep > 0 else start + sweep
        assert np.cos(curve.start_angle - expected) == pytest.approx(1.0)


def test_different_arcs_stay_apart() -> None:
    first = _arc((100, 100), 50, 0.0, np.pi / 2, 1)
    second = _arc((100, 120), 30, np.pi / 2, np.pi / 2, 1)
    curves = curves_from_beziers(first + second)
    assert [curve.radius for curve in curves] == pytest.approx([50, 30])
    # The way back along the same circle is no longer arc.
    there, back = curves_from_beziers([*first, first[0][::-1]])
    assert there.sweep == pytest.approx(np.pi / 2)
    assert back.sweep == pytest.approx(np.pi / 2)


def test_paths_of_lines_and_curves() -> None:
    arc = _arc((100, 100), 50, 0.0, np.pi / 2, 1)
    pieces = [
        np.array([(150, 0), (150, 100)], float),
        *arc,
        np.array([(100, 150), (0, 150)], float),
    ]
    kinds = [type(curve) for curve in curves_from_path(pieces, 0.0)]
    assert kinds == [LineSegment, CircularArc, LineSegment]
    plain = [type(curve) for curve in curves_from_path(pieces, None)]
    assert plain == [LineSegment, Chain, LineSegment]
    assert curves_from_path([np.zeros((2, 2))], 0.0) == []
