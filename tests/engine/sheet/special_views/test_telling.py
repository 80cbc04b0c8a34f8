"""Each kind of drawing has a message with its place."""

import re

import pytest

from gaussiancad_core.sheet.special_views.kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.special_views.telling import tellings

BOX = (10.4, 20.0, 110.0, 220.6)


@pytest.mark.parametrize("kind", SpecialKind)
def test_what_is_left_out_is_a_warning(kind: SpecialKind) -> None:
    (told,) = tellings([SpecialView(kind, BOX)])
    assert told.code == f"{kind.value}-left-out"
    assert not told.doubt
    assert "(10, 20)-(110, 221) px" in told.message
    assert "\n" not in told.message


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
    (told,) = tellings([SpecialView(kind, BOX, used=True)])
    assert (told.code, told.doubt) == (code, True)
    assert "(10, 20)-(110, 221) px" in told.message


def test_one_message_names_all_of_a_kind() -> None:
    views = [SpecialView(SpecialKind.DETAIL, (k, 0.0, k + 5.0, 5.0)) for k in range(7)]
    views.append(SpecialView(SpecialKind.PICTORIAL, BOX))
    told = tellings(views)
    assert [t.code for t in told] == ["pictorial-left-out", "detail-left-out"]
    assert len(re.findall(r"\(\d+, \d+\)-\(\d+, \d+\)", told[1].message)) == 5
