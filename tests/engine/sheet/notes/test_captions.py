"""Captions that name views."""

import pytest

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.sheet.notes.captions import (
    Caption,
    caption_role,
    captioned,
    captions_of,
    told_projection,
)
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.scale.texts import SheetText

FRONT, TOP, RIGHT = (
    (460.0, 115.0, 640.0, 385.0),
    (460.0, 529.0, 640.0, 671.0),
    (129.0, 115.0, 271.0, 385.0),
)
FIRST_ANGLE = {Role.FRONT: FRONT, Role.TOP: TOP, Role.RIGHT: RIGHT}


def above(role: Role, box: Box, gap: float = 30.0) -> Caption:
    middle = (box[0] + box[2]) / 2.0
    return Caption(role, (middle - 40.0, box[1] - gap - 14.0, middle + 40.0, box[1] - gap))


@pytest.mark.parametrize(
    ("text", "role"),
    [
        ("Front View", Role.FRONT),
        ("TOP", Role.TOP),
        ("Right side", Role.RIGHT),
        ("Right Side View", Role.RIGHT),
        ("PLAN VIEW (1:2)", Role.TOP),
        ("Front elevation", Role.FRONT),
        ("Ansicht von links", Role.LEFT),
        ("Draufsicht", Role.TOP),
        ("Vue de gauche", Role.LEFT),
        ("Vista superior", Role.TOP),
        ("\u4e3b\u89c6\u56fe", Role.FRONT),
        ("\u4fef\u89c6\u56fe", Role.TOP),
        ("\u0412\u0438\u0434 \u0441\u0432\u0435\u0440\u0445\u0443", Role.TOP),
        ("Bottom view", Role.BOTTOM),
        ("REAR VIEW", Role.REAR),
        ("SECTION A-A", None),
        ("VIEW A", None),
        ("TOP PLATE", None),
        ("40", None),
        ("", None),
    ],
)
def test_what_views_are_called(text: str, role: Role | None) -> None:
    assert caption_role(text) is role


def test_a_name_that_stands_twice_names_nothing() -> None:
    texts = [SheetText(name, (0.0, 0.0, 50.0, 12.0)) for name in ("TOP", "FRONT", "FRONT VIEW")]
    assert [own.role for own in captions_of(texts)] == [Role.TOP]
    assert captions_of([SheetText("TOP", (0.0, 0.0, 50.0, 12.0), field=True)]) == ()


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
    assert told_projection(FIRST_ANGLE) is Projection.FIRST
    third = {Role.FRONT: TOP, Role.TOP: FRONT}
    assert told_projection(third) is Projection.THIRD
    assert told_projection({Role.TOP: TOP, Role.RIGHT: RIGHT}) is None
    mixed = {Role.FRONT: FRONT, Role.TOP: TOP, Role.LEFT: RIGHT}
    assert told_projection(mixed) is None
