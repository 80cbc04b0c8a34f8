import numpy as np
import pytest

from gaussiancad_core.kernel.solid_rays import SolidRays
from gaussiancad_core.lines.visibility import RayTest, Visibility
from gaussiancad_core.model.axes import Axis, Role
from sample_parts.modelling import box, cut, cylinder, edges_along, filleted, fuse

ACROSS_X, ACROSS_Y = (1.0, 0.0), (0.0, 1.0)


def _look(shape: object, role: Role, point: tuple, normal: tuple, slack: float = 0.0) -> Visibility:
    witness = RayTest(SolidRays(shape, role.frame, 1e-6), role.frame, 1e-3)
    return witness.visibility_of(np.array([point]), np.array([normal]), np.array([slack]))[0]


STEP = fuse(box((0, 0, 0), (40, 30, 10)), box((0, 0, 9), (20, 30, 20)))
SLIT = cut(STEP, box((-1, 10, 5), (41, 14, 8)))


@pytest.mark.parametrize(
    ("role", "point", "normal", "expected"),
    [
        (Role.TOP, (20.0, 15.0), ACROSS_X, Visibility.VISIBLE),
        (Role.TOP, (10.0, 10.0), ACROSS_Y, Visibility.HIDDEN),
        (Role.TOP, (30.0, 14.0), ACROSS_Y, Visibility.HIDDEN),
        (Role.TOP, (0.0, 15.0), ACROSS_X, Visibility.VISIBLE),
        (Role.TOP, (33.0, 20.0), ACROSS_X, Visibility.BLANK),
        (Role.TOP, (90.0, 90.0), ACROSS_X, Visibility.BLANK),
        (Role.BOTTOM, (20.0, -15.0), ACROSS_X, Visibility.HIDDEN),
        (Role.RIGHT, (12.0, 10.0), ACROSS_Y, Visibility.VISIBLE),
        (Role.LEFT, (-20.0, 10.0), ACROSS_Y, Visibility.HIDDEN),
    ],
)
def test_what_is_beside_a_line_tells_what_it_is(
    role: Role, point: tuple, normal: tuple, expected: Visibility
) -> None:
    assert _look(SLIT, role, point, normal) is expected


def test_a_smooth_edge_is_told_from_nothing_at_all() -> None:
    block = box((0, 0, 0), (80, 60, 30))
    part = filleted(block, edges_along(block, Axis.Z, [(0, 0), (80, 60)]), 12)
    assert _look(part, Role.FRONT, (12.0, 15.0), ACROSS_X) is Visibility.SMOOTH_VISIBLE
    assert _look(part, Role.FRONT, (68.0, 15.0), ACROSS_X) is Visibility.SMOOTH_HIDDEN
    assert _look(part, Role.FRONT, (40.0, 15.0), ACROSS_X) is Visibility.BLANK


def test_a_line_that_is_a_little_off_is_seen_from_further_away() -> None:
    assert _look(SLIT, Role.TOP, (20.008, 15.0), ACROSS_X) is Visibility.VISIBLE
    assert _look(SLIT, Role.TOP, (20.05, 15.0), ACROSS_X) is Visibility.BLANK
    assert _look(SLIT, Role.TOP, (20.05, 15.0), ACROSS_X, slack=0.05) is Visibility.VISIBLE


def test_a_faulty_solid_still_gets_an_answer() -> None:
    assert _look(SLIT.Reversed(), Role.TOP, (10.0, 10.0), ACROSS_Y) is Visibility.HIDDEN
    assert _look(SLIT.Reversed(), Role.TOP, (20.0, 15.0), ACROSS_X) is Visibility.VISIBLE


def test_steep_surfaces_are_followed_across_the_line() -> None:
    rod = cylinder(Axis.Y, (20, 20), 15, 0, 40)
    part = cut(rod, box((0, 10, 0), (40, 12, 8)))
    # Nearly at the silhouette the depth changes fast, and yet nothing is to be drawn.
    assert _look(part, Role.TOP, (34.9, 30.0), ACROSS_X) is Visibility.BLANK
    assert _look(part, Role.TOP, (35.0, 30.0), ACROSS_X) is Visibility.VISIBLE
