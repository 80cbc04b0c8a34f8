"""Hidden circles as small as letters."""

import cv2
import numpy as np
import pytest

from gaussiancad_core.sheet.labels.dashed_rings import dashed_rings

WIDTH = 3.0


def ring(dashes: int, filled: float = 0.6, radius: float = 12.0) -> np.ndarray:
    """A circle of dashes, (80, 80) bool."""
    rows, columns = np.mgrid[:80, :80] - 40.3
    turns = np.arctan2(rows, columns) / (2.0 * np.pi)
    inked = np.abs(np.hypot(rows, columns) - radius) < WIDTH / 2.0
    return inked & (np.mod(dashes * turns, 1.0) < filled)


@pytest.mark.parametrize("dashes", [3, 4, 5, 6])
def test_a_circle_of_dashes_is_no_writing(dashes: int) -> None:
    ink = ring(dashes)
    assert (dashed_rings(ink, WIDTH) == ink).all()


@pytest.mark.parametrize("text", ["R10", "0.8", "M6 x 1", "III", "(2x)", "A-A", "%8C", "H7/g6"])
def test_writing_is_no_circle_of_dashes(text: str) -> None:
    ink = np.zeros((80, 200), np.uint8)
    cv2.putText(ink, text, (10, 50), cv2.FONT_HERSHEY_SIMPLEX, 1.0, 1, 3)
    assert not dashed_rings(ink > 0, WIDTH).any()


def test_dashes_of_a_row_and_a_piece_of_a_circle_are_no_whole_circle() -> None:
    row = np.zeros((80, 80), bool)
    for start in (10, 24, 38, 52):
        row[40:43, start : start + 9] = True
    half = ring(8)
    half[:40] = False
    assert not dashed_rings(row | half, WIDTH).any()
    assert not dashed_rings(half, WIDTH).any()
    assert not dashed_rings(np.zeros((80, 80), bool), WIDTH).any()
