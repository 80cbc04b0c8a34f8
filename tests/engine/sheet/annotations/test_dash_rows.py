"""Dashes of hidden lines that are close beside each other, and letters."""

import numpy as np
import pytest

from gaussiancad_core.sheet.annotations.dash_rows import are_dashes


def _row(count: int, length: float, gap: float, widths: list[tuple[float, float]]) -> np.ndarray:
    """Upright dashes: columns of them at places and with widths."""
    return np.array(
        [(x, k * (length + gap), width, length) for k in range(count) for x, width in widths]
    )


@pytest.mark.parametrize("count", [2, 3, 8])
@pytest.mark.parametrize("widths", [[(0.0, 6.0)], [(0.0, 6.0), (8.0, 3.0)]])
@pytest.mark.parametrize("level", [False, True])
def test_even_pieces_along_their_row_are_dashes(
    count: int, widths: list[tuple[float, float]], level: bool
) -> None:
    boxes = _row(count, 19.0, 10.0, widths)
    assert are_dashes(boxes[:, [1, 0, 3, 2]] if level else boxes)


def test_dashes_at_the_ends_may_be_cut() -> None:
    boxes = _row(5, 19.0, 10.0, [(0.0, 6.0)])
    boxes[0, 1], boxes[0, 3] = 12.0, 7.0
    boxes[-1, 3] = 9.0
    assert are_dashes(boxes)


def test_letters_are_higher_than_wide() -> None:
    letters = np.array([(x, 0.0, 12.0, 18.0) for x in (0.0, 16.0, 32.0, 48.0)])
    assert not are_dashes(letters)


def test_uneven_pieces_are_no_dashes() -> None:
    lengths, at = (30.0, 18.0, 26.0, 12.0), (0.0, 40.0, 66.0, 104.0)
    words = np.array([(x, 0.0, wide, 8.0) for x, wide in zip(at, lengths, strict=True)])
    assert not are_dashes(words)


def test_one_piece_is_no_row() -> None:
    assert not are_dashes(np.array([(0.0, 0.0, 30.0, 8.0)]))
