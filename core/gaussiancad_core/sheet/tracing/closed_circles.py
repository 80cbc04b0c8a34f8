"""Hidden arcs that are no whole circle, though lines which touch it have ink all around.

The sides of a slot, and an edge that its rounded end would touch were it a whole circle, leave gaps
between them that are no longer than those of dashes.
"""

from collections.abc import Iterable, Sequence

import numpy as np

from gaussiancad_core.geometry.whole_curves import Circle, Line, WholeCurve
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import DARK, STEP, TOUCHING
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm, Run
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.junctions import is_full_circle

_OWN_INKED, _TELLING = 0.25, 1.5
"""Share of what is not beside lines that touch a circle that is ink at least; gaps that it is long
at least to tell."""


def is_closed_by_others(
    geometry: WholeCurve,
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
    return not has_separate_ink(geometry, pieces[0], lines, sheet, rhythm)


def has_separate_ink(
    circle: Circle,
    piece: Piece,
    lines: Iterable[tuple[Line, Sequence[Run | Piece]]],
    sheet: CleanSheet,
    rhythm: Rhythm,
) -> bool:
    """Whether what an arc leaves of its circle has ink beside that of lines which touch it there.

    Args:
        circle: of the arc.
        piece: the arc.
        lines: with what is drawn of each.
        sheet: the ink.
        rhythm: of its dashes.
    """
    points = circle.points_at(np.arange(piece.end, piece.start + circle.around, STEP))
    adjacent = np.zeros(len(points), np.bool_)
    near = sheet.stroke_width / 2.0 + TOUCHING
    for line, drawn in lines:
        if (
            abs(abs(float(line.coordinates(np.array([circle.centre]))[1][0])) - circle.radius)
            > TOUCHING
        ):
            continue
        along, off = line.coordinates(points)
        for stretch in drawn:
            inside = (along >= stretch.start - near) & (along <= stretch.end + near)
            adjacent |= inside & (np.abs(off) <= near)
    point = points[~adjacent]
    # A gap of the circle's own dashes may lie there.
    if len(point) * STEP < _TELLING * rhythm.gap:
        return True
    return bool(
        (sample(sheet.weight, point[:, :1], point[:, 1:])[:, 0] > DARK).mean() >= _OWN_INKED
    )
