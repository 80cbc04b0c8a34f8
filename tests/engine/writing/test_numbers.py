"""What the texts of a drawing say in numbers."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.writing.numbers import (
    DimensionText,
    Sign,
    Unit,
    parse_dimension,
    parse_scale,
    parse_unit,
)

LENGTH, DIAMETER, RADIUS = Sign.LENGTH, Sign.DIAMETER, Sign.RADIUS
MM, INCH = Unit.MILLIMETRE, Unit.INCH


@pytest.mark.parametrize(
    ("text", "value", "sign", "unit"),
    [
        (text, float(value), *said)
        for said, rows in {
            (LENGTH, None): (
                "12 = 12|12.5 = 12.5|12,5 = 12.5|0.75 = 0.75| 100  = 100|20\u00b10.1 = 20|"
                "20 \u00b1 0,05 = 20|20 +0.2 -0.1 = 20|20 +0.2/-0.1 = 20|20 +0.2 0 = 20|20H7 = 20|"
                "20 js6 = 20|(45) = 45|25 TYP = 25|2.00 [50.8] = 2"
            ),
            (DIAMETER, None): (
                "\u00d816 = 16|\u230016 = 16|\u03a6 16,5 = 16.5|\u00f814 = 14|076 = 76|"
                "2x O12.5 = 12.5|S\u00d820 = 20|2x \u00d810 = 10|4\u00d7\u00d810 = 10|"
                "4-\u00d810 = 10|\u00d820 H7/g6 = 20|\u00d810 THRU = 10"
            ),
            (DIAMETER, INCH): ".750 DIA = 0.75",
            (RADIUS, None): "R8 = 8|R 2.5 = 2.5|SR20 = 20|4X R12 = 12",
            (LENGTH, MM): "25 mm = 25|25 \u043c\u043c = 25",
            (LENGTH, INCH): (
                '1 1/2" = 1.5|1-1/2" = 1.5|3/8" = 0.375|3/8 = 0.375|1\u00bd\u2033 = 1.5|.500 = 0.5|'
                '2.250" = 2.25|2 in = 2|3 inch = 3'
            ),
            (RADIUS, INCH): "R.125 = 0.125",
        }.items()
        for text, value in (row.split(" = ") for row in rows.split("|"))
    ],
)
def test_dimensions(text: str, value: float, sign: Sign, unit: Unit | None) -> None:
    assert parse_dimension(text) == DimensionText(value, sign, unit)


def test_a_bare_point_tells_inches_where_nothing_else_does() -> None:
    assert parse_dimension(".5", bare_point_is_inch=False) == DimensionText(0.5)
    assert parse_dimension('.5"', bare_point_is_inch=False) == DimensionText(0.5, unit=INCH)


_NO_DIMENSIONS = (
    "|A|PART|M8|M8x1.25|45\u00b0|30\u00b015'|1:2|1/1|5/3|3/7|0|R|\u00d8|C2|2x45\u00b0|Ra 3.2|"
    "S235JR|ISO 2768-m|12.5.2026|A-A|+0.1"
)


@pytest.mark.parametrize(
    "text", [*_NO_DIMENSIONS.split("|"), "9" * 400, "1/" + "9" * 5000, "1" + "0" * 400 + "/2"]
)
def test_other_texts_are_no_dimensions(text: str) -> None:
    assert parse_dimension(text) is None


@given(st.integers(1, 999_999), st.sampled_from([".", ","]), st.sampled_from(["", "R", "\u00d8"]))
def test_every_decimal_is_read(hundredths: int, point: str, sign: str) -> None:
    text = sign + f"{hundredths / 100:.2f}".replace(".", point)
    assert parse_dimension(text).value == pytest.approx(hundredths / 100, rel=1e-12)


@given(st.integers(0, 99), st.sampled_from([2, 4, 8, 16, 32, 64]), st.data())
def test_every_fraction_of_an_inch_is_read(whole: int, under: int, data: st.DataObject) -> None:
    over = data.draw(st.integers(1, under - 1))
    text = f'{whole} {over}/{under}"' if whole else f'{over}/{under}"'
    expected = 25.4 * (whole + over / under)
    assert parse_dimension(text).millimetres(MM) == pytest.approx(expected, rel=1e-12)


def test_a_text_says_its_unit_or_has_the_usual_one() -> None:
    assert parse_dimension("2").millimetres(MM) == 2.0
    assert parse_dimension("2").millimetres(INCH) == 50.8
    assert parse_dimension("25 mm").millimetres(INCH) == 25.0


_SCALES = (
    "1:1 = 1.0|1:2 = 0.5|2:1 = 2.0|1 : 5 = 0.2|SCALE 1/2 = 0.5|SCALE: 1:10 = 0.1|"
    "Scale 1:2.5 = 0.4|M 1:5 = 0.2|M1:5 = 0.2|Ma\u00dfstab 1:20 = 0.05|(2:1) = 2.0|"
    "FULL SCALE = 1.0|SCALE: FULL = 1.0|333333 : 1000000 = 0.333333|3 : 4 = 0.75|"
    "SCALE 3:4 = 0.75|1:2,5 = 0.4|2,5:1 = 2.5|1,0 : 2,0 = 0.5|\u5c3a\u5ea6 1:2 = 0.5|"
    "\u5c3a\u5ea6\uff1a\uff11\uff1a\uff12 = 0.5|\u6bd4\u4f8b 2:1 = 2.0|\u7e2e\u5c3a1:5 = 0.2|"
    "\ucc99\ub3c4 1:5 = 0.2|\u041c\u0430\u0441\u0448\u0442\u0430\u0431 1:2,5 = 0.4|"
    "\u041c 1:4 = 0.25|\u041c\u0430\u0441\u0448\u0442. 4:1 = 4.0|"
    "M\u011b\u0159\u00edtko 1:2 = 0.5"
)


@pytest.mark.parametrize(("text", "ratio"), [row.split(" = ") for row in _SCALES.split("|")])
def test_scale_notes(text: str, ratio: str) -> None:
    assert parse_scale(text) == pytest.approx(float(ratio), rel=1e-12)


_NO_SCALES = "1/2|1/1|3:7|0:1|1:0|12|SCALE|NTS|A:B|1:9999|12:30|16:9|27.08 : "


@pytest.mark.parametrize("text", _NO_SCALES.split("|"))
def test_other_texts_are_no_scale_notes(text: str) -> None:
    assert parse_scale(text) is None


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        (text, said)
        for said, texts in {
            MM: "mm|DIMENSIONS IN MM|ALL DIMENSIONS ARE IN MILLIMETERS|UNIT SYSTEM: MMGS",
            INCH: "UNLESS OTHERWISE SPECIFIED DIMENSIONS ARE IN INCHES|INCH|IPS",
            None: "IN|DIMENSIONS IN|INCH [MM]|COMMON",
        }.items()
        for text in texts.split("|")
    ],
)
def test_unit_notes(text: str, unit: Unit | None) -> None:
    assert parse_unit(text) is unit


def test_a_bare_word_is_a_unit_in_a_field_of_the_title_block_alone() -> None:
    assert parse_unit("in", field=True) is INCH and parse_unit("in") is None
    assert parse_unit("part in", field=True) is None
