"""Lines one pixel wide along the middle of ink, thinned from both sides.

Each round takes away pixels of the border twice, first those whose ink lies on one side, then those
of the other (Zhang and Suen, *A fast parallel algorithm for thinning digital patterns*, 1984).
Beyond their rule the corners of steps go, and of lines two pixels wide one of both stays, so that
the outcome is that of ``skimage.morphology.skeletonize``, pixel by pixel.
"""

import numpy as np
import numpy.typing as npt

Mask = npt.NDArray[np.bool_]

_FIRST, _SECOND = 1, 2
"""Bits of the halves of a round in which a pixel may go."""

_NORTH, _EAST, _SOUTH, _WEST = 1, 3, 5, 7
"""Places among the eight neighbours of a pixel, which are counted clockwise from north-west."""

_ELSEWHERE = {
    0: (48, 129),
    _FIRST: (3, 6, 11, 12, 14, 131, 134, 161, 194, 198),
    _SECOND: (24, 26, 56, 96, 104, 108, 176, 192, 224),
    _FIRST | _SECOND: (10, 40, 130, 160),
}
"""Halves of a round -> the neighbours, a bit each, of pixels that go then and not by the rule."""


def _by_rule(neighbours: int) -> int:
    """The halves of a round in which a pixel goes by the rule, whose neighbours are ink or not."""
    ink = [bool(neighbours >> place & 1) for place in range(8)]
    starts = sum(not ink[place - 1] and ink[place] for place in range(8))
    if not 2 <= sum(ink) <= 6 or starts != 1:
        return 0
    north, east, south, west = (ink[place] for place in (_NORTH, _EAST, _SOUTH, _WEST))
    first = not (north and east and south) and not (east and south and west)
    second = not (north and east and west) and not (north and south and west)
    return first * _FIRST | second * _SECOND


def _rules() -> npt.NDArray[np.uint8]:
    """(256,) by the neighbours, a bit each: the halves of a round in which a pixel goes."""
    rules = np.array([_by_rule(neighbours) for neighbours in range(256)], dtype=np.uint8)
    for halves, patterns in _ELSEWHERE.items():
        rules[list(patterns)] = halves
    return rules


_RULES = _rules()


def skeleton(ink: Mask) -> Mask:
    """(h, w) the lines, one pixel wide, along the middle of ink (h, w)."""
    padded = np.pad(np.ascontiguousarray(ink, dtype=np.uint8), 1)
    row = padded.shape[1]
    around = np.array([-row - 1, -row, -row + 1, 1, row + 1, row, row - 1, -1])
    pixels = padded.ravel()
    left = np.flatnonzero(pixels)
    # A pixel that stayed stays until a neighbour goes: by halves, those that are looked at again.
    doubtful = {half: pixels > 0 for half in (_FIRST, _SECOND)}
    changed = True
    while changed:
        changed = False
        for half in (_FIRST, _SECOND):
            places = left[doubtful[half][left]]
            doubtful[half][places] = False
            neighbours = np.zeros(len(places), dtype=np.uint8)
            for place, step in enumerate(around):
                neighbours |= pixels[places + step] << np.uint8(place)
            gone = places[(_RULES[neighbours] & half) > 0]
            if not len(gone):
                continue
            changed = True
            pixels[gone] = 0
            left = left[pixels[left] > 0]
            for step in around:
                doubtful[_FIRST][gone + step] = doubtful[_SECOND][gone + step] = True
    return padded[1:-1, 1:-1] > 0
