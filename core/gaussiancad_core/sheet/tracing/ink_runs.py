"""Runs of ink under a shape, and the rhythm of a sheet's dashes.

Along each line or circle the ink is cut into runs.  The sheet's own rhythm (median dash and gap) is
learnt from shapes with several equal runs; :mod:`.run_linetypes` says then what a
run is.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import ClosedCurve, Line, WholeCurve
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.annotations.annotation_marks import values_at
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import STEP
from gaussiancad_core.sheet.tracing.hidden_labels import TOLD
from gaussiancad_core.sheet.tracing.ink_shapes import sample

Floats = npt.NDArray[np.float64]

_MAX_TURN = np.cos(np.radians(16.0))
"""Ink that runs in a direction further from the shape's than this belongs to another shape."""


_LEAST_OWN = 4.0
"""px of ink in a shape's own direction that are a dash, though they lead into other ink."""


_LEAST_CLEAR = 3.0
"""px of these that have a clear direction at least."""

_STUB, _AT_END = 1.5, 1.0
"""Stroke widths that a dash is long at least that leads to another stroke and has no direction; px
of ink beyond that stroke at most."""

SHORTEST_DASH, SHORTEST_DOT = 1.2, 0.7
"""Stroke widths that ink without a direction is long at least to be a dash; the same where labels
say that it is a hidden line's.  Half a px of the width decides of dots where nothing else tells."""

_MOSTLY = 0.4
"""Share of a closed curve that is told as dashed where the rest of it is bridged."""

_LEAST_GAP = 0.5
"""px of paper between dashes at least."""

_LONGEST_BRIDGE, _BRIDGE_INK = 3.5, 0.35
"""Dashes with their gaps that others may cover in a row, and the share of ink that is there."""


_OPEN = 0.4
"""Share of a circle beside one piece of it at most that others' ink closes."""


@dataclass(frozen=True)
class Run:
    """An unbroken piece of ink along a shape, from ``start`` to ``end`` in px of arc length."""

    start: float
    end: float

    @property
    def length(self) -> float:
        """Extent in px."""
        return self.end - self.start


@dataclass(frozen=True)
class Piece:
    """A stretch of a shape with one linetype."""

    start: float
    end: float
    linetype: Linetype
    confidence: float


@dataclass(frozen=True)
class Rhythm:
    """A sheet's dashes: median length of a dash and of a gap in px."""

    dash: float
    gap: float


@dataclass(frozen=True)
class InkField:
    """The ink of a sheet with the direction in which it runs.

    Attributes:
        weight: (h, w) float32 0..1.
        cosine, sine: (h, w) float32, of twice the strokes' direction times how clearly the ink has
            one.
        stroke_width: px.
        hidden: (h, w) bool, where labels say that ink is a hidden line's; None where none told.
    """

    weight: npt.NDArray[np.float32]
    cosine: npt.NDArray[np.float32]
    sine: npt.NDArray[np.float32]
    stroke_width: float
    hidden: npt.NDArray[np.bool_] | None = None


def ink_field(sheet: CleanSheet) -> InkField:
    """Strokes' directions by the structure tensor of the ink."""
    smooth = cv2.GaussianBlur(sheet.weight, (0, 0), 0.8)
    gx = cv2.Sobel(smooth, cv2.CV_32F, 1, 0)
    gy = cv2.Sobel(smooth, cv2.CV_32F, 0, 1)
    sigma = max(1.2, 0.7 * sheet.stroke_width)
    # The stroke runs across the gradient, hence the minus signs.
    cosine = -cv2.GaussianBlur(gx * gx - gy * gy, (0, 0), sigma)
    sine = -cv2.GaussianBlur(2 * gx * gy, (0, 0), sigma)
    energy = cv2.GaussianBlur(gx * gx + gy * gy, (0, 0), sigma) + 1e-6
    hidden = None if sheet.hidden_odds is None else sheet.hidden_odds >= TOLD
    return InkField(sheet.weight, cosine / energy, sine / energy, sheet.stroke_width, hidden)


