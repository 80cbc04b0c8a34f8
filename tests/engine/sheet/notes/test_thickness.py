"""How thick notes say that a plate is."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.sheet.notes.thickness import Thickness, parse_thickness
from gaussiancad_core.sheet.scale.numbers import Unit

MM, INCH = Unit.MILLIMETRE, Unit.INCH


@pytest.mark.parametrize(
    ("text", "value", "unit"),
    [
        ("t=3", 3.0, None),
        ("t 3", 3.0, None),
        ("T3", 3.0, None),
        ("t = 3 mm", 3.0, MM),
        ("t=3\u00b10.1", 3.0, None),
        ("S235JR, t=3", 3.0, None),
        ("s=3", 3.0, None),
        ("s 3", 3.0, None),
        ("S3", 3.0, None),
        ("3 mm thick", 3.0, MM),
        ("3mm THK", 3.0, MM),
        ("3-mm-thick", 3.0, MM),
        ("PLATE 3 THK", 3.0, None),
        ("THK 3", 3.0, None),
        ("THK. 3", 3.0, None),
        ("THK: 0,5 mm", 0.5, MM),
        ('.0625" thick', 0.0625, INCH),
        ('0.0625" THK', 0.0625, INCH),
        ("0.0625\u201d THK", 0.0625, INCH),
        ("1/16 in. thick", 0.0625, INCH),
        ('1 1/2" THICK', 1.5, INCH),
        (".25 inch thick steel", 0.25, INCH),
        ("thickness 3", 3.0, None),
        ("Thickness: 3 mm", 3.0, MM),
        ("MATERIAL: STEEL, THICKNESS = 3", 3.0, None),
        ("Dicke 3", 3.0, None),
        ("Blech 3 mm dick", 3.0, MM),
        ("Blechdicke 1,5", 1.5, None),
        ("St\u00e4rke 3", 3.0, None),
        ("Sta\u0308rke 3", 3.0, None),
        ("Materialst\u00e4rke: 3 mm", 3.0, MM),
        ("\u539a3", 3.0, None),
        ("\u539a 3", 3.0, None),
        ("3\u539a", 3.0, None),
        ("\u677f\u539a3", 3.0, None),
        ("\u677f\u539a\uff1a3 mm", 3.0, MM),
        ("\u539a\u5ea6 3\u6beb\u7c73", 3.0, MM),
        ("\u03b4=3", 3.0, None),
        ("\u0442\u043e\u043b\u0449\u0438\u043d\u0430 3", 3.0, None),
        ("\u0422\u043e\u043b\u0449\u0438\u043d\u0430 3 \u043c\u043c", 3.0, MM),
        ("\u00e9p. 3", 3.0, None),
        ("\u00e9paisseur : 3 mm", 3.0, MM),
        ("EP 3", 3.0, None),
        ("spessore 3", 3.0, None),
        ("espesor 3", 3.0, None),
    ],
)
def test_a_note_tells_how_thick_a_plate_is(text: str, value: float, unit: Unit | None) -> None:
    assert parse_thickness(text) == Thickness(value, unit)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "3",
        "M3",
        "\u00d83",
        "3 mm",
        "t",
        "thick",
        "t=0",
        "1/0 thick",
        "3 deep",
        "at 3",
        "parts 3",
        "SECTION S-S",
        "wall thickness 2",
        "Wandst\u00e4rke 2",
        "\u58c1\u539a2",
        "coating 0.02 mm thick",
        "Schichtdicke 0,02",
        "plating 5 \u00b5m thick",
        "1:3 thick",
        "thickener 3",
        "step 3",
    ],
)
def test_other_notes_tell_none(text: str) -> None:
    assert parse_thickness(text) is None


@given(st.text(max_size=60))
def test_no_text_is_too_much(text: str) -> None:
    found = parse_thickness(text)
    assert found is None or found.value > 0.0
