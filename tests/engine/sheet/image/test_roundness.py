"""How much wider than high circles are on a sheet."""

import cv2
import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.sheet.image.roundness import proportion


def sheet(*ovals: tuple[int, int, int], wider: float = 1.0) -> npt.NDArray[np.uint8]:
    """Circles (x, y, radius) beside a rectangle, stretched across."""
    made = np.full((1600, 2000), 255, np.uint8)
    cv2.rectangle(made, (100, 100), (900, 700), 0, 6)
    for x, y, radius in ovals:
        cv2.circle(made, (2 * x, 2 * y), 2 * radius, 0, 6, cv2.LINE_AA)
    size = round(1000 * wider), 800
    return cv2.resize(made, size, interpolation=cv2.INTER_AREA)


@pytest.mark.parametrize("wider", [0.95, 1.0, 1.03])
def test_several_circles_tell_it(wider: float) -> None:
    made = sheet((300, 250, 60), (700, 300, 90), (500, 600, 45), wider=wider)
    assert proportion(made) == pytest.approx(wider, rel=0.002)


def test_one_circle_may_be_an_ellipse() -> None:
    assert proportion(sheet((300, 250, 60), wider=1.03)) is None


def test_circles_about_one_middle_are_one() -> None:
    assert proportion(sheet((300, 250, 60), (300, 250, 90), wider=1.03)) is None


def test_straight_lines_tell_nothing() -> None:
    assert proportion(sheet()) is None