def runs_spans(runs: list[Run]) -> list[tuple[float, float]]:
    """Start and end of each run."""
    return [(run.start, run.end) for run in runs]


def line_runs(field: InkField, line: Line, start: float, end: float) -> list[Run]:
    """Runs of ink along a line between two positions."""
    along = np.arange(start, end + STEP, STEP)
    return _runs(field, line.points_at(along), line.tangents_at(along), along)


def circle_runs(field: InkField, curve: ClosedCurve) -> list[Run]:
    """Runs of ink around a circle or an ellipse, in px along it; a run that crosses position 0 ends
    beyond the circumference."""
    around = curve.around
    count = max(16, int(np.ceil(around / STEP)))
    along = np.arange(count, dtype=np.float64) * (around / count)
    runs = _runs(field, curve.points_at(along), curve.tangents_at(along), along)
    return _join_around(runs, around)


def _join_around(runs: list[Run], circumference: float) -> list[Run]:
    if len(runs) < 2:
        return runs
    first, last = runs[0], runs[-1]
    if first.start + circumference - last.end > 2 * STEP:
        return runs
    return [*runs[1:-1], Run(last.start, first.end + circumference)]


def _runs(field: InkField, points: Floats, directions: Floats, along: Floats) -> list[Run]:
    """Cut a path into runs; ``directions`` are (n, 2) unit tangents of the path."""
    normals = np.stack([-directions[:, 1], directions[:, 0]], 1)
    inked = _inked(field, points, normals)
    cosine = sample(field.cosine, points[:, :1], points[:, 1:])[:, 0]
    sine = sample(field.sine, points[:, :1], points[:, 1:])[:, 0]
    double = np.arctan2(directions[:, 1], directions[:, 0]) * 2
    agreement = cosine * np.cos(double) + sine * np.sin(double)
    strength = np.hypot(cosine, sine)
    # cos of twice the angle between them; ends of dashes and crossings have no clear direction.
    clear = strength > 0.45
    foreign = clear & (agreement <= (2 * _MAX_TURN**2 - 1) * strength)
    item = clear & ~foreign
    dots = field.hidden if field.hidden is not None else np.zeros((1, 1), bool)
    hidden = values_at(dots, points)
    runs = []
    for inked_span in runs_of_ink(inked):
        dotted = hidden[inked_span[0] : inked_span[1] + 1].mean() > 0.5
        least = (SHORTEST_DOT if dotted else SHORTEST_DASH) * field.stroke_width
        span = _own_span(inked_span, item, foreign, field.stroke_width, least)
        if span is not None:
            runs.append(Run(float(along[span[0]]), float(along[span[1]])))
    return _close_gaps(runs, 1.6)


def _inked(field: InkField, points: Floats, normals: Floats) -> npt.NDArray[np.bool_]:
    """(n,) whether there is ink at points of a path, or just beside it."""
    offsets = np.array([-0.6, 0.0, 0.6])
    xs = points[:, :1] + normals[:, :1] * offsets
    ys = points[:, 1:] + normals[:, 1:] * offsets
    return sample(field.weight, xs, ys).max(1) > 0.45


def _own_span(
    span: tuple[int, int],
    values: npt.NDArray[np.bool_],
    foreign: npt.NDArray[np.bool_],
    stroke_width: float,
    shortest: float,
) -> tuple[int, int] | None:
    """The part of a stretch of ink that is the shape's, by the direction that its ink has, or of
    its length in px."""
    first, last = span
    if foreign[first : last + 1].mean() > 0.4:
        # A crossing, perhaps with the dash that leads to it.
        mine = first + np.flatnonzero(values[first : last + 1])
        least = max(_LEAST_OWN, stroke_width)
        if len(mine) * STEP < least:
            # The end of a dash has no clear direction, but is the dash's where it leads to it.
            mine = _with_vague_ends(mine, (first, last), foreign)
            if len(mine) * STEP < least:
                return _stub((first, last), foreign, stroke_width)
        first, last = int(mine[0]), int(mine[-1])
    vague = values[first : last + 1].sum() * STEP < 1.5
    return None if vague and (last - first) * STEP < shortest else (first, last)


