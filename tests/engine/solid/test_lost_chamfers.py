"""A chamfer of a bore whose slanted lines are too short to be read is found by its circles."""

from itertools import pairwise
from math import pi

import pytest

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import faces_of, volume
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_protocol.modes import Status

_SIDE, _HEIGHT, _CENTRE, _BORE, _MOUTH = 40.0, 20.0, 15.0, 4.0, 5.0
"""mm of a block, its bore, and where the chamfer ends."""

_RIM = _HEIGHT - (_MOUTH - _BORE)

_PICTURE, _FILE = 0.1, 1e-4
"""mm by which lines of a picture and of a file may miss where they belong."""


def _outline(height: float) -> list[Segment | Arc]:
    corners = ((0.0, 0.0), (_SIDE, 0.0), (_SIDE, height), (0.0, height), (0.0, 0.0))
    return [Segment(start, end, Linetype.VISIBLE) for start, end in pairwise(corners)]


def _bored(*, chamfer: bool) -> tuple[Segment | Arc, ...]:
    """A view from the side: the bore's sides up to its rim, and the chamfer's if asked for."""
    left, right = _CENTRE - _BORE, _CENTRE + _BORE
    lines = [((x, 0.0), (x, _RIM)) for x in (left, right)] + [((left, _RIM), (right, _RIM))]
    if chamfer:
        lines += [
            ((_CENTRE + way * _BORE, _RIM), (_CENTRE + way * _MOUTH, _HEIGHT)) for way in (-1, 1)
        ]
    return (*_outline(_HEIGHT), *(Segment(*ends, Linetype.HIDDEN) for ends in lines))


def _views(front: bool, right: bool, tolerance: float) -> DrawnViews:
    circles = [
        Arc((_CENTRE, _CENTRE), radius, 0.0, 2.0 * pi, Linetype.VISIBLE)
        for radius in (_BORE, _MOUTH)
    ]
    strokes = {
        Role.FRONT: _bored(chamfer=front),
        Role.TOP: (*_outline(_SIDE), *circles),
        Role.RIGHT: _bored(chamfer=right),
    }
    return DrawnViews(strokes, (_SIDE, _SIDE, _HEIGHT), tolerance)


@pytest.mark.parametrize(("front", "right"), [(False, False), (True, False), (True, True)])
def test_the_chamfer_is_a_cone_whichever_views_draw_it(front: bool, right: bool) -> None:
    found = exact_solid(_views(front, right, _PICTURE)).shape
    assert found is not None and len(faces_of(found)) == 8
    cone = pi / 3.0 * (_HEIGHT - _RIM) * (_BORE**2 + _BORE * _MOUTH + _MOUTH**2)
    expected = _SIDE**2 * _HEIGHT - pi * _BORE**2 * _RIM - cone
    assert volume(found) == pytest.approx(expected, rel=1e-6)


def test_a_file_draws_all_of_its_lines_so_that_nothing_is_made_up() -> None:
    found = exact_solid(_views(False, False, _FILE))
    assert found.status is Status.APPROXIMATE
    assert "lines-unexplained" in [code for code, _ in found.reasons]
