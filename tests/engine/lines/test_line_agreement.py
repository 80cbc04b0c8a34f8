import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.lines.line_agreement import Agreement, match_lines
from gaussiancad_core.lines.line_points import Lines, lines_of_strokes
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke

_SHEET = (
    Segment((0, 0), (100, 0), Linetype.VISIBLE),
    Arc((50, 50), 20, 0, 6.28, Linetype.VISIBLE),
    Segment((0, 30), (100, 30), Linetype.HIDDEN),
)


def _lines(*strokes: Stroke) -> Lines:
    return lines_of_strokes(strokes, 0.1)


_VISIBLE = Segment((0, 0), (10, 0), Linetype.VISIBLE)
_HIDDEN = Segment((0, 0), (10, 0), Linetype.HIDDEN)


@pytest.mark.parametrize(
    ("sheet", "result", "shares"),
    [
        (_SHEET, _SHEET, (1.0, 1.0, 1.0, 1.0)),
        ((), (), (1.0, 1.0, 1.0, 1.0)),
        (_SHEET, (), (0.0, 1.0, 0.0, 1.0)),
        ((), _SHEET, (1.0, 0.0, 1.0, 0.0)),
        # Visible for hidden is no agreement.
        ((_HIDDEN,), (_VISIBLE,), (1.0, 0.0, 0.0, 1.0)),
        # What is hidden under what is visible is explained, and not asked for.
        ((_VISIBLE,), (_VISIBLE, _HIDDEN), (1.0, 1.0, 1.0, 1.0)),
        ((_VISIBLE, _HIDDEN), (_VISIBLE,), (1.0, 1.0, 1.0, 1.0)),
    ],
)
def test_what_is_missing_lowers_recall_and_what_is_invented_precision(
    sheet: tuple[Stroke, ...], result: tuple[Stroke, ...], shares: tuple[float, ...]
) -> None:
    found = match_lines(sheet, _lines(*result), 1.0).agreement
    assert found == Agreement(*shares)
    assert found.worst == min(shares)


def test_recall_is_a_share_of_length() -> None:
    """A quarter of one line drawn, and the tolerance beyond its end."""
    sheet = [Segment((0, 0), (100, 0), Linetype.VISIBLE)]
    result = _lines(Segment((0, 0.5), (25, 0.5), Linetype.VISIBLE))
    found = match_lines(sheet, result, 1.0).agreement
    assert found.visible_recall == pytest.approx((25 + 0.75**0.5) / 100, abs=2e-3)
    assert found.visible_precision == 1.0


def test_precision_is_a_share_of_length() -> None:
    sheet = [Segment((0, 0), (10, 0), Linetype.HIDDEN)]
    result = _lines(
        Segment((0, 0), (10, 0), Linetype.HIDDEN), Segment((0, 9), (30, 9), Linetype.HIDDEN)
    )
    found = match_lines(sheet, result, 1.0).agreement
    assert (found.hidden_recall, found.hidden_precision) == pytest.approx((1.0, 0.25), abs=1e-9)


@pytest.mark.parametrize(("shift", "share"), [(0.95, 1.0), (1.05, 0.0)])
def test_the_tolerance_is_a_distance(shift: float, share: float) -> None:
    sheet = [Segment((0, 0), (100, 0), Linetype.VISIBLE)]
    result = _lines(Segment((0, shift), (100, shift), Linetype.VISIBLE))
    found = match_lines(sheet, result, 1.0).agreement
    assert (found.visible_recall, found.visible_precision) == (share, share)


_NUMBER = st.floats(-50, 50)
_STROKE = st.builds(
    Segment, st.tuples(_NUMBER, _NUMBER), st.tuples(_NUMBER, _NUMBER), st.sampled_from(Linetype)
) | st.builds(
    Arc,
    st.tuples(_NUMBER, _NUMBER),
    st.floats(0.1, 40),
    st.floats(0, 6),
    st.floats(0.1, 6.28),
    st.sampled_from(Linetype),
)


@settings(max_examples=40, deadline=None)
@given(st.lists(_STROKE, max_size=6), st.lists(_STROKE, max_size=6))
def test_more_result_never_lowers_recall(sheet: list[Stroke], more: list[Stroke]) -> None:
    agreement = match_lines(sheet, _lines(*sheet), 1.0).agreement
    both = match_lines(sheet, _lines(*sheet, *more), 1.0).agreement
    assert agreement == Agreement(1.0, 1.0, 1.0, 1.0)
    assert (both.visible_recall, both.hidden_recall) == (1.0, 1.0)
    assert 0.0 <= both.worst <= 1.0
