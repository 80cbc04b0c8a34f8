"""Hidden lines that end too early, at a line that they only cross: their corner is a dash farther.

No edge ends in blank paper.  Where a hidden line ends and nothing else does, another hidden one
whose course leads there was taken to end at a crossing on the way, in the gap of its dashes.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.picture_noise import MEETING, ONE_PLACE
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to


def with_corners_reached(pieces: Sequence[Placed], rhythm: Rhythm) -> list[Placed]:
    """The pieces, hidden lines led on to the free ends of others, no farther than a dash and a gap.

    Args:
        pieces: with their ends at junctions; px.
        rhythm: of the sheet's dashes.
    """
    led = list(pieces)
    hidden = [
        (number, geometry, piece)
        for number, (geometry, piece) in enumerate(pieces)
        if isinstance(geometry, Line) and piece.linetype is Linetype.HIDDEN
    ]
    for number, line, piece in hidden:
        for at in (piece.start, piece.end):
            place = np.array([line.at(at)])
            if any(
                k != number and distances_to(this_piece, place)[0] <= ONE_PLACE
                for k, this_piece in enumerate(pieces)
            ):
                continue
            found = [
                (beyond, other)
                for other, course, _ in hidden
                if other != number and _sine(line, course) >= MEETING
                for beyond in [_beyond(course, led[other][1], place)]
                if 0.0 < abs(beyond) <= rhythm.dash + rhythm.gap
            ]
            if found:
                beyond, other = min(found, key=lambda pair: abs(pair[0]))
                course, item = led[other]
                low, high = min(beyond, 0.0), max(beyond, 0.0)
                led[other] = course, replace(item, start=item.start + low, end=item.end + high)
    return led


def _sine(one: Line, other: Line) -> float:
    (a, b), (c, d) = one.direction, other.direction
    return abs(a * d - b * c)


def _beyond(line: Line, piece: Piece, place: npt.NDArray[np.float64]) -> float:
    """px by which a place lies beyond a piece's end, negative before its start; 0 if it is not on
    the line or not beyond."""
    along, across = (float(coordinate[0]) for coordinate in line.coordinates(place))
    if abs(across) > ONE_PLACE:
        return 0.0
    return along - min(max(along, piece.start), piece.end)
