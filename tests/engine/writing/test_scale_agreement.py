"""One scale from many dimensions, some of them wrong."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.writing.dimension_texts import Span
from gaussiancad_core.writing.numbers import Unit, parse_dimension
from gaussiancad_core.writing.scale_agreement import (
    Candidate,
    Dimension,
    Measure,
    ReadDimension,
    agree,
    fitting_unit,
    usual_unit,
)

MM, INCH = Unit.MILLIMETRE, Unit.INCH
SCALE = 0.2


def dimension(text: str, *pixels: float | tuple[float, float]) -> Dimension:
    """A dimension of candidate lengths, each perhaps with a weight."""
    lengths = [
        Candidate(*pixel) if isinstance(pixel, tuple) else Candidate(pixel) for pixel in pixels
    ]
    return Dimension(text, parse_dimension(text), (0.0, 0.0, 9.0, 9.0), tuple(lengths))


def true(value: float, error: float = 0.0) -> Dimension:
    """A dimension that is drawn to scale, but for some px."""
    return dimension(f"{value:g}", value / SCALE + error)


def test_a_misread_digit_does_not_win_and_is_told() -> None:
    # 88 for 80, 5 for 50, 125 for 12.5.
    wrong = [dimension("88", 80 / SCALE), dimension("5", 50 / SCALE), dimension("125", 62.5)]
    found = agree([*wrong, true(30), true(44), true(20)], MM, None)
    assert found.mm_per_pixel == pytest.approx(SCALE, rel=1e-12)
    assert [dimension.used for dimension in found.dimensions] == 3 * [False] + 3 * [True]
    assert [item.text for item in found.disagreeing] == ["88", "5", "125"]
    assert found.disagreeing[0] == ReadDimension(
        "88", 88.0, (0.0, 0.0, 9.0, 9.0), pytest.approx(0.22), False
    )


def test_long_dimensions_count_more() -> None:
    found = agree([true(10, 0.5), true(100), true(120)], MM, None)
    assert found.mm_per_pixel == pytest.approx(SCALE, rel=1e-4)


def test_dimensions_without_a_line_are_kept_and_not_used() -> None:
    found = agree([true(10), true(30), dimension("7")], MM, None)
    assert found.dimensions[2] == ReadDimension("7", 7.0, (0.0, 0.0, 9.0, 9.0), None, False)
    assert found.disagreeing == ()


def test_one_dimension_alone_is_believed_only_with_the_paper() -> None:
    assert agree([true(10)], MM, None).mm_per_pixel is None
    assert agree([true(40)], MM, SCALE * 1.02).mm_per_pixel == pytest.approx(SCALE, rel=1e-12)
    assert agree([true(40)], MM, SCALE * 1.2).mm_per_pixel is None


def test_two_pairs_that_contradict_each_other_tell_nothing() -> None:
    others = [dimension("30", 30 / 0.3), dimension("50", 50 / 0.3)]
    assert agree([true(20), true(60), *others], MM, None).mm_per_pixel is None
    # Unless the paper takes sides.
    found = agree([true(20), true(60), *others], MM, 1.01 * SCALE)
    assert found.mm_per_pixel == pytest.approx(SCALE, rel=1e-12)


def test_two_of_many_may_agree_by_chance() -> None:
    others = [dimension("50", 50 / (0.3 + 0.05 * k)) for k in range(6)]
    assert agree([true(20), true(60), *others], MM, None).mm_per_pixel is None
    assert agree([true(20), true(60), *others[:2]], MM, None).mm_per_pixel is not None


def test_the_second_candidate_serves_where_the_first_disagrees() -> None:
    odd = dimension("40", 333.0, (40 / SCALE, 0.5))
    found = agree([true(20), true(60), odd], MM, None)
    assert found.dimensions[2].used
    assert found.dimensions[2].mm_per_pixel == pytest.approx(SCALE)


def test_inches_become_millimetres() -> None:
    texts = [("1 1/2", 1.5), (".500", 0.5), ("3.25", 3.25)]
    dimensions = [dimension(text, 25.4 * value / SCALE) for text, value in texts]
    unit = usual_unit(dimensions)
    assert unit is INCH
    found = agree(dimensions, unit, None)
    assert found.mm_per_pixel == pytest.approx(SCALE, rel=1e-12)
    assert found.dimensions[2].value_mm == pytest.approx(82.55)


def test_the_unit_follows_what_is_drawn_and_what_most_texts_name() -> None:
    plain = [true(2), true(5)]
    assert usual_unit(plain) is MM
    assert usual_unit([*plain, dimension('3"')]) is MM
    assert fitting_unit(plain, None) is None
    assert fitting_unit(plain, SCALE) is MM
    assert fitting_unit(plain, 25.4 * SCALE) is INCH
    assert fitting_unit(plain, 7.0 * SCALE) is None


@given(
    st.lists(st.integers(15, 400), min_size=4, max_size=9, unique=True),
    st.integers(1, 9),
    st.floats(-0.4, 0.4),
    st.data(),
)
def test_one_wrong_digit_never_wins(
    values: list[int], digit: int, error: float, data: st.DataObject
) -> None:
    k = data.draw(st.integers(0, len(values) - 1))
    digits = str(values[k])
    place = data.draw(st.integers(0, len(digits) - 1))
    misread = int(digits[:place] + str(digit) + digits[place + 1 :])
    dimensions = [true(value, error) for value in values]
    dimensions[k] = dimension(str(misread), values[k] / SCALE + error)
    found = agree(dimensions, MM, None)
    assert found.mm_per_pixel == pytest.approx(SCALE, rel=0.007)
    assert sum(dimension.used for dimension in found.dimensions) >= len(values) - 1


def test_what_dimensions_that_agree_measure_is_told_with_their_numbers() -> None:
    span, wrong = Span(True, 100.0, 150.2), Span(False, 10.0, 60.0)
    bore = Arc((40.0, 50.0), 20.1, 0.0, 6.28, Linetype.VISIBLE)
    texts = {
        "10": Candidate(span.length, place=span),
        "\u00d88": Candidate(2.0 * bore.radius, place=bore),
        "77": Candidate(wrong.length, place=wrong),
    }
    box = (0.0, 0.0, 9.0, 9.0)
    placed = [Dimension(item, parse_dimension(item), box, (at,)) for item, at in texts.items()]
    found = agree([*placed, true(30), true(44)], MM, None)
    # The radius, where the number is a diameter; nothing of what was misread, or has no place.
    assert found.measures == (
        Measure(span, 10.0, 1.0),
        Measure(bore, pytest.approx(4.0), pytest.approx(0.5)),
    )
    assert agree([placed[0], placed[2]], MM, None).measures == ()
