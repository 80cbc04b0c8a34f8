"""Whether told lengths agree."""

from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.readings.corrected_scales import CLICK_PX, contradicting_lengths
from gaussiancad_core.readings.correction_operations import ScaleOperation
from gaussiancad_core.readings.reading_schema import ReadScale

_ALONG = ((100.0, 500.0), (900.0, 500.0))
_UP = ((100.0, 500.0), (100.0, 100.0))


_UNTOLD = ReadScale(source="default")


def _told(points: tuple, length: float) -> ScaleOperation:
    return ScaleOperation(points=points, length_mm=length)


@given(st.floats(0.01, 10.0), st.floats(-CLICK_PX, CLICK_PX))
def test_lengths_of_one_scale_agree_up_to_a_click(scale: float, miss: float) -> None:
    along = _told(_ALONG, 800.0 * scale)
    up = _told((_UP[0], (100.0, 100.0 + miss)), 400.0 * scale)
    assert contradicting_lengths(_UNTOLD, [along, up]) is None


@given(st.floats(0.2, 5.0).filter(lambda item: abs(item - 1.0) > 0.05))
def test_lengths_of_two_scales_contradict(wrong: float) -> None:
    stated = [_told(_ALONG, 80.0), _told(_UP, 40.0 * wrong)]
    earlier, last = contradicting_lengths(_UNTOLD, stated)
    assert (earlier.length_mm, last.length_mm) == (80.0, 40.0 * wrong)


def test_what_is_told_again_takes_the_place_of_what_was_told() -> None:
    wrong, right = _told(_ALONG, 8.0), _told(_ALONG[::-1], 80.0)
    up = _told(_UP, 40.0)
    assert contradicting_lengths(_UNTOLD, [wrong, up]) is not None
    assert contradicting_lengths(_UNTOLD, [wrong, up, right]) is None
    assert contradicting_lengths(_UNTOLD, [wrong, ScaleOperation(mm_per_px=0.1), up]) is None
    assert contradicting_lengths(_UNTOLD, []) is None


def test_a_length_that_the_reading_was_told_counts() -> None:
    before = ReadScale(source="given", mm_per_px=0.1, length_mm=80.0, points=_ALONG)
    assert contradicting_lengths(before, [_told(_UP, 40.0)]) is None
    assert contradicting_lengths(before, [_told(_UP, 20.0)]) is not None
