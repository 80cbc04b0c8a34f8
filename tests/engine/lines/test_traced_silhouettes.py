import numpy as np
import pytest
from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert

from gaussiancad_core.lines.hlr import draw_view
from gaussiancad_core.lines.traced_silhouettes import SplineSilhouettes
from gaussiancad_core.model.axes import Role
from sample_parts import sample
from sample_parts.modelling import box, cut, sphere

CHORD = 1e-3


def _splined(shape: object) -> object:
    return BRepBuilderAPI_NurbsConvert(shape, True).Shape()


@pytest.mark.parametrize("role", Role)
def test_the_silhouette_of_a_splined_ball_is_its_circle(role: Role) -> None:
    chains = SplineSilhouettes(_splined(sphere((0, 0, 0), 10))).view(role.frame, CHORD)
    points = np.concatenate([chain.points for chain in chains])
    np.testing.assert_allclose(np.hypot(*points.T), 10.0, atol=1e-6)
    for chain in chains:
        middles = (np.array(chain.points)[1:] + np.array(chain.points)[:-1]) / 2.0
        assert np.hypot(*middles.T).min() > 10.0 - 2.0 * CHORD
    angles = np.linspace(0.0, 2.0 * np.pi, 720)
    circle = 10.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    apart = np.min([chain.distances(circle) for chain in chains], axis=0)
    assert apart.max() < 2.0 * CHORD


def test_silhouettes_end_at_the_border_of_their_face() -> None:
    ball = cut(sphere((0, 0, 0), 10), box((-11, -11, 4), (11, 11, 11)))
    (chain, *rest) = SplineSilhouettes(_splined(ball)).view(Role.FRONT.frame, CHORD)
    tops = [max(point[1] for point in each.points) for each in (chain, *rest)]
    assert max(tops) == pytest.approx(4.0, abs=1e-3)
    assert all(top <= 4.0 + 1e-9 for top in tops)


@pytest.mark.parametrize("name", ["rounded-cover", "ball-knob", "countersunk-plate"])
@pytest.mark.parametrize("role", [Role.FRONT, Role.TOP])
def test_a_solid_of_splines_is_drawn_like_the_solid_that_it_is(name: str, role: Role) -> None:
    part = sample(name).build()
    exact, splined = draw_view(part, role), draw_view(_splined(part), role)
    for one, other in ((exact, splined), (splined, exact)):
        for stroke in one:
            same = [rival for rival in other if rival.linetype is stroke.linetype]
            samples = stroke.sample(stroke.length / 50.0)
            apart = np.min([rival.distances(samples) for rival in same], axis=0)
            assert np.quantile(apart, 0.95) < 0.02
