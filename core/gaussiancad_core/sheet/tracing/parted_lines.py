"""Hidden lines that are two: parted where nothing is drawn between two corners.

Two hidden edges on one line, with less than three gaps of dashes between them, are taken for one.
What parts them is a wide gap at both ends of which another stroke meets the line.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import FAINT, ONE_PLACE, STEP
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.outline_jogs import distance_to

_WIDE = 1.5
"""Gaps of the sheet's dashes that a gap between two lines is wide at least."""


def parted_at_corners(pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm) -> list[Placed]:
    """The pieces, hidden lines cut where a wide gap lies between two strokes that meet them.

    The cut ends are where the ink ends, not yet at the junctions.

    Args:
        pieces: of a view, with their ends at junctions; px.
        sheet: its ink.
        rhythm: of its dashes.
    """
    parted: list[Placed] = []
    for geometry, piece in pieces:
        if not isinstance(geometry, Line) or piece.linetype is not Linetype.HIDDEN:
            parted.append((geometry, piece))
            continue
        others = [other for other in pieces if other[0] != geometry]
        start = piece.start
        for low, high in wide_gaps(geometry, piece, sheet, rhythm):
            near = sheet.stroke_width / 2.0 + ONE_PLACE
            if all(_is_met(geometry, at, others, near) for at in (low, high)):
                parted.append((geometry, replace(piece, start=start, end=low)))
                start = high
        parted.append((geometry, replace(piece, start=start)))
    return parted


def wide_gaps(
    line: Line, piece: Piece, sheet: CleanSheet, rhythm: Rhythm
) -> Iterator[tuple[float, float]]:
    """Where nothing is drawn along a hidden line for longer than between its dashes, in px."""
    along = np.arange(piece.start, piece.end, STEP)
    points = line.points_at(along)
    dark = sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] > FAINT
    places = along[dark]
    for before, after in pairwise(places):
        if after - before > _WIDE * rhythm.gap:
            yield float(before), float(after)


def _is_met(line: Line, at: float, others: Sequence[Placed], near: float) -> bool:
    point = np.array(line.at(at))
    return any(distance_to(other, point) <= near for other in others)
