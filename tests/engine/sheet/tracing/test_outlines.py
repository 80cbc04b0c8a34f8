"""Outlines that faded somewhere are closed, those with a side missing are not."""

from typing import Any

import pytest

Sketch = Any
"""The class that the fixture gives."""


def _plate(sketch: Sketch, gap: float = 0.0, short: float = 0.0) -> Any:  # noqa: ANN401
    """A rectangle of 300 x 200 px whose upper side lacks some px, or one of its corners."""
    drawn = sketch(500, 360).line((100, 80), (240, 80)).line((240 + gap, 80), (400, 80))
    drawn.line((400, 80), (400, 280 - short)).line((400 - short, 280), (100, 280))
    return drawn.line((100, 280), (100, 80))


@pytest.mark.parametrize(
    ("gap", "short", "inner"),
    [(0, 0, False), (5, 0, False), (9, 0, False), (0, 2, True), (0, 6, True)],
)
def test_a_faded_outline_is_closed(sketch: Sketch, gap: float, short: float, inner: bool) -> None:
    """A line within the view all but closes what is left of it before the corner."""
    drawn = _plate(sketch, gap, short)
    if inner:
        drawn.line((340, 80), (340, 280))
    outline = drawn.view().closed
    area = outline.mask.sum() / outline.supersampling**2
    assert area == pytest.approx(300 * 200, rel=0.01)
    assert outline.box == pytest.approx((100.5, 80.5, 400.5, 280.5), abs=0.6)


def test_an_outline_without_a_side_stays_open(sketch: Sketch) -> None:
    assert _plate(sketch, gap=60.0).view().outline is None


@pytest.mark.parametrize("apart", [4.0, 5.0, 8.0])
def test_an_edge_close_inside_an_outline_leaves_it_where_it_is(
    sketch: Sketch, apart: float
) -> None:
    """As a narrow chamfer around a shaft; closed gaps must not make one wide line of both."""
    drawn = sketch(300, 300).arc((150, 150), 100, width=2.7).arc((150, 150), 100 - apart, width=2.7)
    outline = drawn.view().closed
    assert outline.box == pytest.approx((50.5, 50.5, 250.5, 250.5), abs=0.6)


@pytest.mark.parametrize("gap", [False, True])
def test_a_thin_profile_is_closed_however_little_of_its_box_it_covers(
    sketch: Sketch, gap: bool
) -> None:
    """As a bent sheet of metal seen from its side."""
    drawn = sketch(500, 360).lines((100, 88), (100, 80), (400, 80), (400, 280))
    inner = [(370, 280), (340, 88)] if gap else [(400, 280), (392, 280), (392, 88), (100, 88)]
    outline = drawn.lines(*inner).view().outline
    if gap:
        assert outline is None
    else:
        area = outline.mask.sum() / outline.supersampling**2
        assert area == pytest.approx(300 * 8 + 192 * 8, rel=0.05)
