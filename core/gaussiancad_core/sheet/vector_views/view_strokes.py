"""The strokes of one view from the curves of a file, visible and hidden ones as these are told."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from gaussiancad_core.files.vectors import StrokeRole, VectorStroke
from gaussiancad_core.geometry.chains import Chain
from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.geometry.whole_curves import Line, WholeCurve
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke
from gaussiancad_core.sheet.dash_noise import LIKE_A_DASH
from gaussiancad_core.sheet.file_noise import SAME_POINT
from gaussiancad_core.sheet.line_conventions import WIDEST_GAP
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.vector_views.curve_intervals import united, without
from gaussiancad_core.sheet.vector_views.curve_tracks import Track, tracks_of
from gaussiancad_core.sheet.vector_views.free_curves import free_curve
from gaussiancad_core.sheet.votes import MOST

_SHORTEST = 0.5
"""px: what is left of hidden lines under visible ones is shorter."""

_LONGEST = 8.0
"""Length of a dash at most, in the gap beside it."""

_FEWEST_GAPS = 2
"""Gaps of a sheet from which they tell how long they are."""

_BRIDGED = 1.5
"""Gap over which a dashed line goes on, in the usual one."""

_WHOLE = 0.5
"""px that a whole turn may lack: the ends of a polygon's first and last chord are rounded."""


def tracks_and_gap(
    views: Sequence[Sequence[VectorStroke]],
) -> tuple[list[list[Track]], float]:
    """Lines and circles of all views, and px between the dashes of hidden lines that are drawn one
    by one; 0 where none are.

    Args:
        views: the part's curves of each.
    """
    tracks = [tracks_of(strokes) for strokes in views]
    return tracks, _usual_gap([track for of_view in tracks for track in of_view])


def _usual_gap(tracks: Sequence[Track]) -> float:
    """px between dashes that are drawn one by one; 0 where gaps are not of one length."""
    gaps = []
    for track in tracks:
        if not track.patterned:
            dashes = united(track.hidden, track.geometry.around, SAME_POINT)
            for before, after in pairwise(dashes):
                gap = after[0] - before[1]
                longer = max(pair[1] - pair[0] for pair in (before, after))
                if gap <= WIDEST_GAP * longer <= WIDEST_GAP * _LONGEST * gap:
                    gaps.append(gap)
    if len(gaps) < _FEWEST_GAPS:
        return 0.0
    usual = float(np.median(gaps))
    alike = np.abs(np.array(gaps) - usual) <= LIKE_A_DASH * usual
    return usual if alike.mean() >= MOST else 0.0


def strokes_of(
    tracks: Sequence[Track], strokes: Sequence[VectorStroke], gap: float
) -> tuple[Stroke, ...]:
    """The strokes of a view in px of the sheet (y down).

    Args:
        tracks: lines, circles and ellipses of the view.
        strokes: its curves; of these only the chains are used.
        gap: px between dashes that are drawn one by one.
    """
    found: list[Stroke] = []
    for track in tracks:
        found += [_stroke(track.geometry, piece) for piece in _pieces_as_named(track, gap)]
    for stroke in strokes:
        if isinstance(stroke.curve, Chain):
            kind = Linetype.HIDDEN if stroke.role is StrokeRole.HIDDEN else Linetype.VISIBLE
            found += free_curve(stroke.curve, kind)
    return tuple(found)


def _pieces_as_named(track: Track, gap: float) -> list[Piece]:
    """Visible and hidden pieces as the file calls them; nothing hidden under a visible one."""
    around = track.geometry.around
    visible = united(track.solid, around, SAME_POINT)
    bridged = SAME_POINT if track.patterned else max(SAME_POINT, _BRIDGED * gap)
    whole = united(track.hidden, around, bridged)
    hidden = without(whole, visible, around, _SHORTEST)
    return [Piece(*span, Linetype.VISIBLE, 1.0) for span in visible] + [
        Piece(*span, Linetype.HIDDEN, 1.0) for span in hidden
    ]


def _stroke(geometry: WholeCurve, piece: Piece) -> Stroke:
    kind = piece.linetype, piece.confidence
    if isinstance(geometry, Line):
        return Segment(geometry.at(piece.start), geometry.at(piece.end), *kind)
    whole = piece.end - piece.start >= geometry.around - _WHOLE
    if isinstance(geometry, WholeEllipse):
        first, last = geometry.parameters(np.array([piece.start, piece.end]))
        turn = 2.0 * np.pi if whole else float(last - first)
        axes = geometry.semi_major, geometry.semi_minor, geometry.rotation
        return Ellipse(geometry.centre, *axes, float(np.mod(first, 2.0 * np.pi)), turn, *kind)
    sweep = 2.0 * np.pi if whole else (piece.end - piece.start) / geometry.radius
    start = float(np.mod(piece.start / geometry.radius, 2.0 * np.pi))
    return Arc(geometry.centre, geometry.radius, start, sweep, *kind)
