"""Hidden lines too short for their dashes to be told: slanted ones from the end of a hidden line.

The cone of a countersink or of a drill's tip, or a chamfer, shows as one dash or two between the
corner of a hidden line and the next stroke.  What tells it is ink that no stroke explains, on a
straight way from that corner: to another stroke, or to where two such lines meet.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.corner_dashes import longest_blank
from gaussiancad_core.sheet.explained import Explained
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.jogs import distances_to
from gaussiancad_core.sheet.runs import Piece, Rhythm, widest_gap
from gaussiancad_core.sheet.shapes import sample
from gaussiancad_core.sheet.stubs import Placed
from gaussiancad_core.views import Linetype

_LONGEST = 3.0
"""Dashes with their gaps that a leg is long at most."""

_SHORTEST = 2.5
"""Line widths that it is long at least."""

_SMALLEST, _LARGEST = 0.5, 3.0
"""Squared line widths of a blot of ink at least; dashes, as pixels of a line, at most."""

_TIP_INK = 0.5
"""Dashes, as pixels of a line, that a leg to a tip has of its own at least: no stroke tells it."""

_BESIDE = 1.0
"""px beside a leg's ink by which a blot of it may reach."""

_OFF = 0.2
"""Sine of the angle to the line it starts from, or to an axis, under which a leg is no slant."""

_ONE_DASH = 1.4
"""Dashes that a piece is long at most to be a single one."""

_STEP = 0.5
"""px between the places that are looked at."""

_DARK = 0.5
"""Weight from which a pixel is ink."""

_INKED, _LEAST_INKED = 0.35, 2.0
"""Share of a leg's own way that is ink, and px, at least."""

_ROUGHLY = 1.5
"""Times the widest gap that a way may be blank for before it is fitted to the ink."""

_MOST_CORNERS, _MOST_BLOTS = 400, 400
"""Of a view, up to which legs are looked for: more are a sketch's."""

_TIP = 3.0
"""px by which the ink of two legs may end before they meet, beyond a gap of the dashes."""

_CONFIDENCE = 0.6

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class _Blot:
    """Ink that no stroke explains: its number, and its pixels, (n, 2) px."""

    number: int
    pixels: Floats

    @property
    def middle(self) -> Floats:
        """(2,) px."""
        return self.pixels.mean(0)


@dataclass(frozen=True)
class _View:
    """The pieces of a view, its ink, the blots that no piece has, and the rhythm of its dashes."""

    pieces: Sequence[Placed]
    sheet: CleanSheet
    blots: Sequence[_Blot]
    rhythm: Rhythm

    @property
    def longest(self) -> float:
        """px of a leg, at most."""
        return _LONGEST * (self.rhythm.dash + self.rhythm.gap)


@dataclass(frozen=True)
class _Place:
    """The end of a hidden line.

    Attributes:
        corner: (2,) px.
        along: (2,) unit vector of the line.
        others: pieces within a leg's reach that do not meet there.
        view: with the pieces and the blots within a leg's reach alone.
    """

    corner: Floats
    along: Floats
    others: Sequence[Placed]
    view: _View


@dataclass(frozen=True)
class _Leg:
    """A slanted way from a corner along some blots.

    Attributes:
        corner: (2,) px.
        way: (2,) unit vector.
        end: px from the corner to the stroke that it meets, None if none is near.
        inked: px from the corner of the last ink.
        blots: numbers of those that lie on it.
    """

    corner: Floats
    way: Floats
    end: float | None
    inked: float
    blots: frozenset[int]


