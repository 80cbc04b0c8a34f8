"""First or third angle, by how much of the lines either reading's sketch explains."""

from types import SimpleNamespace

import pytest

from gaussiancad_core.model.axes import Role
from gaussiancad_core.sketch import projection_by_sketch
from gaussiancad_core.sketch.projection_by_sketch import weigh

USUAL, UNUSUAL = (Role.FRONT, Role.TOP), (Role.FRONT, Role.BOTTOM)


@pytest.mark.parametrize(
    ("energies", "roles", "likelier", "is_clear"),
    [
        ((100.0, 120.0), (USUAL, USUAL), 0, True),
        ((120.0, 100.0), (USUAL, USUAL), 1, True),
        # A little less tells which is likelier, and leaves it open.
        ((105.0, 100.0), (USUAL, USUAL), 1, False),
        ((100.5, 100.0), (USUAL, USUAL), 0, False),
        ((0.0, 0.0), (USUAL, USUAL), 0, False),
        # A search that was not ended tells no more.
        ((110.0, 199.0), (USUAL, USUAL), 0, False),
        ((199.0, 110.0), (USUAL, USUAL), 1, False),
        # What hardly fits is no better for fitting a little less badly.
        ((180.0, 130.0), (USUAL, USUAL), 0, False),
        # A view from below in place of one from above must explain more.
        ((120.0, 100.0), (USUAL, UNUSUAL), 0, False),
        ((140.0, 100.0), (USUAL, UNUSUAL), 1, True),
        ((199.0, 100.0), (USUAL, UNUSUAL), 0, False),
        ((100.0, 120.0), (USUAL, UNUSUAL), 0, True),
        # Nothing is told where a reading has no sketch.
        ((None, 100.0), (USUAL, USUAL), 1, False),
        ((None, None), (USUAL, USUAL), 0, False),
        ((100.0,), (USUAL,), 0, False),
    ],
)
def test_the_sketch_that_explains_clearly_more_tells_the_reading(
    monkeypatch: pytest.MonkeyPatch,
    energies: tuple[float | None, ...],
    roles: tuple[tuple[Role, ...], ...],
    likelier: int,
    is_clear: bool,
) -> None:
    readings = [
        SimpleNamespace(
            numbered=energy,
            drawn=SimpleNamespace(
                strokes={Role.FRONT: [SimpleNamespace(length=500.0)]}, roles=role
            ),
            grid=1.0,
        )
        for energy, role in zip(energies, roles, strict=True)
    ]
    monkeypatch.setattr(
        projection_by_sketch,
        "sketch",
        lambda energy, grid: (
            None
            if energy is None
            else SimpleNamespace(
                energy=energy, at_least=energy if energy < 199.0 else 0.0, unexplained=0.0
            )
        ),
    )
    found = weigh(readings)
    assert (found.likelier, found.is_clear) == (likelier, is_clear)


@pytest.mark.parametrize(
    ("unexplained", "roles", "likelier"),
    [
        ((40.0, 20.0), (USUAL, USUAL), 1),
        ((20.0, 40.0), (USUAL, USUAL), 0),
        # Alike: the slabs tell.
        ((20.0, 20.1), (USUAL, USUAL), 1),
        ((40.0, 20.0), (USUAL, UNUSUAL), 0),
    ],
)
def test_what_the_parts_leave_unexplained_tells_the_likelier_reading(
    monkeypatch: pytest.MonkeyPatch,
    unexplained: tuple[float, float],
    roles: tuple[tuple[Role, ...], ...],
    likelier: int,
) -> None:
    readings = [
        SimpleNamespace(
            numbered=number,
            drawn=SimpleNamespace(
                strokes={Role.FRONT: [SimpleNamespace(length=500.0)]}, roles=role
            ),
            grid=1.0,
        )
        for number, role in enumerate(roles)
    ]
    energies = 104.0, 100.0
    monkeypatch.setattr(
        projection_by_sketch,
        "sketch",
        lambda number, grid: SimpleNamespace(
            energy=energies[number], at_least=0.0, unexplained=unexplained[number]
        ),
    )
    found = weigh(readings)
    assert (found.likelier, found.is_clear) == (likelier, False)
