"""Which unit numbers are in that do not name theirs."""

import pytest

from gaussiancad_core.files.vectors import VectorDrawing
from gaussiancad_core.writing.number_units import Units, noted_unit, other_size
from gaussiancad_core.writing.numbers import Unit
from gaussiancad_core.writing.sheet_texts import SheetText

MM, INCH = Unit.MILLIMETRE, Unit.INCH


@pytest.mark.parametrize(
    ("noted", "in_file", "fitting", "taken", "doubts"),
    [
        (None, None, None, None, 0),
        (None, MM, None, MM, 0),
        (None, None, INCH, INCH, 0),
        (INCH, None, None, INCH, 0),
        # A note goes before what the numbers would fit on paper, not before what the file states.
        (INCH, None, MM, INCH, 0),
        (INCH, MM, None, INCH, 0),
        (INCH, MM, MM, MM, 1),
        (MM, INCH, INCH, INCH, 1),
        # Drawn in inches, written in millimetres.
        (MM, INCH, MM, MM, 0),
        (None, INCH, MM, MM, 0),
    ],
)
def test_what_is_drawn_and_written_goes_before_a_note(
    noted: Unit | None, in_file: Unit | None, fitting: Unit | None, taken: Unit | None, doubts: int
) -> None:
    units = Units(None, noted, in_file, fitting)
    assert units.taken is taken
    assert [contradiction.code for contradiction in units.contradictions] == doubts * [
        "unit-contradicts-note"
    ]


def test_what_the_user_says_goes_before_all() -> None:
    units = Units(INCH, MM, MM, MM)
    assert units.taken is INCH
    assert [contradiction.code for contradiction in units.contradictions] == [
        "unit-contradicts-note"
    ]


@pytest.mark.parametrize(
    ("unit_mm", "share", "stated"),
    [(1.0, 1.0, 0), (1.0, 1.02, 0), (1.0, 2.0, 1), (25.4, 1 / 25.4, 1), (None, 2.0, 0)],
)
def test_dimensions_of_another_size_than_the_files_are_told(
    unit_mm: float | None, share: float, stated: int
) -> None:
    found = other_size(VectorDrawing((), (), unit_mm=unit_mm), 0.127 * share, 0.127)
    assert [item.code for item in found] == stated * ["size-contradicts-unit"]
    assert all(item.message.args["share"] == pytest.approx(share) for item in found)


def test_two_notes_that_differ_tell_nothing() -> None:
    inches, millimetres = (
        SheetText(text, (0.0, 0.0, 1.0, 1.0)) for text in ("DIMENSIONS IN INCHES", "ALL IN MM")
    )
    assert noted_unit([inches]) is INCH
    assert noted_unit([inches, inches]) is INCH
    assert noted_unit([inches, millimetres]) is None
