from dataclasses import fields

import pytest

from gaussiancad_core.drawing.sheet_style import (
    PRESETS,
    Cap,
    SheetStyle,
    checked_style,
    parse_style,
)
from gaussiancad_core.errors import UsageError


def test_values_override_a_preset() -> None:
    style = parse_style(
        "thin, dash=9,gap=4.5,ink=#102030,mm-per-pixel=0.25,antialiasing=off,cap=butt,width=800"
    )
    thin = PRESETS["thin"]
    assert (style.visible_width, style.hidden_width) == (thin.visible_width, thin.hidden_width)
    assert (style.dash, style.gap, style.ink) == (9.0, 4.5, (16, 32, 48))
    assert (style.mm_per_pixel, style.antialiasing, style.cap) == (0.25, False, Cap.BUTT)
    assert style.width == 800


def test_annotations_and_defects_are_off_unless_asked_for() -> None:
    style = SheetStyle()
    assert not (style.annotations or style.frame or style.centre_lines)
    assert (style.bleed, style.fade, style.specks, style.light, style.shadow, style.salt) == (
        0,
    ) * 6
    assert style.contrast == 1.0


def test_ansi_hidden_lines_are_as_thin_as_centre_lines() -> None:
    style = PRESETS["ansi"]
    assert style.hidden_width == style.annotation_width == style.visible_width / 2.0
    assert style.centre_lines


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
        ("annotations=some", "style-value-bad"),
        ("light=1.1", "style-value-bad"),
        ("contrast=0.5", "style-value-bad"),
        ("text-height=0", "style-value-bad"),
        ("text-place=below", "style-value-bad"),
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
