"""Each kind of drawing has a message with its place."""

import re

import pytest

from gaussiancad_core.sheet.special_views.special_view_notes import (
    special_view_messages,
    why_unused,
)
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind, SpecialView

BOX = (10.4, 20.0, 110.0, 220.6)


ILLUSTRATIONS = (SpecialKind.PICTORIAL, SpecialKind.THREAD)


@pytest.mark.parametrize("kind", SpecialKind)
def test_what_shows_the_part_and_is_not_used_is_a_reason_for_doubt(kind: SpecialKind) -> None:
    (stated,) = special_view_messages([SpecialView(kind, BOX)])
    illustrates = kind in ILLUSTRATIONS
    assert stated.doubt == (not illustrates)
    assert stated.code == (f"{kind.value}-left-out" if illustrates else "unused-view")
    assert "(10, 20)-(110, 221) px" in stated.message
    assert stated.message.endswith(why_unused(kind))
    assert "\n" not in stated.message


@pytest.mark.parametrize(
    ("kind", "code"),
    [
        (SpecialKind.SECTION, "section-used"),
        (SpecialKind.HALF_SECTION, "section-used"),
        (SpecialKind.PARTIAL_SECTION, "section-used"),
        (SpecialKind.BROKEN, "broken-view"),
        (SpecialKind.HALF, "half-view"),
    ],
)
def test_what_stands_for_a_view_is_a_reason_for_doubt(kind: SpecialKind, code: str) -> None:
    (stated,) = special_view_messages([SpecialView(kind, BOX, used=True)])
    assert (stated.code, stated.doubt) == (code, True)
    assert "(10, 20)-(110, 221) px" in stated.message


def test_one_message_names_all_of_a_kind() -> None:
    views = [SpecialView(SpecialKind.DETAIL, (k, 0.0, k + 5.0, 5.0)) for k in range(7)]
    views.append(SpecialView(SpecialKind.PICTORIAL, BOX))
    stated = special_view_messages(views)
    assert [t.code for t in stated] == ["pictorial-left-out", "unused-view"]
    assert len(re.findall(r"\(\d+, \d+\)-\(\d+, \d+\)", stated[1].message)) == 5