def with_slanted_dashes(
    pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm
) -> list[Placed]:
    """The pieces, and short hidden lines that leave the ends of hidden ones at a slant.

    A single dash that begins at a corner and ends on nothing is taken for a part of such a line.

    Args:
        pieces: of a view, with their ends at junctions; px, pixel centres at integers.
        sheet: its ink.
        rhythm: of its dashes.
    """
    dangling = _dangling(pieces, rhythm)
    kept = [own for k, own in enumerate(pieces) if k not in dangling]
    corners = list(_corners(kept))
    if not corners or len(corners) > _MOST_CORNERS:
        return list(pieces)
    blots = _blots(_unexplained(kept, sheet), sheet.stroke_width, rhythm)
    if len(blots) > _MOST_BLOTS:
        return list(pieces)
    view = _View(kept, sheet, blots, rhythm)
    legs = [leg for place in _places(corners, view) for leg in _legs(place)]
    found: list[Placed] = []
    taken: set[int] = set()
    for leg in sorted(legs, key=lambda leg: -leg.inked):
        if leg.end is not None and not taken & leg.blots:
            taken |= leg.blots
            found.append(_hidden(leg, leg.end))
    area = {blot.number: len(blot.pixels) for blot in blots}
    least = _TIP_INK * rhythm.dash * sheet.stroke_width
    free = [leg for leg in legs if leg.end is None and sum(area[k] for k in leg.blots) >= least]
    for one, other, tip in _tips(free, sheet, rhythm):
        if not taken & (one.blots | other.blots):
            taken |= one.blots | other.blots
            found += [_hidden(leg, float((tip - leg.corner) @ leg.way)) for leg in (one, other)]
    near = sheet.stroke_width / 2.0 + _BESIDE
    replaced = {k for k in dangling if any(_covers(own, pieces[k], near) for own in found)}
    return [own for k, own in enumerate(pieces) if k not in replaced] + found


def _dangling(pieces: Sequence[Placed], rhythm: Rhythm) -> set[int]:
    """Numbers of slanted hidden pieces of about a dash, one end of which is on no other stroke."""
    found = set()
    for index, (geometry, piece) in enumerate(pieces):
        if not isinstance(geometry, Line) or piece.linetype is not Linetype.HIDDEN:
            continue
        if (
            piece.end - piece.start > _ONE_DASH * rhythm.dash
            or min(np.abs(geometry.direction)) < _OFF
        ):
            continue
        others = [own for k, own in enumerate(pieces) if k != index]
        ends = geometry.points_at(np.array([piece.start, piece.end]))
        free = np.min([distances_to(own, ends) for own in others], axis=0, initial=1e3) > _STEP
        if free.sum() == 1:
            found.add(index)
    return found


def _covers(own: Placed, other: Placed, near: float) -> bool:
    """Whether both ends of another piece lie on one."""
    geometry, piece = other
    ends = geometry.points_at(np.array([piece.start, piece.end]))
    return bool((distances_to(own, ends) <= near).all())


def _corners(pieces: Sequence[Placed]) -> Iterator[tuple[Floats, Floats]]:
    """(2,) px of the end of each hidden line, and its direction."""
    for geometry, piece in pieces:
        if isinstance(geometry, Line) and piece.linetype is Linetype.HIDDEN:
            for at in (piece.start, piece.end):
                yield np.array(geometry.at(at)), np.array(geometry.direction)


def _unexplained(pieces: Sequence[Placed], sheet: CleanSheet) -> npt.NDArray[np.bool_]:
    """(h, w) where there is ink that no piece has now; others may have had it before."""
    explained = Explained.blank(sheet)
    for own in pieces:
        explained.add(*own)
    return sheet.ink & (explained.around == 0)


def _blots(unexplained: npt.NDArray[np.bool_], stroke_width: float, rhythm: Rhythm) -> list[_Blot]:
    count, labels, boxes, _ = cv2.connectedComponentsWithStats(
        unexplained.astype(np.uint8), connectivity=8
    )
    found: list[_Blot] = []
    smallest, largest = _SMALLEST * stroke_width**2, _LARGEST * rhythm.dash * stroke_width
    for label in range(1, count):
        x, y, w, h, area = boxes[label]
        if not smallest <= area <= largest:
            continue
        rows, columns = np.nonzero(labels[y : y + h, x : x + w] == label)
        pixels = np.stack([columns + x, rows + y], axis=1).astype(np.float64)
        found.append(_Blot(label, pixels))
    return found


