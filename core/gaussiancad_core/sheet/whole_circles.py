"""Hidden circles of which only an arc was told, though dashes lie all around.

Where lines cross or touch a dashed circle some of its dashes have little ink of their own, and end
it there.  An arc of half a turn and more tells the circle so well that what lies on the rest of it,
as closely as dashes do, is the circle's.
"""

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.corner_dashes import longest_blank
from gaussiancad_core.sheet.geometry import Circle, Geometry, Line
from gaussiancad_core.sheet.junctions import Placed, is_full_circle
from gaussiancad_core.sheet.runs import Piece, Rhythm, Run, widest_gap
from gaussiancad_core.sheet.shapes import sample
from gaussiancad_core.views import Linetype

_TOLD = 0.5
"""Share of a circle that an arc is at least, to tell all of it."""

_INKED, _FAR_INKED = 0.45, 0.3
"""Share of the rest that is ink at least, and of that half of it which is farthest from the arc:
beside it lies the ink of the sides of a slot."""

_LONGEST = 2.0
"""Dashes that ink without a gap is long at most, with that of a stroke which crosses one."""

_TOUCHING_PX, _OWN_INKED, _TELLING = 1.0, 0.25, 1.5
"""px that a line passes nearer or farther by than the radius at most, to touch a circle; share of
what is not beside such lines that is ink at least; gaps that it is long at least to tell."""

_STEP, _DARK, _OF_DASHES = 0.5, 0.5, 0.8
"""px between the places that are looked at; share of the weight of dashes from which one is ink;
share of an arc that is paler than these, as hidden lines may be pale."""


def with_whole_circles(pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm) -> list[Placed]:
    """The pieces, hidden arcs of circles that are dashed all around as whole ones.

    Args:
        pieces: of a view, where their ink is seen; px, pixel centres at integers.
        sheet: the ink.
        rhythm: of its dashes.
    """
    lines = [(geometry, [piece]) for geometry, piece in pieces if isinstance(geometry, Line)]
    visible = {geometry for geometry, piece in pieces if piece.linetype is Linetype.VISIBLE}
    whole = {
        geometry: replace(piece, end=piece.start + geometry.around)
        for geometry, piece in pieces
        if isinstance(geometry, Circle)
        and piece.linetype is Linetype.HIDDEN
        and geometry not in visible
        and not is_full_circle(geometry, piece)
        and piece.end - piece.start >= _TOLD * geometry.around
        and _is_dashed(geometry, piece, sheet, rhythm)
        and has_ink_of_its_own(geometry, piece, lines, sheet, rhythm)
    }
    kept = [own for own in pieces if own[0] not in whole]
    return [*kept, *whole.items()]


def is_closed_by_others(
    geometry: Geometry,
    change: tuple[Sequence[Piece], Sequence[Piece]],
    lines: Sequence[tuple[Line, Sequence[Run]]],
    sheet: CleanSheet,
    rhythm: Rhythm,
) -> bool:
    """Whether one arc was made a whole circle by the ink of lines alone that touch it.

    The change is told by the pieces before and after.
    """
    pieces, joined = change
    if not isinstance(geometry, Circle) or len(pieces) != 1 or len(joined) != 1:
        return False
    if is_full_circle(geometry, pieces[0]) or not is_full_circle(geometry, joined[0]):
        return False
    return not has_ink_of_its_own(geometry, pieces[0], lines, sheet, rhythm)


def has_ink_of_its_own(
    circle: Circle,
    told: Piece,
    lines: Iterable[tuple[Line, Sequence[Run | Piece]]],
    sheet: CleanSheet,
    rhythm: Rhythm,
) -> bool:
    """Whether what an arc leaves of its circle has ink beside that of lines which touch it there.

    The sides of a slot, and an edge that its rounded end would touch were it a whole circle, leave
    gaps between them that are no longer than those of dashes.

    Args:
        circle: of the arc.
        told: the arc.
        lines: with what is drawn of each.
        sheet: the ink.
        rhythm: of its dashes.
    """
    points = circle.points_at(np.arange(told.end, told.start + circle.around, _STEP))
    beside = np.zeros(len(points), np.bool_)
    near = sheet.stroke_width / 2.0 + _TOUCHING_PX
    for line, drawn in lines:
        if (
            abs(abs(float(line.coordinates(np.array([circle.centre]))[1][0])) - circle.radius)
            > _TOUCHING_PX
        ):
            continue
        along, off = line.coordinates(points)
        for stretch in drawn:
            inside = (along >= stretch.start - near) & (along <= stretch.end + near)
            beside |= inside & (np.abs(off) <= near)
    own = points[~beside]
    # A gap of the circle's own dashes may lie there.
    if len(own) * _STEP < _TELLING * rhythm.gap:
        return True
    return bool((sample(sheet.weight, own[:, :1], own[:, 1:])[:, 0] > _DARK).mean() >= _OWN_INKED)


def _is_dashed(circle: Circle, told: Piece, sheet: CleanSheet, rhythm: Rhythm) -> bool:
    """Whether what an arc leaves of its circle has ink as dashes have it, and paper in between."""
    level = _DARK * float(np.quantile(_ink(circle, told.start, told.end, sheet), _OF_DASHES))
    dark = _ink(circle, told.end, told.start + circle.around, sheet) > level
    if longest_blank(dark) * _STEP > widest_gap(rhythm):
        return False
    if longest_blank(~dark) * _STEP > _LONGEST * rhythm.dash:
        return False
    far = dark[len(dark) // 4 : len(dark) - len(dark) // 4]
    # There is a gap more than there are dashes.
    between = max(len(dark) * _STEP - rhythm.gap, rhythm.dash)
    return bool(dark.sum() * _STEP >= _INKED * between and far.mean() >= _FAR_INKED)


def _ink(circle: Circle, start: float, end: float, sheet: CleanSheet) -> npt.NDArray[np.float64]:
    """(n,) weights along a stretch of a circle in px."""
    points = circle.points_at(np.arange(start, end, _STEP))
    return sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0]
