"""Which planes that no view sees edge-on the views speak of."""

import itertools
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.cells.space_corners import spatial_edges
from gaussiancad_core.coordinates.carriers import PartCarriers, find_carriers
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.hypotheses.oblique_planes import find_half_spaces
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.samples.classed import PartClass, classed_part
from gaussiancad_core.samples.classed.outlines import convex
from gaussiancad_core.samples.modelling import box, cut

Size = tuple[float, float, float]
Draw = Callable[..., DrawnViews]

_NEAR = 0.005


def _planes(solid: TopoDS_Shape, scale: float) -> set[tuple[float, ...]]:
    """(normal, offset) of a solid's planes that no view sees edge-on, in units, rounded."""
    found = set()
    for face in faces_of(solid):
        surface = BRepAdaptor_Surface(face)
        if surface.GetType() != GeomAbs_SurfaceType.GeomAbs_Plane:
            continue
        direction, place = surface.Plane().Axis().Direction(), surface.Plane().Location()
        normal = np.array([direction.X(), direction.Y(), direction.Z()])
        if np.abs(normal).min() < 1e-6:
            continue
        normal = normal if normal[2] > 0.0 else -normal
        offset = float(normal @ [place.X(), place.Y(), place.Z()]) * scale
        found.add(tuple(np.round([*normal, offset], 4).tolist()))
    return found


def _found(carriers: PartCarriers) -> set[tuple[float, ...]]:
    return {
        tuple(np.round([*body.normal, body.offset], 4).tolist())
        for body in find_half_spaces(carriers)
    }


@pytest.mark.parametrize(("seed", "level"), [(0, 0), (1, 1), (2, 2), (3, 3), (4, 4)])
def test_exactly_the_planes_of_a_part_are_found(seed: int, level: int, drawn: Draw) -> None:
    solid = classed_part(PartClass.OBLIQUE, seed, level)
    carriers = find_carriers(drawn(solid))
    true = _planes(solid, carriers.scale)
    assert true
    assert _found(carriers) == true


@pytest.mark.parametrize("kind", [PartClass.PLANES, PartClass.SLANTS, PartClass.HOLES])
def test_other_parts_have_no_such_planes(kind: PartClass, drawn: Draw) -> None:
    solid = classed_part(kind, 2, 2)
    assert _planes(solid, 1.0) == set()
    assert find_half_spaces(find_carriers(drawn(solid))) == ()


def _cut_block(size: Size, legs: Size) -> DrawnViews:
    """The three views of a block whose corner at the right, in front, on top is cut off.

    It is seen in all of them, so that all lines are visible.
    """
    (x, y, z), (i, j, k) = size, legs
    flat = {Role.FRONT: (x, z), Role.TOP: (x, y), Role.RIGHT: (y, z)}
    cuts = {
        Role.FRONT: ((x - i, z), (x, z - k)),
        Role.TOP: ((x - i, 0.0), (x, j)),
        Role.RIGHT: ((0.0, z - k), (j, z)),
    }
    strokes = {}
    for role, (a, b) in flat.items():
        outline = ((0.0, 0.0), (a, 0.0), (a, b), (0.0, b), (0.0, 0.0))
        sides = [Segment(p, q, Linetype.VISIBLE) for p, q in itertools.pairwise(outline)]
        strokes[role] = (*sides, Segment(*cuts[role], Linetype.VISIBLE))
    return exact_views(strokes, size)


_EXTENT = st.integers(20, 80)


@settings(max_examples=40, deadline=None)
@given(st.tuples(_EXTENT, _EXTENT, _EXTENT), st.tuples(*[st.floats(0.15, 0.85)] * 3))
def test_a_cut_corner_is_the_plane_through_its_three_ends(
    size: tuple[int, int, int], shares: tuple[float, float, float]
) -> None:
    legs = tuple(extent * share for extent, share in zip(size, shares, strict=True))
    assume(min(legs) > 3.0)
    x, y, z = (float(extent) for extent in size)
    carriers = find_carriers(_cut_block((x, y, z), legs))
    (body,) = find_half_spaces(carriers)
    ends = np.array([(x - legs[0], 0.0, z), (x, legs[1], z), (x, 0.0, z - legs[2])])
    ends *= carriers.scale
    (hull,) = body.hulls
    found = np.array(hull)
    nearest = np.abs(found[:, None] - ends[None]).max(2)
    assert nearest.min(0) == pytest.approx(0.0, abs=1e-6)
    assert sorted(nearest.argmin(1).tolist()) == [0, 1, 2]
    assert ends @ np.array(body.normal) == pytest.approx(body.offset, abs=1e-6)
    assert body.creases == ()


def test_a_slant_that_one_view_lacks_closes_no_loop() -> None:
    views = _cut_block((60.0, 40.0, 30.0), (20.0, 15.0, 10.0))
    for role in views.roles:
        strokes = {**views.strokes, role: views.strokes[role][:-1]}
        assert find_half_spaces(find_carriers(exact_views(strokes, views.size))) == ()


def test_a_slant_at_another_place_closes_no_loop() -> None:
    views = _cut_block((60.0, 40.0, 30.0), (20.0, 15.0, 10.0))
    other = _cut_block((60.0, 40.0, 30.0), (20.0, 12.0, 10.0))
    strokes = {**views.strokes, Role.TOP: other.strokes[Role.TOP]}
    assert find_half_spaces(find_carriers(exact_views(strokes, views.size))) == ()


def test_two_views_tell_no_corner_in_space() -> None:
    views = _cut_block((60.0, 40.0, 30.0), (20.0, 15.0, 10.0))
    strokes = {role: views.strokes[role] for role in (Role.FRONT, Role.TOP)}
    carriers = find_carriers(exact_views(strokes, views.size))
    assert len(spatial_edges(carriers, _NEAR).points) == 0
    assert find_half_spaces(carriers) == ()


def test_the_edges_of_a_cut_are_those_that_three_views_draw() -> None:
    carriers = find_carriers(_cut_block((100.0, 40.0, 30.0), (20.0, 15.0, 10.0)))
    shown = spatial_edges(carriers, _NEAR)
    assert carriers.scale == 1.0
    edges = {
        frozenset(tuple(np.round(shown.points[end], 6).tolist()) for end in edge)
        for edge in shown.edges
    }
    ends = (80.0, 0.0, 30.0), (100.0, 15.0, 30.0), (100.0, 0.0, 20.0)
    assert edges == {frozenset((p, q)) for p in ends for q in ends if p < q}


def test_faces_on_one_plane_share_a_half_space(drawn: Draw) -> None:
    corners = [(x, y, z) for x in (0.0, 60.0) for y in (0.0, 60.0) for z in (0.0, 60.0)]
    corners.remove((60.0, 60.0, 60.0))
    whole = convex([*corners, (30.0, 60.0, 60.0), (60.0, 30.0, 60.0), (60.0, 60.0, 30.0)])
    # A slot deep enough to divide the oblique face.
    divided = cut(whole, box((42.0, -1.0, 40.0), (48.0, 61.0, 61.0)))
    for solid, hulls in ((whole, 1), (divided, 2)):
        (body,) = find_half_spaces(find_carriers(drawn(solid)))
        assert body.normal == pytest.approx((3**-0.5,) * 3)
        assert {axis: len(body.outlines(axis)) for axis in Axis} == dict.fromkeys(Axis, hulls)
