import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.lines.two_rays import Difference, difference, linetype_between
from gaussiancad_core.model.views import Linetype

_RULE = 0.5, float(np.cos(np.radians(10.0))), True
_IN, _OUT = np.array([0.0, 0.0, -1.0]), np.array([0.0, 0.0, 1.0])
_LEANING = np.array([0.6, 0.0, -0.8])

Ray = list[tuple[float, bool]]


def _crossings(one: Ray, other: Ray, faces: list[int] | None = None) -> tuple:
    """Crossings of level surfaces, given as depth and whether the material is entered."""
    both = one + other
    normals = np.array([_IN if entering else _OUT for _, entering in both]).reshape(-1, 3)
    return (
        np.array([depth for depth, _ in both]),
        np.array([entering for _, entering in both], dtype=bool),
        np.zeros(len(both)),
        normals,
        np.array(faces or [], dtype=np.int64),
    )


def _between(one: Ray, other: Ray, faces: list[int] | None = None) -> Difference:
    ends = (0, len(one)), (len(one), len(one) + len(other))
    return Difference(difference(_crossings(one, other, faces), *ends, _RULE))


@st.composite
def _layers(draw: st.DrawFn) -> list[tuple[bool, bool]]:
    """From the viewer on, whether each ray has a surface at a depth."""
    return draw(st.lists(st.sampled_from([(True, True), (True, False), (False, True)]), max_size=6))


@given(_layers())
def test_depths_and_labels_are_judged_alike(layers: list[tuple[bool, bool]]) -> None:
    """Surfaces far apart, all entered: which rays have one at a depth says it all."""
    rays = [[(10.0 * k, True) for k, has in enumerate(layers) if has[side]] for side in (0, 1)]
    steps = [(one != other, one or other) for one, other in layers]
    shown = {
        Difference.NONE: None,
        Difference.VISIBLE_STEP: Linetype.VISIBLE,
        Difference.HIDDEN_STEP: Linetype.HIDDEN,
    }
    assert shown[_between(*rays)] is linetype_between(steps)
    assert _between(*rays) is _between(*rays[::-1])


def test_a_difference_in_front_of_what_is_shared_is_visible() -> None:
    assert linetype_between([(True, True), (False, True)]) is Linetype.VISIBLE
    assert linetype_between([(False, True), (True, True)]) is Linetype.HIDDEN
    assert linetype_between([(False, False), (True, True)]) is Linetype.VISIBLE
    assert linetype_between([(False, True)]) is None


def test_entering_and_leaving_are_no_partners() -> None:
    assert _between([(1.0, True)], [(1.0, False)]) is Difference.VISIBLE_STEP


def test_a_change_of_face_without_an_edge_is_smooth() -> None:
    ray = [(1.0, True), (5.0, False)]
    assert _between(ray, ray, [0, 1, 0, 1]) is Difference.NONE
    assert _between(ray, ray, [0, 1, 2, 1]) is Difference.VISIBLE_SMOOTH
    assert _between(ray, ray, [0, 1, 0, 2]) is Difference.HIDDEN_SMOOTH
    assert _between(ray, [(1.0, True), (8.0, False)], [0, 1, 2, 1]) is Difference.HIDDEN_STEP


def test_one_face_may_turn_and_two_faces_make_an_edge() -> None:
    depths, entering, slopes, _, _ = _crossings([(1.0, True)], [(1.2, True)])
    normals = np.stack([_IN, _LEANING])
    for faces, expected in (([3, 3], Difference.NONE), ([3, 4], Difference.VISIBLE_BEND)):
        crossings = depths, entering, slopes, normals, np.array(faces)
        assert difference(crossings, (0, 1), (1, 2), _RULE) == expected


def test_a_surface_along_the_ray_has_no_partner() -> None:
    depths, entering, _, normals, faces = _crossings([(1.0, True)], [(1.0, True)])
    crossings = depths, entering, np.array([np.nan, 0.0]), normals, faces
    assert difference(crossings, (0, 1), (1, 2), _RULE) == Difference.VISIBLE_STEP


def test_a_slope_carries_a_surface_from_ray_to_ray() -> None:
    depths, entering, _, normals, faces = _crossings([(1.0, True)], [(4.0, True)])
    for slope, expected in ((3.0, Difference.NONE), (2.0, Difference.VISIBLE_STEP)):
        crossings = depths, entering, np.full(2, slope), normals, faces
        assert difference(crossings, (0, 1), (1, 2), _RULE) == expected
