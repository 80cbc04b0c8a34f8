"""Three dashes that meet in the corner of a drilled bore, and letters that look like it."""

import cv2
import numpy as np
import pytest

from gaussiancad_core.sheet.annotations.dash_stars import is_dash_star

WIDTH, GAP = 3.0, 10.0
CENTRE = (60, 60)


def _drawn(*lines: tuple[tuple[int, int], tuple[int, int]]) -> np.ndarray:
    ink = np.zeros((120, 120), np.uint8)
    for start, end in lines:
        cv2.line(ink, start, end, 1, int(WIDTH))
    return ink > 0


def _is_star(ink: np.ndarray) -> bool:
    _, labels, stats, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    piece = int(labels[CENTRE[1], CENTRE[0]])
    return is_dash_star(labels, stats[piece], piece, WIDTH, GAP)


RIGHT, DOWN, UP = (CENTRE, (76, 60)), (CENTRE, (60, 74)), (CENTRE, (68, 52))
AHEAD = ((85, 60), (92, 60)), ((60, 83), (60, 90)), ((74, 46), (80, 40))


@pytest.mark.parametrize("turn", range(4))
@pytest.mark.parametrize("mirrored", [False, True])
def test_a_corner_of_three_dashes_that_go_on(turn: int, mirrored: bool) -> None:
    ink = _drawn(RIGHT, DOWN, UP, *AHEAD)
    ink = np.rot90(ink[:, ::-1] if mirrored else ink, turn).copy()
    _, labels, stats, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    own = 1 + int(np.argmax(stats[1:, cv2.CC_STAT_AREA]))
    assert is_dash_star(labels, stats[own], own, WIDTH, GAP)


@pytest.mark.parametrize("left_out", range(3))
def test_a_leg_with_nothing_ahead_is_a_letters(left_out: int) -> None:
    others = [line for k, line in enumerate(AHEAD) if k != left_out]
    assert not _is_star(_drawn(RIGHT, DOWN, UP, *others))


@pytest.mark.parametrize(
    "lines",
    [
        [RIGHT, DOWN],
        [RIGHT, DOWN, UP, (CENTRE, (44, 60))],
        [(CENTRE, (48, 50)), (CENTRE, (72, 50)), DOWN],
        [RIGHT, DOWN, (CENTRE, (60, 46))],
        [RIGHT, DOWN, UP, ((76, 60), (76, 70))],
    ],
    ids=["l", "four", "y", "t", "hook"],
)
def test_other_forms_are_none(lines: list[tuple[tuple[int, int], tuple[int, int]]]) -> None:
    around = [
        ((20, 20), (100, 20)),
        ((100, 20), (100, 100)),
        ((100, 100), (20, 100)),
        ((20, 100), (20, 20)),
    ]
    near = [((85, 40), (85, 85)), ((40, 83), (80, 83)), ((40, 40), (80, 40)), ((38, 42), (38, 80))]
    assert not _is_star(_drawn(*lines, *near, *around))