def _stub(
    span: tuple[int, int], foreign: npt.NDArray[np.bool_], stroke_width: float
) -> tuple[int, int] | None:
    """What a stretch of ink has beside a stroke that it crosses at one end, if that is a dash: one
    nearly as wide as it is long has no direction."""
    others = span[0] + np.flatnonzero(foreign[span[0] : span[1] + 1])
    before, after = int(others[0]) - span[0], span[1] - int(others[-1])
    if min(before, after) * STEP > _AT_END or max(before, after) * STEP < _STUB * stroke_width:
        return None
    return (span[0], int(others[0]) - 1) if before > after else (int(others[-1]) + 1, span[1])


def _with_vague_ends(
    mine: npt.NDArray[np.int64], span: tuple[int, int], foreign: npt.NDArray[np.bool_]
) -> npt.NDArray[np.int64]:
    """Places of a shape's own ink and those beside them, up to the ends of the span, that are no
    other's either; none where there is too little ink that is its own."""
    if len(mine) * STEP < _LEAST_CLEAR:
        return mine
    first, last = int(mine[0]), int(mine[-1])
    if not foreign[span[0] : first].any():
        first = span[0]
    elif not foreign[last + 1 : span[1] + 1].any():
        last = span[1]
    return np.arange(first, last + 1)


