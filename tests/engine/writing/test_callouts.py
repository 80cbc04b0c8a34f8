"""What notes at features say."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.writing.callouts import Callout, NoteKind, parse_callout
from gaussiancad_core.writing.note_texts import notes_of
from gaussiancad_core.writing.numbers import Unit
from gaussiancad_core.writing.sheet_texts import SheetText

DIAMETER, THREAD, RADIUS = NoteKind.DIAMETER, NoteKind.THREAD, NoteKind.RADIUS
BORE, SINK, CHAMFER = NoteKind.COUNTERBORE, NoteKind.COUNTERSINK, NoteKind.CHAMFER
MM = Unit.MILLIMETRE


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("\u00d84,00 THRU", [Callout(DIAMETER, 4.0, through=True)]),
        ("\u00d85.0THRU", [Callout(DIAMETER, 5.0, through=True)]),
        ("4 x 5.50 \u8d2f\u7a7f", [Callout(DIAMETER, 5.5, 4, through=True)]),
        ("\u23008 DURCHGEHEND", [Callout(DIAMETER, 8.0, through=True)]),
        ("6x \u00d83.4 \u21a7 10", [Callout(DIAMETER, 3.4, 6, depth=10.0)]),
        ("\u00d86 8 DEEP", [Callout(DIAMETER, 6.0, depth=8.0)]),
        ("2X R3.5", [Callout(RADIUS, 3.5, 2)]),
        ("\u2334 \u00d87,00", [Callout(BORE, 7.0)]),
        (
            "4x \u00d85.5 THRU \u2334 \u00d810 \u21a7 5.7",
            [Callout(DIAMETER, 5.5, 4, through=True), Callout(BORE, 10.0, 4, depth=5.7)],
        ),
        ("CBORE 10", [Callout(BORE, 10.0)]),
        ("\u2335 \u00d88 X 90\u00b0", [Callout(SINK, 8.0, angle=90.0)]),
        ("M6x1 - 6H", [Callout(THREAD, 6.0, unit=MM)]),
        ("M5x20", [Callout(THREAD, 5.0, unit=MM)]),
        ("4X M3 THRU", [Callout(THREAD, 3.0, 4, through=True, unit=MM)]),
        ("4\u00d7M3\u6df18", [Callout(THREAD, 3.0, 4, depth=8.0, unit=MM)]),
        ("4-40 UNC", [Callout(THREAD, 0.112, unit=Unit.INCH)]),
        ("1/4-20 UNC", [Callout(THREAD, 0.25, unit=Unit.INCH)]),
        ("1,00 X 45\u00b0", [Callout(CHAMFER, 1.0, angle=45.0)]),
        ("C0.5", [Callout(CHAMFER, 0.5, angle=45.0)]),
        ("120\u00b0", [Callout(NoteKind.ANGLE, 120.0)]),
        ("t=3", [Callout(NoteKind.THICKNESS, 3.0)]),
        ("ALL PARTS 3 mm THICK", [Callout(NoteKind.THICKNESS, 3.0, unit=MM)]),
        ("(s 3)", [Callout(NoteKind.THICKNESS, 3.0, reference=True)]),
        (
            "ALL FILLETS R3, PLATE 5 THK",
            [Callout(NoteKind.THICKNESS, 5.0), Callout(NoteKind.ALL_FILLETS, 3.0)],
        ),
        (
            "UNLESS NOTED R2, THICKNESS 5",
            [Callout(NoteKind.THICKNESS, 5.0), Callout(NoteKind.ALL_FILLETS, 2.0)],
        ),
        (
            "M6 THRU 5 THK PLATE",
            [Callout(NoteKind.THICKNESS, 5.0), Callout(THREAD, 6.0, through=True, unit=MM)],
        ),
        (
            "4x \u00d85, t=3, s=4",
            [
                Callout(NoteKind.THICKNESS, 3.0),
                Callout(NoteKind.THICKNESS, 4.0),
                Callout(DIAMETER, 5.0, 4),
            ],
        ),
        ("\u21a7 12", [Callout(NoteKind.DEPTH, 12.0)]),
        ("(\u00d8 38)", [Callout(DIAMETER, 38.0, reference=True)]),
        ("5.05 x6", [Callout(NoteKind.LENGTH, 5.05, 6)]),
        (
            "\u672a\u6807\u5012\u89d2\u5747\u4e3aC0.5\uff0c\u5706\u89d2R1",
            [Callout(NoteKind.ALL_CHAMFERS, 0.5), Callout(NoteKind.ALL_FILLETS, 1.0)],
        ),
        ("ALL FILLETS R2 UNLESS SPECIFIED", [Callout(NoteKind.ALL_FILLETS, 2.0)]),
    ],
)
def test_what_a_note_says(text: str, expected: list[Callout]) -> None:
    assert list(parse_callout(text)) == expected


@pytest.mark.parametrize(
    "text", ["", "A-A", "1:1", "THRU", "Material: POM", "30.11.2018", "Arbitrary", "\u2334", "#-1"]
)
def test_other_texts_say_nothing_of_a_feature(text: str) -> None:
    assert parse_callout(text) == ()


@pytest.mark.parametrize("text", ["R{}", "\u00d85 {} DEEP", "M{}", "C{}", "ALL R{}", "{} THK"])
def test_endless_numbers_are_none(text: str) -> None:
    assert all(item.value == 5.0 for item in parse_callout(text.format("9" * 400)))


@given(st.text(max_size=60))
def test_no_text_is_too_much(text: str) -> None:
    for item in parse_callout(text):
        assert item.count >= 0 and isinstance(item.kind, NoteKind)


def test_notes_are_in_mm_and_those_of_the_title_block_tell_a_thickness_alone() -> None:
    texts = [
        SheetText("\u00d8.5 THRU", (10.0, 10.0, 40.0, 20.0)),
        SheetText("M6", (10.0, 40.0, 40.0, 50.0)),
        SheetText("90\u00b0", (10.0, 60.0, 40.0, 70.0)),
        SheetText("12", (10.0, 70.0, 40.0, 80.0)),
        SheetText("R5", (10.0, 90.0, 40.0, 99.0), field=True),
        SheetText("THK .25", (10.0, 110.0, 40.0, 119.0), field=True),
        SheetText("3 mm thick", (10.0, 130.0, 40.0, 139.0)),
    ]
    found = notes_of(texts, Unit.INCH)
    assert [item.value_mm for item in found] == [pytest.approx(12.7), 6.0, 90.0, 6.35, 3.0]


def test_a_zero_may_be_left_out_where_the_file_says_its_unit() -> None:
    texts = [
        SheetText("\u00d8.5 THRU", (10.0, 10.0, 40.0, 20.0)),
        SheetText("THK .25", (10.0, 110.0, 40.0, 119.0)),
    ]
    found = notes_of(texts, MM, bare_point_is_inch=False)
    assert [item.value_mm for item in found] == [0.5, 0.25]
