"""The strokes of one view from the curves of a file.

A line that the file calls hidden, or gives dashes, is one hidden stroke.  Where a file has no
dashed lines at all, dashes may have been drawn one by one: then the rhythm of short lines tells, as
it does in a picture.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gaussiancad_core.files.vectors import StrokeRole, VectorStroke
from gaussiancad_core.geometry.chains import Chain
from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.geometry.whole_curves import Line, WholeCurve
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke
from gaussiancad_core.sheet.dash_noise import LIKE_A_DASH, TELLING
from gaussiancad_core.sheet.file_noise import EXACT, PLOTTED, SAME_POINT
from gaussiancad_core.sheet.line_conventions import WIDEST_GAP
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm, Run, learn_rhythm
from gaussiancad_core.sheet.tracing.run_linetypes import classify
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


@dataclass(frozen=True)
class SheetDashes:
    """How a file draws dashed lines.

    Attributes:
        heard: their rhythm, where only that tells them from solid ones; None where the file says
            which lines are hidden.
        gap: px between dashes of such lines that it draws one by one; 0 where it draws them whole.
    """

    heard: Rhythm | None
    gap: float = 0.0


def tracks_and_dashes(
    views: Sequence[Sequence[VectorStroke]], stroke_width: float
) -> tuple[list[list[Track]], SheetDashes]:
    """Lines and circles of all views, and how their dashes are drawn.

    Args:
        views: the part's curves of each.
        stroke_width: px.
    """
    is_given = any(stroke.role is StrokeRole.HIDDEN for strokes in views for stroke in strokes)
    if not is_given:
        plotted = [tracks_of(strokes, PLOTTED) for strokes in views]
        runs = [_runs(track) for tracks in plotted for track in tracks]
        regular = [series for series in runs if len(series) >= 3]
        rhythm = learn_rhythm(regular, stroke_width)
        short = sum(0.5 < run.length / rhythm.dash < 1.5 for series in regular for run in series)
        if short >= TELLING:
            return plotted, SheetDashes(rhythm)
    exact = [tracks_of(strokes, EXACT) for strokes in views]
    return exact, SheetDashes(None, _usual_gap([track for tracks in exact for track in tracks]))


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
    tracks: Sequence[Track], strokes: Sequence[VectorStroke], dashes: SheetDashes
) -> tuple[Stroke, ...]:
    """The strokes of a view in px of the sheet (y down).

    Args:
        tracks: lines, circles and ellipses of the view.
        strokes: its curves; of these only the chains are used.
        dashes: how they are drawn on the sheet.
    """
    heard = dashes.heard
    found: list[Stroke] = []
    for track in tracks:
        pieces = (
            _pieces_as_named(track, dashes.gap) if heard is None else _heard(track, tracks, heard)
        )
        found += [_stroke(track.geometry, piece) for piece in pieces]
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


def _runs(track: Track) -> list[Run]:
    spans = united(track.solid, track.geometry.around, SAME_POINT)
    return [Run(start, end) for start, end in spans]


def _heard(track: Track, tracks: Sequence[Track], rhythm: Rhythm) -> list[Piece]:
    """Visible and hidden pieces by the lengths of runs, dashes with their ends at other strokes."""
    runs = _runs(track)
    touches = [
        (_meets(track, run.start, tracks, 0.6), _meets(track, run.end, tracks, 0.6)) for run in runs
    ]
    pieces = classify(runs, rhythm, touches, track.geometry.around)
    reach = 1.2 * rhythm.gap + 0.6
    return [
        piece
        if piece.linetype is Linetype.VISIBLE
        else Piece(
            _reaching(track, piece.start, -1.0, reach, tracks),
            _reaching(track, piece.end, 1.0, reach, tracks),
            piece.linetype,
            piece.confidence,
        )
        for piece in pieces
    ]


def _drawn_at(track: Track, position: float, slack: float) -> bool:
    around = track.geometry.around
    spans = track.solid + track.hidden
    if not np.isfinite(around):
        return any(start - slack <= position <= end + slack for start, end in spans)
    return any(
        np.mod(position - start + slack, around) <= end - start + 2 * slack for start, end in spans
    )


def _meets(track: Track, position: float, tracks: Sequence[Track], slack: float) -> bool:
    """Whether another stroke passes a place along a track."""
    point = track.geometry.points_at(np.array([position]))
    return any(
        other is not track
        and other.geometry.distances(point)[0] <= slack
        and _drawn_at(other, float(other.geometry.positions(point)[0]), slack)
        for other in tracks
    )


def _reaching(
    track: Track, position: float, way: float, reach: float, tracks: Sequence[Track]
) -> float:
    """The end of a dashed line at the first stroke that it would meet within a gap."""
    if _meets(track, position, tracks, 0.1):
        return position
    ahead = position + way * np.arange(0.0, reach + 0.5, 0.5)
    points = track.geometry.points_at(ahead)
    best = position
    nearest = np.inf
    for other in tracks:
        if other is track:
            continue
        distances = other.geometry.distances(points)
        index = int(np.argmin(distances))
        # A stroke that is crossed comes nearer and goes away again, by about a step's half.
        if distances[index] > 0.26 or distances.max() < 1.0 or index * 0.5 >= nearest:
            continue
        if _drawn_at(other, float(other.geometry.positions(points[[index]])[0]), 0.6):
            nearest = index * 0.5
            best = _refined(track.geometry, other.geometry, float(ahead[index]))
    return best


def _refined(geometry: WholeCurve, other: WholeCurve, near: float) -> float:
    """The position along a shape where it comes nearest to another, from half a px away."""
    low, high = near - 0.6, near + 0.6
    for _ in range(40):
        a, b = low + (high - low) / 3.0, high - (high - low) / 3.0
        first, second = other.distances(geometry.points_at(np.array([a, b])))
        low, high = (low, b) if first < second else (a, high)
    return (low + high) / 2.0


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
