"""Captions that name views."""

import pytest

from gaussiancad_core.model.axes import Role
from gaussiancad_core.writing.captions import caption_role, captions_of
from gaussiancad_core.writing.sheet_texts import SheetText


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
    assert [caption.role for caption in captions_of(texts)] == [Role.TOP]
    assert captions_of([SheetText("TOP", (0.0, 0.0, 50.0, 12.0), field=True)]) == ()
