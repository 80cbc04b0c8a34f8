"""Which views captions name, and what projection these tell."""

import pytest

from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.views.captioned_views import Caption, captioned, projection_named

FRONT, TOP, RIGHT = (
    (460.0, 115.0, 640.0, 385.0),
    (460.0, 529.0, 640.0, 671.0),
    (129.0, 115.0, 271.0, 385.0),
)
FIRST_ANGLE = {Role.FRONT: FRONT, Role.TOP: TOP, Role.RIGHT: RIGHT}


def above(role: Role, box: Box, gap: float = 30.0) -> Caption:
    middle = (box[0] + box[2]) / 2.0
    return Caption(role, (middle - 40.0, box[1] - gap - 14.0, middle + 40.0, box[1] - gap))


@pytest.mark.parametrize("gap", [30.0, 95.0])
def test_captions_above_their_views(gap: float) -> None:
    captions = [above(role, box, gap) for role, box in FIRST_ANGLE.items()]
    figures = [TOP, RIGHT, FRONT, (700.0, 700.0, 720.0, 720.0)]
    assert captioned(captions, figures) == FIRST_ANGLE


def test_captions_below_their_views() -> None:
    captions = [
        Caption(role, (box[0] + 20.0, box[3] + 12.0, box[2] - 20.0, box[3] + 26.0))
        for role, box in FIRST_ANGLE.items()
    ]
    assert captioned(captions, list(FIRST_ANGLE.values())) == FIRST_ANGLE


def test_a_view_of_a_few_px_has_its_caption() -> None:
    thin = (460.0, 598.0, 640.0, 603.0)
    views = {**FIRST_ANGLE, Role.TOP: thin}
    captions = [above(role, box, 60.0) for role, box in views.items()]
    assert captioned(captions, [FRONT, RIGHT, thin]) == views


def test_captions_without_figures_name_nothing() -> None:
    assert captioned([above(Role.TOP, TOP)], []) == {}
    assert captioned([], [TOP, FRONT]) == {}


def test_places_tell_the_projection() -> None:
    assert projection_named(FIRST_ANGLE) is Projection.FIRST
    third = {Role.FRONT: TOP, Role.TOP: FRONT}
    assert projection_named(third) is Projection.THIRD
    assert projection_named({Role.TOP: TOP, Role.RIGHT: RIGHT}) is None
    mixed = {Role.FRONT: FRONT, Role.TOP: TOP, Role.LEFT: RIGHT}
    assert projection_named(mixed) is None
