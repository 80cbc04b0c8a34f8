"""Pieces of lines, drawn or blank."""

from collections.abc import Callable
from math import hypot

import pytest

from gaussiancad_core.axes import Axis
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.part import PartModel, model_part
from gaussiancad_core.reasoning.pieces import Piece, find_pieces
from gaussiancad_core.reasoning.planes import IN_PLANE, role_plane
from gaussiancad_core.views import Linetype

_NAMES = ("stepped-block", "counterbored-block", "wedge-block", "countersunk-plate")

Found = tuple[PartModel, DrawnViews, list[Piece]]


@pytest.fixture(scope="module", params=_NAMES)
def found(request: pytest.FixtureRequest, sample_views: Callable[[str], DrawnViews]) -> Found:
    views = sample_views(request.param)
    part = model_part(views)
    return part, views, list(find_pieces(part.space, part.supports.planes, 0.01))


def test_pieces_have_a_length_a_direction_and_a_place_in_the_plane(found: Found) -> None:
    part, views, pieces = found
    assert {piece.role for piece in pieces} == set(views.roles)
    for piece in pieces:
        assert piece.length > 0.0 and 0.0 < piece.confidence <= 1.0
        assert hypot(*piece.across) == pytest.approx(1.0)
        axes = IN_PLANE[role_plane(piece.role).normal]
        for index, coordinate in zip(axes, piece.point, strict=True):
            values = part.space.values[Axis(index)]
            assert values[0] - 0.1 <= coordinate <= values[-1] + 0.1


def test_the_drawn_pieces_on_supports_are_as_long_as_what_is_drawn(found: Found) -> None:
    part, _, pieces = found
    for plane in part.supports.planes.values():
        (role,) = plane.roles
        for linetype in Linetype:
            told = sum(
                piece.length
                for piece in pieces
                if piece.role is role
                and piece.linetype is linetype
                and any(s.curve.distance(piece.point) < 1e-6 for s in plane.supports)
            )
            drawn = 0.0
            for support in plane.supports:
                for low, high in support.drawn():
                    steps = 4000
                    share = sum(
                        support.linetype_at(role, low + (k + 0.5) / steps * (high - low))
                        is linetype
                        for k in range(steps)
                    )
                    drawn += share / steps * (high - low) * support.curve.speed
            assert told == pytest.approx(drawn, rel=0.01, abs=0.5)


def test_a_pieces_linetype_is_what_its_support_shows(found: Found) -> None:
    part, _, pieces = found
    for piece in pieces:
        plane = part.supports.planes[role_plane(piece.role).normal]
        shown = {
            support.linetype_at(piece.role, support.curve.parameter(piece.point))
            for support in plane.supports
            if support.curve.distance(piece.point) < 1e-7
        }
        if piece.linetype is None:
            assert Linetype.VISIBLE not in shown
        elif shown:
            assert piece.linetype in shown