def _places(corners: Sequence[tuple[Floats, Floats]], view: _View) -> Iterator[_Place]:
    """Corners that a blot is near, with what is around each."""
    if not view.blots:
        return
    places = np.array([corner for corner, _ in corners])
    away = np.array([distances_to(own, places) for own in view.pieces])
    middles = np.array([blot.middle for blot in view.blots])
    reach = view.longest + view.sheet.stroke_width
    for k, (corner, along) in enumerate(corners):
        blots = np.flatnonzero(np.hypot(*(middles - corner).T) <= view.longest)
        if not len(blots):
            continue
        around = np.flatnonzero(away[:, k] <= reach)
        others = [view.pieces[i] for i in around if away[i, k] > _STEP]
        pieces = [view.pieces[i] for i in around]
        own = replace(view, pieces=pieces, blots=[view.blots[i] for i in blots])
        yield _Place(corner, along, others, own)


def _legs(place: _Place) -> Iterator[_Leg]:
    """The slanted ways out of a corner on which blots lie."""
    corner, along, view = place.corner, place.along, place.view
    reach = view.sheet.stroke_width / 2.0 + _BESIDE, view.longest
    tried: set[frozenset[int]] = set()
    for blot in view.blots:
        way = _direction(corner, blot.pixels)
        if not _is_slanted(way, along):
            continue
        on = [own for own in view.blots if _is_on(own, corner, way, reach)]
        numbers = frozenset(own.number for own in on)
        if not on or numbers in tried:
            continue
        tried.add(numbers)
        pixels = np.concatenate([own.pixels for own in on])
        way = _direction(corner, pixels)
        if not _is_dashed(corner, way, float(((pixels - corner) @ way).max()), view):
            continue
        way = _refined(corner, way, view)
        if not _is_slanted(way, along):
            continue
        leg = _followed(place, way, numbers)
        if leg is not None:
            yield leg


def _is_slanted(way: Floats, along: Floats) -> bool:
    """Whether a way goes neither along a line nor along an axis."""
    return min(abs(way[0] * along[1] - way[1] * along[0]), *np.abs(way)) >= _OFF


def _is_dashed(corner: Floats, way: Floats, last: float, view: _View) -> bool:
    """Whether ink lies on a way as dashes have it, roughly, up to ``last`` px from the corner."""
    points = corner + np.arange(0.0, last, _STEP)[:, None] * way
    dark = sample(view.sheet.weight, points[:, :1], points[:, 1:])[:, 0] > _DARK
    return longest_blank(dark) * _STEP <= _ROUGHLY * widest_gap(view.rhythm)


def _direction(corner: Floats, pixels: Floats) -> Floats:
    """The way from a corner that runs closest to some pixels, (2,) unit vector."""
    offsets = pixels - corner
    _, vectors = np.linalg.eigh(offsets.T @ offsets)
    way = vectors[:, 1]
    return way if offsets.mean(0) @ way >= 0.0 else -way


def _refined(corner: Floats, way: Floats, view: _View) -> Floats:
    """The way through the middle of the ink along it that no piece has."""
    sheet, longest = view.sheet, view.longest
    beside = sheet.stroke_width / 2.0 + _BESIDE
    columns, rows = np.meshgrid(
        *(np.arange(c - longest, c + longest + 1.0) for c in np.rint(corner))
    )
    pixels = np.stack([columns.ravel(), rows.ravel()], axis=1)
    offsets = pixels - corner
    along, across = offsets @ way, offsets @ np.array([-way[1], way[0]])
    inside = ((pixels >= 0.0) & (pixels < sheet.weight.shape[::-1])).all(1)
    inside &= (along > 0.0) & (along < longest) & (np.abs(across) <= beside)
    pixels, along, across = pixels[inside], along[inside], across[inside]
    own = np.min([distances_to(piece, pixels) for piece in view.pieces], axis=0) > beside
    columns, rows = pixels[own].astype(int).T
    ink = sheet.weight[rows, columns]
    turn = float((ink * along[own] * across[own]).sum() / max((ink * along[own] ** 2).sum(), 1e-9))
    turned = way + turn * np.array([-way[1], way[0]])
    return turned / np.hypot(*turned)


