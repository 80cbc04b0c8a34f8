"""Pieces of lines, drawn or blank."""

from collections.abc import Callable
from itertools import pairwise
from math import hypot

import pytest

from gaussiancad_core.cells.edge_fragments import Piece, find_pieces
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.labelling.part_model import PartModel, model_part
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.model.views import Linetype, Segment

_NAMES = ("stepped-block", "counterbored-block", "wedge-block", "countersunk-plate")

Found = tuple[PartModel, DrawnViews, list[Piece]]


@pytest.fixture(scope="module", params=_NAMES)
def found(request: pytest.FixtureRequest, sample_views: Callable[[str], DrawnViews]) -> Found:
    views = sample_views(request.param)
    part = model_part(views)
    return part, views, list(find_pieces(part.space, part.carriers.planes, 0.01))


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
    for plane in part.carriers.planes.values():
        (role,) = plane.roles
        for linetype in Linetype:
            stated = sum(
                piece.length
                for piece in pieces
                if piece.role is role
                and piece.linetype is linetype
                and any(s.curve.distance(piece.point) < 1e-6 for s in plane.carriers)
            )
            drawn = 0.0
            for carrier in plane.carriers:
                for low, high in carrier.drawn():
                    steps = 4000
                    share = sum(
                        carrier.linetype_at(role, low + (k + 0.5) / steps * (high - low))
                        is linetype
                        for k in range(steps)
                    )
                    drawn += share / steps * (high - low) * carrier.curve.speed
            assert stated == pytest.approx(drawn, rel=0.01, abs=0.5)


def test_a_pieces_linetype_is_what_its_support_shows(found: Found) -> None:
    part, _, pieces = found
    for piece in pieces:
        plane = part.carriers.planes[role_plane(piece.role).normal]
        shown = {
            carrier.linetype_at(piece.role, carrier.curve.parameter(piece.point))
            for carrier in plane.carriers
            if carrier.curve.distance(piece.point) < 1e-7
        }
        if piece.linetype is None:
            assert Linetype.VISIBLE not in shown
        elif shown:
            assert piece.linetype in shown


@pytest.mark.parametrize(("length", "linetype"), [(0.5, Linetype.VISIBLE), (5.0, Linetype.HIDDEN)])
def test_a_dash_of_the_outline_is_visible(length: float, linetype: Linetype) -> None:
    """A ledge along the left edge, from which a hidden line goes on: both look like one."""
    corners = [(0, 0), (40, 0), (40, 30), (length, 30), (length, 20), (0, 20), (0, 0)]
    edges = [(a, b) for a, b in pairwise(corners) if not a[1] == b[1] == 20]
    front = [Segment(a, b, Linetype.VISIBLE) for a, b in edges]
    front.append(Segment((0, 20), (30, 20), Linetype.HIDDEN))
    boxes = {Role.FRONT: front}
    for role, high in ((Role.TOP, 25), (Role.RIGHT, 30)):
        wide = 40 if role is Role.TOP else 25
        items = [(0, 0), (wide, 0), (wide, high), (0, high), (0, 0)]
        boxes[role] = [Segment(a, b, Linetype.VISIBLE) for a, b in pairwise(items)]
    tolerance = 0.1
    part = model_part(DrawnViews(boxes, (40.0, 25.0, 30.0), tolerance, 0.03))
    scale = part.carriers.scale
    found = [
        piece.linetype
        for rule in part.rules
        for piece in rule.pieces
        if piece.role is Role.FRONT
        and piece.point[1] == pytest.approx(20.0 * scale)
        and piece.point[0] < length * scale
    ]
    assert set(found) == {linetype}
