"""Letters to lines of writing."""

import pytest

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


LEVEL, LOWER, FAR = word(10.0, 10.0, 4), word(10.0, 36.0, 4), word(120.0, 10.0, 3)
HANGING = [LEVEL[0], (*LEVEL[1][:3], 31.0), *LEVEL[2:]]
LAST = LEVEL[-1][2]
FULL_STOP, RAISED = (LAST + 4.0, 23.0, LAST + 7.0, 26.0), (LAST + 4.0, 8.0, LAST + 7.0, 11.0)


@pytest.mark.parametrize(
    "lines",
    [[LEVEL, LOWER], [[*HANGING, FULL_STOP]], [LEVEL, up(word(10.0, 200.0, 5))], [LEVEL, FAR], []],
    ids=["two rows", "a hanging letter and a point", "up the sheet", "a wide gap", "nothing"],
)
def test_letters_are_lines_of_writing(lines: list[list[Box]]) -> None:
    letters = [box for line in lines for box in line]
    assert sorted(written_lines(letters)) == sorted(map(around, lines))


def test_what_is_as_small_and_stands_high_is_no_point() -> None:
    assert around(LEVEL) in written_lines([*LEVEL, RAISED])