def runs_of_ink(flags: npt.NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last index of each stretch of True."""
    padded = np.concatenate([[False], flags, [False]]).astype(np.int8)
    edges = np.flatnonzero(np.diff(padded))
    return [(int(a), int(b) - 1) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def _close_gaps(runs: list[Run], gap: float) -> list[Run]:
    closed: list[Run] = []
    for run in runs:
        if closed and run.start - closed[-1].end <= gap:
            closed[-1] = Run(closed[-1].start, run.end)
        else:
            closed.append(run)
    return closed


def learn_rhythm(series: Sequence[list[Run]], stroke_width: float) -> Rhythm:
    """Dash and gap of a sheet from the runs of all its shapes, or usual ones."""
    usual = Rhythm(4.0 * stroke_width + 2.0, 2.0 * stroke_width + 1.0)
    return labelled_rhythm(series, SHORTEST_DASH * stroke_width) or usual


def labelled_rhythm(series: Sequence[Sequence[Run]], shortest: float) -> Rhythm | None:
    """Dash and gap of a sheet as the runs of its shapes tell them, if they do.

    A shape counts if it has three runs or more in a row whose inner ones are of one length, with
    paper between them: runs that were cut where a pen changes are no dashes.

    Args:
        series: runs, in order along each shape.
        shortest: px of a dash.
    """
    dashes: list[float] = []
    gaps: list[float] = []
    for runs in series:
        for before, run, after in zip(runs, runs[1:], runs[2:], strict=False):
            spaces = (run.start - before.end, after.start - run.end)
            even = abs(spaces[0] - spaces[1]) < max(2.0, 0.35 * max(spaces))
            even &= min(spaces) >= _LEAST_GAP
            if even and max(spaces) < 2.5 * run.length and run.length > shortest:
                dashes.append(run.length)
                gaps.extend(spaces)
    if len(dashes) < 3:
        return None
    # Solid strokes between two others look like dashes too, but seldom of one length.
    typical = float(np.median(dashes))
    return Rhythm(typical, float(np.median(gaps)))


def widest_gap(rhythm: Rhythm) -> float:
    """px between dashes of one stroke, at most."""
    return min(2.2 * rhythm.gap + 2.0, 4.0 * rhythm.gap)


def bridged(
    field: InkField, geometry: WholeCurve, pieces: list[Piece], rhythm: Rhythm
) -> list[Piece]:
    """Hidden pieces of a shape that are parted by dashes of theirs that other strokes cover.

    Ink in between that is not the shape's alone, yet lies as closely as dashes do, joins them; over
    any length where they make up much of a circle.
    """
    longest = _LONGEST_BRIDGE * (rhythm.dash + rhythm.gap)
    if is_mostly_dashed(geometry, pieces):
        longest = geometry.around
    joined: list[Piece] = []
    for piece in pieces:
        before = joined[-1] if joined else None
        if before and _is_bridged(field, geometry, (before, piece), rhythm, longest):
            sure = max(before.confidence, piece.confidence)
            joined[-1] = Piece(before.start, piece.end, Linetype.HIDDEN, sure)
        else:
            joined.append(piece)
    if joined and np.isfinite(geometry.around):
        first, last = joined[0], joined[-1]
        over = replace(first, start=first.start + geometry.around, end=first.end + geometry.around)
        # One piece that others' ink would close is most of what it closes to.
        most = longest if len(joined) > 1 else min(longest, _OPEN * geometry.around)
        if _is_bridged(field, geometry, (last, over), rhythm, most):
            # One piece that reaches its own beginning goes once around.
            end = over.end if len(joined) > 1 else over.start
            sure = max(first.confidence, last.confidence)
            joined = [*joined[1:-1], Piece(last.start, end, Linetype.HIDDEN, sure)]
    return joined


def with_dashes_led_to(
    field: InkField,
    geometry: WholeCurve,
    pieces: Sequence[Piece],
    chosen: Sequence[Piece],
    rhythm: Rhythm,
) -> list[Piece]:
    """The chosen pieces of a closed curve, and the hidden ones that these lead on to.

    The last dashes of an arc hardly bend, but are the arc's where those before them are there,
    under lines that cross them.
    """
    hidden = [piece for piece in pieces if piece.linetype is Linetype.HIDDEN]
    longest = _LONGEST_BRIDGE * (rhythm.dash + rhythm.gap)
    joined: list[tuple[Piece, Piece]] = []
    for before, after in zip(hidden, [*hidden[1:], *hidden[:1]], strict=True):
        # The last one is followed by the first, once around.
        turn = geometry.around if after.start < before.start else 0.0
        over = replace(after, start=after.start + turn, end=after.end + turn)
        if over.start > before.end and _is_bridged(
            field, geometry, (before, over), rhythm, longest
        ):
            joined.append((before, after))
    led = {piece for piece in chosen if piece.linetype is Linetype.HIDDEN}
    while more := {piece for pair in joined if led & set(pair) for piece in pair} - led:
        led |= more
    return [piece for piece in pieces if piece in chosen or piece in led]


def is_mostly_dashed(geometry: WholeCurve, pieces: Sequence[Piece]) -> bool:
    """Whether hidden pieces make up so much of a closed curve that the rest of it will be there."""
    dashed = sum(piece.end - piece.start for piece in pieces if piece.linetype is Linetype.HIDDEN)
    return bool(np.isfinite(geometry.around)) and dashed > _MOSTLY * geometry.around


def _is_bridged(
    field: InkField,
    geometry: WholeCurve,
    pair: tuple[Piece, Piece],
    rhythm: Rhythm,
    longest: float,
) -> bool:
    before, after = pair
    both = before.linetype is after.linetype is Linetype.HIDDEN
    gap = after.start - before.end
    if not both or gap > longest:
        return False
    if gap <= STEP:
        return True
    along = np.arange(before.end, after.start + STEP, STEP)
    tangents = geometry.tangents_at(along)
    normals = np.stack([-tangents[:, 1], tangents[:, 0]], 1)
    inked = _inked(field, geometry.points_at(along), normals)
    blank = max(((last - first) * STEP for first, last in runs_of_ink(~inked)), default=0.0)
    return blank <= widest_gap(rhythm) and bool(inked.mean() > _BRIDGE_INK)
