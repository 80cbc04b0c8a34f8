"""Dashes that meet in the corners of pockets are told by their form and what is ahead of them."""

import cv2
import numpy as np
import pytest

from gaussiancad_core.sheet.annotations.corner_pieces import is_dash_corner

WIDTH, GAP = 3.0, 10.0


def _drawn(*strips: tuple[int, int, int, int]) -> np.ndarray:
    ink = np.zeros((120, 120), bool)
    for x0, y0, x1, y1 in strips:
        ink[y0:y1, x0:x1] = True
    return ink


def _is_corner(ink: np.ndarray, place: tuple[int, int]) -> bool:
    _, labels, stats, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    piece = int(labels[place[1], place[0]])
    return is_dash_corner(labels, stats[piece], piece, WIDTH, GAP)


L_PIECE = (50, 50, 66, 53), (50, 50, 53, 66)
L_AHEAD = (75, 50, 80, 53), (50, 75, 53, 90)
U_PIECE = (*L_PIECE, (63, 50, 66, 65))
U_AHEAD = (50, 75, 53, 90), (63, 75, 66, 90)


@pytest.mark.parametrize("turn", range(4))
@pytest.mark.parametrize(
    ("strips", "is_one"),
    [
        ((*L_PIECE, *L_AHEAD), True),
        ((*U_PIECE, *U_AHEAD), True),
        # Nothing is ahead of one end: a letter.
        ((*L_PIECE, L_AHEAD[0]), False),
        ((*L_PIECE, L_AHEAD[1]), False),
        ((*U_PIECE, U_AHEAD[0]), False),
        # A cross, and an F.
        (((50, 56, 66, 59), (56, 50, 59, 66), *L_AHEAD), False),
        ((*L_PIECE, (50, 58, 66, 61), *L_AHEAD), False),
        # One straight dash.
        (((50, 50, 66, 53), *L_AHEAD), False),
    ],
    ids=["l", "u", "l-right", "l-down", "u-left", "cross", "f", "dash"],
)
def test_an_l_or_u_with_ink_ahead(
    strips: tuple[tuple[int, int, int, int], ...], is_one: bool, turn: int
) -> None:
    ink = np.rot90(_drawn(*strips), turn).copy()
    seed = np.rot90(
        _drawn((57, 57, 58, 58)) if strips[0][1] == 56 else _drawn((51, 51, 52, 52)), turn
    )
    row, column = np.argwhere(seed)[0]
    assert _is_corner(ink, (int(column), int(row))) is is_one


def test_at_the_border_of_the_sheet_nothing_is_ahead() -> None:
    ink = np.zeros((40, 40), bool)
    ink[0:3, 0:16] = ink[0:16, 0:3] = True
    assert not _is_corner(ink, (1, 1))
