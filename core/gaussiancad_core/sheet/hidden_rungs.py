"""Hidden lines of little more than a gap between two others: a tick from each towards the other.

Where dashes begin and end at corners, a line of a dash and a half has no dash of its own, and no
ridge to grow from.  Two ticks that face each other are no chance.
"""

from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.corner_dashes import longest_blank
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.jogs import distance_to
from gaussiancad_core.sheet.runs import Piece, Rhythm, runs_of_ink, widest_gap
from gaussiancad_core.sheet.shapes import sample
from gaussiancad_core.sheet.stubs import Placed
from gaussiancad_core.views import Linetype

Floats = npt.NDArray[np.float64]

_LONGEST = 2.0
"""Dashes with their gaps that a rung is long at most."""

_PARALLEL = 0.9998
"""Cosine of the angle between the two lines at least."""

_TICK = 2.5
"""px beyond half a line's width where a tick has ink: where a centre line was taken off that
crossed both lines, up to two are left of it."""

_WIDER = 2.0
"""px by which a tick is wider than a line at most, along it."""

_FACING = 0.8
"""px by which two ticks that face each other are out of line at most."""

_TAKEN = 1.5
"""px from the middle of a rung, and from its ticks, within which no other stroke runs."""

_STEP, _DARK = 0.5, 0.5
"""px between the places that are looked at, and weight from which one is ink."""

_MOST = 600
"""Pieces of a view up to which rungs are looked for."""

_CONFIDENCE = 0.6


def with_hidden_rungs(pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm) -> list[Placed]:
    """The pieces of a view and the hidden rungs between them.

    Args:
        pieces: with their ends at junctions; px.
        sheet: the view's ink.
        rhythm: of its dashes.
    """
    lines = [
        (geometry, piece)
        for geometry, piece in pieces
        if isinstance(geometry, Line)
        and piece.linetype is Linetype.HIDDEN
        and piece.end - piece.start > rhythm.dash
    ]
    if len(lines) > _MOST or rhythm.dash <= 0.0:
        return list(pieces)
    found = list(pieces)
    for one, other in combinations(lines, 2):
        for rung in _between(one, other, sheet, rhythm):
            beside = [own for own in found if own is not one and own is not other]
            if not _is_taken(rung, beside, 0.5 * sheet.stroke_width + _TICK):
                found.append(rung)
    return found


def _is_taken(rung: Placed, others: Sequence[Placed], tick: float) -> bool:
    """Whether other strokes run through the middle of a rung, or through one of its ticks, which
    then is ink of theirs: dashes of a circle between two tangents face each other as well."""
    line, piece = rung
    length = piece.end - piece.start
    places = [np.array(line.at(piece.start + at)) for at in (tick, 0.5 * length, length - tick)]
    return any(distance_to(own, place) <= _TAKEN for own in others for place in places)


def _between(
    one: tuple[Line, Piece], other: tuple[Line, Piece], sheet: CleanSheet, rhythm: Rhythm
) -> Iterator[Placed]:
    """The rungs from one line to another, if these are parallel and near enough."""
    (line, piece), (beside, its) = one, other
    if abs(float(np.dot(line.direction, beside.direction))) < _PARALLEL:
        return
    along, across = line.coordinates(beside.points_at(np.array([its.start, its.end])))
    apart = float(across.mean())
    clear = 0.5 * sheet.stroke_width + _TICK
    if not 2.0 * clear < abs(apart) <= _LONGEST * (rhythm.dash + rhythm.gap):
        return
    start, end = max(piece.start, float(along.min())), min(piece.end, float(along.max()))
    if end - start < _STEP:
        return
    direction = np.array(line.direction)
    way = np.sign(apart) * np.array([-direction[1], direction[0]])
    places = np.arange(start - sheet.stroke_width, end + sheet.stroke_width, _STEP)
    points = line.points_at(places)
    near = _ticks(sheet, points + clear * way, places)
    far = _ticks(sheet, points + (abs(apart) - clear) * way, places)
    for tick in near:
        facing = far[np.abs(far - tick) <= _FACING]
        if not len(facing):
            continue
        place = np.array(line.at(0.5 * float(tick + facing[0])))
        away = np.arange(0.0, abs(apart) + _STEP, _STEP)
        column = place + away[:, None] * way
        dark = sample(sheet.weight, column[:, :1], column[:, 1:])[:, 0] > _DARK
        inner = (away >= clear) & (away <= abs(apart) - clear)
        blanks = len(runs_of_ink(~dark[inner]))
        gap = longest_blank(dark[inner]) * _STEP
        if blanks == 1 and 2.0 * _STEP <= gap <= widest_gap(rhythm):
            x, y = place
            rung = Line((float(x), float(y)), (float(way[0]), float(way[1])))
            yield rung, Piece(0.0, abs(apart), Linetype.HIDDEN, _CONFIDENCE)


def _ticks(sheet: CleanSheet, points: Floats, places: Floats) -> Floats:
    """(n,) middles of the short stretches of ink at (m, 2) px, at positions (m,)."""
    dark = sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] > _DARK
    widest = sheet.stroke_width + _WIDER
    return np.array(
        [
            0.5 * (places[first] + places[last])
            for first, last in runs_of_ink(dark)
            if places[last] - places[first] <= widest and first > 0 and last < len(dark) - 1
        ]
    )
