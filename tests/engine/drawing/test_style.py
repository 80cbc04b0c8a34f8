from dataclasses import fields

import pytest

from gaussiancad_core.drawing.style import PRESETS, Cap, SheetStyle, checked_style, parse_style
from gaussiancad_core.errors import UsageError


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_is_found_by_its_name(name: str) -> None:
    assert parse_style(name) == PRESETS[name]


def test_the_defaults_are_a_full_hd_sheet_with_lines_of_three_and_two_pixels() -> None:
    style = parse_style("clean")
    assert (style.width, style.height) == (1920, 1080)
    assert (style.visible_width, style.hidden_width) == (3.0, 2.0)
    assert style == SheetStyle()


def test_values_override_a_preset() -> None:
    style = parse_style(
        "thin, dash=9,gap=4.5,ink=#102030,mm-per-pixel=0.25,antialiasing=off,cap=butt,width=800"
    )
    thin = PRESETS["thin"]
    assert (style.visible_width, style.hidden_width) == (thin.visible_width, thin.hidden_width)
    assert (style.dash, style.gap, style.ink) == (9.0, 4.5, (16, 32, 48))
    assert (style.mm_per_pixel, style.antialiasing, style.cap) == (0.25, False, Cap.BUTT)
    assert style.width == 800


def test_values_alone_change_the_clean_style() -> None:
    assert parse_style("noise=2") == SheetStyle(noise=2.0)
    assert parse_style("mm-per-pixel=0.5,mm-per-pixel=fit") == SheetStyle()


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("fancy", "style-unknown"),
        ("", "style-unknown"),
        ("dash=9,thin", "style-unknown"),
        ("colour=#000000", "style-key-unknown"),
        ("dash=wide", "style-value-bad"),
        ("ink=black", "style-value-bad"),
        ("antialiasing=maybe", "style-value-bad"),
        ("cap=square", "style-value-bad"),
        ("width=1920.5", "style-value-bad"),
        ("width=10", "style-value-bad"),
        ("dash=nan", "style-value-bad"),
        ("mm-per-pixel=0", "style-value-bad"),
        ("mm-per-pixel=inf", "style-value-bad"),
        ("jpeg-quality=0", "style-value-bad"),
    ],
)
def test_mistakes_are_told(text: str, code: str) -> None:
    with pytest.raises(UsageError) as caught:
        parse_style(text)
    assert caught.value.code == code


def test_every_number_has_limits() -> None:
    for field in fields(SheetStyle):
        if isinstance(field.default, (int, float)) and not isinstance(field.default, bool):
            with pytest.raises(UsageError):
                checked_style(SheetStyle(**{field.name: -1e9}))