def _is_on(blot: _Blot, corner: Floats, way: Floats, reach: tuple[float, float]) -> bool:
    """Whether all of a blot lies on the way out of a corner, within px beside and along it."""
    near, longest = reach
    offsets = blot.pixels - corner
    along, across = offsets @ way, np.abs(offsets @ np.array([-way[1], way[0]]))
    return bool(along.min() > 0.0 and along.max() < longest and across.max() <= near)


def _followed(place: _Place, way: Floats, on: frozenset[int]) -> _Leg | None:
    """A way out of a corner up to the stroke that it meets, if ink is there as dashes have it."""
    corner, others, view = place.corner, place.others, place.view
    width = view.sheet.stroke_width
    places = np.arange(0.0, view.longest, _STEP)
    points = corner + places[:, None] * way
    dark = sample(view.sheet.weight, points[:, :1], points[:, 1:])[:, 0] > _DARK
    to_others = np.min([distances_to(own, points) for own in others], axis=0, initial=1e3)
    to_any = np.min([distances_to(own, points) for own in view.pieces], axis=0, initial=1e3)
    met = np.flatnonzero((to_others < _STEP) & (places >= _SHORTEST * width))
    last = int(met[0]) if len(met) else len(places) - 1
    own = (to_any > width / 2.0 + 1.0)[: last + 1]
    inked = np.flatnonzero(dark[: last + 1] & own)
    if len(inked) * _STEP < _LEAST_INKED:
        return None
    if not len(met):
        last = int(inked[-1])
        own = own[: last + 1]
    share = float(dark[: last + 1][own].mean())
    blank = longest_blank(dark[: last + 1]) * _STEP
    if share < _INKED or blank > widest_gap(view.rhythm):
        return None
    end = _meeting(corner, way, float(places[last]), others) if len(met) else None
    return _Leg(corner, way, end, float(places[inked[-1]]), on)


def _meeting(corner: Floats, way: Floats, about: float, others: Sequence[Placed]) -> float:
    """px from the corner to where a way comes closest to the stroke that it meets there."""
    places = about + np.arange(-1.0, 1.5, 0.05)
    points = corner + places[:, None] * way
    distance = np.min([distances_to(own, points) for own in others], axis=0)
    return float(places[int(distance.argmin())])


def _tips(
    legs: Sequence[_Leg], sheet: CleanSheet, rhythm: Rhythm
) -> Iterator[tuple[_Leg, _Leg, Floats]]:
    """Pairs of legs that end on no stroke but on each other, and where."""
    slack = widest_gap(rhythm) + _TIP
    for k, one in enumerate(legs):
        for other in legs[:k]:
            cross = float(one.way[0] * other.way[1] - one.way[1] * other.way[0])
            gap = other.corner - one.corner
            if abs(cross) < _OFF or np.hypot(*gap) < _SHORTEST * sheet.stroke_width:
                continue
            places = (
                float(gap[0] * other.way[1] - gap[1] * other.way[0]) / cross,
                float(gap[0] * one.way[1] - gap[1] * one.way[0]) / cross,
            )
            if all(
                -_TIP <= at - leg.inked <= slack
                for at, leg in zip(places, (one, other), strict=True)
            ):
                yield one, other, one.corner + places[0] * one.way


def _hidden(leg: _Leg, length: float) -> Placed:
    line = Line(tuple(map(float, leg.corner)), tuple(map(float, leg.way)))
    return line, Piece(0.0, length, Linetype.HIDDEN, _CONFIDENCE)
