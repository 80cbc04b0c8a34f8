"""Lines of the grid: how many pieces they have, and that all others say nothing."""

from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import pytest

from gaussiancad_core.cells.edge_fragments import SHARE, Piece, find_pieces
from gaussiancad_core.cells.grid_rows import count_pieces, find_rows
from gaussiancad_core.errors import LimitError
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.tolerances import SHORTEST
from gaussiancad_core.labelling import part_model as reasoning_part
from gaussiancad_core.labelling.part_model import PartModel, model_part
from gaussiancad_core.labelling.visibility_rules import groups_at
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane

_NAMES = ("stepped-block", "counterbored-block", "wedge-block", "ball-knob")

Views = Callable[[str], DrawnViews]


@pytest.fixture(scope="module", params=_NAMES)
def part(request: pytest.FixtureRequest, sample_views: Views) -> PartModel:
    return model_part(sample_views(request.param))


def test_pieces_of_the_grid_are_counted(part: PartModel) -> None:
    found = list(find_pieces(part.space, part.carriers.planes, 0.01))
    on_grid = Counter(
        (role_plane(piece.role).normal, place, round(piece.point[place], 6))
        for piece in found
        for place in (0, 1)
        if piece.across == ((1.0, 0.0) if place == 0 else (0.0, 1.0))
    )
    for normal in part.carriers.planes:
        rows = find_rows(part.space, normal)
        assert count_pieces(rows) == sum(len(list(row.pieces())) for row in rows)
        for row in rows:
            assert list(row.cuts) == sorted(row.cuts)
            assert all(high - low >= SHORTEST for low, high in row.pieces())
            place = normal, row.coordinate, round(row.value, 6)
            # Curves of two surfaces that run along it may be there as well.
            assert on_grid[place] >= len(list(row.pieces()))


def test_lines_that_are_left_out_say_nothing(part: PartModel) -> None:
    for normal, plane in part.carriers.planes.items():
        known = {(row.coordinate, row.value) for row in find_rows(part.space, normal)}
        for place, axis in enumerate(IN_PLANE[normal]):
            values, across = _axis_values(part, normal, place)
            for value in part.space.values[type(normal)(axis)]:
                if (place, value) in known:
                    continue
                for low, high in pairwise(values):
                    at = low + SHARE * (high - low)
                    point = (value, at) if place == 0 else (at, value)
                    piece = Piece(plane.roles[0], point, across, None, high - low)
                    assert groups_at(part.space, piece) is None


def _axis_values(
    part: PartModel, normal: object, place: int
) -> tuple[list[float], tuple[float, float]]:
    other = IN_PLANE[normal][1 - place]
    across = (1.0, 0.0) if place == 0 else (0.0, 1.0)
    return part.space.values[type(normal)(other)], across


def test_too_many_are_refused_before_one_is_made(
    sample_views: Views, monkeypatch: pytest.MonkeyPatch
) -> None:
    views = sample_views("l-bracket")
    part = model_part(views)
    count = sum(
        len(plane.roles) * count_pieces(find_rows(part.space, normal))
        for normal, plane in part.carriers.planes.items()
    )
    every = list(find_pieces(part.space, part.carriers.planes, 0.01))
    assert 0 < count <= len(every)
    monkeypatch.setattr(reasoning_part, "_MOST_PIECES", len(every))
    assert model_part(views).rules == part.rules
    monkeypatch.setattr(reasoning_part, "_MOST_PIECES", count - 1)
    monkeypatch.setattr(reasoning_part, "find_pieces", _none_is_asked_for)
    with pytest.raises(LimitError) as caught:
        model_part(replace(views))
    assert caught.value.code == "part-too-complex"


def _none_is_asked_for(*_: object) -> object:
    yield pytest.fail("a piece was made")
