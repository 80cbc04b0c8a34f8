import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.drawing.annotation import Label
from gaussiancad_core.drawing.lettering import DIAMETER, ink_label, label, text_width

SHAPE = (160, 240)
CENTRE = (120.0, 80.0)


def _inked(written: Label) -> np.ndarray:
    ink = np.zeros(SHAPE, dtype=np.float32)
    ink_label(ink, written)
    return ink


def _extent(ink: np.ndarray, axis: int) -> tuple[float, float]:
    """The borders of what is at least half covered, in px."""
    there = np.flatnonzero(ink.max(axis=1 - axis) >= 0.5)
    return float(there[0]), float(there[-1] + 1)


@given(st.floats(14.0, 60.0))
@settings(max_examples=20, deadline=None)
def test_capitals_are_as_high_as_asked_and_stand_where_asked(height: float) -> None:
    low, high = _extent(_inked(label("HE", CENTRE, height)), 0)
    assert high - low == pytest.approx(height, abs=1.5)
    assert (low + high) / 2.0 == pytest.approx(CENTRE[1], abs=1.0)


@pytest.mark.parametrize("text", ["1080", "R12", f"4x {DIAMETER}10", "H", DIAMETER])
def test_the_ink_is_as_wide_as_the_label_says(text: str) -> None:
    written = label(text, CENTRE, 24.0)
    low, high = _extent(_inked(written), 1)
    # Letters have a little room at both sides.
    assert 0.0 <= written.width - (high - low) < 9.0
    assert (low + high) / 2.0 == pytest.approx(CENTRE[0], abs=3.0)


def test_widths_add_up() -> None:
    assert text_width("12", 20.0) == pytest.approx(2.0 * text_width("12", 10.0))
    assert text_width(f"{DIAMETER}8", 10.0) > text_width("8", 10.0) + 5.0
    assert text_width("", 10.0) == 0.0


def test_turned_text_is_the_text_turned() -> None:
    level = _inked(label("L17", CENTRE, 30.0))
    upright = _inked(label("L17", CENTRE, 30.0, -np.pi / 2.0))
    assert upright.sum() == pytest.approx(level.sum(), rel=2e-3)
    # Counter-clockwise to the eye, about the label's centre.
    reach = 60
    x, y = (int(value) for value in CENTRE)
    window = level[y - reach : y + reach, x - reach : x + reach]
    other = upright[y - reach : y + reach, x - reach : x + reach]
    assert np.abs(np.rot90(window) - other).max() < 0.05


def test_text_beyond_the_sheet_is_cut_off() -> None:
    whole = _inked(label("HHHH", CENTRE, 30.0))
    half = _inked(label("HHHH", (0.0, CENTRE[1]), 30.0))
    np.testing.assert_allclose(half[:, :100], whole[:, 120:220], atol=1e-6)
    assert _inked(label("H", (-500.0, 900.0), 30.0)).sum() == 0.0


def test_letters_unite_with_what_is_there() -> None:
    ink = np.full(SHAPE, 0.25, dtype=np.float32)
    ink_label(ink, label("8", CENTRE, 40.0))
    assert ink.min() == 0.25
    assert ink.max() == pytest.approx(1.0)


def test_a_diameter_sign_is_a_circle_with_a_slash() -> None:
    ink = _inked(label(DIAMETER, CENTRE, 60.0))
    low, high = _extent(ink, 0)
    assert high - low == pytest.approx(60.0, abs=5.0)
    turned = ink[::-1, ::-1]
    middle = _extent(ink, 1)
    shift = round(middle[0] - _extent(turned, 1)[0]), round(low - _extent(turned, 0)[0])
    turned = np.roll(turned, shift, axis=(1, 0))
    # The same after half a turn, not mirrored.
    assert (np.abs(ink - turned) > 0.6).sum() < 0.05 * ink.sum()
    assert (np.abs(ink - turned[:, ::-1]) > 0.6).sum() > 0.2 * ink.sum()


def test_characters_that_the_font_lacks_become_question_marks() -> None:
    assert label("梯 B1", CENTRE, 20.0).text == "? B1"
