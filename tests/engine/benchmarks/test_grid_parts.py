"""Parts of a grid, and what each view shows of them."""

import numpy as np
import pytest

from benchmarks.parts.grid_parts import Grid, grid_solid, grid_strokes, looks, sound_parts
from gaussiancad_core.kernel.brep import soundness, volume
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Segment

_GRID = Grid((2, 3, 2))
_PLACES = ((0.0, 7.0, 20.0), (0.0, 4.0, 15.0, 24.0), (0.0, 9.0, 14.0))
_VOLUMES = np.einsum("i,j,k->ijk", *(np.diff(item) for item in _PLACES))


def _key(strokes: tuple[Segment, ...]) -> list[tuple]:
    ends = [sorted((stroke.start, stroke.end)) for stroke in strokes]
    kinds = [stroke.linetype.value for stroke in strokes]
    return sorted(
        (*np.round(np.ravel(pair), 4).tolist(), kind)
        for pair, kind in zip(ends, kinds, strict=True)
    )


@pytest.mark.parametrize("part", sound_parts(_GRID)[::97].tolist())
def test_solid_is_the_boxes_and_has_the_lines(part: int) -> None:
    solid = grid_solid(_GRID, part, _PLACES)
    facts = soundness(solid)
    assert facts.valid and facts.closed and facts.solids == 1
    boxes = _GRID.boxes(np.array([part]))[0]
    assert volume(solid) == pytest.approx(float(_VOLUMES[boxes].sum()), rel=1e-12)
    drawing = LineDrawing(solid)
    for role in Role:
        assert _key(grid_strokes(_GRID, part, _PLACES, role)) == _key(drawing.view(role))


def test_sound_parts_of_four_boxes_are_those_that_hang_together() -> None:
    # Of 2 x 2 x 1 boxes that reach all four sides: two that touch by an edge are no part.
    square = Grid((2, 2, 1))
    assert sorted(sound_parts(square).tolist()) == [7, 11, 13, 14, 15]


def test_looks_are_alike_where_the_strokes_are() -> None:
    grid = Grid((3, 2, 2))
    places = ((0.0, 7.0, 20.0, 31.0), (0.0, 4.0, 15.0), (0.0, 9.0, 14.0))
    parts = sound_parts(grid)
    for hidden in (True, False):
        for role in (Role.FRONT, Role.LEFT):
            seen: dict[int, set] = {}
            for part, number in zip(parts.tolist(), looks(grid)[role, hidden], strict=True):
                strokes = grid_strokes(grid, part, places, role)
                kept = [item for item in _key(strokes) if hidden or item[-1] == "visible"]
                seen.setdefault(int(number), set()).add(tuple(kept))
            assert all(len(item) == 1 for item in seen.values())
            assert len(set().union(*seen.values())) == len(seen)


def test_hidden_lines_tell_what_no_visible_one_does() -> None:
    grid = Grid((3, 3, 2))
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    for hidden in (True, False):
        views = np.stack([looks(grid)[role, hidden] for role in roles])
        distinct = len(np.unique(views, axis=1).T)
        assert (distinct == views.shape[1]) is hidden
