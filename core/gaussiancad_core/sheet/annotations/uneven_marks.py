"""Centre marks whose lines begin with a dash and leave off anywhere.

A program dashes the lines of a mark from one end to the other.  The last dash may end at the line's
end or before it, so that the mark has no picture of itself in its centre; and around concentric
circles dashes of two marks lie on each other, and make one line of any form.  But where its lines
begin they are equally far beyond the circle, with nothing ahead, which edges are not.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.ndimage import map_coordinates

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle

_STEP = 0.5
"""px between places that are looked at."""

_DARK = 0.3
"""Weight of ink from which a place is dark."""

_BESIDE = 1.0
"""px by which a mark's line may lie beside the centre."""

_APART = 3.0
"""px from a stroke's edge at which ink on both sides is that of a stroke that crosses."""

_BEYOND = 1.5
"""Distance by which lines begin beyond their circle at least, in stroke widths."""

_FARTHEST, _LONGEST = 1.0, 60.0
"""Distance by which they do so at most, in radii and px beside that."""

_EVEN = 2.0
"""px by which ends of one mark may differ."""

_AHEAD, _LEAST_AHEAD = 1.6, 3.0
"""Blank way ahead of an end, in the sheet's gaps between dashes, and px."""

_GAP = 5.0
"""Gap between dashes at most, in stroke widths, where the sheet's do not tell."""

_UNBROKEN = 9.0
"""Length that no dash of a hidden line has, in stroke widths."""

_INKED = 0.6
"""Share of each line that is ink at least, where nothing crosses it."""

_REACH = 0.7
"""Share of the way from the centre to the end that a side has at least."""


@dataclass(frozen=True)
class _Side:
    """What lies on the way from a centre in one direction, place by place.

    Attributes:
        dark: (n,) whether there is ink.
        own: (n,) whether there is ink, and no other stroke's.
        crossed: (n,) whether another stroke crosses.
    """

    dark: npt.NDArray[np.bool_]
    own: npt.NDArray[np.bool_]
    crossed: npt.NDArray[np.bool_]

    def ends_at(self, place: int, ahead: int) -> bool:
        """Whether there is the line's own ink, and nothing ahead of it."""
        even = round(_EVEN / _STEP)
        ink = np.flatnonzero(self.own[: place + even + 1])
        if not len(ink) or ink[-1] < place - even:
            return False
        way = self.dark[ink[-1] + 1 : ink[-1] + 1 + ahead]
        return len(way) == ahead and not way.any()

    def leaves_off_at(self, place: int, ahead: int) -> int | None:
        """The last place of its own ink, but for ink that is far from a place; nothing if there is
        none, or none of it near that place."""
        ink = np.flatnonzero(self.own)
        near = ink[ink >= _REACH * place]
        if not len(near) or near[0] > place + ahead:
            return None
        # A stroke that crosses is no gap.
        blank = np.cumsum(~self.dark)[near]
        gaps = np.flatnonzero(np.diff(blank) > ahead)
        return int(near[gaps[0] if len(gaps) else -1])


def uneven_mark(circle: Circle, way: tuple[float, float], sheet: CleanSheet) -> float | None:
    """Px from the centre to the ends of a mark's lines; nothing if there is none.

    Args:
        circle: that it belongs to.
        way: unit vector along one of its lines; the other is at right angles.
        sheet: its ink.
    """
    right, down = way
    ways = (right, down), (-down, right), (-right, -down), (down, -right)
    sides = [_side(circle, own, sheet) for own in ways]
    # Hidden lines end a gap before an edge, but have no dash as long.
    whole = max(circle.radius, _UNBROKEN * sheet.stroke_width)
    solid = all(_solid(sides[k], sides[k + 2]) * _STEP >= whole for k in range(2))
    gap = 0.0 if solid else _AHEAD * (sheet.dash_gap or _GAP * sheet.stroke_width)
    ahead = round(max(gap, _LEAST_AHEAD) / _STEP)
    for place in _ends(sides, circle, sheet.stroke_width):
        free = [side.ends_at(place, ahead) for side in sides]
        if not (free[0] or free[2]) or not (free[1] or free[3]):
            continue
        rest = [
            side.leaves_off_at(place, ahead)
            for side, own in zip(sides, free, strict=True)
            if not own
        ]
        end = _end(place, rest, sheet.stroke_width)
        inked = [_inked(sides[k], sides[k + 2], place) for k in range(2)]
        if end is not None and min(inked) >= _INKED:
            return end * _STEP
    return None


def _end(place: int, rest: list[int | None], stroke_width: float) -> int | None:
    """Where the longest side of a mark ends; nothing if it is none.

    Args:
        place: where free ends are, on two sides at least.
        rest: where the other sides leave off.
        stroke_width: px.
    """
    even = round((_EVEN + stroke_width) / _STEP)
    ends = [own for own in rest if own is not None]
    farthest = max(place, *ends) if ends else place
    if len(ends) < len(rest):
        return None
    # What leads farther begins at edges, on both lines alike.
    alike = len(ends) == 2 and farthest - min(ends) <= even and place >= _REACH * farthest
    return farthest if alike or farthest <= place + even else None


def _side(circle: Circle, way: tuple[float, float], sheet: CleanSheet) -> _Side:
    """What lies on the way from a circle's centre, farther than a mark's lines lead."""
    reach = (1.0 + _FARTHEST) * circle.radius + 2.0 * _LONGEST
    places = np.array(circle.centre) + np.arange(0.0, reach, _STEP)[:, None] * np.array(way)
    across = np.array([-way[1], way[0]])
    dark = np.any([_dark(sheet, places + k * across) for k in (-_BESIDE, 0.0, _BESIDE)], axis=0)
    far = (sheet.stroke_width / 2.0 + _APART) * across
    crossed = _dark(sheet, places - far) & _dark(sheet, places + far)
    return _Side(dark, dark & ~crossed, crossed)


def _dark(sheet: CleanSheet, places: npt.NDArray[np.float64]) -> npt.NDArray[np.bool_]:
    """(n,) whether there is ink at (n, 2) px."""
    return map_coordinates(sheet.weight, places[:, ::-1].T, order=1) > _DARK


def _ends(sides: list[_Side], circle: Circle, stroke_width: float) -> Iterator[int]:
    """Places beyond a circle where ink of its own ends on some side, the farthest first."""
    least = circle.radius + _BEYOND * stroke_width
    most = (1.0 + _FARTHEST) * circle.radius + _LONGEST
    places = {
        int(place)
        for side in sides
        for place in np.flatnonzero(side.own[:-1] & ~side.dark[1:])
        if least <= place * _STEP <= most
    }
    return iter(sorted(places, reverse=True))


def _inked(one: _Side, other: _Side, place: int) -> float:
    """Share of ink on both sides of a line up to a place, where nothing crosses it."""
    own = np.concatenate([side.own[: place + 1] for side in (one, other)])
    crossed = np.concatenate([side.crossed[: place + 1] for side in (one, other)])
    return float(own.sum()) / max(float((~crossed).sum()), 1.0)


def _solid(one: _Side, other: _Side) -> int:
    """Number of places without a gap through the centre."""
    blank = [np.flatnonzero(~side.dark) for side in (one, other)]
    return sum(int(own[0]) if len(own) else 0 for own in blank)
