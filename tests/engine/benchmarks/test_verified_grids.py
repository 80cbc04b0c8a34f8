"""Parts of grids that look alike."""

import numpy as np
import pytest

from benchmarks.parts.grid_parts import Grid, are_sound, grid_solid, grid_strokes, sound_parts
from benchmarks.sheets.sheet_policies import POLICIES, as_drawn, same_drawing
from benchmarks.tasks.verified_grids import alike_in_grid, confusable, pair_of, with_thin_box
from gaussiancad_core.evidence.drawn_views import exact_views
from gaussiancad_core.model.axes import Role
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_core.solid.same import same_solid
from gaussiancad_protocol.modes import Status

_PLACES = ((0.0, 7.0, 20.0, 29.0), (0.0, 4.0, 15.0, 24.0), (0.0, 9.0, 14.0, 30.0))
_POLICIES = {policy.name: policy for policy in POLICIES}


def test_a_pair_has_one_drawing_and_is_two_parts() -> None:
    grid = Grid((3, 3, 3))
    pair = pair_of(grid, POLICIES[0], np.random.default_rng(1))
    assert are_sound(grid, np.array(pair)).all()
    drawings = [
        {role: grid_strokes(grid, part, _PLACES, role) for role in POLICIES[0].roles}
        for part in pair
    ]
    assert same_drawing(*drawings, 30.0)
    assert not same_solid(*(grid_solid(grid, part, _PLACES) for part in pair))
    thin = with_thin_box(grid, pair, _PLACES, np.random.default_rng(0))
    steps = np.concatenate([np.diff(item) for item in thin])
    assert (steps < 0.5).sum() == 1 and len(steps) == 9


def test_confusable_parts_leave_out_what_another_one_does_not_have() -> None:
    grid, policy = Grid((3, 3, 2)), _POLICIES["hidden lines in front only"]
    numbers = sound_parts(grid)
    places = (*_PLACES[:2], (0.0, 9.0, 14.0))
    index = int(confusable(grid, policy)[5])
    others = alike_in_grid(grid, places, policy, index)
    whole = [
        {role: grid_strokes(grid, int(part), places, role) for role in policy.roles}
        for part in (numbers[index], *others)
    ]
    drawn = [as_drawn(item, policy) for item in whole]
    assert len(others) >= 1 and all(same_drawing(drawn[0], item, 30.0) for item in drawn[1:])
    assert any(same_drawing(drawn[0], item, 30.0) for item in whole[1:])


@pytest.mark.parametrize("mirrored", [True, False])
def test_a_block_is_another_part_in_first_angle_but_where_it_is_its_own_mirror(
    mirrored: bool,
) -> None:
    grid, policy = Grid((2, 2, 2)), _POLICIES["projection not told"]
    numbers = sound_parts(grid)
    block = int(np.flatnonzero(numbers == 255)[0])
    places = ((0.0, 7.0, 20.0), (0.0, 4.0, 8.0 if mirrored else 9.0), (0.0, 9.0, 14.0))
    assert Role.FRONT in policy.roles
    assert alike_in_grid(grid, places, policy, block) == ([] if mirrored else [255])


@pytest.mark.parametrize(
    ("shape", "part", "policy", "reason"),
    [
        ((2, 4, 2), 62391, "hidden lines in front only", "assumed"),
        ((2, 4, 2), 61877, "hidden lines in front only", "assumed"),
        ((3, 3, 4), 68132274087, "all hidden lines", "ambiguous"),
    ],
)
@pytest.mark.parametrize("thin", [0.02, 9.0])
def test_a_part_that_looks_like_another_one_is_not_verified(
    shape: tuple[int, int, int], part: int, policy: str, reason: str, thin: float
) -> None:
    grid, drawn_by = Grid(shape), _POLICIES[policy]
    steps = ((10.0, 7.0, 23.0), (24.0, 8.0, 11.0, thin), (4.0, 17.0, 16.0, 7.0))
    cut = [step[: count - 1] + step[-1:] for step, count in zip(steps, shape, strict=True)]
    x, y, z = ((0.0, *np.cumsum(item).tolist()) for item in cut)
    drawn = {role: grid_strokes(grid, part, (x, y, z), role) for role in drawn_by.roles}
    result = exact_solid(exact_views(as_drawn(drawn, drawn_by), (x[-1], y[-1], z[-1])))
    assert result.status is Status.APPROXIMATE
    assert [code for code, _ in result.reasons] == [reason]
    assert not same_solid(result.shape, result.alternatives[0])
