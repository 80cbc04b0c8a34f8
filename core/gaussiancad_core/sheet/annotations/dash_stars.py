"""Pieces of ink in which three dashes of hidden edges meet at one point, as at a bore's bottom.

The side of a bore, its bottom and the flank of its tip meet there: a level leg, an upright one and
a slanted one.  Small ones look like letters, but each leg goes on beyond a gap.
"""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.marks import Mask

_SECTORS = 48
"""Directions in which legs are looked for."""

_APART = 5
"""Sectors between two legs at least: more than 37 degrees."""

_SHORTEST = 1.5
"""Length of a leg at least, in stroke widths."""

_COVERED = 0.93
"""Share of the ink that lies on the legs at least."""

_BESIDE_PX = 1.0
"""px beside half a stroke within which ink lies on a leg."""

_LIKELIEST = 24
"""Points with the longest legs that are looked at."""

_SQUARE, _SLANTED = 1, 3
"""Sectors from an axis of the sheet up to which a leg is along it, and from which it is slanted."""

_LARGEST = 60
"""px of the side of a piece up to which it is looked at."""

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]


def is_dash_star(
    labels: npt.NDArray[np.int32],
    stat: npt.NDArray[np.int32],
    piece: int,
    stroke_width: float,
    gap: float,
) -> bool:
    """Whether a piece of ink is three dashes, one level, one upright and one slanted, that meet at
    a point, each with other ink ahead of its end.

    Args:
        labels: (h, w) numbers of the pieces of ink.
        stat: (4 at least,) x, y, width, height in px of the piece.
        piece: its number.
        stroke_width: px.
        gap: px from where its ends are to the next ink at most.
    """
    x, y, width, height = (int(value) for value in stat[:4])
    if max(width, height) > _LARGEST:
        return False
    reach = int(np.ceil(gap + stroke_width)) + 1
    window = np.pad(labels, reach)[y : y + height + 2 * reach, x : x + width + 2 * reach]
    own, others = window == piece, (window != 0) & (window != piece)
    places = np.argwhere(own)[:, ::-1].astype(np.float64)
    lengths = _ray_lengths(own, places, max(width, height) + 2)
    legs = [_legs(rays, _SHORTEST * stroke_width) for rays in lengths]
    told = [k for k, found in enumerate(legs) if _is_corner(found)]
    told.sort(key=lambda k: -sum(lengths[k][leg] for leg in legs[k]))
    for k in told[:_LIKELIEST]:
        ends = [(_direction(leg), float(lengths[k][leg])) for leg in legs[k]]
        if _covered(places, places[k], ends, stroke_width) >= _COVERED:
            return all(
                _is_ahead(others, places[k] + length * way, way, gap + stroke_width)
                for way, length in ends
            )
    return False


def _direction(sector: int) -> Floats:
    angle = 2.0 * np.pi * sector / _SECTORS
    return np.array([np.cos(angle), np.sin(angle)])


def _ray_lengths(own: Mask, places: Floats, longest: int) -> Floats:
    """(n, sectors) px of ink from each place on in each direction."""
    ways = np.array([_direction(sector) for sector in range(_SECTORS)])
    steps = np.arange(1, longest + 1)
    points = places[:, None, None] + steps[:, None] * ways[None, :, None]
    columns, rows = np.rint(points).astype(int).transpose(3, 0, 1, 2)
    inside = (rows >= 0) & (columns >= 0) & (rows < own.shape[0]) & (columns < own.shape[1])
    inked = own[np.clip(rows, 0, own.shape[0] - 1), np.clip(columns, 0, own.shape[1] - 1)] & inside
    return np.cumprod(inked, axis=2).sum(axis=2).astype(np.float64)


def _legs(rays: Floats, shortest: float) -> list[int]:
    """The sectors of the longest rays, apart from each other."""
    found: list[int] = []
    for sector in np.argsort(-rays, kind="stable").tolist():
        if rays[sector] < shortest:
            break
        if all(_between(sector, other) >= _APART for other in found):
            found.append(sector)
    return found


def _between(one: int, other: int) -> int:
    apart = abs(one - other) % _SECTORS
    return min(apart, _SECTORS - apart)


def _is_corner(legs: list[int]) -> bool:
    """Whether legs are one level, one upright and one slanted."""
    quarter = _SECTORS // 4
    off = [min(leg % quarter, quarter - leg % quarter) for leg in legs]
    square = [leg for leg, away in zip(legs, off, strict=True) if away <= _SQUARE]
    if len(legs) != 3 or len(square) != 2 or max(off) < _SLANTED:
        return False
    return abs(_between(*square) - quarter) <= 2 * _SQUARE


def _covered(
    places: Floats, centre: Floats, legs: list[tuple[Floats, float]], stroke_width: float
) -> float:
    """Share of the ink that lies along the legs."""
    offset = places - centre
    on = np.zeros(len(places), dtype=bool)
    for way, length in legs:
        along = offset @ way
        aside = np.abs(offset[:, 0] * way[1] - offset[:, 1] * way[0])
        near = stroke_width / 2.0 + _BESIDE_PX
        on |= (aside <= near) & (along >= -near) & (along <= length + _BESIDE_PX)
    return float(on.mean())


def _is_ahead(others: Mask, end: Floats, way: Floats, gap: float) -> bool:
    """Whether other ink lies ahead of a leg's end."""
    normal = np.array([-way[1], way[0]])
    steps, sides = np.meshgrid(np.arange(1.0, gap + 1.0), (-1.0, 0.0, 1.0))
    points = end + steps.ravel()[:, None] * way + sides.ravel()[:, None] * normal
    columns, rows = np.rint(points).astype(int).T
    inside = (rows >= 0) & (columns >= 0) & (rows < others.shape[0]) & (columns < others.shape[1])
    return bool(others[rows[inside], columns[inside]].any())
