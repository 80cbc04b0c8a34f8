"""What notes at features say."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.writing.callout_words import is_typical
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
        ("THRU", [Callout(NoteKind.DEPTH, through=True)]),
        ("4 x 5.5 THRU ALL", [Callout(DIAMETER, 5.5, 4, through=True)]),
        ("\u00d86.8 DRILL 20 DEEP", [Callout(DIAMETER, 6.8, depth=20.0)]),
        (
            "M8 \u21a7 14, \u00d86.8 \u21a7 20",
            [Callout(THREAD, 8.0, depth=14.0, unit=MM), Callout(DIAMETER, 6.8, depth=20.0)],
        ),
        (
            "\u00d88 \u21a7 12 \u2334 \u00d814 \u21a7 5",
            [Callout(DIAMETER, 8.0, depth=12.0), Callout(BORE, 14.0, depth=5.0)],
        ),
        (
            "\u00d85.5 THRU, \u00d810 CBORE 5.7 DEEP",
            [Callout(DIAMETER, 5.5, through=True), Callout(BORE, 10.0, depth=5.7)],
        ),
        ("SENKUNG 10 X 90\u00b0", [Callout(SINK, 10.0, angle=90.0)]),
        ("4x \u00d85.5 EQ SP ON \u00d860 B.C. THRU", [Callout(DIAMETER, 5.5, 4, through=True)]),
        ("\u00d88 H7 FROM FAR SIDE \u21a7 12", [Callout(DIAMETER, 8.0, depth=12.0)]),
        ("CBORE 10X5.7 DP", [Callout(BORE, 10.0, depth=5.7)]),
        ("M6 HOLES THRU", [Callout(THREAD, 6.0, through=True, unit=MM)]),
        ("4X M6 TAPPED HOLES, 12 DEEP", [Callout(THREAD, 6.0, 4, depth=12.0, unit=MM)]),
        ("2 HOLES \u00d85 DEPTH 8", [Callout(DIAMETER, 5.0, 2, depth=8.0)]),
        ("M8 x 1 x 14 DEEP", [Callout(THREAD, 8.0, depth=14.0, unit=MM)]),
    ],
)
def test_what_a_note_says(text: str, expected: list[Callout]) -> None:
    assert list(parse_callout(text)) == expected


@pytest.mark.parametrize(
    "word",
    [
        "C'BORE",
        "CBORE",
        "C-BORE",
        "COUNTERBORE",
        "SPOTFACE",
        "SPOT FACE",
        "S.F.",
        "SF",
        "\u2334",
        "Zylindersenkung",
        "Flachsenkung",
        "LAMAGE",
        "lamatura",
        "REFRENTADO",
        "\u0446\u0435\u043a\u043e\u0432\u043a\u0430",
        "\u6c89\u5b54",
    ],
)
@pytest.mark.parametrize("depth", ["X 5.7 DP", "x 5,7", "DEPTH 5.7", "\u21a7 5.7", "- 5.7 tief"])
@pytest.mark.parametrize("sign", ["", "\u2300 "])
def test_every_word_for_a_counterbore_has_its_diameter_and_depth(
    word: str, depth: str, sign: str
) -> None:
    assert parse_callout(f"{word} {sign}10 {depth}") == (Callout(BORE, 10.0, depth=5.7),)


@pytest.mark.parametrize(
    "word",
    [
        "CSK",
        "C'SINK",
        "COUNTERSUNK",
        "Kegelsenkung",
        "FRAISURE",
        "svasatura",
        "AVELLANADO",
        "\u0437\u0435\u043d\u043a\u043e\u0432\u043a\u0430",
        "\u2335",
    ],
)
@pytest.mark.parametrize("order", ["{} \u00d811 x 90\u00b0", "{} 90\u00b0 \u00d811", "{} 11 X 90"])
def test_every_word_for_a_countersink_has_its_diameter_and_angle(word: str, order: str) -> None:
    assert parse_callout(order.format(word)) == (Callout(SINK, 11.0, angle=90.0),)


@pytest.mark.parametrize(
    "depth",
    [
        "12 DP",
        "12 DP.",
        "DP 12",
        "12 DEEP",
        "DEEP 12",
        "DEPTH 12",
        "DEPTH: 12",
        "12 mm DEEP",
        "12 tief",
        "Tiefe 12",
        "prof. 12",
        "PROF 12",
        "profondeur 12",
        "profundidad 12",
        "x 12 DEEP",
        "\u0433\u043b\u0443\u0431. 12",
        "\u0433\u043b\u0443\u0431\u0438\u043d\u043e\u0439 12",
        "\u6df112",
        "\u6df1\u5ea6 12",
        "\u21a7 12",
        "\u21a712",
    ],
)
def test_a_depth_in_every_language(depth: str) -> None:
    assert parse_callout(f"\u00d88 {depth}") == (Callout(DIAMETER, 8.0, depth=12.0),)
    assert parse_callout(depth.removeprefix("x ")) == (Callout(NoteKind.DEPTH, 12.0),)


@pytest.mark.parametrize(
    "word",
    [
        "THRU",
        "THRU ALL",
        "THROUGH",
        "durchgehend",
        "D\u00c9BOUCHANT",
        "traversant",
        "passante",
        "pasante",
        "\u0441\u043a\u0432\u043e\u0437\u043d\u043e\u0435",
        "\u8d2f\u7a7f",
    ],
)
def test_through_in_every_language(word: str) -> None:
    assert parse_callout(f"\u00d88 {word}") == (Callout(DIAMETER, 8.0, through=True),)


@pytest.mark.parametrize(
    "text",
    [
        "6x {}",
        "6 X {}",
        "(6x) {}",
        "6-{}",
        "{} x6",
        "{} 6 PLACES",
        "{} (6 PLCS)",
        "6 HOLES {}",
        "6 Bohrungen {}",
        "6 trous {}",
        "6 fori {}",
        "6 agujeros {}",
        "{} 6\u5904",
        "6 \u043e\u0442\u0432. {}",
        "{} 6 \u043c\u0435\u0441\u0442",
    ],
)
def test_how_often_in_every_language(text: str) -> None:
    assert parse_callout(text.format("\u00d88")) == (Callout(DIAMETER, 8.0, 6),)
    assert parse_callout(text.format("\u00d88 DP 9")) == (Callout(DIAMETER, 8.0, 6, depth=9.0),)


@pytest.mark.parametrize("second", ["THRU ALL", "\u21a7 12", "CBORE 10 X 5.7 DP"])
def test_a_number_that_goes_on_below_is_the_diameter_of_a_hole(second: str) -> None:
    first = SheetText("4 x 5.5", (10.0, 10.0, 60.0, 20.0))
    below = SheetText(second, (10.0, 26.0, 60.0, 36.0))
    assert notes_of([first, below], MM)[0].callout == Callout(DIAMETER, 5.5, 4)
    apart = SheetText(second, (10.0, 86.0, 60.0, 96.0))
    assert all(note.text == second for note in notes_of([first, apart], MM))


def test_a_typical_feature_is_said_to_be_one() -> None:
    assert parse_callout("\u00d88 THRU TYP.") == (Callout(DIAMETER, 8.0, through=True),)
    assert is_typical("\u00d88 TYP") and is_typical("(TYP.)") and not is_typical("TYPE 8")


@pytest.mark.parametrize(
    "text", ["", "A-A", "1:1", "Material: POM", "30.11.2018", "Arbitrary", "\u2334", "#-1"]
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
