import numpy as np
import pytest

from gaussiancad_core.drawing.drawn_view import drawn_view
from gaussiancad_core.drawing.view_placing import Placement
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

PLACE = Placement(Role.FRONT, (50.0, 20.0, 90.0, 60.0), 4.0, (50.0, 60.0))
PLANE = (
    Segment((0.0, 0.0), (10.0, 0.0), Linetype.VISIBLE),
    Arc((5.0, 5.0), 5.0, 0.0, np.pi, Linetype.HIDDEN),
)


def test_a_view_stands_where_its_place_is() -> None:
    view = drawn_view(PLACE, PLANE)
    line, arc = view.strokes
    assert (line.start, line.end) == ((50.0, 60.0), (90.0, 60.0))
    # Up in the plane is up on the sheet, where y points down.
    assert arc.centre == (70.0, 40.0)
    assert np.array(arc.sample(1.0))[:, 1].max() == pytest.approx(40.0)
    assert view.box == pytest.approx((50.0, 20.0, 90.0, 60.0))
    assert view.plane_strokes == PLANE


def test_turning_a_view_turns_its_strokes_and_leaves_its_plane() -> None:
    view = drawn_view(PLACE, PLANE)
    turned = view.turned(np.pi / 2.0, (0.0, 0.0))
    assert turned.box == pytest.approx((-60.0, 50.0, -20.0, 90.0))
    assert turned.plane_strokes == PLANE
    again = turned.turned(-np.pi / 2.0, (0.0, 0.0))
    np.testing.assert_allclose(again.strokes[0].end, view.strokes[0].end, atol=1e-12)
