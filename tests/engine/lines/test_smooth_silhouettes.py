import numpy as np
import pytest
from OCP.BRepAdaptor import BRepAdaptor_Curve

from gaussiancad_core.lines.smooth_silhouettes import silhouettes
from gaussiancad_core.model.axes import Axis, Role
from sample_parts.modelling import box, cut, cylinder, sphere


def _ends(edge: object) -> np.ndarray:
    curve = BRepAdaptor_Curve(edge)
    points = [curve.Value(at) for at in (curve.FirstParameter(), curve.LastParameter())]
    return np.array([(point.X(), point.Y(), point.Z()) for point in points])


def test_planes_have_no_silhouettes() -> None:
    for role in Role:
        assert silhouettes(box((0, 0, 0), (3, 2, 1)), role.frame) == []


@pytest.mark.parametrize("role", [Role.FRONT, Role.RIGHT])
def test_a_hole_has_its_silhouettes_but_not_its_seam(role: Role) -> None:
    part = cut(box((0, 0, 0), (40, 30, 20)), cylinder(Axis.Z, (12, 10), 5, -1, 21))
    found = silhouettes(part, role.frame)
    side = np.array(role.frame.right, dtype=float)
    # At +X lies the seam, which is an edge of the solid already.
    expected = {Role.FRONT: [-5.0], Role.RIGHT: [-5.0, 5.0]}[role]
    assert sorted(float((_ends(edge)[0] - [12, 10, 0]) @ side) for edge in found) == pytest.approx(
        expected
    )
    for edge in found:
        assert sorted(_ends(edge)[:, 2]) == pytest.approx([0.0, 20.0])


def test_a_hole_seen_along_its_axis_has_none() -> None:
    part = cut(box((0, 0, 0), (40, 30, 20)), cylinder(Axis.Z, (12, 10), 5, -1, 21))
    assert silhouettes(part, Role.TOP.frame) == []


def test_the_silhouette_of_a_ball_is_its_great_circle() -> None:
    for edge in silhouettes(sphere((1, 2, 3), 5), Role.TOP.frame):
        np.testing.assert_allclose(_ends(edge)[:, 2], 3.0, atol=1e-6)
        np.testing.assert_allclose(np.hypot(*(_ends(edge)[:, :2] - [1, 2]).T), 5.0, atol=1e-6)
