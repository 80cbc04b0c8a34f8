"""Numbers of the sheet that are others in the body: what is written at them, and in the list."""

from freecad.gaussiancad.canvas.changes import CHANGED, Change, change_lines, new_texts
from freecad.gaussiancad.canvas.labels import labels_of
from freecad.gaussiancad.canvas.sheet import Number, Sheet

_WIDTH = Number("d1", "80", 80.0, (10.0, 10.0, 30.0, 20.0))
_BORE = Number("d2", "\u230020", 20.0, (50.0, 10.0, 70.0, 20.0))
_STEPS = (
    Number("d3", "12", 12.0, (10.0, 50.0, 30.0, 60.0)),
    Number("d4", "12", 12.0, (50.0, 50.0, 70.0, 60.0)),
)
_SHEET = Sheet((), (), (), "", None, numbers=(_WIDTH, _BORE, *_STEPS))


def test_the_new_value_stands_beside_the_old_one() -> None:
    texts = new_texts(_SHEET, [Change("Pad1.Width", 80.0, 95.5), Change("H", 20.002, 18.0)])
    assert texts == {"d1": "80 \u2192 95.5", "d2": "\u230020 \u2192 18"}


def test_of_numbers_that_are_alike_nobody_knows_which() -> None:
    texts = new_texts(_SHEET, [Change("Pad1.DistanceY", 12.0, 15.0)])
    assert texts == {"d3": "12 \u2192 15?", "d4": "12 \u2192 15?"}


def test_a_number_that_does_not_count_is_no_candidate() -> None:
    other = Number("d5", "12", 12.0, (0.0, 0.0, 1.0, 1.0), used=False)
    sheet = Sheet((), (), (), "", None, numbers=(_STEPS[0], other))
    assert new_texts(sheet, [Change("n", 12.0, 15.0)]) == {"d3": "12 \u2192 15"}


def test_a_sheet_in_inches_has_inches() -> None:
    sheet = Sheet((), (), (), "", None, numbers=(Number("d1", "2", 50.8, (0, 0, 1, 1)),), unit="in")
    assert new_texts(sheet, [Change("n", 50.8, 63.5)]) == {"d1": "2 \u2192 2.5"}


def test_labels_of_changed_numbers_are_loud_and_of_another_colour() -> None:
    labels = labels_of(_SHEET, [Change("Pad1.Width", 80.0, 95.5)])
    assert [(each.colour == CHANGED, each.quiet) for each in labels] == [
        (True, False),
        *[(False, True)] * 3,
    ]
    assert all(each.colour != CHANGED for each in labels_of(_SHEET))


def test_the_list_has_the_way_back_and_each_number_with_its_place() -> None:
    called: list[bool] = []
    changes = [Change("Pad1.Width", 80.0, 95.5), Change("Pad1.Length", 50.0, 55.0)]
    head, *rows = change_lines(_SHEET, changes, lambda: called.append(True))
    ((text, back),) = head.buttons
    assert text == "Back to the Sheet's Numbers"
    back()
    assert called == [True]
    assert [row.box for row in rows] == [_WIDTH.box, None]
    assert rows[0].text == "Pad1.Width: 80 mm on the sheet, 95.5 mm in the body"
    assert change_lines(_SHEET, [], lambda: None) == []
