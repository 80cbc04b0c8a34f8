"""Letters to lines of writing."""

from gaussiancad_core.sheet.labels.writing_lines import written_lines
from gaussiancad_core.sheet.reading_options import Box


def word(x: float, y: float, count: int, height: float = 16.0) -> list[Box]:
    """Letters in a level row."""
    step = 0.8 * height
    return [(x + k * step, y, x + k * step + 0.6 * height, y + height) for k in range(count)]


def around(boxes: list[Box]) -> Box:
    x0, y0, x1, y1 = zip(*boxes, strict=True)
    return min(x0), min(y0), max(x1), max(y1)


def up(boxes: list[Box]) -> list[Box]:
    """The same, written up the sheet."""
    return [(y0, -x1, y1, -x0) for x0, y0, x1, y1 in boxes]


def test_letters_of_a_row_are_one_line_and_rows_are_not() -> None:
    rows = word(10.0, 10.0, 6), word(10.0, 36.0, 4)
    assert sorted(written_lines([*rows[0], *rows[1]])) == sorted(map(around, rows))


def test_a_hanging_letter_and_a_point_belong_to_their_line() -> None:
    letters = word(10.0, 10.0, 4)
    letters[1] = (*letters[1][:3], 31.0)
    letters.append((letters[-1][2] + 4.0, 23.0, letters[-1][2] + 7.0, 26.0))
    assert written_lines(letters) == [around(letters)]


def test_what_is_as_small_and_stands_high_is_no_point() -> None:
    letters = word(10.0, 10.0, 4)
    high = (letters[-1][2] + 4.0, 8.0, letters[-1][2] + 7.0, 11.0)
    assert around(letters) in written_lines([*letters, high])


def test_writing_up_the_sheet() -> None:
    level, turned = word(10.0, 10.0, 3), up(word(10.0, 200.0, 5))
    found = written_lines(level + turned)
    assert sorted(found) == sorted([around(level), around(turned)])


def test_a_wide_gap_parts_two_texts() -> None:
    pair = word(10.0, 10.0, 3), word(120.0, 10.0, 3)
    assert len(written_lines([*pair[0], *pair[1]])) == 2


def test_no_letters_no_lines() -> None:
    assert written_lines([]) == []
