from itertools import pairwise

import numpy as np
import pytest

from benchmarks.sheets.exact_perturbations import (
    jittered,
    missing_and_spurious,
    of_wrong_length,
    pixel,
)
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

VISIBLE, HIDDEN = Linetype
SIZE = (60.0, 30.0, 45.0)


@pytest.fixture
def views() -> DrawnViews:
    """Three views with a frame, ten inner lines, a circle and a quarter of one each."""

    def drawn(width: float, height: float) -> list[Segment | Arc]:
        corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height), (0.0, 0.0)]
        frame = [Segment(*ends, VISIBLE) for ends in pairwise(corners)]
        inner = [Segment((x, 2.0), (x, 12.0), HIDDEN) for x in np.linspace(2, 20, 10).tolist()]
        round_ones = [
            Arc((12.0, 20.0), 4.0, 0.0, 2 * np.pi, VISIBLE),
            Arc((12.0, 20.0), 6.0, 0.0, 0.5 * np.pi, HIDDEN),
        ]
        return [*frame, *inner, *round_ones]

    x, y, z = SIZE
    return exact_views(
        {Role.FRONT: drawn(x, z), Role.TOP: drawn(x, y), Role.RIGHT: drawn(y, z)}, SIZE
    )


@pytest.mark.parametrize("noise", [missing_and_spurious, jittered, of_wrong_length])
def test_the_seed_is_the_noise(noise, views: DrawnViews) -> None:  # noqa: ANN001
    assert noise(views, 7) == noise(views, 7)
    assert noise(views, 7) != noise(views, 8)
    assert noise(views, 7).size == SIZE


@pytest.mark.parametrize("share", [0.05, 0.2])
def test_as_many_strokes_come_as_go(views: DrawnViews, share: float) -> None:
    noisy = missing_and_spurious(views, 3, share)
    before = [(role, stroke) for role in views.roles for stroke in views.strokes[role]]
    after = [(role, stroke) for role in noisy.roles for stroke in noisy.strokes[role]]
    count = round(share * 48)
    assert len(before) == len(after) == 48
    assert sum(stroke not in after for stroke in before) == count
    added = [stroke for stroke in after if stroke not in before]
    assert len(added) == count
    for role, stroke in added:
        points = np.array([stroke.start, stroke.end])
        width, height = {
            Role.FRONT: (60.0, 45.0), Role.TOP: (60.0, 30.0), Role.RIGHT: (30.0, 45.0),
        }[role]  # fmt: skip
        assert (points >= 0.0).all() and (points <= (width, height)).all()
        assert 0.5 < stroke.length <= 0.3 * 60.0 + 1e-9
    assert noisy.tolerance == views.tolerance


def test_spurious_strokes_of_left_views_lie_where_those_are(views: DrawnViews) -> None:
    left = exact_views({Role.LEFT: views.strokes[Role.RIGHT]}, SIZE)
    for seed in range(20):
        added = set(missing_and_spurious(left, seed).strokes[Role.LEFT])
        (stroke,) = added - set(left.strokes[Role.LEFT])
        assert min(stroke.start[0], stroke.end[0]) >= -30.0
        assert max(stroke.start[0], stroke.end[0]) <= 0.0


def test_jitter_stays_within_its_pixels(views: DrawnViews) -> None:
    reach = pixel(views)
    assert reach == 0.1
    noisy = jittered(views, 1)
    assert noisy.tolerance == reach
    moves = []
    for role in views.roles:
        for one, other in zip(views.strokes[role], noisy.strokes[role], strict=True):
            assert one.linetype is other.linetype
            if isinstance(one, Segment):
                moves += [np.subtract(one.start, other.start), np.subtract(one.end, other.end)]
            else:
                moves.append(np.subtract(one.centre, other.centre))
                assert 0.0 < abs(one.radius - other.radius) <= reach
                assert (one.start_angle, one.sweep) == (other.start_angle, other.sweep)
    distances = np.hypot(*np.array(moves).T)
    assert (distances > 0.0).all()
    # Evenly over a disc: the root mean square is the radius by the root of two.
    assert distances.max() <= reach
    assert np.sqrt((distances**2).mean()) == pytest.approx(reach / np.sqrt(2.0), rel=0.1)


def test_ends_move_along_their_strokes_only(views: DrawnViews) -> None:
    noisy = of_wrong_length(views, 2)
    reach = 2.0 * pixel(views)
    assert noisy.tolerance == reach
    longer = shorter = 0
    for role in views.roles:
        for one, other in zip(views.strokes[role], noisy.strokes[role], strict=True):
            if isinstance(one, Arc):
                assert (one.centre, one.radius) == (other.centre, other.radius)
                if one.sweep > 6.0:
                    assert one == other
                    continue
            else:
                way = np.subtract(one.end, one.start) / one.length
                off = np.subtract([other.start, other.end], [one.start, one.end])
                across = off @ np.array([-way[1], way[0]])
                np.testing.assert_allclose(across, 0.0, atol=1e-12)
            assert 0.0 < abs(other.length - one.length) <= 2.0 * reach
            longer += other.length > one.length
            shorter += other.length < one.length
    assert min(longer, shorter) > 10
