"""Open outlines, and what closes them."""

from hypothesis import given
from hypothesis import strategies as st

from freecad.gaussiancad.canvas.gaps import closing_lines, open_ends
from freecad.gaussiancad.canvas.sheet import Sheet, Stroke, View

_VIEW = View("front", "front", (0.0, 0.0, 200.0, 100.0))
_CORNERS = [(0.0, 0.0), (200.0, 0.0), (200.0, 100.0), (0.0, 100.0)]


def _sheet(lines: list) -> Sheet:
    strokes = [Stroke(f"s{n}", "front", "visible", ("line", line)) for n, line in enumerate(lines)]
    return Sheet(tuple(strokes), (_VIEW,), (), "", None)


def _outline() -> list:
    return list(zip(_CORNERS, [*_CORNERS[1:], _CORNERS[0]], strict=True))


def test_a_closed_outline_has_no_open_ends() -> None:
    inner = ((50.0, 0.0), (50.0, 100.0))
    assert open_ends(_sheet([*_outline(), inner]), _VIEW) == []
    assert closing_lines(_sheet(_outline()), _VIEW) == []


@given(st.floats(10.0, 180.0), st.floats(8.0, 90.0), st.integers(0, 3))
def test_a_gap_in_an_outline_is_closed_by_one_line(at: float, wide: float, side: int) -> None:
    (x0, y0), (x1, y1) = _outline()[side]
    length = abs(x1 - x0) + abs(y1 - y0)
    low = min(at / 200.0 * length, length - 10.0)
    high = min(low + wide, length - 5.0)
    ends = [(x0 + (x1 - x0) * t / length, y0 + (y1 - y0) * t / length) for t in (low, high)]
    lines = _outline()
    lines[side : side + 1] = [((x0, y0), ends[0]), (ends[1], (x1, y1))]
    sheet = _sheet(lines)
    if high - low <= 4.0 or low <= 4.0:
        return
    assert sorted(open_ends(sheet, _VIEW)) == sorted(ends)
    (line,) = closing_lines(sheet, _VIEW)
    assert sorted(line) == sorted(ends)


def test_ends_that_are_far_apart_stay_open() -> None:
    sheet = _sheet([((0.0, 0.0), (20.0, 0.0)), ((180.0, 100.0), (200.0, 100.0))])
    assert len(open_ends(sheet, _VIEW)) == 4
    assert closing_lines(sheet, _VIEW) == []
