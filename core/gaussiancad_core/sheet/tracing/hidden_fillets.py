"""Small fillets of hidden lines: corners whose dashes lie on an arc, not on the lines.

A hidden arc of a few px shows as a dash or two, too few points to be grown.  As in
:mod:`.small_fillets` all is known of it but the radius.  Where the gaps between
dashes lie is not known, so only ink counts that is drawn off the strokes, and how far these are
blank at a stretch.
"""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import AROUND, BLANK, DARK, ONE_PLACE, STEP
from gaussiancad_core.sheet.tracing.corner_dashes import longest_blank
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.corners import (
    Corner,
    End,
    from_cut,
    from_fillet,
    from_joins,
    from_passing,
)
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm
from gaussiancad_core.sheet.tracing.ink_shapes import radial_profile, sample
from gaussiancad_core.sheet.tracing.leftover import dash_pen
from gaussiancad_core.sheet.tracing.outline_jogs import distance_to
from gaussiancad_core.sheet.tracing.passing_corners import passing_corners
from gaussiancad_core.sheet.tracing.pen_profile import Pen
from gaussiancad_core.sheet.tracing.small_fillets import (
    Fillet,
    Key,
    best_of,
    boxes_of,
    keys_of,
    open_corners,
    others_near,
    pixels_around,
    rounded_at,
    straight_ends,
)

Floats = npt.NDArray[np.float64]

_SMALLEST = 2.5
"""Stroke widths of a radius from which an arc leaves its corner clearly."""

_BETTER, _THAN_OTHER = 0.2, 0.5
"""Share of a sharp corner's squared error that a round or cut one may have, and of the other's."""

_FAR_BETTER, _CUT = 0.1, 0.3
"""Share of what a chamfer leaves of the ink beside a line that runs past that an arc may leave for
being told from it for sure, where the chamfer leaves as many full pixels, squared."""

_LEAST_INK = 0.2
"""Squared ink, in full pixels, off a sharp corner at least: a part of a dash."""

_BLANK, _WITHOUT, _PAST = 1.35, 1.3, 0.6
"""Gaps of the dashes that an arc is blank for at a stretch at most, a sharp corner at least, and
the one leg that a line which runs past leaves: the ink of both its ends is that of others."""

_ROUNDS, _NEAR = 4, 1.2
"""How often an arc is fitted to the ink, and px from it within which ink is its own."""

_CLEARLY = 4.0
"""px from a corner to a line that is beyond it."""

_TWO_DASHES = 2.0
"""Dashes from which a stroke is told by more than one of them."""


def find_hidden_fillets(
    placed: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm
) -> list[Fillet]:
    """The round corners between the ends of hidden straight pieces.

    Args:
        placed: pieces with their ends at junctions; px, pixel centres at integers.
        sheet: the ink.
        rhythm: of its dashes.
    """
    ends = straight_ends(placed, Linetype.HIDDEN)
    boxes = boxes_of(placed)
    corners = [
        corner
        for corner in (
            *open_corners(ends, placed),
            *_beyond_no_corner(
                passing_corners(ends, placed, set(Linetype)),
                [end for end in ends if end.length > _TWO_DASHES * rhythm.dash],
            ),
        )
        if not _is_met(corner, placed, boxes, sheet.stroke_width)
    ]
    if not corners:
        return []
    pen = dash_pen(placed, sheet)
    pieces = dict(enumerate(piece for _, piece in placed))
    found: list[Fillet] = []
    taken: set[Key] = set()
    for corner in corners:
        keys = keys_of(corner)
        if keys & taken:
            continue
        others = others_near(corner, placed, boxes, pen.width + 2.0 * AROUND)
        radius = _radius(corner, others, pen, sheet, rhythm.gap)
        if radius is None:
            continue
        taken |= keys
        fillet = rounded_at(corner, radius, placed, pieces)
        pieces.update(fillet.pieces)
        found.append(fillet)
    return found


def _beyond_no_corner(corners: Sequence[Corner], ends: Sequence[End]) -> list[Corner]:
    """The corners with lines that run past, but those clearly beyond one with another stroke."""
    places = np.array([end.place for end in ends]).reshape(-1, 2)
    return [
        corner
        for corner in corners
        if np.hypot(*(corner.place - corner.first.place)) < _CLEARLY
        or (np.hypot(*(places - corner.first.place).T) <= ONE_PLACE).sum() <= 1
    ]


