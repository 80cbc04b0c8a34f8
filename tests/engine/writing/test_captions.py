"""Captions that name views."""

import pytest

from gaussiancad_core.model.axes import Role
from gaussiancad_core.writing.captions import caption_role, captions_of
from gaussiancad_core.writing.sheet_texts import SheetText


@pytest.mark.parametrize(
    ("text", "role"),
    [
        (text, said)
        for said, texts in {
            Role.FRONT: "Front View|Front elevation|\u4e3b\u89c6\u56fe",
            Role.TOP: "TOP|PLAN VIEW (1:2)|Draufsicht|Vista superior|\u4fef\u89c6\u56fe|"
            "\u0412\u0438\u0434 \u0441\u0432\u0435\u0440\u0445\u0443",
            Role.RIGHT: "Right side|Right Side View",
            Role.LEFT: "Ansicht von links|Vue de gauche",
            Role.BOTTOM: "Bottom view",
            Role.REAR: "REAR VIEW",
            None: "SECTION A-A|VIEW A|TOP PLATE|40|",
        }.items()
        for text in texts.split("|")
    ],
)
def test_what_views_are_called(text: str, role: Role | None) -> None:
    assert caption_role(text) is role


def test_a_name_that_stands_twice_names_nothing() -> None:
    texts = [SheetText(name, (0.0, 0.0, 50.0, 12.0)) for name in ("TOP", "FRONT", "FRONT VIEW")]
    assert [caption.role for caption in captions_of(texts)] == [Role.TOP]
    assert captions_of([SheetText("TOP", (0.0, 0.0, 50.0, 12.0), field=True)]) == ()
