"""How thick notes say that a plate is."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.writing.numbers import Unit
from gaussiancad_core.writing.thickness import Thickness, take_thickness

MM, INCH = Unit.MILLIMETRE, Unit.INCH


@pytest.mark.parametrize(
    ("text", "value", "unit"),
    [
        (text, *said)
        for said, texts in {
            (3.0, None): (
                "t=3|t 3|t=3\u00b10.1|S235JR, t=3|s=3|s 3|s3|T=3|PLATE 3 THK|THK 3|THK. 3|"
                "t=3 in 2 places|thickness 3|MATERIAL: STEEL, THICKNESS = 3|Dicke 3|St\u00e4rke 3|"
                "Sta\u0308rke 3|\u539a3|\u539a 3|3\u539a|\u677f\u539a3|\u03b4=3|"
                "\u0442\u043e\u043b\u0449\u0438\u043d\u0430 3|\u00e9p. 3|EP 3|spessore 3|espesor 3"
            ),
            (3.0, MM): (
                "t = 3 mm|S = 3 mm|3 mm thick|3mm THK|3-mm-thick|Thickness: 3 mm|Blech 3 mm dick|"
                "Materialst\u00e4rke: 3 mm|\u677f\u539a\uff1a3 mm|\u539a\u5ea6 3\u6beb\u7c73|"
                "\u0422\u043e\u043b\u0449\u0438\u043d\u0430 3 \u043c\u043c|\u00e9paisseur : 3 mm"
            ),
            (0.5, MM): "THK: 0,5 mm",
            (
                0.0625,
                INCH,
            ): '.0625" thick|0.0625" THK|0.0625\u201d THK|1/16 in. thick|1/16 in thick',
            (0.25, INCH): "THK .25 in|THK 1/4|THK .25|.25 inch thick steel",
            (2.0, INCH): "thickness 2 in, steel|THICKNESS 2 IN. MAX",
            (1.5, INCH): '1 1/2" THICK',
            (1.5, None): "Blechdicke 1,5",
        }.items()
        for text in texts.split("|")
    ],
)
def test_a_note_tells_how_thick_a_plate_is(text: str, value: float, unit: Unit | None) -> None:
    assert take_thickness(text)[0] == Thickness(value, unit)


@pytest.mark.parametrize(
    ("text", "rest"),
    [
        ("t=3", ""),
        ("t=3\u00b10.1 mm", ""),
        ("ALL FILLETS R3, PLATE 5 THK", "ALL FILLETS R3"),
        ("M6 THRU 5 mm THK PLATE", "M6 THRU"),
        ("BLECH 3 mm dick; C45", "C45"),
        ("R2, t=3\u00b10.1 mm, M6", "R2, M6"),
        ("t=3 in 2 places", "in 2 places"),
        ("t=3, s=4", "s=4"),
    ],
)
def test_what_a_note_says_besides_is_kept(text: str, rest: str) -> None:
    found, besides = take_thickness(text)
    assert found is not None and besides == rest


_NO_THICKNESS = (
    "|3|T3|S3|S235|S355|S=1:2|HARDEN AT T = 850 C|T=850\u00b110\u00b0C|T = 850 +10/-5 C|"
    "T=25\u00b0C|T = 0.5 s|t=3 cm|thickness 5 \u00b5m|M3|\u00d83|3 mm|t|thick|t=0|1/0 thick|"
    "3 deep|at 3|parts 3|SECTION S-S|wall thickness 2|Wandst\u00e4rke 2|\u58c1\u539a2|"
    "coating 0.02 mm thick|Schichtdicke 0,02|plating 5 \u00b5m thick|1:3 thick|thickener 3|"
    "step 3"
)


@pytest.mark.parametrize("text", _NO_THICKNESS.split("|"))
def test_other_notes_tell_none(text: str) -> None:
    assert take_thickness(text) == (None, text)


_FIELDS = dict.fromkeys(("T6", "s3", "t 3", "S235", "t: 3"))
_FIELDS |= dict.fromkeys(("t=3", "S = 3", "THK 3", "Dicke: 3", "3 mm thick", "\u539a3"), 3.0)


@pytest.mark.parametrize(("text", "value"), _FIELDS.items())
def test_a_field_of_the_title_block_needs_more_than_a_letter(text: str, value: float) -> None:
    found, _ = take_thickness(text, field=True)
    assert (found and found.value) == value


@given(st.text(max_size=60), st.booleans())
def test_no_text_is_too_much(text: str, field: bool) -> None:
    found, _ = take_thickness(text, field=field)
    assert found is None or 0.0 < found.value < math.inf
