"""Titles of sections, and where they are cut."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.structure.arrowheads import Head
from gaussiancad_core.writing.section_titles import named_sections
from gaussiancad_core.writing.sheet_texts import SheetText
from gaussiancad_core.writing.titles import Title, TitleKind, parse_title

_STILL = Turn(0.0, (0.0, 0.0))
_FRONT, _SIDE = (100.0, 100.0, 300.0, 250.0), (500.0, 100.0, 600.0, 250.0)
_VIEWS = ({Role.FRONT: _FRONT, Role.RIGHT: _SIDE}, (), ())
_HEAD = 14.0


@pytest.mark.parametrize(
    ("text", "title"),
    [
        ("A-A", Title(TitleKind.SECTION, "A")),
        ("A\u2013A", Title(TitleKind.SECTION, "A")),
        ("SECTION B-B", Title(TitleKind.SECTION, "B")),
        ("Schnitt C-C (1:2)", Title(TitleKind.SECTION, "C", 0.5)),
        ("A - A SCALE 2:1", Title(TitleKind.SECTION, "A", 2.0)),
        ("VIEW D", Title(TitleKind.VIEW, "D")),
        ("DETAIL E (5:1)", Title(TitleKind.DETAIL, "E", 5.0)),
        ("E (5:1)", Title(TitleKind.DETAIL, "E", 5.0)),
        ("\u0410\u2013\u0410", Title(TitleKind.SECTION, "\u0410")),
        ("\u0411-\u0411 (1:2,5)", Title(TitleKind.SECTION, "\u0411", 0.4)),
        (
            "\u0420\u0430\u0437\u0440\u0435\u0437 \u0412 - \u0412",
            Title(TitleKind.SECTION, "\u0412"),
        ),
        ("\u0416 (4:1)", Title(TitleKind.DETAIL, "\u0416", 4.0)),
        ("\u0393-\u0393 \u041c 2:1", Title(TitleKind.SECTION, "\u0393", 2.0)),
        ("\u03a3-\u03a3", Title(TitleKind.SECTION, "\u03a3")),
        ("A-\u0410", None),
        ("A-B", None),
        ("A", None),
        ("1-1", None),
        ("M6-M6", None),
        ("", None),
    ],
)
def test_titles(text: str, title: Title | None) -> None:
    assert parse_title(text) == title


@given(st.text(max_size=40))
def test_no_text_is_too_much(text: str) -> None:
    assert parse_title(text) is None or parse_title(text).label


def _letter(x: float, y: float, text: str = "A") -> SheetText:
    return SheetText(text, (x - 6.0, y - 8.0, x + 6.0, y + 8.0))


_TITLE = SheetText("A-A", (530.0, 70.0, 570.0, 86.0))


def _arrows(
    x: float, way: float, within: float = 0.0
) -> tuple[list[Head], list[tuple[np.ndarray, np.ndarray]]]:
    """Two arrows beside the front view, above and below it, with shafts from the cutting line to a
    share of their heads."""
    heads, lines = [], []
    for y in (80.0, 270.0):
        heads.append(Head((x + way * 40.0, y), (way, 0.0), _HEAD))
        end = 40.0 - (1.0 - within) * _HEAD
        lines.append((np.array([x, y]), np.array([x + way * end, y])))
    return heads, lines


@pytest.mark.parametrize(("way", "looks"), [(1.0, Role.LEFT), (-1.0, Role.RIGHT)])
@given(x=st.floats(110.0, 290.0), within=st.floats(0.0, 1.0))
def test_two_arrows_with_the_titles_letter_tell_plane_and_direction(
    way: float, looks: Role, x: float, within: float
) -> None:
    """The cut is where the shafts begin, wherever between base and tip of a head they end."""
    heads, lines = _arrows(x, way, within)
    texts = [_TITLE, _letter(x + way * 40.0, 60.0), _letter(x + way * 40.0, 290.0)]
    (found,) = named_sections(texts, heads, lines, _VIEWS, _STILL)
    assert found.box == _SIDE and found.cut_in is Role.FRONT
    assert found.axis is Axis.X and found.looks is looks and found.trace.straight
    assert [end[0] for end in found.trace.ends] == pytest.approx([x, x])


def test_arrows_out_of_line_are_a_cut_in_steps() -> None:
    (up, shaft), (down, other) = (
        (heads[0], lines[0]) if k == 0 else (heads[1], lines[1])
        for k, (heads, lines) in enumerate((_arrows(150.0, 1.0), _arrows(200.0, 1.0)))
    )
    texts = [_TITLE, _letter(190.0, 60.0), _letter(240.0, 290.0)]
    (found,) = named_sections(texts, [up, down], [shaft, other], _VIEWS, _STILL)
    assert not found.trace.straight


def test_without_arrows_or_with_other_letters_the_plane_is_not_known() -> None:
    heads, lines = _arrows(200.0, 1.0)
    for texts in ([_TITLE], [_TITLE, _letter(240.0, 60.0, "B"), _letter(240.0, 290.0, "B")]):
        (found,) = named_sections(texts, heads, lines, _VIEWS, _STILL)
        assert found.trace is None and found.box == _SIDE
    far = SheetText("A-A", (900.0, 900.0, 940.0, 916.0))
    assert named_sections([far], heads, lines, _VIEWS, _STILL) == ()


@pytest.mark.parametrize("line_at", ["tips", "tails"])
@given(y=st.floats(110.0, 240.0), before=st.floats(0.0, 2.0), within=st.floats(0.0, 1.0))
def test_arrows_may_rest_on_the_line_with_their_tips(
    line_at: str, y: float, before: float, within: float
) -> None:
    """A tip ends at the middle of a line, or at its edge."""
    heads, lines = [], []
    for x in (70.0, 330.0):
        heads.append(Head((x, y), (0.0, 1.0), _HEAD))
        lines.append((np.array([x, y - 40.0]), np.array([x, y - (1.0 - within) * _HEAD])))
        at = y + before if line_at == "tips" else y - 40.0
        lines.append((np.array([x - 16.0, at]), np.array([x + 16.0, at])))
    texts = [_TITLE, _letter(50.0, y - 30.0), _letter(350.0, y - 30.0)]
    (found,) = named_sections(texts, heads, lines, _VIEWS, _STILL)
    cut = y + before if line_at == "tips" else y - 40.0
    assert [end[1] for end in found.trace.ends] == pytest.approx([cut, cut])
    assert found.trace.straight and found.trace.way == pytest.approx((0.0, 1.0))


def _lettered(title: str, *letters: str) -> bool:
    """Whether a section has its trace where arrows have such letters, beside other titles."""
    heads, lines = _arrows(200.0, 1.0)
    first, *others = title.split()
    texts = [SheetText(f"{first}-{first}", _TITLE.box)]
    texts += [SheetText(f"{other}-{other}", _TITLE.box) for other in others]
    for letter in letters:
        texts += [_letter(240.0, 60.0, letter), _letter(240.0, 290.0, letter)]
    found = named_sections(texts, heads, lines, _VIEWS, _STILL)
    assert [item.title.label for item in found] == [first, *others]
    return found[0].trace is not None


def test_letters_of_any_script_name_a_section() -> None:
    for letter in ("\u0410", "\u0411", "\u0414", "\u03a9", "B"):
        assert _lettered(letter, letter)
    assert not _lettered("\u0411", "B")


def test_look_alikes_of_another_script_are_a_letter_only_where_nothing_else_is_meant() -> None:
    cyrillic, latin = "\u0412", "B"
    assert _lettered(cyrillic, latin)
    assert not _lettered(f"{cyrillic} {latin}", latin)
    assert _lettered(f"{cyrillic} {latin}", cyrillic)
