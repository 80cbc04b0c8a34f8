"""A solid's smooth edges against tangent edges of the views."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.lines.hlr import LineDrawing, LineOptions
from gaussiancad_core.lines.smooth_edges import smooth_edges
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.tangent_policies import TangentPolicy
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.solid.verify import verify
from sample_parts import sample
from sample_parts.modelling import box

Draw = Callable[..., DrawnViews]


def _with_smooth(views: DrawnViews, policy: TangentPolicy) -> DrawnViews:
    """Views of the filleted block that have its smooth edges among their strokes."""
    drawing = LineDrawing(sample("filleted-block").build(), LineOptions(tangent_edges=True))
    return replace(
        views,
        strokes={role: drawing.view(role) for role in views.roles},
        tangent_policy=policy,
    )


@pytest.mark.parametrize("policy", list(TangentPolicy))
def test_a_smooth_edge_is_no_missing_line_where_the_sheet_draws_them(
    drawn: Draw, policy: TangentPolicy
) -> None:
    solid = sample("filleted-block").build()
    found = verify(solid, _with_smooth(drawn(solid), policy))
    assert found.explains is policy.draws
    missing = {(flaw.role, flaw.missing) for flaw in found.flaws}
    assert missing == (set() if policy.draws else {(Role.FRONT, True), (Role.RIGHT, True)})


def test_a_sharp_edge_of_the_sheet_is_missing_whatever_it_draws(drawn: Draw) -> None:
    solid = sample("filleted-block").build()
    views = _with_smooth(drawn(solid), TangentPolicy.DRAWN)
    sharp = Segment((40.0, 0.0), (40.0, 30.0), Linetype.VISIBLE)
    strokes = {**views.strokes, Role.FRONT: (*views.strokes[Role.FRONT], sharp)}
    found = verify(solid, replace(views, strokes=strokes))
    (flaw,) = found.flaws
    assert (flaw.role, flaw.missing) == (Role.FRONT, True)
    assert flaw.length == pytest.approx(30.0, rel=0.05)


def test_a_tangent_edge_of_the_sheet_has_to_be_an_edge_of_the_solid(drawn: Draw) -> None:
    solid = sample("filleted-block").build()
    views = drawn(solid)
    smooth = smooth_edges(solid, dict(views.strokes))
    seen = replace(views, tangents=smooth, tangent_policy=TangentPolicy.THIN)
    assert sum(map(len, smooth.values())) == 4 and verify(solid, seen).explains
    # A box has no such edges: each is a line that it lacks.
    block = box((0.0, 0.0, 0.0), tuple(views.size))
    plain = replace(drawn(block), tangents=smooth, tangent_policy=TangentPolicy.THIN)
    found = verify(block, plain)
    assert not found.explains and {flaw.missing for flaw in found.flaws} == {True}
    assert sum(flaw.length for flaw in found.flaws) == pytest.approx(4 * 30.0, rel=0.05)
    # A sharp edge that lies there is one, too.
    outline = {Role.FRONT: (views.strokes[Role.FRONT][0],)}
    assert verify(block, replace(drawn(block), tangents=outline)).explains


def test_smooth_edges_are_those_of_the_drawing_that_has_them() -> None:
    for name in ("filleted-block", "slotted-link", "rounded-cover"):
        shape = sample(name).build()
        plain, every = (
            LineDrawing(shape, LineOptions(tangent_edges=tangent)) for tangent in (False, True)
        )
        for role in (Role.FRONT, Role.TOP, Role.RIGHT):
            lines = {role: plain.view(role)}
            (smooth,) = smooth_edges(shape, lines).values()
            visible = sum(
                stroke.length
                for stroke in (*lines[role], *smooth)
                if stroke.linetype is Linetype.VISIBLE
            )
            expected = sum(
                stroke.length for stroke in every.view(role) if stroke.linetype is Linetype.VISIBLE
            )
            assert visible == pytest.approx(expected, rel=1e-6)


def test_a_solid_without_round_faces_has_none() -> None:
    shape = sample("l-bracket").build()
    assert smooth_edges(shape, {Role.TOP: ()}) == {Role.TOP: ()}
