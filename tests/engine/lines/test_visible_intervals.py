import numpy as np
import pytest

from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.kernel.solid_rays import SolidRays
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.lines.visibility import RayTest, Visibility
from gaussiancad_core.lines.visible_intervals import ProjectedLine, decided
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from sample_parts.modelling import box, fuse

V, H = Linetype.VISIBLE, Linetype.HIDDEN
PRECISION = Precision(1e-4, 5e-4, 1e-2, 2e-2)
PART = fuse(box((0, 20, 0), (60, 40, 30)), box((10, 0, 0), (30, 20, 18)))


def _decided(strokes: list[DrawnStroke], role: Role = Role.REAR) -> list[tuple]:
    witness = RayTest(SolidRays(PART, role.frame, 1e-6), role.frame, 1e-3)
    found = decided([ProjectedLine(stroke, 0.0) for stroke in strokes], witness, PRECISION, False)
    return [
        (round(stroke.start[0], 2), round(stroke.end[0], 2), stroke.linetype) for stroke in found
    ]


def test_lines_that_are_none_vanish() -> None:
    assert _decided([Segment((-50.0, 5.0), (-40.0, 7.0), V)]) == []
    assert decided([], None, PRECISION, False) == []


def test_what_lies_behind_is_hidden() -> None:
    assert _decided([Segment((-30.0, 18.0), (-10.0, 18.0), V)]) == [(-30.0, -10.0, H)]


@pytest.mark.parametrize("helped", [True, False])
def test_a_line_is_cut_where_it_stops_being_one_with_and_without_a_junction(helped: bool) -> None:
    """From the rear, the small block's top edge prolonged over the large block's face."""
    strokes: list[DrawnStroke] = [Segment((-52.0, 18.0), (-4.0, 18.0), V)]
    if helped:
        strokes += [
            Segment((-30.0, 0.0), (-30.0, 18.0), V),
            Segment((-10.0, 0.0), (-10.0, 18.0), V),
        ]
    found = _decided(strokes)[0]
    assert found[2] is H
    assert found[:2] == pytest.approx((-30.0, -10.0), abs=1e-9 if helped else 0.02)


class _Fickle(RayTest):
    """Says visible, but hidden near one place."""

    def __init__(self, place: tuple[float, float], reach: float) -> None:
        self._place, self._reach = place, reach

    def visibility_of(
        self, points: np.ndarray, normals: np.ndarray, slacks: np.ndarray
    ) -> list[Visibility]:
        near = np.hypot(*(points - self._place).T) < self._reach
        return [Visibility.HIDDEN if hidden else Visibility.VISIBLE for hidden in near]


def test_a_single_dissenter_is_overruled() -> None:
    line = ProjectedLine(Segment((0.0, 0.0), (100.0, 0.0), V), 0.0)
    fickle = _Fickle((43.8, 0.0), 1.0)
    (stroke,) = decided([line], fickle, PRECISION, False)
    assert (stroke.linetype, stroke.length) == (V, pytest.approx(100.0))


def test_a_real_change_is_found_by_bisection() -> None:
    line = ProjectedLine(Segment((0.0, 0.0), (100.0, 0.0), V), 0.0)
    strokes = decided([line], _Fickle((43.8, 0.0), 20.0), PRECISION, False)
    assert [stroke.linetype for stroke in strokes] == [V, H, V]
    assert strokes[1].start[0] == pytest.approx(23.8, abs=0.01)
    assert strokes[1].end[0] == pytest.approx(63.8, abs=0.01)


def test_a_run_over_the_start_of_a_circle_is_one() -> None:
    line = ProjectedLine(Arc((0.0, 0.0), 50.0, 0.0, 2 * np.pi, V), 0.0)
    strokes = decided([line], _Fickle((-50.0, 0.0), 40.0), PRECISION, False)
    assert sorted(stroke.linetype.value for stroke in strokes) == ["hidden", "visible"]
    visible = next(stroke for stroke in strokes if stroke.linetype is V)
    opening = 2.0 * np.arcsin(20.0 / 50.0)
    assert visible.sweep == pytest.approx(2 * np.pi - 2 * opening, abs=1e-3)
    middle = visible.start_angle + visible.sweep / 2.0
    assert np.cos(middle) == pytest.approx(1.0, abs=1e-4)