def _is_met(corner: Corner, placed: Sequence[Placed], boxes: Floats, stroke_width: float) -> bool:
    """Whether another stroke runs through a corner or ends there."""
    near = stroke_width / 2.0 + ONE_PLACE
    around = (boxes[:, 0] <= corner.place + near) & (boxes[:, 1] >= corner.place - near)
    around[[corner.first.index, corner.second.index]] = False
    return any(
        distance_to(placed[k], corner.place) <= near
        for k in np.flatnonzero(around.all(axis=1)).tolist()
    )


def _dark(points: Floats, sheet: CleanSheet) -> npt.NDArray[np.bool_]:
    return sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] > DARK


def _radius(
    corner: Corner, others: Sequence[Placed], pen: Pen, sheet: CleanSheet, gap: float
) -> float | None:
    """The radius whose arc has the ink at a corner, None if it is sharp or cut."""
    most = corner.longest * float(np.tan(corner.half))
    least = _SMALLEST * pen.width
    if most <= least:
        return None
    offsets, ink = pixels_around(sheet.weight, corner, others, pen)
    # A line that runs past may be thicker than the dashes.
    free = from_passing(corner, offsets) > sheet.stroke_width / 2.0 + ONE_PLACE
    offsets, ink = offsets[free], ink[free]
    if not len(ink):
        return None

    def error(distance: Floats) -> float:
        return float((np.maximum(ink - pen.ink(distance) - BLANK, 0.0) ** 2).sum())

    def rounded(radius: float) -> float:
        return error(from_fillet(corner, offsets, radius))

    sharp = min(error(distance) for distance in from_joins(corner, offsets))
    if sharp < _LEAST_INK:
        return None
    radius = best_of(rounded, np.arange(least, most + 0.5, 1.0))
    best = rounded(radius)
    cuts = np.arange(1.0, corner.longest, 0.5)
    cut = min(error(from_cut(corner, offsets, float(length))) for length in cuts)
    # Beside a line that runs past, a chamfer is as likely: it must leave some of the ink.
    sure = cut >= _CUT and best <= _FAR_BETTER * cut
    least_cut = 0.0 if sure else _LEAST_INK * corner.passes
    if best > _BETTER * sharp or best > _THAN_OTHER * cut - least_cut:
        return None
    radius = _refined(radius, corner, sheet)
    if not least <= radius <= most:
        return None
    begin = radius / np.tan(corner.half)
    legs = np.linspace(0.0, begin, max(2, int(np.ceil(begin / STEP))))[:, None]
    way = [corner.place + legs * end.inward for end in (corner.first, corner.second)]
    half = np.pi / 2.0 - corner.half
    count = max(2, int(np.ceil(2.0 * half * radius / STEP)))
    arc = _facing(corner, radius, np.linspace(-half, half, count))
    sharp_way = way[0] if corner.passes else np.concatenate([way[0][::-1], way[1]])
    is_given = _blank(sharp_way, sheet) >= (_PAST if corner.passes else _WITHOUT) * gap
    return radius if is_given and _blank(arc, sheet) <= _BLANK * gap else None


def _facing(corner: Corner, radius: float, angles: Floats) -> Floats:
    """(n,) angles from a corner's direction -> (n, 2) px on the arc that rounds it."""
    circle = corner.circle(radius)
    middle = float(np.arctan2(-corner.bisector[1], -corner.bisector[0]))
    return circle.points_at(radius * (middle + angles))


def _blank(points: Floats, sheet: CleanSheet) -> float:
    """px without ink at a stretch along a way, at most."""
    return longest_blank(_dark(points, sheet)) * STEP


def _refined(radius: float, corner: Corner, sheet: CleanSheet) -> float:
    """The radius whose arc runs through the middle of the dashes, by least squares."""
    half = np.pi / 2.0 - corner.half
    for _ in range(_ROUNDS):
        angles, radii = radial_profile(sheet, corner.circle(radius), sheet.stroke_width / 2 + 1.5)
        middle = float(np.arctan2(-corner.bisector[1], -corner.bisector[0]))
        off = np.mod(angles - middle + np.pi, 2.0 * np.pi) - np.pi
        # By how much a larger radius moves the arc outward there: it touches the lines.
        outward = 1.0 - np.cos(off) / np.sin(corner.half)
        residual = radii - radius
        values = (np.abs(off) < half) & (np.abs(residual) < _NEAR)
        # Beside a line that runs past the ink is also that line's.
        places = corner.circle(radius).points_at(radius * angles) - corner.place
        values &= from_passing(corner, places) > sheet.stroke_width + ONE_PLACE
        if not values.any():
            return radius
        weight = float((outward[values] ** 2).sum())
        radius += float((outward[values] * residual[values]).sum()) / max(weight, 1e-9)
    return radius
