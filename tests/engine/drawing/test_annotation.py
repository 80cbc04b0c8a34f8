import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind, Label
from gaussiancad_core.model.views import Arc, Linetype, Segment

LABEL = Label("42", (100.0, 50.0), 10.0, 24.0)
MARK = Annotation(
    AnnotationKind.LEADER,
    3,
    (
        Segment((10.0, 20.0), (60.0, 20.0), Linetype.VISIBLE),
        Arc((40.0, 60.0), 5.0, 0.0, 2.0 * np.pi, Linetype.VISIBLE),
    ),
    arrows=(((10.0, 20.0), (20.0, 18.0), (20.0, 22.0)),),
    label=LABEL,
    value_mm=42.0,
)


def test_a_label_has_its_corners_where_its_letters_end() -> None:
    np.testing.assert_allclose(LABEL.corners, [(88, 45), (112, 45), (112, 55), (88, 55)])
    upright = Label("42", (100.0, 50.0), 10.0, 24.0, -np.pi / 2.0)
    # Read from the right: it begins at the bottom, its upper side is on the left.
    np.testing.assert_allclose(upright.corners, [(95, 62), (95, 38), (105, 38), (105, 62)])


def test_the_box_is_around_everything() -> None:
    assert MARK.box == pytest.approx((10.0, 18.0, 112.0, 65.0))


@given(st.floats(-np.pi, np.pi), st.floats(-200.0, 200.0), st.floats(-200.0, 200.0))
def test_turning_there_and_back_changes_nothing(angle: float, x: float, y: float) -> None:
    again = MARK.turned(angle, (x, y)).turned(-angle, (x, y))
    np.testing.assert_allclose(again.box, MARK.box, atol=1e-9)
    np.testing.assert_allclose(again.label.corners, LABEL.corners, atol=1e-9)
    assert (again.kind, again.group, again.value_mm) == (MARK.kind, MARK.group, MARK.value_mm)


def test_a_quarter_turn_runs_from_right_to_down() -> None:
    turned = MARK.turned(np.pi / 2.0, (0.0, 0.0))
    np.testing.assert_allclose(turned.strokes[0].end, (-20.0, 60.0), atol=1e-12)
    np.testing.assert_allclose(turned.label.centre, (-50.0, 100.0), atol=1e-12)
    np.testing.assert_allclose(turned.arrows[0][1], (-18.0, 20.0), atol=1e-12)
